// SPDX-License-Identifier: Apache-2.0
#include "generators/family_statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "generators/polygons.hpp"

namespace quadbound {
namespace {

FamilyStatistics of(const Polygon& polygon) {
  FamilyStatistics statistics;
  statistics.add(polygon);
  return statistics;
}

/// A square of side 8 with a vertex in the middle of a side, and a triangular hole near the left.
Polygon frame() {
  return {"frame", {{{0, 0}, {4, 0}, {8, 0}, {8, 8}, {0, 8}}, {{1, 4}, {3, 6}, {5, 4}}}};
}

TEST(FamilyStatistics, ASquareWithAHole) {
  const FamilyStatistics s = of(frame());
  EXPECT_EQ(s.vertices, 8U);
  EXPECT_EQ(s.holes, 1U);
  EXPECT_EQ(s.straight, 1U);
  EXPECT_DOUBLE_EQ(s.smallest_angle, 90);
  EXPECT_DOUBLE_EQ(s.largest_angle, 315);
  EXPECT_DOUBLE_EQ(s.smallest_feature, 1.0 / 8);
  EXPECT_EQ(s.features[0], 1U);
  EXPECT_DOUBLE_EQ(s.smallest_edge_ratio, std::sqrt(8.0) / 8);
  EXPECT_EQ(s.edges[0], 1U);
  EXPECT_DOUBLE_EQ(s.acute_share(), 0);
  EXPECT_DOUBLE_EQ(s.reflex_share(), 3.0 / 8);
}

TEST(FamilyStatistics, ClassesAreHalfOpenAndHoldEverything) {
  const double tiny = std::ldexp(1.0, -30);
  const FamilyStatistics s = of({"sliver", {{{0, 0}, {1, 0}, {1, tiny}}}});
  EXPECT_EQ(s.angles.front(), 1U);
  EXPECT_EQ(s.features.back(), 1U);
  EXPECT_EQ(s.edges.back(), 1U);
  for (const FamilyDescription& family : polygon_families()) {
    const PolygonRecipe recipe{std::string(family.name), fitting(family.sizes, 60), 1, {}};
    const FamilyStatistics f = of(generate_polygon(recipe));
    EXPECT_EQ(std::accumulate(f.angles.begin(), f.angles.end(), f.straight), f.vertices)
        << family.name;
  }
}

double naive_feature_size(const Polygon& polygon) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Ring& ring : polygon.rings)
    for (const Point& p : ring)
      for (const Ring& other : polygon.rings)
        for (std::size_t i = 0; i < other.size(); ++i) {
          const Point& a = other[i];
          const Point& b = other[(i + 1) % other.size()];
          if (p == a || p == b) continue;
          const double length = std::hypot(b.x - a.x, b.y - a.y);
          const double along = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length;
          const double height = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
          double distance = std::abs(height) / length;
          if (along < 0) distance = std::hypot(p.x - a.x, p.y - a.y);
          if (along > length) distance = std::hypot(p.x - b.x, p.y - b.y);
          smallest = std::min(smallest, distance);
        }
  return smallest;
}

TEST(FamilyStatistics, TheSmallestFeatureIsThatOfAllPairs) {
  for (const FamilyDescription& family : polygon_families())
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const PolygonRecipe recipe{std::string(family.name), fitting(family.sizes, 60), seed, {}};
      const Polygon polygon = generate_polygon(recipe);
      const double naive = naive_feature_size(polygon);
      EXPECT_NEAR(smallest_feature_size(polygon), naive, 1e-9 * naive + 1e-15) << polygon.file;
    }
}

TEST(FamilyStatistics, MergedIsAdded) {
  const Polygon other = generate_polygon(parse_polygon_recipe("star:n=20,seed=3"));
  FamilyStatistics one = of(frame());
  one.merge(of(other));
  FamilyStatistics both;
  both.add(other);
  both.add(frame());
  EXPECT_EQ(one.polygons, both.polygons);
  EXPECT_EQ(one.angles, both.angles);
  EXPECT_EQ(one.features, both.features);
  EXPECT_EQ(one.smallest_angle, both.smallest_angle);
  EXPECT_EQ(one.largest_edge_ratio, both.largest_edge_ratio);
}

}  // namespace
}  // namespace quadbound
