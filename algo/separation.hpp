// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 2.1 at work: the closure of a quadtree under conditions A, B and C and the 5x5 grids.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "algo/point_separation.hpp"
#include "algo/quadtree.hpp"

namespace quadbound {

/// Grows the smallest set of splits that is closed under conditions A, B and C. All rules only ever
/// ask for more splits, so the order in which they are applied does not matter.
///
/// Guarantees: 1. after refine_five_by_five and refine every point has its 5x5 grid of equal,
/// otherwise empty leaves. 2. the tree does not depend on the order of the points.
/// Throws (all of it): TreeBudgetExceeded.
class Separation {
 public:
  Separation(const PlacedPoints& placed, const Budget& budget);

  void apply_conditions();
  void refine_six_by_six();
  void refine_five_by_five();
  /// Splits leaves (those of them that still are), restores the conditions and the 5x5 grids.
  void refine(const std::vector<Cell>& leaves);

  [[nodiscard]] const Quadtree& tree() const { return tree_; }
  [[nodiscard]] Quadtree take_tree() && { return std::move(tree_); }
  /// The leaf of each point, in the order that they were given in.
  [[nodiscard]] std::vector<Cell> cell_of_point() const;

 private:
  [[nodiscard]] std::vector<Cell> point_cells() const;
  [[nodiscard]] bool is_crowded(Cell cell) const;
  void settle();
  void split_and_follow(Cell cell);
  void follow_changes();
  void split_beside(Cell parent, Quadrant q);
  void suspect_neighbours(Cell cell);
  void suspect_grids(Cell cell);
  void make_grids();
  bool make_five_by_five(Cell cell);
  bool make_row(Cell middle, Direction direction);
  bool is_empty_in_grid(Cell cell);
  [[nodiscard]] bool may_be_in_grid(Cell cell) const {
    return cell.block < in_grid_.size() && (unsigned{in_grid_[cell.block]} >> cell.quadrant & 1U);
  }
  std::optional<Cell> make_and_follow(Cell cell, Direction direction);

  std::vector<std::uint32_t> order_;  ///< the points along the Z curve
  Quadtree tree_;
  Deadline deadline_;
  std::vector<std::int8_t> separated_side_bits_;
  std::vector<Cell> suspects_;  ///< cells that may be crowded
  std::vector<Cell> changed_;   ///< split by the last request
  bool wants_grids_ = false;
  std::vector<Cell> grids_;            ///< cells of points whose 5x5 grid is to be made
  std::vector<std::uint8_t> in_grid_;  ///< by node: the children found in such grids, as bits
};

}  // namespace quadbound
