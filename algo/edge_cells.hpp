// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the edges of a domain run among the leaves of a quadtree, and on which side of the boundary
// the other leaves lie.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "algo/domain.hpp"
#include "algo/quadtree.hpp"
#include "algo/window.hpp"

namespace quadbound {

enum class Where : std::uint8_t { kUnknown, kOutside, kInside, kBoundary };

/// The leaves of a window that edges may meet, each with these edges. A leaf is *met* if one of
/// them may come within a quarter of its side, which is how far outside a mirrored extra point
/// lies.
///
/// Guarantees: 1. every edge that meets a leaf, grown by a quarter of its side, is listed for it;
/// some that do not may be, too. They ascend. 2. where(leaf) is exact: kInside or kOutside for a
/// leaf that is not met and for all of it, grown likewise; kUnknown for one that is met, or not in
/// the window. Requires: tree and domain outlive it, and stay as they are. Complexity: linear in
/// the pairs of an edge and a node of the tree that meet; where_at in the edges of its leaf. 2
/// bytes for each node of the tree, 12 for each leaf that is met, 4 for each of its edges.
class EdgeCells {
 public:
  EdgeCells(const Domain& domain, const Quadtree& tree, const Window& window = {});

  [[nodiscard]] Where where(Cell leaf) const {
    return static_cast<Where>((unsigned{leaves_[leaf.block]} >> (2U * leaf.quadrant)) & 3U);
  }
  /// Calls visit(leaf, its edges) for all that are met, depth first.
  template <class Visit>
  void for_met(const Visit& visit) const {
    std::size_t first = 0;
    for (const Met& met : met_) {
      visit(met.leaf, std::span<const EdgeId>(edges_.data() + first, met.end - first));
      first = met.end;
    }
  }
  /// Where a point lies, exactly. Requires: the leaf is met, by these edges; the point is in it, or
  /// within a quarter of its side outside.
  [[nodiscard]] Where where_at(Cell leaf, std::span<const EdgeId> edges, LatticePoint point) const;

 private:
  struct Met {
    Cell leaf;
    std::uint32_t end;  ///< of its edges
  };
  class Finder;

  const Domain& domain_;
  const Quadtree& tree_;
  std::vector<Met> met_;
  std::vector<EdgeId> edges_;
  std::vector<std::uint8_t> leaves_;  ///< by node: Where of its leaves, two bits each
  /// By node that edges may meet: of its centre, moved as by Domain::moved_off.
  std::vector<Where> centres_;
};

/// Calls visit for each leaf that some edges may meet, with these edges, in the order given;
/// guarantee 1 of EdgeCells.
void for_leaves_with_edges(const Domain& domain, const Quadtree& tree,
                           const std::vector<EdgeId>& edges,
                           const std::function<void(Cell, std::span<const EdgeId>)>& visit);

/// Leaves that two edges without a common vertex both run through, the inside between them. Where
/// the leaves around such a leaf are as large, and it holds no vertex, it is always at fault:
/// either its centre is above both edges, or both cut the same one of the four quads there. To be
/// split before there is a quadrangulation, which costs far more to make.
///
/// Guarantees: 1. each leaf of the window once, in the order of for_met.
std::vector<Cell> leaves_too_large(const Domain& domain, const Quadtree& tree,
                                   const EdgeCells& edge_cells);

}  // namespace quadbound
