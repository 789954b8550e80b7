// SPDX-License-Identifier: Apache-2.0
#pragma once
// The quadtree of Section 2.1 while it grows: internal nodes only, each with its four children and
// its edge neighbours. Always balanced (condition C).

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/exact.hpp"

namespace quadbound {

/// Children and corners of a cell, counter-clockwise; the paper's C0..C3 as its table shows them.
enum Quadrant : std::uint8_t { kNorthEast = 0, kNorthWest = 1, kSouthWest = 2, kSouthEast = 3 };

inline constexpr bool is_east(Quadrant q) { return q == kNorthEast || q == kSouthEast; }
inline constexpr bool is_north(Quadrant q) { return q == kNorthEast || q == kNorthWest; }
inline constexpr Quadrant quadrant(bool east, bool north) {
  return north ? (east ? kNorthEast : kNorthWest) : (east ? kSouthEast : kSouthWest);
}
/// The quadrant `steps` further counter-clockwise.
inline constexpr Quadrant turned(Quadrant q, int steps) {
  return static_cast<Quadrant>((static_cast<int>(q) + steps) & 3);
}
inline constexpr Quadrant opposite(Quadrant q) { return turned(q, 2); }
inline constexpr std::array<Quadrant, 4> kQuadrants{kNorthEast, kNorthWest, kSouthWest, kSouthEast};

enum Direction : std::uint8_t { kEast = 0, kNorth = 1, kWest = 2, kSouth = 3 };
inline constexpr std::array<Direction, 4> kDirections{kEast, kNorth, kWest, kSouth};
inline constexpr Direction reversed(Direction d) { return static_cast<Direction>((d + 2) & 3); }
inline constexpr bool is_horizontal(Direction d) { return d == kEast || d == kWest; }

/// The quadrant that a step in a direction leads to, in the same or in the neighbouring node.
inline constexpr Quadrant mirrored(Quadrant q, Direction d) {
  return is_horizontal(d) ? quadrant(!is_east(q), is_north(q)) : quadrant(is_east(q), !is_north(q));
}
/// Whether a step in a direction from a quadrant leaves the node.
inline constexpr bool leaves_node(Quadrant q, Direction d) {
  return is_horizontal(d) ? is_east(q) == (d == kEast) : is_north(q) == (d == kNorth);
}

/// The square that the whole tree divides: lower left corner and side in lattice units, the side a
/// power of two.
struct RootSquare {
  LatticePoint corner;
  int side_bits = 0;
  int exponent = 0;  ///< of the lattice
};

using BlockId = std::uint32_t;
using PointId = std::uint32_t;

/// One of the four children of an internal node.
struct Cell {
  BlockId block = 0;
  Quadrant quadrant = kNorthEast;
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// Why a tree cannot be refined further.
enum class RefusalKind : std::uint8_t { kTooDeep, kTooManyCells, kTooMuchTime };

/// Thrown inside algo/ only; the public functions turn it into a Refusal.
struct TreeBudgetExceeded {
  RefusalKind kind;
  LatticePoint where;
  int level;
};

/// Guarantees: 1. Condition C: the same-size edge neighbours of every internal node exist (as leaf
/// or internal node) unless they lie outside the root. 2. A split moves the points of a leaf to the
/// children whose half-open squares [x, x + side) x [y, y + side) hold them. 3. The set of nodes
/// does not depend on the order of splits that request the same cells.
/// Requires: at most 2^31 points and 2^31 - 1 internal nodes (kTooManyCells is thrown before).
/// Complexity: neighbours in constant time; 56 bytes per internal node, i.e. 19 per leaf.
class Quadtree {
 public:
  /// What a leaf holds: nothing, or the first of a list of points.
  static constexpr std::uint32_t kLeaf = 0x8000'0000U;
  static constexpr std::uint32_t kEmptyLeaf = 0xFFFF'FFFFU;
  static constexpr BlockId kNone = 0xFFFF'FFFFU;
  /// Extra points lie at a quarter of a cell's side and must be on the lattice.
  static constexpr int kFinestSideBits = 2;

  struct Block {
    std::array<std::uint32_t, 4> child;  ///< BlockId, or kLeaf | first point, or kEmptyLeaf
    std::array<BlockId, 4> neighbour;    ///< same-size internal node in each direction, or kNone
    LatticePoint corner;                 ///< lower left
    BlockId parent;                      ///< kNone for the root
    Quadrant quadrant;                   ///< in the parent
    std::uint8_t level;                  ///< 0 for the root
  };

