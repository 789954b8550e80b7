// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 2.1: the quadtree of a point set with the conditions A (separation), B and C (balance),
// and the 5x5 grid of equal leaves around every point.

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "algo/quadtree.hpp"
#include "model/polygon.hpp"

namespace quadbound {

/// How the 5x5 grid around each point is made.
enum class GridRefinement : std::uint8_t {
  kSixBySix,    ///< the paper: split the 3x3 cells around every point into 6x6
  kFiveByFive,  ///< "a possible smaller-sized quadtree": ask for the 5x5 grid itself
};

/// Vertex numbers have 31 bits, and a leaf has three vertices of its own at most (centre, outer and
/// inner extra, or centre and two extras of the case 2,2): 2^29 leaves always fit.
inline constexpr std::uint64_t kMostCells = std::uint64_t{1} << 29;

struct Budget {
  std::uint64_t max_cells = kMostCells;  ///< no effect beyond kMostCells
  double max_seconds = 3600;
};

/// A deadline that costs next to nothing to ask.
class Deadline {
 public:
  explicit Deadline(double seconds);
  /// Throws: TreeBudgetExceeded (kTooMuchTime) naming `where` once the time is over.
  void check(LatticePoint where, int level);
  /// The same, always looking at the clock.
  void check_now(LatticePoint where, int level) const;

 private:
  std::chrono::steady_clock::time_point end_;
  unsigned calls_ = 0;
};

/// The root square and the points on its lattice.
struct PlacedPoints {
  RootSquare root;
  std::vector<LatticePoint> floors;  ///< rounded down
  std::vector<bool> rounded;         ///< where rounding cut something off
};

/// Moves the root square to the left and down by 1/x and 1/y of a sixteenth of its side, rounded
/// down to 2^-26 of the side; 0 for none.
struct RootShift {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// Chooses the root square.
///
/// Guarantees: 1. the side is a power of two and the corner a multiple of a sixteenth of it, so
/// that all cell corners, centres and extra points are dyadic in the coordinates of the input. 2.
/// the side is at least 3/2 of the extent of the points and every point is at least a tenth of it
/// inside.
/// 3. scaling the points by a power of two (with no overflow or underflow) scales the square by it;
/// translating them by a multiple of a sixteenth of the side translates the square by it as long as
/// the points keep all their bits.
/// With a shift, 1 holds for multiples of 2^-26, and 2 for a twelfth.
/// Requires: at least one point; all finite.
PlacedPoints place_root(const std::vector<Point>& points, RootShift shift = {});

struct SeparatedTree {
  Quadtree tree;
  std::vector<Cell> cell_of_point;
  std::uint64_t refinement_splits = 0;
};

/// Builds the tree.
///
/// Guarantees: 1. every point lies in a leaf of its own, in the centre of a 5x5 grid of leaves of
/// the same size, the 24 others empty; the 3x3 grids of different points are disjoint. 2. the tree
/// is balanced. 3. it is the smallest tree with conditions A, B, C (before the grids are made),
/// hence independent of the order of the points. Requires: distinct points. Throws:
/// TreeBudgetExceeded.
SeparatedTree separate_points(const PlacedPoints& placed, GridRefinement refinement,
                              const Budget& budget);

/// Names the first broken part of guarantees 1 and 2; nullopt if all hold. For tests.
std::optional<std::string> broken_separation(const SeparatedTree& separated);

}  // namespace quadbound
