// SPDX-License-Identifier: Apache-2.0
#pragma once
// One sweep over the edges of rings: do they meet anywhere, and which ring lies in which?

#include <cstddef>
#include <optional>
#include <vector>

#include "model/polygon.hpp"

namespace quadbound {

struct RingNesting {
  /// For each ring the innermost ring around it; nullopt where there is none.
  std::vector<std::optional<std::size_t>> around;
};

/// The nesting of disjoint simple rings; nullopt where two edges have a point in common, except
/// that edges which follow each other in a ring share a vertex.
///
/// Requires: finite coordinates, all vertices different, and no edge that folds back on the edge
/// before it.
/// Complexity: O(n log n) exact orientations (the sweep of Shamos and Hoey).
std::optional<RingNesting> nesting_of_disjoint_rings(const std::vector<Ring>& rings);

/// The smallest k such that edge k has a point in common with an edge before it, not counting the
/// vertices that neighbours share. Edges are numbered through all rings; edge k starts at vertex k.
///
/// Requires: as above, and that nesting_of_disjoint_rings returned nullopt.
/// Complexity: O(n log^2 n) exact orientations.
std::size_t first_edge_that_meets_an_earlier_one(const std::vector<Ring>& rings);

/// +1 where a ring is counter-clockwise, -1 where clockwise.
/// Requires: a simple ring.
int ring_orientation(const Ring& ring);

}  // namespace quadbound