  /// The root is split at once. `points` are the positions of the points rounded down to the
  /// lattice.
  Quadtree(const RootSquare& root, std::vector<LatticePoint> points, std::uint64_t max_leaves);

  [[nodiscard]] const RootSquare& root() const { return root_; }
  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  [[nodiscard]] std::uint64_t leaf_count() const { return 3 * std::uint64_t{blocks_.size()} + 1; }

  [[nodiscard]] std::uint32_t content(Cell cell) const {
    return blocks_[cell.block].child[cell.quadrant];
  }
  [[nodiscard]] bool is_leaf(Cell cell) const { return (content(cell) & kLeaf) != 0; }
  [[nodiscard]] bool has_point(Cell cell) const {
    return is_leaf(cell) && content(cell) != kEmptyLeaf;
  }
  [[nodiscard]] int side_bits(Cell cell) const {
    return root_.side_bits - 1 - blocks_[cell.block].level;
  }
  [[nodiscard]] LatticePoint corner(Cell cell) const;
  [[nodiscard]] LatticePoint point(PointId id) const { return points_[id]; }
  /// The first point of a leaf and those that follow it. Requires: has_point(cell).
  [[nodiscard]] PointId first_point(Cell cell) const { return content(cell) & ~kLeaf; }
  [[nodiscard]] PointId next_point(PointId id) const { return next_point_[id]; }

  /// The same-size edge neighbour; nullopt where that is outside the root or inside a larger leaf.
  [[nodiscard]] std::optional<Cell> neighbour(Cell cell, Direction direction) const {
    const Quadrant there = mirrored(cell.quadrant, direction);
    if (!leaves_node(cell.quadrant, direction)) return Cell{cell.block, there};
    const BlockId block = blocks_[cell.block].neighbour[direction];
    if (block == kNone) return std::nullopt;
    return Cell{block, there};
  }
  /// Calls visit(dx, dy, cell) for the extended neighbours (same size, sharing a side or a corner)
  /// that exist and that are reached through an existing neighbour to the east or west. For a cell
  /// with a point these are all that lie inside the root (condition B).
  template <class Visit>
  void for_extended_neighbours(Cell cell, const Visit& visit) const {
    for (const int dx : {-1, 0, 1}) {
      const std::optional<Cell> middle =
          dx == 0 ? std::optional<Cell>(cell) : neighbour(cell, dx < 0 ? kWest : kEast);
      if (!middle) continue;
      if (dx != 0) visit(dx, 0, *middle);
      if (const auto below = neighbour(*middle, kSouth)) visit(dx, -1, *below);
      if (const auto above = neighbour(*middle, kNorth)) visit(dx, 1, *above);
    }
  }

  /// The leaf whose half-open square holds a point. Requires: inside the root.
  /// Complexity: linear in its level.
  [[nodiscard]] Cell leaf_at(LatticePoint point) const { return leaf_below(0, point); }

  /// Splits a leaf and whatever balance asks for. Cells that were split are appended to `changed`.
  /// Throws: TreeBudgetExceeded.
  void split(Cell cell, std::vector<Cell>& changed);
  /// Like neighbour, but splits the larger leaf that is in the way. nullopt only outside the root.
  std::optional<Cell> make_neighbour(Cell cell, Direction direction, std::vector<Cell>& changed);

 private:
  BlockId add_block(Cell cell, LatticePoint corner, std::uint8_t level);
  void link(BlockId id);
  void distribute(BlockId id, std::uint32_t content);
  [[nodiscard]] bool on_root_border(BlockId block, Direction direction) const;
  /// The leaf at a point of an internal node.
  [[nodiscard]] Cell leaf_below(BlockId block, LatticePoint point) const;
  friend class LeafFinder;

  RootSquare root_;
  std::vector<LatticePoint> points_;
  std::vector<PointId> next_point_;
  std::vector<Block> blocks_;
  std::uint64_t max_leaves_;
};

/// Quadtree::leaf_at for points that come near each other, one after the other.
/// Complexity: of a step, linear in the levels up to a node that has both points, and down.
class LeafFinder {
 public:
  /// Requires: the tree outlives it; it may grow.
  explicit LeafFinder(const Quadtree& tree) : tree_(tree) {}
  [[nodiscard]] Cell leaf_at(LatticePoint point);

 private:
  const Quadtree& tree_;
  BlockId last_ = 0;
};

}  // namespace quadbound
