// SPDX-License-Identifier: Apache-2.0
#include "generators/polygons.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "generators/points.hpp"
#include "generators/unit_circle.hpp"
#include "model/predicates.hpp"
#include "model/validate.hpp"

namespace quadbound {
namespace {

Polygon made(const std::string& recipe) { return generate_polygon(parse_polygon_recipe(recipe)); }

std::uint64_t hash(const Polygon& polygon) {
  std::uint64_t h = 0xcbf29ce484222325U;
  for (const Ring& ring : polygon.rings)
    for (const Point& p : ring)
      for (const double value : {p.x, p.y})
        h = (h ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3U;
  return h;
}

/// The number of holes nearest to `wanted` that the family takes.
std::int64_t fitting_holes(const FamilyDescription& family, std::int64_t wanted) {
  const Parameter& holes = family.parameters.front();
  EXPECT_EQ(holes.name, "holes") << family.name;
  return std::clamp(wanted, holes.smallest, holes.largest);
}

/// How many rings there are with so many holes asked for.
std::size_t rings(const FamilyDescription& family, std::int64_t holes) {
  const bool one_at_least = family.name == "annulus" || family.name == "plate";
  return 1 + static_cast<std::size_t>(one_at_least ? std::max<std::int64_t>(1, holes) : holes);
}

TEST(Polygons, EveryFamilyDeliversValidPolygonsOfTheSizeAsked) {
  std::mt19937_64 engine(1);
  for (const FamilyDescription& family : polygon_families()) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const std::uint64_t n = fitting(family.sizes, 24 + engine() % 200);
      const std::int64_t holes = fitting_holes(family, static_cast<std::int64_t>(seed % 4));
      const Polygon polygon =
          made(fmt::format("{}:n={},seed={},holes={}", family.name, n, seed, holes));
      EXPECT_NO_THROW(validate(polygon)) << polygon.file;
      EXPECT_EQ(polygon.rings.front().size(), n) << polygon.file;
      if (family.name != "glyph") {
        EXPECT_EQ(polygon.rings.size(), rings(family, holes)) << polygon.file;
      }
    }
  }
}

TEST(Polygons, ManyVerticesAndHoles) {
  for (const FamilyDescription& family : polygon_families()) {
    const std::uint64_t n = fitting(family.sizes, 5000);
    const std::int64_t holes = fitting_holes(family, 40);
    const Polygon polygon = made(fmt::format("{}:n={},seed=9,holes={}", family.name, n, holes));
    EXPECT_EQ(polygon.rings.front().size(), n) << polygon.file;
    if (family.name != "glyph") {
      EXPECT_EQ(polygon.rings.size(), rings(family, holes)) << polygon.file;
    }
  }
}

TEST(Polygons, SmallestSizes) {
  for (const FamilyDescription& family : polygon_families()) {
    // With their default numbers of slits and corners these two need more.
    if (family.name == "slit" || family.name == "collinear") continue;
    for (std::uint64_t i = 0; i < 12; ++i) {
      const std::uint64_t n = fitting(family.sizes, family.sizes.smallest + i);
      for (std::uint64_t seed = 1; seed <= 10; ++seed)
        EXPECT_EQ(made(fmt::format("{}:n={},seed={}", family.name, n, seed)).rings[0].size(), n);
    }
  }
}

TEST(Polygons, ExtremeParametersAreValidOrRefused) {
  for (const FamilyDescription& family : polygon_families()) {
    for (const Parameter& parameter : family.parameters) {
      // More than 3000 holes, or vertices of a hole, would only take time.
      const bool count = parameter.largest == 10'000 || parameter.largest == 100'000;
      for (const std::int64_t value : {parameter.smallest, count ? 3000 : parameter.largest}) {
        const std::string recipe = fmt::format("{}:n={},seed=3,{}={}", family.name,
                                               fitting(family.sizes, 48), parameter.name, value);
        try {
          validate(made(recipe));
        } catch (const RecipeError& error) {
          EXPECT_NE(std::string(error.what()).find(family.name), std::string::npos);
        }
      }
    }
  }
}

TEST(Polygons, SameRecipeSameBytes) {
  // deterministic: recorded once; another machine, library or optimisation level must agree.
  const std::map<std::string_view, std::uint64_t> recorded{
      {"star", 8591104987252567301U},
      {"regular", 15794131975801318661U},
      {"gear", 12904439822563060997U},
      {"annulus", 14888316323190519589U},
      {"sharp", 11166528980373646597U},
      {"notch", 13289292961281387781U},
      {"slit", 11905553437376818437U},
      {"blob", 7573332393915231493U},
      {"x-monotone", 3116668169155423493U},
      {"orthogonal", 1980482992459918597U},
      {"grid-aligned", 7111514523584343301U},
      {"near-grid", 4367662271259127045U},
      {"comb", 16456722791077948677U},
      {"spiral-band", 17209289995265568037U},
      {"obtuse-spiral", 17049546896332729605U},
      {"collinear", 10561208049295863045U},
      {"slopes", 16355552201950529957U},
      {"two-opt", 15970807474156907781U},
      {"space-partition", 8385978964103310597U},
      {"growth", 9328331115679100165U},
      {"coast", 244724882368539909U},
      {"koch", 8565846083928453757U},
      {"plate", 10680049408079446981U},
      {"needle", 15476946495986249317U},
      {"clusters", 11011468617899748613U},
      {"glyph", 10182641250385849637U},
  };
  EXPECT_EQ(recorded.size(), polygon_families().size());
  for (const FamilyDescription& family : polygon_families()) {
    const std::string recipe = fmt::format("{}:n={},seed=5,holes={}", family.name,
                                           fitting(family.sizes, 64), fitting_holes(family, 2));
    EXPECT_EQ(hash(made(recipe)), recorded.at(family.name)) << recipe;
  }
}

TEST(Polygons, SeedsMatterWhereThereIsChance) {
  const std::set<std::string_view> fixed{"regular",     "gear",          "notch", "comb",
                                         "spiral-band", "obtuse-spiral", "koch",  "plate"};
  for (const FamilyDescription& family : polygon_families()) {
    const std::uint64_t n = fitting(family.sizes, 64);
    const bool same = hash(made(fmt::format("{}:n={},seed=1", family.name, n))) ==
                      hash(made(fmt::format("{}:n={},seed=2", family.name, n)));
    EXPECT_EQ(same, fixed.contains(family.name)) << family.name;
  }
}

TEST(Polygons, ARecipeTellsPolygonsFromPointSets) {
  for (const FamilyDescription& family : polygon_families())
    for (const FamilyDescription& points : point_families()) EXPECT_NE(family.name, points.name);
}

TEST(Polygons, WhatAFamilyCannotHaveIsRefused) {
  for (const char* recipe : {"gear:n=13",
                             "gear:n=8",
                             "plate:n=5",
                             "spiral-band:n=7",
                             "spiral-band:n=8,holes=1",
                             "annulus:n=8,holes=2",
                             "comb:n=6",
                             "star:n=3",
                             "regular:n=2",
                             "two-opt:n=20001",
                             "koch:n=4",
                             "koch:n=12,height=290",
                             "slit:n=20,slits=6",
                             "slit:n=40,reflex=36000",
                             "collinear:n=7",
                             "collinear:n=200000",
                             "slopes:n=5",
                             "obtuse-spiral:n=7",
                             "obtuse-spiral:n=20,holes=10",
                             "blob:n=4",
                             "clusters:n=12,clusters=60,holes=60,spread=3",
                             "needle:n=6,depth=4,holes=100",
                             "growth:n=3,holes=-1",
                             "coast:n=20,rough=61",
                             "star:n=20,holes=10000",
                             "glyph:n=20,character=105",
                             "glyph:n=3,character=73",
                             "glyph:n=20,character=32"})
    EXPECT_THROW(made(recipe), RecipeError) << recipe;
}

TEST(Polygons, ALatticeTooCoarseIsNamed) {
  for (const char* recipe : {"star:n=1000000,low=5", "sharp:n=20000,depth=16"}) {
    try {
      const Polygon polygon = made(recipe);
      FAIL() << recipe;
    } catch (const RecipeError& error) {
      EXPECT_EQ(std::string(error.what()).find(std::string(recipe).substr(0, 5)), 0U)
          << error.what();
    }
  }
}

// --- what single families promise ---

/// Calls with each corner's vertex before, vertex and vertex after.
template <class Call>
void for_each_corner(const Ring& ring, Call call) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    call(ring[(i + ring.size() - 1) % ring.size()], ring[i], ring[(i + 1) % ring.size()]);
}

