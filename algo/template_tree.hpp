// SPDX-License-Identifier: Apache-2.0
#pragma once
// The finished quadtree as Section 2.2 reads it: nodes in depth-first order, leaves numbered by the
// mesh vertices at their centres, and what becomes of each leaf's outer extra point.

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "algo/construction.hpp"
#include "algo/quadtree.hpp"
#include "algo/window.hpp"
#include "model/mesh.hpp"

namespace quadbound {

using NodeId = std::uint32_t;

/// What the stitching does to a leaf's outer extra point. A mirrored point is reflected across the
/// side of its cell into the cell beyond it (Fig. 8b, 8c), in x or in y.
enum class ExtraFate : std::uint8_t { kKept = 0, kMirroredX = 1, kMirroredY = 2, kDropped = 3 };

/// A node or leaf as seen from its parent.
struct CellRef {
  std::uint32_t ref;  ///< NodeId, kHole, or Quadtree::kLeaf | centre vertex
  NodeId parent;
  Quadrant quadrant;
  std::uint8_t level;
  /// A node outside the window: nothing below it is known.
  static constexpr std::uint32_t kHole = Quadtree::kLeaf - 1;
  [[nodiscard]] bool is_leaf() const { return (ref & Quadtree::kLeaf) != 0; }
  [[nodiscard]] bool is_hole() const { return ref == kHole; }
};

/// Leaves may be left out: they have no vertices, and neither have quads with such a vertex. The
/// others are wanted; what is left out comes back where a quad joins it to a wanted leaf.
class TemplateTree {
 public:
  static constexpr NodeId kNoNode = 0xFFFF'FFFFU;
  /// The centre of a leaf that is left out. Its extra points, counted from there, are no smaller.
  static constexpr VertexId kLeftOut = ~Quadtree::kLeaf;

  /// Complexity: linear; 17 bytes per internal node in the window.
  explicit TemplateTree(const Quadtree& tree, const Window& window = {});

  [[nodiscard]] std::size_t size() const { return children_.size(); }
  [[nodiscard]] std::uint64_t leaf_count() const { return 3 * std::uint64_t{children_.size()} + 1; }
  /// kNoNode outside the window.
  [[nodiscard]] NodeId node_of(BlockId block) const { return node_of_block_[block]; }
  [[nodiscard]] const std::array<std::uint32_t, 4>& children(NodeId node) const {
    return children_[node];
  }

  [[nodiscard]] CellRef child(NodeId node, Quadrant q, std::uint8_t child_level) const {
    return {children_[node][q], node, q, child_level};
  }
  /// Requires: !cell.is_leaf().
  [[nodiscard]] CellRef child(const CellRef& cell, Quadrant q) const {
    return child(cell.ref, q, static_cast<std::uint8_t>(cell.level + 1));
  }

  [[nodiscard]] bool is_t4(NodeId node) const {
    const auto& c = children_[node];
    return (c[0] & c[1] & c[2] & c[3] & Quadtree::kLeaf) != 0;
  }
  /// T1, T2a, T2b and T3 give every leaf child an outer extra point, T4 none.
  [[nodiscard]] bool has_outer_extra(const CellRef& leaf) const { return !is_t4(leaf.parent); }

  [[nodiscard]] ExtraFate fate(NodeId node, Quadrant q) const {
    return static_cast<ExtraFate>((unsigned{fates_[node]} >> (2U * q)) & 3U);
  }
  void set_fate(NodeId node, Quadrant q, ExtraFate fate);
  /// Before the leaves are numbered. Requires: a leaf.
  void leave_out(NodeId node, Quadrant q) {
    set_centre(node, q, kLeftOut);
    leaves_out_ = true;
  }
  [[nodiscard]] bool leaves_any_out() const { return leaves_out_; }
  void bring_back(NodeId node, Quadrant q) { set_centre(node, q, kBroughtBack); }
  [[nodiscard]] bool is_left_out(NodeId node, Quadrant q) const {
    return centre(node, q) == kLeftOut;
  }
  [[nodiscard]] bool is_wanted(NodeId node, Quadrant q) const { return centre(node, q) == kWanted; }

  void set_centre(NodeId node, Quadrant q, VertexId vertex) {
    children_[node][q] = Quadtree::kLeaf | vertex;
  }
  [[nodiscard]] VertexId centre(NodeId node, Quadrant q) const {
    return children_[node][q] & ~Quadtree::kLeaf;
  }

  /// Gives back its memory.
  void forget();

  /// All vertices but the last ones, the extra points of the case 2,2.
  [[nodiscard]] VertexId vertices_of_leaves() const { return vertices_of_leaves_; }
  void set_vertices_of_leaves(VertexId count) { vertices_of_leaves_ = count; }
  /// Whether a vertex is the centre of a leaf.
  [[nodiscard]] bool is_centre(VertexId vertex) const { return !is_extra_[vertex]; }
  /// Before any is marked: of all vertices, at most.
  void set_most_vertices(std::size_t count) { is_extra_.assign(count, false); }
  void mark_extra(VertexId vertex) { is_extra_[vertex] = true; }

  /// The extra points of the case 2,2, with the centre of their leaf before them.
  [[nodiscard]] const std::vector<std::pair<VertexId, VertexId>>& halves_extras() const {
    return halves_extras_;
  }
  void add_halves_extra(VertexId centre, VertexId extra) {
    halves_extras_.emplace_back(centre, extra);
    mark_extra(extra);
  }
  void sort_halves_extras() { std::sort(halves_extras_.begin(), halves_extras_.end()); }

 private:
  // Instead of a centre, as long as there is none.
  static constexpr VertexId kWanted = 0;
  static constexpr VertexId kBroughtBack = 1;

  NodeId copy(const Quadtree& tree, const Window& window, BlockId block);

  std::vector<std::array<std::uint32_t, 4>> children_;
  std::vector<std::uint8_t> fates_;  ///< two bits per child
  std::vector<NodeId> node_of_block_;
  std::vector<bool> is_extra_;  ///< by vertex
  VertexId vertices_of_leaves_ = 0;
  std::vector<std::pair<VertexId, VertexId>> halves_extras_;
  bool leaves_out_ = false;
};

/// Which template a node takes: the number of its leaf children, and for two of them whether they
/// are neighbours (T2a) or opposite (T2b).
inline Template which_template(const std::array<std::uint32_t, 4>& children) {
  constexpr Template t0 = Template::kT0, t1 = Template::kT1, a = Template::kT2a, b = Template::kT2b,
                     t3 = Template::kT3, t4 = Template::kT4;
  // By the set of quadrants that are leaves, NE = 1, NW = 2, SW = 4, SE = 8.
  constexpr std::array<Template, 16> by_leaves{t0, t1, t1, a,  t1, b,  a,  t3,
                                               t1, a,  b,  t3, a,  t3, t3, t4};
  unsigned leaves = 0;
  for (const Quadrant q : kQuadrants) leaves |= (children[q] >> 31) << q;
  return by_leaves[leaves];
}

}  // namespace quadbound
