// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 4, the cut: acute vertices of the polygon are cut off by kites, which leaves the paper's
// polygon B without acute angles there. Filled again by algo/kite_filling.hpp.

#include <vector>

#include "algo/domain.hpp"
#include "algo/quadtree.hpp"
#include "model/polygon.hpp"

namespace quadbound {

/// The polygon less a kite a-p-v-q (Figure 43) at each marked vertex a: there the ring runs through
/// q, v, p instead, and Domain::kites names the four. `cut` is by vertex, rings in order.
///
/// Guarantees: 1. p and q lie on the edges of a, exactly, in their first thirds (but for the
/// rounding of 3.); v on the lattice. 2. The kite's angles at p and q are at most 90 degrees, hence
/// those of B at least 90, exactly, and so is B's angle at v. 3. |ap| and |aq| differ from each
/// other, and the kite's angles at p and q from 90 degrees, by no more than about 2^-11 |pv| and
/// 2^-11 radians; where that is finer than the lattice, by a degree at most. 4. Enlarged from a by
/// a half, a kite holds no other vertex and meets no edge but the two of a. Enlarged by a quarter,
/// no two kites meet. 5. The domain of a polygon with nothing marked is the polygon.
/// Requires: polygon valid and normalised, inside the root square; marked vertices strictly acute.
/// Throws: TreeBudgetExceeded (kTooDeep) where a kite's side |pv| = |ap| tan(angle / 2) would be
/// too short for the lattice.
/// Complexity: O(n log n) plus the vertices and edges in the bounding boxes of parts of kites;
/// 20,000 tips of a star with 40,000 edges take about a second.
Domain cut_kites(const Polygon& polygon, const RootSquare& root, const std::vector<bool>& cut);

}  // namespace quadbound
