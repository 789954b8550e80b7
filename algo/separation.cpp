// SPDX-License-Identifier: Apache-2.0
#include "algo/separation.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <numeric>

#include "algo/nearest_neighbour.hpp"

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

template <class Value>
std::vector<Value> in_order(const std::vector<Value>& values,
                            const std::vector<std::uint32_t>& order) {
  std::vector<Value> result;
  result.reserve(order.size());
  for (const std::uint32_t i : order) result.push_back(values[i]);
  return result;
}

}  // namespace

Separation::Separation(const PlacedPoints& placed, const Budget& budget)
    : order_(z_order(placed.floors)),
      tree_(placed.root, in_order(placed.floors, order_), std::min(budget.max_cells, kMostCells)),
      deadline_(budget.max_seconds) {
  const std::vector<UInt128> squares =
      nearest_neighbour_squares(in_order(placed.floors, order_), in_order(placed.rounded, order_));
  separated_side_bits_.reserve(squares.size());
  for (const UInt128 square : squares)
    separated_side_bits_.push_back(static_cast<std::int8_t>(largest_separated_side_bits(square)));
}

void Separation::apply_conditions() {
  for (const Quadrant q : kQuadrants) suspects_.push_back({0, q});
  settle();
}

void Separation::refine_six_by_six() {
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
void Separation::refine_five_by_five() {
  wants_grids_ = true;
  grids_ = point_cells();
  make_grids();
}

/// A split that breaks a grid that was whole puts it back on the list: see suspect_grids.
void Separation::make_grids() {
  while (!grids_.empty()) {
    const Cell cell = grids_.back();
    grids_.pop_back();
    if (!make_five_by_five(cell) && tree_.is_leaf(cell)) split_and_follow(cell);
    settle();
  }
}

std::vector<Cell> Separation::point_cells() const {
  std::vector<Cell> cells;
  for (BlockId block = 0; block < tree_.blocks().size(); ++block) {
    for (const Quadrant q : kQuadrants)
      if (tree_.has_point({block, q})) cells.push_back({block, q});
  }
  return cells;
}

bool Separation::is_crowded(Cell cell) const {
  const PointId first = tree_.first_point(cell);
  if (tree_.next_point(first) != Quadtree::kEmptyLeaf) return true;      // A.1
  if (tree_.side_bits(cell) > separated_side_bits_[first]) return true;  // A.3
  int whole = 0;
  tree_.for_extended_neighbours(
      cell, [&](int, int, Cell there) { whole += tree_.is_leaf(there) ? 1 : 0; });
  return whole < 8;  // A.2: one is split; or one lies beyond the root
}

void Separation::settle() {
  while (!suspects_.empty()) {
    const Cell cell = suspects_.back();
    suspects_.pop_back();
    if (tree_.has_point(cell) && is_crowded(cell)) split_and_follow(cell);
  }
}

void Separation::split_and_follow(Cell cell) {
  deadline_.check(tree_.corner(cell), tree_.root().side_bits - tree_.side_bits(cell));
  changed_.clear();
  tree_.split(cell, changed_);
  follow_changes();
}

/// Applies condition B to every cell with points that was split, and suspects all cells that may
/// have become crowded by the splits.
void Separation::follow_changes() {
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    const Cell parent = changed_[i];
    suspect_neighbours(parent);
    if (may_be_in_grid(parent)) suspect_grids(parent);
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
void Separation::split_beside(Cell parent, Quadrant q) {
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

void Separation::suspect_neighbours(Cell cell) {
  tree_.for_extended_neighbours(cell, [this](int, int, Cell there) {
    if (tree_.has_point(there)) suspects_.push_back(there);
  });
}

/// Cells of points in whose 5x5 grid a cell is. All cells of a whole grid exist, so the way to its
/// middle leads through them.
void Separation::suspect_grids(Cell cell) {
  for (int dx = -2; dx <= 2; ++dx) {
    std::optional<Cell> middle = cell;
    for (int i = 0; i < std::abs(dx) && middle; ++i)
      middle = tree_.neighbour(*middle, dx > 0 ? kEast : kWest);
    for (const Direction d : {kNorth, kSouth}) {
      std::optional<Cell> there = middle;
      for (int i = 0; i <= 2 && there; ++i) {
        if (tree_.has_point(*there)) grids_.push_back(*there);
        there = tree_.neighbour(*there, d);
      }
    }
  }
}

/// Makes the 24 cells around a cell exist; whether all are inside the root, whole and empty.
bool Separation::make_five_by_five(Cell cell) {
  bool whole = make_row(cell, kNorth);
  whole = make_row(cell, kSouth) && whole;
  for (const Direction direction : {kEast, kWest}) {
    std::optional<Cell> middle = cell;
    for (int dx = 1; dx <= 2; ++dx) {
      middle = make_and_follow(*middle, direction);
      whole = middle && is_empty_in_grid(*middle) && whole;
      if (!middle) break;
      whole = make_row(*middle, kNorth) && whole;
      whole = make_row(*middle, kSouth) && whole;
    }
  }
  return whole;
}

/// Two more cells beyond one of the middle row; likewise.
bool Separation::make_row(Cell middle, Direction direction) {
  bool whole = true;
  std::optional<Cell> there = middle;
  for (int dy = 1; dy <= 2; ++dy) {
    there = make_and_follow(*there, direction);
    if (!there) return false;
    whole = is_empty_in_grid(*there) && whole;
  }
  return whole;
}

/// Whether a cell is a leaf without points; it is known to be in a grid from now on.
bool Separation::is_empty_in_grid(Cell cell) {
  if (in_grid_.size() <= cell.block) in_grid_.resize(tree_.blocks().size());
  std::uint8_t& children = in_grid_[cell.block];
  children = static_cast<std::uint8_t>(children | 1U << cell.quadrant);
  return tree_.content(cell) == Quadtree::kEmptyLeaf;
}

std::optional<Cell> Separation::make_and_follow(Cell cell, Direction direction) {
  if (const auto there = tree_.neighbour(cell, direction)) return there;
  changed_.clear();
  const auto there = tree_.make_neighbour(cell, direction, changed_);
  follow_changes();
  return there;
}

void Separation::refine(const std::vector<Cell>& leaves) {
  for (const Cell cell : leaves) {
    if (tree_.is_leaf(cell)) split_and_follow(cell);
    settle();
  }
  make_grids();
}

std::vector<Cell> Separation::cell_of_point() const {
  std::vector<Cell> cells(order_.size());
  for (const Cell cell : point_cells()) cells[order_[tree_.first_point(cell)]] = cell;
  return cells;
}

Deadline::Deadline(double seconds)
    : end_(std::chrono::steady_clock::now() +
           std::chrono::duration_cast<std::chrono::steady_clock::duration>(
               std::chrono::duration<double>(std::min(seconds, 1e9)))) {}

void Deadline::check(LatticePoint where, int level) {
  if ((++calls_ & 0x3FFU) == 0) check_now(where, level);
}

void Deadline::check_now(LatticePoint where, int level) const {
  if (std::chrono::steady_clock::now() > end_)
    throw TreeBudgetExceeded{RefusalKind::kTooMuchTime, where, level};
}

}  // namespace quadbound
