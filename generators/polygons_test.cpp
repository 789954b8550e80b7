// SPDX-License-Identifier: Apache-2.0
#include "generators/polygons.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "generators/unit_circle.hpp"
#include "model/validate.hpp"

namespace quadbound {
namespace {

/// A number of vertices near `wanted` that the family can have.
std::int64_t fitting(const std::string& family, std::int64_t wanted) {
  if (family == "plate") return 4;
  return std::max<std::int64_t>(wanted / 4 * 4, 16);
}

std::uint64_t hash(const Polygon& polygon) {
  std::uint64_t h = 0xcbf29ce484222325U;
  for (const Ring& ring : polygon.rings)
    for (const Point& p : ring)
      for (const double value : {p.x, p.y})
        h = (h ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3U;
  return h;
}

TEST(Polygons, EveryFamilyDeliversValidPolygonsOfTheSizeAsked) {
  std::mt19937_64 engine(1);
  for (const FamilyDescription& family : polygon_families()) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const std::int64_t n =
          fitting(std::string(family.name), static_cast<std::int64_t>(engine() % 200));
      const std::int64_t most_holes = family.parameters.front().largest;
      const std::int64_t holes =
          std::min<std::int64_t>(most_holes, static_cast<std::int64_t>(seed % 4));
      const Polygon polygon = generate_polygon(parse_polygon_recipe(
          fmt::format("{}:n={},seed={},holes={}", family.name, n, seed, holes)));
      EXPECT_NO_THROW(validate(polygon)) << polygon.file;
      EXPECT_EQ(polygon.rings.front().size(), static_cast<std::size_t>(n)) << polygon.file;
      const bool own_holes = family.name == "annulus" || family.name == "plate";
      const std::int64_t rings = 1 + (own_holes ? std::max<std::int64_t>(1, holes) : holes);
      EXPECT_EQ(polygon.rings.size(), static_cast<std::size_t>(rings)) << polygon.file;
    }
  }
}

TEST(Polygons, ExtremeParametersAreValidOrRefused) {
  for (const FamilyDescription& family : polygon_families()) {
    for (const Parameter& parameter : family.parameters) {
      if (parameter.name == "holes") continue;
      for (const std::int64_t value : {parameter.smallest, parameter.largest}) {
        const auto recipe =
            fmt::format("{}:n={},seed=3,{}={}", family.name, fitting(std::string(family.name), 48),
                        parameter.name, value);
        try {
          EXPECT_NO_THROW(validate(generate_polygon(parse_polygon_recipe(recipe)))) << recipe;
        } catch (const RecipeError& error) {
          EXPECT_NE(std::string(error.what()).find(family.name), std::string::npos);
        }
      }
    }
  }
}

TEST(Polygons, SameRecipeSameBytes) {
  // deterministic: recorded once; another machine, library or optimisation level must agree.
  std::uint64_t all = 0;
  for (const FamilyDescription& family : polygon_families()) {
    const auto recipe =
        fmt::format("{}:n={},seed=5", family.name, fitting(std::string(family.name), 64));
    all = all * 31 + hash(generate_polygon(parse_polygon_recipe(recipe)));
  }
  EXPECT_EQ(all, 5690784926123569184U);
}

TEST(Polygons, WhatAFamilyCannotHaveIsRefused) {
  for (const char* recipe : {"gear:n=13,seed=1", "plate:n=5,seed=1", "spiral-band:n=7,seed=1",
                             "spiral-band:n=8,seed=1,holes=1", "comb:n=6,seed=1", "star:n=3,seed=1",
                             "regular:n=2,seed=1"})
    EXPECT_THROW(generate_polygon(parse_polygon_recipe(recipe)), RecipeError) << recipe;
}

TEST(UnitCircle, DirectionsHaveLengthOneAndTheRightAngle) {
  for (std::int64_t i = 0; i < 1000; ++i) {
    const Point p = direction_of_turn(i, 1000);
    EXPECT_NEAR(std::hypot(p.x, p.y), 1, 4e-16);
    const double angle = std::atan2(p.y, p.x) / 6.283185307179586;
    EXPECT_NEAR(angle < -1e-12 ? angle + 1 : angle, static_cast<double>(i) / 1000, 4e-16);
  }
  EXPECT_EQ(direction_of_turn(3, 4), (Point{0, -1}));
}

}  // namespace
}  // namespace quadbound
