// SPDX-License-Identifier: Apache-2.0
// Properties of random inputs: the judge's claims, the same bytes twice, and how inputs shrink. The
// seed is fixed; RC_PARAMS="seed=1 max_success=1000" in the environment asks for others and more.
#include <algorithm>
#include <array>
#include <functional>

#include "cli/property_cases.hpp"
#include "model/validate.hpp"
#include "verify/verify.hpp"

namespace quadbound::cli {
namespace {

constexpr std::array kGrids{GridRefinement::kSixBySix, GridRefinement::kFiveByFive};

// --- claims --------------------------------------------------------------------------------------

TEST(Claims, Theorem13HoldsForPolygons) {
  Reached reached(Reached::Of::kPolygons);
  check_property(200, reached, [&](const PolygonSample& sample) {
    const auto made = meshed(sample.polygon);
    RC_PRE(made.has_value());
    const Report report = verify_polygon(sample.polygon, made->mesh);
    RC_ASSERT(broken_claims(report) == "");
    RC_ASSERT(report.holds());
    reached.add(*made);
  });
}

/// The kite at an acute vertex with neither side divided: found by the property above.
TEST(Claims, Theorem13HoldsForAKiteThatIsOneQuad) {
  const Polygon polygon =
      generate_polygon(parse_polygon_recipe("x-monotone:n=29,seed=516922104,holes=0"));
  const auto made = meshed(polygon);
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(made->counters.kite_filling.whole, 1U);
  EXPECT_EQ(broken_claims(verify_polygon(polygon, made->mesh)), "");
}

TEST(Claims, Theorem1HoldsForPointSetsWithBothGrids) {
  Reached reached(Reached::Of::kPoints);
  check_property(100, reached, [&](const PointSample& sample) {
    for (const GridRefinement grid : kGrids) {
      const auto made = meshed(sample.points, grid);
      RC_PRE(made.has_value());
      const Report report = verify_points(sample.points, made->mesh);
      RC_ASSERT(broken_claims(report) == "");
      RC_ASSERT(report.holds());
      reached.add(*made);
    }
  });
}

// --- deterministic -------------------------------------------------------------------------------

/// The report of the judge with so many threads.
template <class Judge>
void same_report_whatever_the_threads(Judge judge) {
  VerifyOptions options;
  const std::string alone = to_json(judge(options));
  for (const unsigned threads : {2U, 3U, 0U}) {
    options.threads = threads;
    RC_ASSERT(to_json(judge(options)) == alone);
  }
}

TEST(Deterministic, PolygonsGiveTheSameBytesTwiceAndOneReport) {
  Reached reached(Reached::Of::kPolygons);
  check_property(100, reached, [&](const PolygonSample& sample) {
    const auto made = meshed(sample.polygon);
    RC_PRE(made.has_value());
    RC_ASSERT(json_text(meshed(sample.polygon)->mesh) == json_text(made->mesh));
    if (sample.recipe) RC_ASSERT(generate_polygon(*sample.recipe).rings == sample.polygon.rings);
    same_report_whatever_the_threads([&](const VerifyOptions& options) {
      return verify_polygon(sample.polygon, made->mesh, options);
    });
    reached.add(*made);
  });
}

TEST(Deterministic, PointSetsGiveTheSameBytesTwiceAndOneReport) {
  Reached reached(Reached::Of::kPoints);
  check_property(100, reached, [&](const PointSample& sample) {
    const auto made = meshed(sample.points);
    RC_PRE(made.has_value());
    RC_ASSERT(json_text(meshed(sample.points)->mesh) == json_text(made->mesh));
    if (sample.recipe) RC_ASSERT(generate_points(*sample.recipe).points == sample.points.points);
    same_report_whatever_the_threads([&](const VerifyOptions& options) {
      return verify_points(sample.points, made->mesh, options);
    });
    reached.add(*made);
  });
}

// --- shrinking -----------------------------------------------------------------------------------

/// Follows the first smaller sample that is still bad, as rapidcheck does.
template <class Sample>
Sample shrunk(rc::Shrinkable<Sample> sample, const std::function<bool(const Sample&)>& is_bad) {
  for (;;) {
    auto smaller = sample.shrinks();
    auto next = smaller.next();
    while (next && !is_bad(next->value())) next = smaller.next();
    if (!next) return sample.value();
    sample = *next;
  }
}

std::size_t vertices_of(const Polygon& polygon) {
  std::size_t count = 0;
  for (const Ring& ring : polygon.rings) count += ring.size();
  return count;
}

TEST(Shrinking, PolygonsWithAHoleEndAsTwoTriangles) {
  const auto has_hole = [](const PolygonSample& s) { return s.polygon.rings.size() > 1; };
  int tried = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto sample = any_polygon()(rc::Random(seed), 60);
    if (!has_hole(sample.value())) continue;
    const PolygonSample least = shrunk<PolygonSample>(sample, has_hole);
    EXPECT_NO_THROW(validate(least.polygon));
    EXPECT_EQ(least.polygon.rings.size(), 2U) << seed;
    EXPECT_LE(vertices_of(least.polygon), 8U) << seed;
    ++tried;
  }
  EXPECT_GT(tried, 10);
}

TEST(Shrinking, ARecipeStaysARecipeAsLongAsItCan) {
  const auto is_large = [](const PolygonSample& s) {
    return s.recipe && s.polygon.rings.front().size() > 9;
  };
  int tried = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto sample = any_polygon()(rc::Random(seed), 60);
    if (!is_large(sample.value())) continue;
    const PolygonSample least = shrunk<PolygonSample>(sample, is_large);
    EXPECT_LE(least.polygon.rings.front().size(), 20U) << to_text(*least.recipe);
    EXPECT_EQ(least.recipe->seed, 1U) << to_text(*least.recipe);
    ++tried;
  }
  EXPECT_GT(tried, 10);
}

TEST(Shrinking, PointSetsEndWithAsManyPointsAsAreNeeded) {
  const auto has_two_on_the_left = [](const PointSample& s) {
    return std::ranges::count_if(s.points.points, [](Point p) { return p.x < 0.5; }) >= 2;
  };
  int tried = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto sample = any_point_set()(rc::Random(seed), 60);
    if (!has_two_on_the_left(sample.value())) continue;
    const PointSample least = shrunk<PointSample>(sample, has_two_on_the_left);
    EXPECT_EQ(least.points.points.size(), 2U) << seed;
    ++tried;
  }
  EXPECT_GT(tried, 10);
}

}  // namespace
}  // namespace quadbound::cli
