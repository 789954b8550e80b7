// SPDX-License-Identifier: Apache-2.0
#include "generators/edge_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generators/unit_circle.hpp"
#include "model/predicates.hpp"

namespace quadbound::generators {
namespace {

Point to_point(LatticePoint p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

/// The points of a grid in random order: many are on one line.
std::vector<LatticePoint> crowded_points(RandomIntegers& random, std::int64_t size) {
  std::vector<LatticePoint> points;
  for (std::int64_t x = 0; x < size; ++x)
    for (std::int64_t y = 0; y < size; ++y) points.push_back({3 * x - 7, 5 * y - 11});
  random.shuffle(points);
  return points;
}

/// What conflict() must find: a common point that is not a common end.
bool meet_beyond_ends(const std::vector<LatticePoint>& points, VertexEdge e, VertexEdge f) {
  const Point a = to_point(points[e.from]);
  const Point b = to_point(points[e.to]);
  const Point c = to_point(points[f.from]);
  const Point d = to_point(points[f.to]);
  if (a != c && a != d && b != c && b != d) return meeting(a, b, c, d) != Meeting::kApart;
  const Point common = a == c || a == d ? a : b;
  const Point one = common == a ? b : a;
  const Point other = common == c ? d : c;
  return orientation(common, one, other) == 0 &&
         (one.x - common.x) * (other.x - common.x) + (one.y - common.y) * (other.y - common.y) > 0;
}

TEST(EdgeGrid, ConflictsAreThoseOfEveryPair) {
  RandomIntegers random(1);
  const std::vector<LatticePoint> points = crowded_points(random, 9);
  const auto index = [&] { return static_cast<std::uint32_t>(random.below(points.size())); };
  EdgeGrid grid(points, box_around(points), 200);
  std::vector<VertexEdge> edges;
  std::size_t conflicts = 0;
  for (int i = 0; i < 4000; ++i) {
    const VertexEdge edge{index(), index()};
    if (edge.from == edge.to || std::ranges::find(edges, edge) != edges.end()) continue;
    const bool expected = std::ranges::any_of(
        edges, [&](VertexEdge other) { return meet_beyond_ends(points, edge, other); });
    const auto found = grid.conflict(edge);
    ASSERT_EQ(found.has_value(), expected);
    if (found) {
      ++conflicts;
      EXPECT_TRUE(meet_beyond_ends(points, edge, *found));
    }
    grid.insert(edge);
    edges.push_back(edge);
    while (edges.size() > 6) {
      const std::size_t out = random.below(edges.size());
      grid.remove(edges[out]);
      edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(out));
    }
  }
  EXPECT_GT(conflicts, 1000U);
  EXPECT_LT(conflicts, 3900U);
}

/// A ring around the origin, far from round.
std::vector<LatticePoint> wild_ring(RandomIntegers& random, std::int64_t n) {
  std::vector<LatticePoint> points;
  for (std::int64_t i = 0; i < n; ++i)
    points.push_back(
        at({500, -300}, static_cast<double>(random.between(100, 4000)), direction_of_turn(i, n)));
  return points;
}

double distance(Point p, Point a, Point b) {
  const double length = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
  const double t =
      std::clamp(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length, 0.0, 1.0);
  return std::hypot(p.x - a.x - t * (b.x - a.x), p.y - a.y - t * (b.y - a.y));
}

TEST(EdgeGrid, ClearanceAndInsideAgreeWithEveryEdge) {
  RandomIntegers random(2);
  for (const std::int64_t n : {3, 20, 400}) {
    const std::vector<LatticePoint> points = wild_ring(random, n);
    const LatticeBox box = box_around(points);
    EdgeGrid grid(points, box, points.size());
    grid.insert_ring(0, points.size());
    Ring ring;
    for (const LatticePoint p : points) ring.push_back(to_point(p));
    for (int i = 0; i < 500; ++i) {
      const LatticePoint place{random.between(box.low.x, box.high.x),
                               random.between(box.low.y, box.high.y)};
      double nearest = 1e9;
      for (std::size_t v = 0; v < ring.size(); ++v)
        nearest =
            std::min(nearest, distance(to_point(place), ring[v], ring[(v + 1) % ring.size()]));
      EXPECT_NEAR(grid.clearance(place), nearest, 1e-6 * (1 + nearest));
      if (nearest > 0.1) {
        EXPECT_EQ(grid.inside(place), strictly_inside(to_point(place), ring));
      }
    }
  }
}

TEST(EdgeGrid, EdgesOutsideTheBoxAreFoundToo) {
  const std::vector<LatticePoint> points{{0, 0},    {10, 10},   {-90, 40},
                                         {70, -80}, {-50, -50}, {80, 90}};
  EdgeGrid grid(points, {{0, 0}, {10, 10}}, 100);
  grid.insert({2, 3});
  EXPECT_TRUE(grid.conflict({4, 5}));
  EXPECT_FALSE(grid.conflict({3, 5}));
}

}  // namespace
}  // namespace quadbound::generators
