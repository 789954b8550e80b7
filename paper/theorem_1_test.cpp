// SPDX-License-Identifier: Apache-2.0
// thm-1, case by case: the list, its bounds, its census, and that the bounds can be broken.
#include "algo/theorem_1.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "algo/quadrangulation.hpp"
#include "paper/theorem_1_table.hpp"

namespace quadbound {
namespace {

using At = std::array<RationalPoint, 4>;

bool all_within(const At& at) {
  for (std::size_t i = 0; i < 4; ++i)
    if (!within(corner_at<Rational>(at[i], at[(i + 1) % 4], at[(i + 3) % 4]), kTheorem1))
      return false;
  return true;
}

At positions(const ConfigurationShape& shape) {
  At at;
  for (std::size_t i = 0; i < 4; ++i) at[i] = {shape.at[i][0], shape.at[i][1]};
  return at;
}

/// The moved vertices of a shape somewhere in their ranges; each with a shift of its own.
At moved(const ConfigurationShape& shape, const Rational& half_side, std::mt19937_64& engine) {
  At at = positions(shape);
  for (std::size_t i = 0; i < 4; ++i) {
    constexpr std::int64_t kSteps = 64;
    // One in three at an end: the worst angles are there.
    const std::uint64_t bits = engine();
    std::int64_t step = static_cast<std::int64_t>(bits >> 8 & 127U) - kSteps;
    if (bits % 3 == 0) step = (bits >> 32 & 1U) != 0 ? kSteps : -kSteps;
    const Rational shift = half_side * Rational(step, kSteps);
    if (shape.motion[i] == Motion::kAlongX) at[i].x += shift;
    if (shape.motion[i] == Motion::kAlongY) at[i].y += shift;
  }
  return at;
}

bool has_point(const ConfigurationShape& shape) {
  for (const Motion m : shape.motion)
    if (m == Motion::kPoint) return true;
  return false;
}

/// Half the side of the cells that a moving shape joins, all of one size: such shapes are a side
/// wide, or a quarter more where an extra point sticks out, and all sides are powers of two.
Rational half_side(const ConfigurationShape& shape) {
  std::int64_t width = 0;
  for (const auto& a : shape.at)
    for (const auto& b : shape.at) width = std::max({width, a[0] - b[0], a[1] - b[1]});
  return Rational(static_cast<std::int64_t>(std::bit_floor(static_cast<std::uint64_t>(width))), 2);
}

const std::vector<Configuration>& configurations() {
  static const std::vector<Configuration> list = theorem_1_configurations();
  return list;
}

TEST(Theorem1, EveryConfigurationIsProved) {
  EXPECT_GE(configurations().size(), 60U);
  for (const Configuration& c : configurations()) EXPECT_TRUE(c.proved) << c.name;
}

TEST(Theorem1, NoConfigurationTwice) {
  std::set<std::pair<Construction, ConfigurationShape>> seen;
  for (const Configuration& c : configurations()) {
    EXPECT_EQ(canonical(c.shape), c.shape) << c.name;
    EXPECT_TRUE(seen.emplace(c.construction, c.shape).second) << c.name;
  }
}

/// The verdicts again, without the code that made them.
TEST(Theorem1, StillConfigurationsAreWithinTheBounds) {
  std::size_t still = 0;
  for (const Configuration& c : configurations()) {
    if (c.moves()) continue;
    ++still;
    EXPECT_TRUE(all_within(positions(c.shape))) << c.name;
  }
  EXPECT_GE(still, 40U);
}

TEST(Theorem1, WarpedConfigurationsAreWithinTheBoundsWhereverThePointIs) {
  std::mt19937_64 engine(1);
  std::size_t tried = 0;
  for (const Configuration& c : configurations()) {
    if (!c.moves() || has_point(c.shape)) continue;  // rectangles at the point: see below
    for (int i = 0; i < 500; ++i, ++tried)
      ASSERT_TRUE(all_within(moved(c.shape, half_side(c.shape), engine))) << c.name;
  }
  EXPECT_GE(tried, 5000U);
}

TEST(Theorem1, ExtremesAreTheBoundsAndStitchOneFourReachesThem) {
  Theorem1Table table;  // no trees
  const Corner<Rational> smallest = table.smallest();
  const Corner<Rational> largest = table.largest();
  EXPECT_EQ(arctangent_text(smallest), "arctan(1/2)");
  EXPECT_EQ(arctangent_text(largest), "180 - arctan(1/2)");
  EXPECT_EQ(arctangent_text(table.smallest(Theorem1Table::Of::kStill, "stitch 1|4")),
            "arctan(1/2)");
  EXPECT_EQ(arctangent_text(table.largest(Theorem1Table::Of::kStill, "stitch 1|4")),
            "180 - arctan(1/2)");
}

TEST(Theorem1, MiddleQuadHasThePapersExtremes) {
  Theorem1Table table;
  EXPECT_EQ(arctangent_text(table.smallest(Theorem1Table::Of::kStill, "middle quad")),
            "arctan(8/15)");  // 2 arctan(1/4)
  EXPECT_EQ(arctangent_text(table.largest(Theorem1Table::Of::kStill, "middle quad")),
            "180 - arctan(8/15)");
}

/// A shape with the vertex at its bound moved by a millionth of a unit, across it or away from it.
TEST(Theorem1, AMutatedShapeIsNotProved) {
  constexpr std::int64_t kUnit = 1'000'000;
  std::size_t broken = 0;
  for (const Configuration& c : configurations()) {
    if (c.construction != Construction::kOneFour) continue;
    const std::string extreme = arctangent_text(c.smallest) + arctangent_text(c.largest);
    if (extreme.find("arctan(1/2)") == std::string::npos) continue;
    for (std::size_t vertex = 0; vertex < 4; ++vertex)
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        ConfigurationShape mutated = c.shape;
        for (auto& p : mutated.at) p = {p[0] * kUnit, p[1] * kUnit};
        mutated.at[vertex][0] += dx;
        mutated.at[vertex][1] += dy;
        broken += all_within(positions(mutated)) ? 0U : 1U;
      }
  }
  EXPECT_GE(broken, 4U);
}

TEST(Theorem1, AVertexThatMovesTooFarBreaksTheBound) {
  std::mt19937_64 engine(1);
  bool broken = false;
  for (const Configuration& c : configurations()) {
    if (!c.moves() || has_point(c.shape)) continue;
    for (int i = 0; i < 100; ++i)
      broken = broken || !all_within(moved(c.shape, half_side(c.shape) * Rational(17, 16), engine));
  }
  EXPECT_TRUE(broken);
}

TEST(Theorem1, CensusMeetsEveryConfigurationAndNoOther) {
  NoWatcher nobody;
  const Theorem1Table table = make_theorem_1_table(200, nobody);
  EXPECT_EQ(table.census.unlisted(), 0U);
  for (std::size_t i = 0; i < configurations().size(); ++i)
    EXPECT_GT(table.census.count(i), 0U) << configurations()[i].name;
  EXPECT_TRUE(table.holds());
  EXPECT_EQ(to_text(table), to_text(make_theorem_1_table(200, nobody)));
}

/// size-3N: a leaf has three mesh vertices at the most, and there are fewer quads than vertices.
TEST(Theorem1, CountOfSize3N) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Quadtree quadtree = random_balanced_tree(seed, 400);
    for (const TwoTwoVariant variant : {TwoTwoVariant::kExact, TwoTwoVariant::kPaper}) {
      TemplateTree tree(quadtree);
      Counters counters;
      const Mesh mesh = quadrangulate(tree, quadtree.root(), variant, counters);
      EXPECT_LT(mesh.quads.size(), mesh.vertices.size());
      EXPECT_LE(mesh.vertices.size(), 3 * mesh.cells);
    }
  }
}

}  // namespace
}  // namespace quadbound
