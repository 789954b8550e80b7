// SPDX-License-Identifier: Apache-2.0
#pragma once
// What Lemmas 2 to 11 are about: a balanced quadtree, its quadrangulation Q, and the line of an
// edge through it. All coordinates are integers: the root is [0, 2^20] x [0, 2^20].

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "algo/apply_template.hpp"
#include "algo/quadtree.hpp"
#include "generators/random.hpp"
#include "model/mesh.hpp"

namespace quadbound {

inline constexpr int kCutTreeBits = 20;
inline constexpr std::int64_t kCutTreeSide = std::int64_t{1} << kCutTreeBits;

/// The square [i, i + 1] x [j, j + 1], scaled to 4^-level of the root's area.
struct TreeNode {
  int level = 0;
  std::int64_t i = 0;
  std::int64_t j = 0;
  friend bool operator==(const TreeNode&, const TreeNode&) = default;
};

/// The line of an edge e: -45 <= theta <= 45 degrees, as Section 3.1 asks.
/// Requires: 0 < dx <= kSteepest, |dy| <= dx.
struct CutLine {
  static constexpr std::int64_t kSteepest = 1 << 16;
  LatticePoint point;
  std::int64_t dx = 1;
  std::int64_t dy = 0;
  friend bool operator==(const CutLine&, const CutLine&) = default;
};

/// An input of the audit in full: internal nodes of the tree and the line.
struct CutTreeCase {
  std::vector<TreeNode> split;  ///< balance adds what is missing
  CutLine line;
  TwoTwoVariant two_two = TwoTwoVariant::kExact;
};

/// For readers: "root [0, 64] x [0, 64], split (level, i, j): ...; through (32, 20), direction
/// (3, -2)". The unit is the largest that keeps all numbers whole.
std::string to_text(const CutTreeCase& cut_case);

/// A closed square of the tree.
struct CellSquare {
  LatticePoint low;
  std::int64_t side = 0;
};

/// Guarantees: 1. Q is what quadrangulate makes. 2. leaf_of is the leaf that a vertex lies in; a
/// centre that the paper's case 2,2 moves stays with its own. 3. joined(v) are the vertices with an
/// edge of Q to v, ascending.
class CutTree {
 public:
  CutTree(Quadtree tree, TwoTwoVariant two_two);

  [[nodiscard]] const Quadtree& tree() const { return tree_; }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const std::vector<Cell>& leaves() const { return leaves_; }
  [[nodiscard]] VertexId vertex_count() const { return static_cast<VertexId>(leaf_of_.size()); }

  [[nodiscard]] LatticePoint at(VertexId v) const { return mesh_.vertices.lattice(v); }
  [[nodiscard]] Cell leaf_of(VertexId v) const { return leaf_of_[v]; }
  [[nodiscard]] bool is_centre(VertexId v) const { return is_centre_[v]; }
  /// On the outer boundary of Q, which no quad of the paper's Q is near.
  [[nodiscard]] bool is_outermost(VertexId v) const { return is_outermost_[v]; }
  [[nodiscard]] VertexId centre(Cell leaf) const { return centre_[4 * leaf.block + leaf.quadrant]; }
  [[nodiscard]] std::span<const VertexId> joined(VertexId v) const {
    return {joined_.data() + first_joined_[v], first_joined_[v + 1] - first_joined_[v]};
  }
  [[nodiscard]] bool are_joined(VertexId u, VertexId v) const;

  [[nodiscard]] CellSquare square(Cell leaf) const {
    return {tree_.corner(leaf), std::int64_t{1} << tree_.side_bits(leaf)};
  }
  /// The paper's N(c), W(c), S(c), E(c): one or two leaves, from west to east or south to north;
  /// none outside the root.
  [[nodiscard]] std::vector<Cell> neighbours(Cell leaf, Direction direction) const;

 private:
  void find_centres(const class TemplateTree& templates);
  void link();

  Quadtree tree_;
  Mesh mesh_;
  std::vector<Cell> leaves_;
  std::vector<VertexId> centre_;  ///< by 4 * block + quadrant
  std::vector<Cell> leaf_of_;
  std::vector<bool> is_centre_;
  std::vector<bool> is_outermost_;
  std::vector<std::uint32_t> first_joined_;
  std::vector<VertexId> joined_;
};

/// How two leaves touch.
enum class Touch : std::uint8_t { kNot, kCorner, kEdge };
Touch touch(const CellSquare& a, const CellSquare& b);

/// The balanced tree with these internal nodes and those that balance asks for.
Quadtree tree_with(std::span<const TreeNode> split);
/// Its internal nodes but the root, the larger first.
std::vector<TreeNode> nodes_of(const Quadtree& tree);

/// Splits in the middle of the root, where the audit looks.
Quadtree random_cut_tree(RandomIntegers& random);
/// A line through the middle ninth of the root: any slope; or one of the slopes 0, 1/7, 1/3, 1/2,
/// 3/4, 1 or within 2^-16 of it, through any point, or through or one unit beside a centre, a
/// corner or an extra point.
CutLine random_cut_line(const CutTree& tree, RandomIntegers& random);

}  // namespace quadbound
