// SPDX-License-Identifier: Apache-2.0
#pragma once
// Nearest neighbours among lattice points, exactly (condition A.3 of Section 2.1).

#include <cstdint>
#include <vector>

#include "model/exact.hpp"

namespace quadbound {

__extension__ using UInt128 = unsigned __int128;

/// For each point the squared distance to its nearest other point; the largest UInt128 if there is
/// none. Points with `rounded` set stand for some point of [x, x + 1) x [y, y + 1): their distances
/// are rounded down to what is certain.
///
/// Guarantees: 1. exact where neither point is rounded; 2. never more than the true value.
/// Requires: |x|, |y| <= 2^60; rounded.size() == points.size().
/// Complexity: expected O(n log n) for points in any position of practical use; 4 n bytes.
std::vector<UInt128> nearest_neighbour_squares(const std::vector<LatticePoint>& points,
                                               const std::vector<bool>& rounded);

}  // namespace quadbound
