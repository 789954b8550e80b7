// SPDX-License-Identifier: Apache-2.0
// Where holes go, and families that are mostly holes: plate, needle, clusters.
#include <algorithm>
#include <cmath>

#include "generators/edge_grid.hpp"
#include "generators/polygon_families.hpp"
#include "generators/unit_circle.hpp"

namespace quadbound::generators {

namespace {

constexpr std::int64_t kHoleSides = 6;
constexpr double kSmallestHole = 8;  ///< radius; below, the lattice would distort a hexagon

}  // namespace

std::vector<LatticeRing> holes_on_circle(const PolygonMaker& maker, double radius) {
  std::vector<LatticeRing> holes;
  const std::int64_t count = maker.parameter("holes");
  const double size = radius / static_cast<double>(count + 1);
  maker.require(count == 0 || size >= kSmallestHole, "too many holes for the polygon's size");
  for (std::int64_t i = 0; i < count; ++i)
    holes.push_back(
        regular(at({0, 0}, radius, direction_of_turn(i, count)), size, kHoleSides, 7 * i % 64));
  return holes;
}

std::vector<LatticeRing> holes_in_row(const PolygonMaker& maker, std::int64_t left,
                                      std::int64_t right, std::int64_t y, std::int64_t room) {
  std::vector<LatticeRing> holes;
  const std::int64_t count = maker.parameter("holes");
  if (count == 0) return holes;
  const std::int64_t step = (right - left) / count;
  const auto size = static_cast<double>(std::min(step / 4, room / 4));
  maker.require(size >= kSmallestHole, "too many holes for the polygon's size");
  for (std::int64_t i = 0; i < count; ++i)
    holes.push_back(regular({left + step * i + step / 2, y}, size, kHoleSides, 7 * i % 64));
  return holes;
}

std::vector<LatticeRing> holes_anywhere(PolygonMaker& maker, const LatticeRing& outer) {
  std::vector<LatticeRing> holes;
  const std::int64_t count = maker.parameter("holes");
  if (count == 0) return holes;
  std::vector<LatticePoint> points = outer;
  const LatticeBox box = box_around(outer);
  EdgeGrid grid(points, box, outer.size() + static_cast<std::size_t>(count * kHoleSides));
  grid.insert_ring(0, outer.size());
  for (std::int64_t tries = 200 * count + 2000; std::ssize(holes) < count; --tries) {
    maker.require(tries > 0, "no room found for that many holes");
    const LatticePoint centre{maker.random.between(box.low.x, box.high.x),
                              maker.random.between(box.low.y, box.high.y)};
    const double size =
        grid.clearance(centre) * static_cast<double>(maker.random.between(25, 75)) / 100;
    if (size < kSmallestHole || !grid.inside(centre)) continue;
    holes.push_back(regular(centre, size, kHoleSides, maker.random.between(0, 63)));
    points.insert(points.end(), holes.back().begin(), holes.back().end());
    grid.insert_ring(points.size() - kHoleSides, points.size());
  }
  return holes;
}

/// A square plate with round holes in rows.
LatticePolygon make_plate(PolygonMaker& maker) {
  const std::int64_t holes = std::max<std::int64_t>(1, maker.parameter("holes"));
  std::int64_t rows = 1;
  while (rows * rows < holes) ++rows;
  const std::int64_t pitch = 2 * kUnit / rows;
  maker.require(pitch >= 64, "too many holes");
  LatticePolygon polygon;
  polygon.outer = {{0, 0}, {rows * pitch, 0}, {rows * pitch, rows * pitch}, {0, rows * pitch}};
  for (std::int64_t i = 0; i < holes; ++i) {
    const LatticePoint centre{i % rows * pitch + pitch / 2, i / rows * pitch + pitch / 2};
    polygon.holes.push_back(
        regular(centre, static_cast<double>(pitch) / 4, maker.parameter("sides")));
  }
  return polygon;
}

namespace {

/// A rhombus around a place, as long and as wide as said.
LatticeRing rhombus(LatticePoint centre, double length, double width, Point along) {
  const Point across{-along.y, along.x};
  return {at(centre, length / 2, along), at(centre, width / 2, across),
          at(centre, -length / 2, along), at(centre, -width / 2, across)};
}

}  // namespace

namespace {

/// The directions of needles: any, and the multiples of 45 degrees, in turns.
Point needle_direction(PolygonMaker& maker, bool any) {
  return any ? direction_of_turn(maker.random.bits(20), kUnit)
             : direction_of_turn(maker.random.between(0, 7), 8);
}

}  // namespace

/// Needles on a square grid, each inside a circle of its own; every other one is parallel to an
/// axis or a diagonal.
LatticePolygon make_needle(PolygonMaker& maker) {
  const std::int64_t holes = maker.parameter("holes");
  std::int64_t rows = 1;
  while (rows * rows < holes) ++rows;
  // A square inside the polygon.
  const double inradius = static_cast<double>(kUnit) * direction_of_turn(1, 2 * maker.n).x;
  const auto pitch = static_cast<std::int64_t>(1.4 * inradius) / rows;
  const double width =
      std::ldexp(static_cast<double>(kUnit), -static_cast<int>(maker.parameter("depth")));
  maker.require(4 * width <= static_cast<double>(pitch),
                "too many holes for needles of this width");
  LatticePolygon polygon{regular({0, 0}, static_cast<double>(kUnit), maker.n), {}};
  for (std::int64_t i = 0; i < holes; ++i) {
    const LatticePoint centre{(2 * (i % rows) + 1 - rows) * pitch / 2,
                              (2 * (i / rows) + 1 - rows) * pitch / 2};
    const double length = static_cast<double>(pitch * maker.random.between(50, 90)) / 100;
    polygon.holes.push_back(rhombus(centre, length, width, needle_direction(maker, i % 2 == 0)));
  }
  return polygon;
}

namespace {

/// Hexagons of different sizes in random cells of a square grid with about twice as many cells.
void add_cluster(PolygonMaker& maker, LatticePoint centre, std::int64_t count,
                 std::int64_t half_side, std::vector<LatticeRing>& holes) {
  std::int64_t rows = 1;
  while (rows * rows < 2 * count) ++rows;
  const std::int64_t pitch = 2 * half_side / rows;
  maker.require(static_cast<double>(pitch) * 0.1 >= kSmallestHole,
                "too many holes for clusters of this size");
  std::vector<std::int64_t> cells(static_cast<std::size_t>(rows * rows));
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = static_cast<std::int64_t>(i);
  maker.random.shuffle(cells);
  cells.resize(static_cast<std::size_t>(count));
  for (const std::int64_t cell : cells) {
    const LatticePoint place{centre.x - half_side + (2 * (cell % rows) + 1) * pitch / 2,
                             centre.y - half_side + (2 * (cell / rows) + 1) * pitch / 2};
    const double size = static_cast<double>(pitch * maker.random.between(10, 48)) / 100;
    holes.push_back(regular(place, size, kHoleSides, maker.random.between(0, 63)));
  }
}

}  // namespace

/// Square clusters evenly spaced on a circle.
LatticePolygon make_clusters(PolygonMaker& maker) {
  const std::int64_t holes = maker.parameter("holes");
  const std::int64_t clusters = std::min(maker.parameter("clusters"), holes);
  const std::int64_t half_side = kUnit >> maker.parameter("spread");
  const auto radius = static_cast<double>(kUnit) * 0.55;
  // Half the distance between two centres must hold half a diagonal.
  maker.require(clusters < 2 || radius * direction_of_turn(1, 2 * clusters).y >
                                    1.5 * static_cast<double>(half_side),
                "too many clusters of this size");
  LatticePolygon polygon{regular({0, 0}, static_cast<double>(kUnit), maker.n), {}};
  for (std::int64_t i = 0; i < clusters; ++i)
    add_cluster(maker, at({0, 0}, radius, direction_of_turn(i, clusters)),
                (i + 1) * holes / clusters - i * holes / clusters, half_side, polygon.holes);
  return polygon;
}

}  // namespace quadbound::generators
