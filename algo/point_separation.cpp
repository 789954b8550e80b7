// SPDX-License-Identifier: Apache-2.0
#include "algo/point_separation.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "algo/nearest_neighbour.hpp"
#include "model/mesh.hpp"

namespace quadbound {
namespace {

constexpr int bit_width(UInt128 value) {
  const auto high = static_cast<std::uint64_t>(value >> 64);
  return high != 0 ? 64 + static_cast<int>(std::bit_width(high))
                   : static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value)));
}

/// Condition A.3: a cell with side l = 2^k is crowded if its point has a neighbour closer than
/// 2 sqrt(2) l, i.e. if d^2 < 2^(2k + 3). The largest k that is not crowded.
int largest_separated_side_bits(UInt128 square) {
  const int log2 = bit_width(square) - 1;  // 2^log2 <= square, and no larger power is
  return log2 < 3 ? -1 : (log2 - 3) / 2;
}

/// Grows the smallest set of splits that is closed under conditions A, B and C. All rules only ever
/// ask for more splits, so the order in which they are applied does not matter.
class Separation {
 public:
  Separation(const PlacedPoints& placed, const Budget& budget)
      : tree_(placed.root, placed.floors, std::min(budget.max_cells, kMostCells)),
        deadline_(budget.max_seconds) {
    const std::vector<UInt128> squares = nearest_neighbour_squares(placed.floors, placed.rounded);
    separated_side_bits_.reserve(squares.size());
    for (const UInt128 square : squares)
      separated_side_bits_.push_back(static_cast<std::int8_t>(largest_separated_side_bits(square)));
  }

  void apply_conditions() {
    for (const Quadrant q : kQuadrants) suspects_.push_back({0, q});
    settle();
  }

  void refine_six_by_six() {
    for (const Cell cell : point_cells()) {
      deadline_.check(tree_.corner(cell), 0);
      std::vector<Cell> grid{cell};
      tree_.for_extended_neighbours(cell, [&grid](int, int, Cell there) { grid.push_back(there); });
      for (const Cell there : grid)
        if (tree_.is_leaf(there)) tree_.split(there, changed_);
      changed_.clear();
    }
  }

  /// Every cell of a point, from the level that the conditions leave it at, gets its 24 cells
  /// around it before it is asked whether it must be split: so that this, too, is a closure that
  /// does not depend on the order.
  void refine_five_by_five() {
    wants_grids_ = true;
    // A later split may break a grid that was whole: ask all again until nothing changes.
    for (std::size_t before = 0; before != tree_.blocks().size();) {
      before = tree_.blocks().size();
      grids_ = point_cells();
      while (!grids_.empty()) {
        const Cell cell = grids_.back();
        grids_.pop_back();
        const bool whole = make_five_by_five(cell);
        if (!whole && tree_.is_leaf(cell)) split_and_follow(cell);
        settle();
      }
    }
  }

  [[nodiscard]] std::vector<Cell> point_cells() const {
    std::vector<Cell> cells;
    for (BlockId block = 0; block < tree_.blocks().size(); ++block) {
      for (const Quadrant q : kQuadrants)
        if (tree_.has_point({block, q})) cells.push_back({block, q});
    }
    return cells;
  }

  [[nodiscard]] Quadtree& tree() { return tree_; }

 private:
  [[nodiscard]] bool is_crowded(Cell cell) const {
    const PointId first = tree_.first_point(cell);
    if (tree_.next_point(first) != Quadtree::kEmptyLeaf) return true;      // A.1
    if (tree_.side_bits(cell) > separated_side_bits_[first]) return true;  // A.3
    int whole = 0;
    tree_.for_extended_neighbours(
        cell, [&](int, int, Cell there) { whole += tree_.is_leaf(there) ? 1 : 0; });
    return whole < 8;  // A.2: one is split; or one lies beyond the root
  }

  void settle() {
    while (!suspects_.empty()) {
      const Cell cell = suspects_.back();
      suspects_.pop_back();
      if (tree_.has_point(cell) && is_crowded(cell)) split_and_follow(cell);
    }
  }

  void split_and_follow(Cell cell) {
    deadline_.check(tree_.corner(cell), tree_.root().side_bits - tree_.side_bits(cell));
    changed_.clear();
    tree_.split(cell, changed_);
    follow_changes();
  }

  /// Applies condition B to every cell with points that was split, and suspects all cells that may
  /// have become crowded by the splits.
  void follow_changes() {
    for (std::size_t i = 0; i < changed_.size(); ++i) {
      const Cell parent = changed_[i];
      suspect_neighbours(parent);
      const BlockId block = tree_.content(parent);
      for (const Quadrant q : kQuadrants) {
        if (!tree_.has_point({block, q})) continue;
        suspects_.push_back({block, q});
        if (wants_grids_) grids_.push_back({block, q});
        split_beside(parent, q);
      }
    }
  }

