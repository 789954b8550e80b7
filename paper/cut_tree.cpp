// SPDX-License-Identifier: Apache-2.0
#include "paper/cut_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "algo/counters.hpp"
#include "algo/quadrangulation.hpp"
#include "algo/template_tree.hpp"

namespace quadbound {
namespace {

/// Extra points lie at a quarter of a side, and a line one unit beside them is to be a near miss.
constexpr int kDeepest = 9;
/// No case comes near it.
constexpr std::uint64_t kMostLeaves = 1 << 20;

int level_of(const Quadtree& tree, Cell cell) { return kCutTreeBits - tree.side_bits(cell); }

Quadtree whole_root() { return {RootSquare{{0, 0}, kCutTreeBits, 0}, {}, kMostLeaves}; }

void split(Quadtree& tree, Cell leaf) {
  std::vector<Cell> changed;
  tree.split(leaf, changed);
}

}  // namespace

CutTree::CutTree(Quadtree tree, TwoTwoVariant two_two) : tree_(std::move(tree)) {
  TemplateTree templates(tree_);
  Counters counters;
  mesh_ = quadrangulate(templates, tree_.root(), two_two, counters);
  find_centres(templates);
  link();
}

void CutTree::find_centres(const TemplateTree& templates) {
  const std::size_t count = mesh_.vertices.size();
  is_centre_.assign(count, false);
  leaf_of_.resize(count);
  centre_.assign(4 * tree_.blocks().size(), kNoVertex);
  for (BlockId block = 0; block < tree_.blocks().size(); ++block) {
    for (const Quadrant q : kQuadrants) {
      if (!tree_.is_leaf({block, q})) continue;
      const VertexId v = templates.centre(templates.node_of(block), q);
      leaves_.push_back({block, q});
      centre_[4 * std::size_t{block} + q] = v;
      is_centre_[v] = true;
      leaf_of_[v] = {block, q};
    }
  }
  for (VertexId v = 0; v < count; ++v)
    if (!is_centre_[v]) leaf_of_[v] = tree_.leaf_at(at(v));
}

void CutTree::link() {
  std::vector<std::pair<VertexId, VertexId>> edges;
  for (const Quad& quad : mesh_.quads)
    for (unsigned k = 0; k < 4; ++k) edges.emplace_back(quad[k], quad[(k + 1) & 3U]);
  std::sort(edges.begin(), edges.end());
  is_outermost_.assign(vertex_count(), false);
  const std::size_t directed = edges.size();
  for (std::size_t i = 0; i < directed; ++i) {
    const std::pair back{edges[i].second, edges[i].first};
    if (std::binary_search(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(directed),
                           back))
      continue;
    is_outermost_[back.first] = is_outermost_[back.second] = true;
    edges.push_back(back);
  }
  std::sort(edges.begin(), edges.end());
  first_joined_.assign(std::size_t{vertex_count()} + 1, 0);
  for (const auto& [from, to] : edges) {
    ++first_joined_[from + 1];
    joined_.push_back(to);
  }
  for (std::size_t v = 1; v < first_joined_.size(); ++v) first_joined_[v] += first_joined_[v - 1];
}

bool CutTree::are_joined(VertexId u, VertexId v) const {
  const auto others = joined(u);
  return std::binary_search(others.begin(), others.end(), v);
}

std::vector<Cell> CutTree::neighbours(Cell leaf, Direction direction) const {
  const CellSquare c = square(leaf);
  std::vector<Cell> found;
  for (const std::int64_t part : {c.side / 4, 3 * (c.side / 4)}) {
    LatticePoint p{c.low.x + part, c.low.y + part};
    if (direction == kEast) p.x = c.low.x + c.side;
    if (direction == kWest) p.x = c.low.x - 1;
    if (direction == kNorth) p.y = c.low.y + c.side;
    if (direction == kSouth) p.y = c.low.y - 1;
    if (std::min(p.x, p.y) < 0 || std::max(p.x, p.y) >= kCutTreeSide) return {};
    const Cell there = tree_.leaf_at(p);
    if (found.empty() || !(found.back() == there)) found.push_back(there);
  }
  return found;
}

Touch touch(const CellSquare& a, const CellSquare& b) {
  const auto overlap = [](std::int64_t low, std::int64_t side, std::int64_t other,
                          std::int64_t other_side) {
    return std::min(low + side, other + other_side) - std::max(low, other);
  };
  const std::int64_t x = overlap(a.low.x, a.side, b.low.x, b.side);
  const std::int64_t y = overlap(a.low.y, a.side, b.low.y, b.side);
  if (x == 0 && y == 0) return Touch::kCorner;
  return (x == 0 && y > 0) || (y == 0 && x > 0) ? Touch::kEdge : Touch::kNot;
}

Quadtree tree_with(std::span<const TreeNode> nodes) {
  Quadtree tree = whole_root();
  for (const TreeNode& node : nodes) {
    const std::int64_t side = kCutTreeSide >> node.level;
    const LatticePoint middle{node.i * side + side / 2, node.j * side + side / 2};
    for (Cell leaf = tree.leaf_at(middle); level_of(tree, leaf) <= node.level;
         leaf = tree.leaf_at(middle))
      split(tree, leaf);
  }
  return tree;
}

std::vector<TreeNode> nodes_of(const Quadtree& tree) {
  std::vector<TreeNode> nodes;
  for (const Quadtree::Block& block : tree.blocks()) {
    if (block.level == 0) continue;
    const std::int64_t side = kCutTreeSide >> block.level;
    nodes.push_back({block.level, block.corner.x / side, block.corner.y / side});
  }
  std::sort(nodes.begin(), nodes.end(), [](const TreeNode& a, const TreeNode& b) {
    return std::array{std::int64_t{a.level}, a.j, a.i} <
           std::array{std::int64_t{b.level}, b.j, b.i};
  });
  return nodes;
}

Quadtree random_cut_tree(RandomIntegers& random) {
  Quadtree tree = whole_root();
  for (const Quadrant q : kQuadrants) split(tree, {0, q});
  const std::int64_t splits = random.between(4, 60);
  const std::int64_t deepest = random.between(4, kDeepest);
  for (std::int64_t i = 0; i < splits; ++i) {
    // Half of the splits go to one of the newest blocks: local depth makes the rare cases.
    const auto size = static_cast<std::int64_t>(tree.blocks().size());
    Cell leaf{};
    if (random.chance(50)) {
      const auto block =
          static_cast<BlockId>(random.between(std::max<std::int64_t>(0, size - 8), size - 1));
      leaf = {block, kQuadrants[random.below(4)]};
      if (!tree.is_leaf(leaf)) continue;
    } else {
      leaf = tree.leaf_at({random.between(kCutTreeSide / 4, 3 * (kCutTreeSide / 4)),
                           random.between(kCutTreeSide / 4, 3 * (kCutTreeSide / 4))});
    }
    if (level_of(tree, leaf) < deepest) split(tree, leaf);
  }
  return tree;
}

namespace {

LatticePoint any_middle_point(RandomIntegers& random) {
  return {random.between(3 * (kCutTreeSide / 8), 5 * (kCutTreeSide / 8)),
          random.between(3 * (kCutTreeSide / 8), 5 * (kCutTreeSide / 8))};
}

/// A vertex of Q or a corner of a leaf, or one unit above or below it.
LatticePoint special_point(const CutTree& tree, RandomIntegers& random) {
  const LatticePoint near = any_middle_point(random);
  const Cell leaf = tree.tree().leaf_at(near);
  LatticePoint point = tree.square(leaf).low;
  if (random.chance(60)) {
    point = tree.at(tree.centre(leaf));
    const auto others = tree.joined(tree.centre(leaf));
    if (random.chance(30)) point = tree.at(others[random.below(others.size())]);
  }
  point.y += random.between(-1, 1);
  return point;
}

}  // namespace

CutLine random_cut_line(const CutTree& tree, RandomIntegers& random) {
  constexpr std::array<std::array<std::int64_t, 2>, 6> kSlopes{
      {{0, 1}, {1, 7}, {1, 3}, {1, 2}, {3, 4}, {1, 1}}};
  CutLine line{any_middle_point(random), CutLine::kSteepest, 0};
  if (random.chance(40)) {
    line.dy = random.between(-line.dx, line.dx);
  } else {
    const auto& [rise, run] = kSlopes[random.below(kSlopes.size())];
    line.dx = (CutLine::kSteepest - 2) / run * run;
    line.dy = line.dx / run * rise;
    if (random.chance(30)) line.dy += random.between(-1, 1);
    if (line.dy > line.dx) line.dy = line.dx;
    if (random.chance(50)) line.dy = -line.dy;
    if (random.chance(70)) line.point = special_point(tree, random);
  }
  return line;
}

std::string to_text(const CutTreeCase& cut_case) {
  const CutLine& line = cut_case.line;
  int deepest = 0;
  std::string nodes;
  for (const TreeNode& n : cut_case.split) {
    deepest = std::max(deepest, n.level);
    nodes += fmt::format(" ({}, {}, {})", n.level, n.i, n.j);
  }
  // Half the smallest cells, or finer for the point of the line.
  const std::int64_t unit =
      std::gcd(kCutTreeSide >> (deepest + 2), std::gcd(line.point.x, line.point.y));
  return fmt::format(
      "root [0, {0}] x [0, {0}], split (level, i, j):{1}; line through ({2}, {3}), "
      "direction ({4}, {5})",
      kCutTreeSide / unit, nodes, line.point.x / unit, line.point.y / unit, line.dx, line.dy);
}

}  // namespace quadbound
