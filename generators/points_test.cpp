// SPDX-License-Identifier: Apache-2.0
#include "generators/points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace quadbound {
namespace {

std::vector<Point> points_of(std::string_view recipe) {
  return generate_points(parse_point_recipe(recipe)).points;
}

Recipe recipe_of(std::string_view family, std::uint64_t n, std::uint64_t seed) {
  return {std::string(family), n, seed, {}};
}

/// FNV-1a over the bytes of the coordinates, lowest byte first.
std::uint64_t fingerprint(const std::vector<Point>& points) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const Point& point : points)
    for (const double value : {point.x, point.y})
      for (int shift = 0; shift < 64; shift += 8) {
        hash ^= std::bit_cast<std::uint64_t>(value) >> shift & 0xFF;
        hash *= 0x100000001B3U;
      }
  return hash;
}

void expect_distinct_and_clean(std::vector<Point> points) {
  for (const Point& point : points)
    for (const double value : {point.x, point.y}) {
      EXPECT_TRUE(std::isfinite(value));
      EXPECT_FALSE(value == 0 && std::signbit(value));
    }
  const auto less = [](const Point& a, const Point& b) {
    return std::pair(a.x, a.y) < std::pair(b.x, b.y);
  };
  std::ranges::sort(points, less);
  EXPECT_EQ(std::ranges::adjacent_find(points), points.end());
}

std::string refusal(std::string_view recipe) {
  try {
    points_of(recipe);
  } catch (const RecipeError& error) {
    return error.what();
  }
  return "";
}

TEST(Points, EveryFamilyDeliversDistinctPointsInFullNumber) {
  for (const FamilyDescription& family : point_families())
    for (const std::uint64_t n : {1U, 2U, 3U, 5U, 64U, 1000U, 20011U})
      for (const std::uint64_t seed : {0U, 1U, 12345U}) {
        const PointSet set = generate_points(recipe_of(family.name, n, seed));
        SCOPED_TRACE(set.file);
        EXPECT_EQ(set.points.size(), n);
        expect_distinct_and_clean(set.points);
      }
}

TEST(Points, ParametersAtBothEndsDeliverOrAreRefused) {
  std::size_t delivered = 0;
  for (const FamilyDescription& family : point_families())
    for (const Parameter& parameter : family.parameters)
      for (const std::int64_t value : {parameter.smallest, parameter.largest}) {
        Recipe recipe = recipe_of(family.name, 50, 3);
        recipe.parameters[std::string(parameter.name)] = value;
        SCOPED_TRACE(to_text(recipe));
        try {
          const PointSet set = generate_points(recipe);
          EXPECT_EQ(set.points.size(), 50U);
          expect_distinct_and_clean(set.points);
          ++delivered;
        } catch (const RecipeError& error) {
          EXPECT_NE(std::string(error.what()).find("distinct points"), std::string::npos);
        }
      }
  EXPECT_GE(delivered, 25U);
}

TEST(Points, SameBytesEverywhere) {
  const std::map<std::string_view, std::uint64_t> recorded = {
      {"uniform", 0xccef32c8c4d35167U},        {"clustered", 0x32080f87ee20f046U},
      {"near-duplicate", 0x2aba81dc8801ab7bU}, {"grid", 0xfa3c0e2aecaf77d9U},
      {"grid-perturbed", 0xb38a23bfa9fdfc9bU}, {"lattice-corners", 0x293bbc131dca93efU},
      {"line", 0x77e8ca2a8d2a113aU},           {"circle", 0x66bd189804ba8b41U},
      {"spiral", 0xafdd5a5af92575ffU},         {"exponential", 0xbea47760acc94e31U},
  };
  EXPECT_EQ(recorded.size(), point_families().size());
  for (const FamilyDescription& family : point_families()) {
    const std::uint64_t hash = fingerprint(generate_points(recipe_of(family.name, 1000, 7)).points);
    EXPECT_EQ(hash, recorded.at(family.name)) << family.name << " 0x" << std::hex << hash;
  }
}

TEST(Points, SeedsDiffer) {
  for (const FamilyDescription& family : point_families())
    EXPECT_NE(generate_points(recipe_of(family.name, 100, 1)).points,
              generate_points(recipe_of(family.name, 100, 2)).points)
        << family.name;
}

TEST(Points, DefaultsWrittenOutChangeNothing) {
  for (const FamilyDescription& family : point_families()) {
    const PointSet set = generate_points(recipe_of(family.name, 100, 9));
    EXPECT_EQ(points_of(set.file), set.points) << set.file;
  }
}

