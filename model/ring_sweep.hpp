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

/// +1 where a ring is counter-clockwise, -1 where clockwise.
/// Requires: a simple ring.
int ring_orientation(const Ring& ring);

}  // namespace quadbound