/// The angle on the left of a corner in degrees.
double angle(const Point& before, const Point& at, const Point& after) {
  const Point in{before.x - at.x, before.y - at.y};
  const Point out{after.x - at.x, after.y - at.y};
  const double turned = std::atan2(out.x * in.y - out.y * in.x, in.x * out.x + in.y * out.y);
  return (turned < 0 ? turned + 2 * M_PI : turned) * 180 / M_PI;
}

TEST(Polygons, BlobsAndSpiralsHaveNoAcuteAngle) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const char* recipe :
         {"blob:n=9,waves=20", "blob:n=300,swing=90,waves=10", "blob:n=20000", "obtuse-spiral:n=33",
          "obtuse-spiral:n=100,sides=12", "obtuse-spiral:n=10001", "obtuse-spiral:n=8",
          "obtuse-spiral:n=60,sides=7"}) {
      const Polygon polygon = made(fmt::format("{},seed={}", recipe, seed));
      for_each_corner(polygon.rings[0], [&](const Point& a, const Point& b, const Point& c) {
        EXPECT_GE(angle(a, b, c), 90) << polygon.file;
      });
    }
}

TEST(Polygons, SlitsHaveTheirReflexAngle) {
  for (const std::int64_t reflex : {34'000, 35'000, 35'900, 35'990, 35'999}) {
    const Polygon polygon =
        made(fmt::format("slit:n=60,seed=4,slits=11,reflex={},holes=2", reflex));
    std::int64_t slits = 0;
    for_each_corner(polygon.rings[0], [&](const Point& a, const Point& b, const Point& c) {
      const double opening = 360 - angle(a, b, c);
      if (opening > 25) return;
      ++slits;
      // To within what the lattice resolves at the slit's mouth.
      const double expected = 360 - static_cast<double>(reflex) / 100;
      EXPECT_NEAR(opening, expected, 0.05 * expected);
    });
    EXPECT_EQ(slits, 11);
  }
}

TEST(Polygons, SlopesAreExact) {
  const std::set<std::pair<std::int64_t, std::int64_t>> allowed{
      {1, 0}, {0, 1}, {1, 1}, {7, 1}, {1, 7}, {3, 1}, {1, 3}, {2, 1}, {1, 2}, {4, 3}, {3, 4}};
  std::set<std::pair<std::int64_t, std::int64_t>> seen;
  for (const char* recipe : {"slopes:n=200,seed=1,holes=3", "slopes:n=4000,seed=2,turn=1"}) {
    const Polygon polygon = made(recipe);
    for (const Ring& ring : polygon.rings)
      for_each_corner(ring, [&](const Point&, const Point& a, const Point& b) {
        const auto x = std::llround(std::ldexp(std::abs(b.x - a.x), 20));
        const auto y = std::llround(std::ldexp(std::abs(b.y - a.y), 20));
        const std::int64_t common = std::gcd(x, y);
        EXPECT_TRUE(allowed.contains({x / common, y / common})) << x << ' ' << y;
        seen.insert({x / common, y / common});
      });
  }
  EXPECT_EQ(seen, allowed);
}

TEST(Polygons, CollinearChainsAreExactOnEveryOtherSide) {
  for (const char* recipe : {"collinear:n=400,seed=1,off=0", "collinear:n=400,seed=1,off=5"}) {
    std::int64_t straight = 0;
    std::int64_t nearly = 0;
    for_each_corner(made(recipe).rings[0], [&](const Point& a, const Point& b, const Point& c) {
      const bool exact = orientation(a, b, c) == 0;
      straight += exact;
      nearly += !exact && std::abs(angle(a, b, c) - 180) < 1;
    });
    const bool all = std::string(recipe).ends_with("off=0");
    EXPECT_EQ(straight >= 392, all) << straight;
    EXPECT_GE(straight, 196);
    EXPECT_EQ(nearly >= 100, !all) << nearly;
  }
}

TEST(Polygons, KochEdgesAreOfOneLengthAtFullDepth) {
  const Ring ring = made("koch:n=768,seed=1").rings[0];
  double shortest = 1;
  double longest = 0;
  for_each_corner(ring, [&](const Point&, const Point& a, const Point& b) {
    shortest = std::min(shortest, std::hypot(b.x - a.x, b.y - a.y));
    longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
  });
  EXPECT_NEAR(longest, std::sqrt(3) / 81, 1e-4);
  EXPECT_LT(longest, 1.005 * shortest);
}

TEST(Polygons, GridPerturbedStaysNearItsGrid) {
  const Polygon polygon = made("near-grid:n=100,seed=7,level=5,amplitude=6");
  for (const Point& p : polygon.rings[0])
    for (const double value : {p.x, p.y})
      EXPECT_LE(std::abs(value - std::round(value * 32) / 32), std::ldexp(1.0, -11));
}

/// Corners of the font's own points, which are multiples of 2^-11.
TEST(Polygons, GlyphsHaveThePointsOfTheFont) {
  const Ring bar = made("glyph:n=4,character=73").rings[0];  // I
  for (const Point& p : bar)
    for (const double value : {p.x, p.y}) EXPECT_EQ(value * 2048, std::round(value * 2048));
  EXPECT_EQ(bar[0].y, 0);
  EXPECT_EQ(made("glyph:n=9,character=73").rings[0].size(), 9U);
  for (const auto& [character, rings] : {std::pair{'o', 2U}, {'B', 3U}, {'S', 1U}, {'8', 3U}})
    for (const int font : {0, 1, 2, 3, 4, 5}) {
      const Polygon polygon =
          made(fmt::format("glyph:n=70,character={},font={}", int{character}, font));
      EXPECT_EQ(polygon.rings.size(), rings) << polygon.file;
    }
  EXPECT_GT(made("glyph:n=40,character=111,pieces=8").rings[1].size(),
            made("glyph:n=40,character=111,pieces=2").rings[1].size());
}

TEST(Polygons, CharactersThatAreNoPolygonSayWhy) {
  const auto why = [](const std::string& recipe) {
    try {
      return made(recipe).file;
    } catch (const RecipeError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_NE(why("glyph:n=80,character=105").find("not one piece"), std::string::npos);  // i
  EXPECT_NE(why("glyph:n=80,character=65535").find("no such char"), std::string::npos);
  EXPECT_NE(why("glyph:n=80,character=32").find("blank"), std::string::npos);
  EXPECT_NE(why("glyph:n=8,character=83").find("n must be "), std::string::npos);
}

TEST(UnitCircle, DirectionsHaveLengthOneAndTheRightAngle) {
  for (std::int64_t i = 0; i < 1000; ++i) {
    const Point p = direction_of_turn(i, 1000);
    EXPECT_NEAR(std::hypot(p.x, p.y), 1, 4e-16);
    const double turned = std::atan2(p.y, p.x) / 6.283185307179586;
    EXPECT_NEAR(turned < -1e-12 ? turned + 1 : turned, static_cast<double>(i) / 1000, 4e-16);
  }
  EXPECT_EQ(direction_of_turn(3, 4), (Point{0, -1}));
}

}  // namespace
}  // namespace quadbound
