// SPDX-License-Identifier: Apache-2.0
#pragma once
// Point sets into the formats that read_points reads.

#include <iosfwd>

#include "model/polygon.hpp"
#include "model/read_points.hpp"

namespace quadbound {

/// One point a line; .csv with the header "x,y", .node numbered from 0.
///
/// Guarantees: 1. reading it back gives the same doubles in the same order (shortest digits that
/// do). 2. Equal sets give equal bytes. Requires: finite coordinates. Errors: show in the stream's
/// state.
void write_points(std::ostream& stream, const PointSet& points, PointFormat format);

}  // namespace quadbound
