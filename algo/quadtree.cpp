// SPDX-License-Identifier: Apache-2.0
#include "algo/quadtree.hpp"

#include <algorithm>
#include <utility>

namespace quadbound {
namespace {

/// Internal nodes per point that memory is set aside for, so that it need not be copied as the tree
/// grows: scattered points take about 22. What stays untouched takes no memory.
constexpr std::uint64_t kNodesPerPoint = 24;

}  // namespace

Quadtree::Quadtree(const RootSquare& root, std::vector<LatticePoint> points,
                   std::uint64_t max_leaves)
    : root_(root),
      points_(std::move(points)),
      next_point_(points_.size(), kEmptyLeaf),
      max_leaves_(max_leaves) {
  blocks_.reserve(std::min(kNodesPerPoint * points_.size(), max_leaves / 3 + 1));
  blocks_.push_back({{kEmptyLeaf, kEmptyLeaf, kEmptyLeaf, kEmptyLeaf},
                     {kNone, kNone, kNone, kNone},
                     root.corner,
                     kNone,
                     kNorthEast,
                     0});
  // From the last to the first, so that the lists of the leaves are in the order of the points.
  std::uint32_t all = kEmptyLeaf;
  for (std::size_t i = points_.size(); i-- > 0;) {
    next_point_[i] = all == kEmptyLeaf ? kEmptyLeaf : all & ~kLeaf;
    all = kLeaf | static_cast<std::uint32_t>(i);
  }
  distribute(0, all);
}

LatticePoint Quadtree::corner(Cell cell) const {
  const LatticePoint low = blocks_[cell.block].corner;
  const std::int64_t side = std::int64_t{1} << side_bits(cell);
  return {low.x + (is_east(cell.quadrant) ? side : 0),
          low.y + (is_north(cell.quadrant) ? side : 0)};
}

Cell Quadtree::leaf_below(BlockId block, LatticePoint point) const {
  for (;;) {
    const Block& b = blocks_[block];
    const std::int64_t half = std::int64_t{1} << (root_.side_bits - 1 - b.level);
    const Cell cell{block, quadrant(point.x >= b.corner.x + half, point.y >= b.corner.y + half)};
    if (is_leaf(cell)) return cell;
    block = content(cell);
  }
}

Cell LeafFinder::leaf_at(LatticePoint point) {
  const auto holds = [&](const Quadtree::Block& block) {
    const std::int64_t side = std::int64_t{1} << (tree_.root().side_bits - block.level);
    return block.corner.x <= point.x && point.x < block.corner.x + side &&
           block.corner.y <= point.y && point.y < block.corner.y + side;
  };
  while (last_ != 0 && !holds(tree_.blocks()[last_])) last_ = tree_.blocks()[last_].parent;
  const Cell leaf = tree_.leaf_below(last_, point);
  last_ = leaf.block;
  return leaf;
}

BlockId Quadtree::add_block(Cell cell, LatticePoint corner, std::uint8_t level) {
  const BlockId id = static_cast<BlockId>(blocks_.size());
  blocks_.push_back({{kEmptyLeaf, kEmptyLeaf, kEmptyLeaf, kEmptyLeaf},
                     {kNone, kNone, kNone, kNone},
                     corner,
                     cell.block,
                     cell.quadrant,
                     level});
  return id;
}

void Quadtree::link(BlockId id) {
  const Cell cell{blocks_[id].parent, blocks_[id].quadrant};
  for (const Direction direction : kDirections) {
    const auto there = neighbour(cell, direction);
    if (!there || is_leaf(*there)) continue;
    const BlockId other = content(*there);
    blocks_[id].neighbour[direction] = other;
    blocks_[other].neighbour[reversed(direction)] = id;
  }
}

void Quadtree::distribute(BlockId id, std::uint32_t content) {
  if (content == kEmptyLeaf) return;
  Block& block = blocks_[id];
  const std::int64_t half = std::int64_t{1} << (root_.side_bits - 1 - block.level);
  const LatticePoint middle{block.corner.x + half, block.corner.y + half};
  std::array<PointId, 4> last{kEmptyLeaf, kEmptyLeaf, kEmptyLeaf, kEmptyLeaf};
  for (PointId id_in_list = content & ~kLeaf; id_in_list != kEmptyLeaf;) {
    const PointId following = next_point_[id_in_list];
    const LatticePoint at = points_[id_in_list];
    const Quadrant q = quadrant(at.x >= middle.x, at.y >= middle.y);
    if (last[q] == kEmptyLeaf) {
      block.child[q] = kLeaf | id_in_list;
    } else {
      next_point_[last[q]] = id_in_list;
    }
    next_point_[id_in_list] = kEmptyLeaf;
    last[q] = id_in_list;
    id_in_list = following;
  }
}

bool Quadtree::on_root_border(BlockId block, Direction direction) const {
  const Block& b = blocks_[block];
  const std::int64_t root_side = std::int64_t{1} << root_.side_bits;
  const std::int64_t side = root_side >> b.level;
  switch (direction) {
    case kEast:
      return b.corner.x + side == root_.corner.x + root_side;
    case kNorth:
      return b.corner.y + side == root_.corner.y + root_side;
    case kWest:
      return b.corner.x == root_.corner.x;
    case kSouth:
      return b.corner.y == root_.corner.y;
  }
  return false;
}

void Quadtree::split(Cell cell, std::vector<Cell>& changed) {
  const std::uint32_t held = content(cell);
  const LatticePoint low = corner(cell);
  const int level = blocks_[cell.block].level + 1;
  if (side_bits(cell) <= kFinestSideBits)
    throw TreeBudgetExceeded{RefusalKind::kTooDeep, low, level};
  if (leaf_count() + 3 > max_leaves_)
    throw TreeBudgetExceeded{RefusalKind::kTooManyCells, low, level};
  const BlockId id = add_block(cell, low, static_cast<std::uint8_t>(level));
  blocks_[cell.block].child[cell.quadrant] = id;
  distribute(id, held);
  link(id);
  changed.push_back(cell);
  for (const Direction direction : kDirections) make_neighbour(cell, direction, changed);
}

std::optional<Cell> Quadtree::make_neighbour(Cell cell, Direction direction,
                                             std::vector<Cell>& changed) {
  if (const auto there = neighbour(cell, direction)) return there;
  if (on_root_border(cell.block, direction)) return std::nullopt;
  // Condition C: the parent is an internal node, so its neighbour exists; it is the leaf in the
  // way.
  const Cell parent{blocks_[cell.block].parent, blocks_[cell.block].quadrant};
  split(*neighbour(parent, direction), changed);
  return neighbour(cell, direction);
}

}  // namespace quadbound
