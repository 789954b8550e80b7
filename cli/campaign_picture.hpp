// SPDX-License-Identifier: Apache-2.0
#pragma once
// A campaign of polygons as a picture.

#include <string>

#include "cli/polygon_tally.hpp"

namespace quadbound::cli {

/// Histograms of the smallest and the largest new angle of each mesh beside the bounds of thm-13,
/// of cells per vertex and of quads per cell; SVG, PDF or PNG by the ending of the name.
///
/// Guarantees: 1. equal tallies give equal bytes of SVG.
/// Errors: OutputError; std::invalid_argument for another ending.
void write_campaign_picture(const std::string& path, const PolygonTally& tally);

}  // namespace quadbound::cli
