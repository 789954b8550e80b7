// SPDX-License-Identifier: Apache-2.0
#pragma once
// What asks for cells: the sum over a polygon's boundary of 1 / local feature size.

#include "model/polygon.hpp"

namespace quadbound {

/// Ruppert's local feature size on the boundary: at a point of an edge, the distance to the nearest
/// edge without a common vertex, or to the farther of its two neighbours where that is less.
///
/// The feature size changes by no more than the way along the boundary, so that the steps taken, a
/// quarter of it, are off by an eighth or so at most.
/// Guarantees: 1. the same polygon gives the same value everywhere.
/// Requires: validate(polygon) passes.
/// Complexity: O(log n) for each step where edges are spread as in a plane, of which there are
/// about four for each unit of the result.
double inverse_feature_size_integral(const Polygon& polygon);

}  // namespace quadbound
