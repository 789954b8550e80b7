// SPDX-License-Identifier: Apache-2.0
#pragma once
// N / n against n as a picture (80n).

#include <string>

#include "paper/reproduction.hpp"

namespace quadbound {

/// An SVG of its own: uniform sets with their spread for both grids, the other sets as marks, and
/// the paper's 80 and 68.8 as lines. Guarantees: 1. the same measurements give the same bytes.
std::string cells_per_point_chart(const Reproduction& reproduction);

}  // namespace quadbound