TEST(Points, LineIsExactlyCollinear) {
  for (const auto& [dx, dy] : {std::pair(3, 1), std::pair(-7, 0), std::pair(0, 5),
                               std::pair(1 << 20, -1), std::pair(1 << 20, (1 << 20) - 1)}) {
    Recipe recipe = recipe_of("line", 500, 4);
    recipe.parameters = {{"dx", dx}, {"dy", dy}};
    for (const Point& point : generate_points(recipe).points)
      EXPECT_EQ(exact_value(point.x) * dy, exact_value(point.y) * dx);
  }
}

TEST(Points, CircleIsTheCorrectlyRoundedCircle) {
  for (const Point& point : points_of("circle:n=1000,seed=2")) {
    const RationalPoint exact = exact_value(point);
    const Rational error = exact.x * exact.x + exact.y * exact.y - 1;
    EXPECT_LE(abs(error), dyadic(1, -52)) << point.x << ' ' << point.y;
  }
}

TEST(Points, NearDuplicatesAreUnitsApart) {
  const std::vector<Point> points = points_of("near-duplicate:n=1000,seed=2,share=100,offset=1");
  for (std::size_t i = 0; i < points.size(); i += 2) {
    const double dx = points[i + 1].x - points[i].x;
    const double dy = points[i + 1].y - points[i].y;
    EXPECT_TRUE(dx == 0 || dx == std::ldexp(1.0, -52));
    EXPECT_TRUE(dy == 0 || dy == std::ldexp(1.0, -52));
  }
}

TEST(Points, LatticeCornersHoldCornersAndBorders) {
  std::size_t corners = 0;
  const std::vector<Point> points = points_of("lattice-corners:n=1000,seed=2,level=8");
  for (const Point& point : points) {
    const bool x_on = std::ldexp(point.x, 8) == std::floor(std::ldexp(point.x, 8));
    const bool y_on = std::ldexp(point.y, 8) == std::floor(std::ldexp(point.y, 8));
    EXPECT_TRUE(x_on || y_on);
    corners += x_on && y_on ? 1 : 0;
  }
  EXPECT_GT(corners, 300U);
  EXPECT_LT(corners, 700U);
}

TEST(Points, ExponentialSpansItsScales) {
  std::set<int> scales;
  for (const Point& point : points_of("exponential:n=400,seed=2"))
    scales.insert(std::ilogb(std::max(point.x, point.y)));
  EXPECT_EQ(scales.size(), 40U);
  EXPECT_EQ(*scales.begin(), -40);
}

TEST(Recipe, TextAndBack) {
  const std::string text = "clustered:n=100,seed=7,clusters=5,spread=6";
  const Recipe recipe = parse_point_recipe(text);
  EXPECT_EQ(recipe, (Recipe{"clustered", 100, 7, {{"clusters", 5}, {"spread", 6}}}));
  EXPECT_EQ(to_text(recipe), text);
  EXPECT_EQ(parse_point_recipe("clustered:spread=6,clusters=5,seed=7,n=100"), recipe);
  EXPECT_EQ(parse_point_recipe("clustered:n=100,seed=7,clusters=5"), recipe);
  EXPECT_EQ(parse_point_recipe("grid:n=9").seed, 1U);
  EXPECT_EQ(parse_point_recipe("grid:n=9,seed=18446744073709551615").seed, ~std::uint64_t{0});
  for (const FamilyDescription& family : point_families()) {
    const Recipe full = completed(recipe_of(family.name, 10, 3), point_families());
    EXPECT_EQ(parse_point_recipe(to_text(full)), full);
    EXPECT_EQ(completed(full, point_families()), full);
  }
}

TEST(Recipe, BadOnesAreRefused) {
  for (const char* text :
       {"", "uniform", "uniform:", "uniform:seed=1", "uniform:n=0", "uniform:n=100000001",
        "uniform:n=-1", "uniform:n=5,", "uniform:n=5,n=6", "uniform:n=5,seed=x", "uniform:n= 5",
        "uniform:n=5,bits=54", "uniform:n=5,colour=1", "uniform:n=5,bits", "nonsense:n=5",
        "uniform:n=5.0", "uniform:n=5,seed=18446744073709551616", "line:n=5,dx=0,dy=0"})
    EXPECT_NE(refusal(text), "") << text;
  EXPECT_NE(refusal("nonsense:n=5").find("lattice-corners"), std::string::npos);
}

TEST(Recipe, TooFewDistinctPointsAreRefused) {
  EXPECT_NE(refusal("uniform:n=9,bits=2").find("at most half of the 16"), std::string::npos);
  EXPECT_EQ(refusal("uniform:n=8,bits=2"), "");
  EXPECT_NE(refusal("lattice-corners:n=10,level=1"), "");
  EXPECT_NE(refusal("exponential:n=100,octaves=2,bits=2"), "");
}

}  // namespace
}  // namespace quadbound
