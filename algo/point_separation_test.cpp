// SPDX-License-Identifier: Apache-2.0
#include "algo/point_separation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "algo/mesh_points.hpp"
#include "algo/template_tree.hpp"

namespace quadbound {
namespace {

std::vector<Point> random_points(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 engine(seed);
  const auto coordinate = [&] { return std::ldexp(static_cast<double>(engine() >> 11), -53); };
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = coordinate();
    points.push_back({x, coordinate()});
  }
  return points;
}

/// The same nodes in the same depth-first order.
bool same_tree(const Quadtree& a, const Quadtree& b) {
  const TemplateTree ta(a);
  const TemplateTree tb(b);
  if (ta.size() != tb.size()) return false;
  for (NodeId node = 0; node < ta.size(); ++node)
    if (ta.children(node) != tb.children(node)) return false;
  return true;
}

constexpr std::array kRefinements{GridRefinement::kSixBySix, GridRefinement::kFiveByFive};

TEST(PlaceRoot, SideIsAPowerOfTwoAndPointsLieWellInside) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    auto points = random_points(seed, 1 + seed % 7);
    const double scale = std::ldexp(1.0, static_cast<int>(seed % 90) - 45);
    const double offset = seed % 3 == 0 ? 0 : static_cast<double>(seed) * 1e6;
    for (Point& p : points) p = {p.x * scale + offset, p.y * scale - offset};
    const PlacedPoints placed = place_root(points);
    const std::int64_t side = std::int64_t{1} << placed.root.side_bits;
    EXPECT_EQ(placed.root.corner.x % (side / 16), 0);
    EXPECT_EQ(placed.root.corner.y % (side / 16), 0);
    for (const LatticePoint p : placed.floors) {
      for (const std::int64_t inside : {p.x - placed.root.corner.x, p.y - placed.root.corner.y}) {
        EXPECT_GE(inside, side / 10 - 1);
        EXPECT_LE(inside, side - side / 10 + 1);
      }
    }
  }
}

TEST(PlaceRoot, ScalesWithPowersOfTwo) {
  const auto points = random_points(5, 50);
  const PlacedPoints placed = place_root(points);
  for (const int exponent : {-300, -7, 3, 400}) {
    std::vector<Point> scaled;
    scaled.reserve(points.size());
    for (const Point p : points)
      scaled.push_back({std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)});
    const PlacedPoints again = place_root(scaled);
    EXPECT_EQ(again.root.corner, placed.root.corner);
    EXPECT_EQ(again.root.side_bits, placed.root.side_bits);
    EXPECT_EQ(again.root.exponent, placed.root.exponent + exponent);
    EXPECT_EQ(again.floors, placed.floors);
  }
}

TEST(PointSeparation, EveryPointIsInTheCentreOfAFiveByFiveGridOfABalancedTree) {
  for (const GridRefinement refinement : kRefinements) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const auto separated =
          separate_points(place_root(random_points(seed, 1 + 3 * seed)), refinement, {});
      EXPECT_EQ(broken_separation(separated), std::nullopt) << seed;
    }
  }
}

TEST(PointSeparation, PointsOnCellCornersAndBordersAreSeparatedToo) {
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) points.push_back({i / 8.0, j / 8.0 + (i == j ? 1.0 / 64 : 0)});
  for (const GridRefinement refinement : kRefinements) {
    const auto separated = separate_points(place_root(points), refinement, {});
    EXPECT_EQ(broken_separation(separated), std::nullopt);
  }
}

TEST(PointSeparation, TheTreeDoesNotDependOnTheOrderOfThePoints) {
  for (const GridRefinement refinement : kRefinements) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      auto points = random_points(seed, 150);
      const auto forwards = separate_points(place_root(points), refinement, {});
      std::reverse(points.begin(), points.end());
      std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(seed), points.end());
      const auto otherwise = separate_points(place_root(points), refinement, {});
      EXPECT_TRUE(same_tree(forwards.tree, otherwise.tree)) << seed;
    }
  }
}

TEST(PointSeparation, ConditionA3IsTightInTheSizeOfTheCells) {
  // Two points at a distance d need cells of side l with 2 sqrt(2) l <= d, and l / 2 after the grid
  // is made; other conditions may ask for one or two halvings more.
  for (int exponent = 0; exponent < 40; ++exponent) {
    const double distance = std::ldexp(1.0, -exponent);
    const auto separated =
        separate_points(place_root({{0, 0}, {distance, 0}, {1, 1}}), GridRefinement::kSixBySix, {});
    const auto side = std::ldexp(
        1.0, separated.tree.side_bits(separated.cell_of_point[0]) + separated.tree.root().exponent);
    EXPECT_LE(std::sqrt(8.0) * 2 * side, distance);
    EXPECT_GE(std::sqrt(8.0) * 2 * side * 8, distance) << exponent;
  }
}

TEST(MeshPoints, BudgetsEndWithARefusalThatSaysWhich) {
  PointSet points{"points", random_points(1, 1000)};
  PointMeshOptions options;
  options.budget.max_cells = 1000;
  auto result = mesh_points(points, options);
  ASSERT_TRUE(std::holds_alternative<Refusal>(result));
  EXPECT_EQ(std::get<Refusal>(result).kind, RefusalKind::kTooManyCells);
  EXPECT_NE(std::get<Refusal>(result).message.find("--max-cells"), std::string::npos);
  options = {};
  options.budget.max_seconds = 0;
  points.points = random_points(1, 20000);
  result = mesh_points(points, options);
  ASSERT_TRUE(std::holds_alternative<Refusal>(result));
  EXPECT_EQ(std::get<Refusal>(result).kind, RefusalKind::kTooMuchTime);
}

TEST(MeshPoints, PointsTooCloseForTheExtentAreRefusedWithTheirPlace) {
  const double tiny = std::ldexp(1.0, -70);
  const auto result = mesh_points({"points", {{0.25, 0.25 * tiny}, {0.25, tiny}, {1, 1}}});
  ASSERT_TRUE(std::holds_alternative<Refusal>(result));
  const Refusal& refusal = std::get<Refusal>(result);
  EXPECT_EQ(refusal.kind, RefusalKind::kTooDeep);
  EXPECT_NEAR(refusal.where.x, 0.25, 1e-9);
  EXPECT_NEAR(refusal.where.y, 0, 1e-9);
  EXPECT_NE(refusal.message.find("too close"), std::string::npos);
}

}  // namespace
}  // namespace quadbound
