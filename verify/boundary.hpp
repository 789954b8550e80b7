// SPDX-License-Identifier: Apache-2.0
#pragma once
// The unpaired edges: closed loops, the largest area, and where unpaired edges meet that should
// not.

#include <cstdint>
#include <optional>
#include <vector>

#include "verify/links.hpp"
#include "verify/plane.hpp"

namespace quadbound::judge {

struct Loops {
  /// A vertex that has not exactly one unpaired edge in and one out; the smallest. The rest is
  /// empty then.
  std::optional<VertexId> branching;

  struct Loop {
    VertexId first;  ///< the smallest vertex; loops ascend by it
    std::uint64_t edges;
  };
  std::vector<Loop> loops;
  std::vector<VertexId> vertices;  ///< of all loops, in their order, each from its first one on
};

/// The smallest vertex with another number of unpaired edges in or out than one.
/// Requires: edges different and ascending by `from`. Complexity: O(n log n).
std::optional<VertexId> find_branching(const std::vector<DirectedEdge>& edges);

/// Requires: edges different and ascending by `from`. Complexity: O(n log n).
Loops trace_loops(const std::vector<DirectedEdge>& edges);

/// The loop of largest signed area; the first of equal ones.
struct Outermost {
  std::size_t loop = 0;
  Rational doubled_area;  ///< positive where it runs counter-clockwise
};
/// Nullopt where there are no loops.
std::optional<Outermost> find_outermost(const ExactPlane& plane, const Loops& loops);

/// Each the first by the smaller, then by the larger index of the two edges.
struct Contacts {
  struct Hanging {
    std::size_t edge;
    VertexId vertex;  ///< an end of another unpaired edge, inside this one
  };
  struct Coincident {
    VertexId first;  ///< the smaller one
    VertexId second;
  };
  struct Crossing {
    std::size_t first;
    std::size_t second;
  };
  std::optional<Hanging> hanging;
  std::optional<Coincident> coincident;
  std::optional<Crossing> crossing;  ///< inner points of both, on different lines
  [[nodiscard]] bool any() const { return hanging || coincident || crossing; }
};

/// All pairs of edges with a common point, except the vertices that they share.
/// Complexity: O(n log n + pairs of edges whose bounding boxes meet) as a rule.
Contacts find_contacts(const ExactPlane& plane, const std::vector<DirectedEdge>& edges);

}  // namespace quadbound::judge