  /// Condition B: the extended neighbours of `parent` that touch its child q.
  void split_beside(Cell parent, Quadrant q) {
    const int east = is_east(q) ? 1 : -1;
    const int north = is_north(q) ? 1 : -1;
    std::array<Cell, 3> touching{};
    std::size_t count = 0;
    tree_.for_extended_neighbours(parent, [&](int dx, int dy, Cell there) {
      if ((dx == 0 || dx == east) && (dy == 0 || dy == north)) touching[count++] = there;
    });
    for (std::size_t i = 0; i < count; ++i)
      if (tree_.is_leaf(touching[i])) tree_.split(touching[i], changed_);
  }

  void suspect_neighbours(Cell cell) {
    tree_.for_extended_neighbours(cell, [this](int, int, Cell there) {
      if (tree_.has_point(there)) suspects_.push_back(there);
    });
  }

  /// Makes the 24 cells around a cell exist; whether all are inside the root, whole and empty.
  bool make_five_by_five(Cell cell) {
    bool whole = true;
    for (int dx = -2; dx <= 2; ++dx) {
      for (int dy = -2; dy <= 2; ++dy) {
        if (dx == 0 && dy == 0) continue;
        const auto there = walk(cell, dx, dy);
        whole = whole && there && tree_.is_leaf(*there) && !tree_.has_point(*there);
      }
    }
    return whole;
  }

  std::optional<Cell> walk(Cell cell, int dx, int dy) {
    std::optional<Cell> at = cell;
    for (int i = 0; i < std::abs(dx) && at; ++i) at = make_and_follow(*at, dx > 0 ? kEast : kWest);
    for (int i = 0; i < std::abs(dy) && at; ++i)
      at = make_and_follow(*at, dy > 0 ? kNorth : kSouth);
    return at;
  }

  std::optional<Cell> make_and_follow(Cell cell, Direction direction) {
    changed_.clear();
    const auto there = tree_.make_neighbour(cell, direction, changed_);
    follow_changes();
    return there;
  }

  Quadtree tree_;
  Deadline deadline_;
  std::vector<std::int8_t> separated_side_bits_;
  std::vector<Cell> suspects_;  ///< cells that may be crowded
  std::vector<Cell> changed_;   ///< split by the last request
  bool wants_grids_ = false;
  std::vector<Cell> grids_;  ///< cells of points whose 5x5 grid is to be made
};

/// Less than 2^result bounds the magnitude of all coordinates.
int magnitude_exponent(const std::vector<Point>& points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest == 0 ? 0 : std::ilogb(largest) + 1;
}

std::vector<LatticePoint> floors_on(const std::vector<Point>& points, int exponent,
                                    std::vector<bool>* rounded) {
  std::vector<LatticePoint> floors;
  floors.reserve(points.size());
  for (const Point& p : points) {
    const LatticeFloor x = *lattice_floor(p.x, exponent);
    const LatticeFloor y = *lattice_floor(p.y, exponent);
    floors.push_back({x.floor, y.floor});
    if (rounded != nullptr) rounded->push_back(!x.exact || !y.exact);
  }
  return floors;
}

struct Range {
  std::int64_t low;
  std::int64_t high;  ///< beyond the largest
  [[nodiscard]] std::int64_t length() const { return high - low; }
};

std::pair<Range, Range> bounding_box(const std::vector<LatticePoint>& floors) {
  Range x{floors.front().x, floors.front().x + 1};
  Range y{floors.front().y, floors.front().y + 1};
  for (const LatticePoint p : floors) {
    x = {std::min(x.low, p.x), std::max(x.high, p.x + 1)};
    y = {std::min(y.low, p.y), std::max(y.high, p.y + 1)};
  }
  return {x, y};
}

/// Where a square of the given side starts that has the range in its middle, rounded down to a
/// sixteenth of the side.
std::int64_t square_start(Range range, std::int64_t side) {
  return (range.low - (side - range.length()) / 2) & -(side / 16);
}

/// Whether a comes before b on the Z curve: decided by the coordinate with the highest bit that
/// differs.
bool z_less(LatticePoint a, LatticePoint b) {
  const auto dx = static_cast<std::uint64_t>(a.x ^ b.x);
  const auto dy = static_cast<std::uint64_t>(a.y ^ b.y);
  const bool y_decides = dy >= dx || (dx ^ dy) > dx;
  return y_decides ? a.y < b.y : a.x < b.x;
}

/// Points in the order of the Z curve, so that neighbours in the plane are neighbours in memory.
std::vector<std::uint32_t> z_order(const std::vector<LatticePoint>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&points](std::uint32_t a, std::uint32_t b) {
    if (points[a] == points[b]) return a < b;
    return z_less(points[a], points[b]);
  });
  return order;
}

PlacedPoints reordered(const PlacedPoints& placed, const std::vector<std::uint32_t>& order) {
  PlacedPoints result{placed.root, {}, {}};
  result.floors.reserve(order.size());
  result.rounded.reserve(order.size());
  for (const std::uint32_t i : order) {
    result.floors.push_back(placed.floors[i]);
    result.rounded.push_back(placed.rounded[i]);
  }
  return result;
}

