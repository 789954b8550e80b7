// SPDX-License-Identifier: Apache-2.0
#pragma once
// Polygons into GeoJSON.

#include <iosfwd>

#include "model/polygon.hpp"

namespace quadbound {

/// A Feature with one Polygon; `file` becomes its name. Rings are closed, one vertex a line.
///
/// Guarantees: 1. reading it back gives the same doubles (shortest digits that do). 2. Equal
/// polygons give equal bytes. Requires: finite coordinates. Errors: show in the stream's state.
void write_geojson(std::ostream& stream, const Polygon& polygon);

}  // namespace quadbound
