// SPDX-License-Identifier: Apache-2.0
#include "algo/point_separation.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>

#include "algo/separation.hpp"
#include "model/mesh.hpp"

namespace quadbound {
namespace {

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

std::int64_t shifted_by(std::int64_t part, std::int64_t side) {
  return part == 0 ? 0 : (side / (16 * part)) & -std::max<std::int64_t>(1, side >> 26);
}

/// Any 56 bits of the largest coordinate tell where the root square may be; the margin of 4 bits
/// keeps the sums below inside the lattice.
constexpr int kCoarseBits = 56;

}  // namespace

PlacedPoints place_root(const std::vector<Point>& points, RootShift shift) {
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
  const LatticePoint corner{square_start(x, side) - shifted_by(shift.x, side),
                            square_start(y, side) - shifted_by(shift.y, side)};
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

SeparatedTree separate_points(const PlacedPoints& placed, GridRefinement refinement,
                              const Budget& budget) {
  Separation separation(placed, budget);
  separation.apply_conditions();
  const std::size_t before = separation.tree().blocks().size();
  if (refinement == GridRefinement::kSixBySix) {
    separation.refine_six_by_six();
  } else {
    separation.refine_five_by_five();
  }
  const std::uint64_t refined = separation.tree().blocks().size() - before;
  std::vector<Cell> cells = separation.cell_of_point();
  return {std::move(separation).take_tree(), std::move(cells), refined};
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