/// Any 56 bits of the largest coordinate tell where the root square may be; the margin of 4 bits
/// keeps the sums below inside the lattice.
constexpr int kCoarseBits = 56;

}  // namespace

Deadline::Deadline(double seconds)
    : end_(std::chrono::steady_clock::now() +
           std::chrono::duration_cast<std::chrono::steady_clock::duration>(
               std::chrono::duration<double>(std::min(seconds, 1e9)))) {}

void Deadline::check(LatticePoint where, int level) {
  if ((++calls_ & 0x3FFU) != 0) return;
  if (std::chrono::steady_clock::now() > end_)
    throw TreeBudgetExceeded{RefusalKind::kTooMuchTime, where, level};
}

PlacedPoints place_root(const std::vector<Point>& points) {
  const int magnitude = magnitude_exponent(points);
  const int coarse = magnitude - kCoarseBits;
  const auto [x, y] = bounding_box(floors_on(points, coarse, nullptr));
  const std::int64_t extent = std::max(x.length(), y.length());
  // A side of 3/2 of the extent at least. One point has no extent: any square will do.
  const std::int64_t side =
      points.size() == 1
          ? std::int64_t{1} << kCoarseBits
          : std::max<std::int64_t>(16, static_cast<std::int64_t>(std::bit_ceil(
                                           static_cast<std::uint64_t>(extent + (extent + 1) / 2))));
  const LatticePoint corner{square_start(x, side), square_start(y, side)};
  const std::int64_t farthest = std::max({-corner.x, -corner.y, corner.x + side, corner.y + side});
  // The finest lattice on which the farthest corner is at most 2^60.
  const int spare =
      kLatticeBits - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(farthest - 1)));
  PlacedPoints placed;
  placed.root.exponent = coarse - spare;
  placed.root.corner = {corner.x * (std::int64_t{1} << spare),
                        corner.y * (std::int64_t{1} << spare)};
  placed.root.side_bits = std::countr_zero(static_cast<std::uint64_t>(side)) + spare;
  placed.floors = floors_on(points, placed.root.exponent, &placed.rounded);
  return placed;
}

SeparatedTree separate_points(const PlacedPoints& given, GridRefinement refinement,
                              const Budget& budget) {
  const std::vector<std::uint32_t> order = z_order(given.floors);
  const PlacedPoints placed = reordered(given, order);
  Separation separation(placed, budget);
  separation.apply_conditions();
  const std::size_t before = separation.tree().blocks().size();
  if (refinement == GridRefinement::kSixBySix) {
    separation.refine_six_by_six();
  } else {
    separation.refine_five_by_five();
  }
  const std::uint64_t refined = separation.tree().blocks().size() - before;
  std::vector<Cell> cell_of_point(placed.floors.size());
  for (const Cell cell : separation.point_cells())
    cell_of_point[order[separation.tree().first_point(cell)]] = cell;
  return {std::move(separation.tree()), std::move(cell_of_point), refined};
}

std::optional<std::string> broken_separation(const SeparatedTree& separated) {
  const Quadtree& tree = separated.tree;
  for (BlockId block = 0; block < tree.blocks().size(); ++block) {
    const Quadtree::Block& b = tree.blocks()[block];
    const std::int64_t side = std::int64_t{1} << (tree.root().side_bits - b.level);
    for (const Direction d : kDirections) {
      const bool inside =
          d == kEast ? b.corner.x + side <
                           tree.root().corner.x + (std::int64_t{1} << tree.root().side_bits)
          : d == kNorth ? b.corner.y + side <
                              tree.root().corner.y + (std::int64_t{1} << tree.root().side_bits)
          : d == kWest ? b.corner.x > tree.root().corner.x
                       : b.corner.y > tree.root().corner.y;
      if (block != 0 && inside && !tree.neighbour({b.parent, b.quadrant}, d))
        return "condition C: unbalanced";
    }
  }
  for (PointId id = 0; id < separated.cell_of_point.size(); ++id) {
    const Cell cell = separated.cell_of_point[id];
    if (!tree.has_point(cell)) return "a point without a cell";
    if (tree.next_point(tree.first_point(cell)) != Quadtree::kEmptyLeaf)
      return "two points in one cell";
    for (int dx = -2; dx <= 2; ++dx) {
      for (int dy = -2; dy <= 2; ++dy) {
        std::optional<Cell> at = cell;
        for (int i = 0; i < std::abs(dx) && at; ++i)
          at = tree.neighbour(*at, dx > 0 ? kEast : kWest);
        for (int i = 0; i < std::abs(dy) && at; ++i)
          at = tree.neighbour(*at, dy > 0 ? kNorth : kSouth);
        if (!at || !tree.is_leaf(*at)) return "5x5 grid: a cell is missing or split";
        if (*at != cell && tree.has_point(*at)) return "5x5 grid: a cell holds another point";
      }
    }
  }
  return std::nullopt;
}

}  // namespace quadbound
