// SPDX-License-Identifier: Apache-2.0
// The parts of the campaign of polygons: its cases, the child processes and the shrinker.
#include "cli/fuzz_polygons.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "cli/fuzz_cases.hpp"
#include "cli/isolated_task.hpp"
#include "cli/polygon_search.hpp"
#include "cli/polygon_tally.hpp"
#include "cli/shrink_polygon.hpp"
#include "model/validate.hpp"

namespace quadbound::cli {
namespace {

Polygon polygon_of(const std::string& recipe) {
  return generate_polygon(parse_polygon_recipe(recipe));
}

std::size_t vertex_count(const Polygon& polygon) {
  std::size_t count = 0;
  for (const Ring& ring : polygon.rings) count += ring.size();
  return count;
}

PolygonCampaign all_families() {
  PolygonCampaign campaign;
  campaign.families = names_of(polygon_families());
  return campaign;
}

// --- cases ---------------------------------------------------------------------------------------

TEST(PolygonCampaign, CasesDependOnTheSeedAndTheIndexAlone) {
  const PolygonCampaign campaign = all_families();
  std::set<std::string> recipes;
  for (std::uint64_t index = 0; index < 100; ++index) {
    const PolygonCase once = random_polygon_case(campaign, index);
    const PolygonCase again = random_polygon_case(campaign, index);
    EXPECT_EQ(once.recipe, again.recipe);
    EXPECT_EQ(once.polygon.rings, again.polygon.rings);
    EXPECT_EQ(once.polygon.rings, polygon_of(to_text(once.recipe)).rings);
    EXPECT_EQ(once.recipe.family, campaign.families[index % campaign.families.size()]);
    recipes.insert(to_text(once.recipe));
  }
  EXPECT_EQ(recipes.size(), 100U);
}

TEST(PolygonCampaign, CasesAreMostlySmallAndNeverLarge) {
  const PolygonCampaign campaign = all_families();
  int small = 0;
  for (std::uint64_t index = 0; index < 500; ++index) {
    const PolygonCase made = random_polygon_case(campaign, index);
    EXPECT_LE(made.recipe.n, campaign.max_n);
    EXPECT_LE(vertex_count(made.polygon), 1000U) << to_text(made.recipe);
    small += made.recipe.n <= 60 ? 1 : 0;
  }
  EXPECT_GT(small, 350);
  EXPECT_LT(small, 490);
}

TEST(PolygonCampaign, AResultSurvivesItsTextForm) {
  PolygonResult result = try_polygon(polygon_of("star:n=12,seed=1"), {});
  result.recipe = "star:n=12,seed=1";
  EXPECT_EQ(result.outcome, PolygonOutcome::kProved) << result.claim << " " << result.detail;
  const std::string text = to_text(result);
  const PolygonResult back = result_from_text(text);
  EXPECT_EQ(to_text(back), text);
  EXPECT_EQ(back.quads, result.quads);
  EXPECT_EQ(back.smallest->cross, result.smallest->cross);
}

/// The extreme of all constructions is that of the judge, who looks at the same corners exactly.
TEST(PolygonCampaign, AnglesByConstructionAgreeWithTheJudge) {
  for (const char* recipe : {"star:n=30,seed=3", "sharp:n=8,seed=1", "plate:n=4,seed=1,holes=2"}) {
    const PolygonResult result = try_polygon(polygon_of(recipe), {});
    ASSERT_EQ(result.outcome, PolygonOutcome::kProved) << recipe << " " << result.detail;
    Record smallest;
    Record largest;
    std::uint64_t quads = 0;
    for (const ConstructionUse& use : result.constructions) {
      smallest.keep_smaller(use.smallest, 0, {});
      largest.keep_larger(use.largest, 0, {});
      quads += use.quads;
    }
    EXPECT_EQ(quads, result.quads);
    EXPECT_FALSE(smaller_angle(*smallest.corner, *result.smallest));
    EXPECT_FALSE(smaller_angle(*result.smallest, *smallest.corner));
    EXPECT_FALSE(smaller_angle(*largest.corner, *result.largest));
    EXPECT_FALSE(smaller_angle(*result.largest, *largest.corner));
  }
}

TEST(PolygonCampaign, AStricterBoundIsAFinding) {
  PolygonTrial trial;
  trial.angles.smallest = {1, 2};
  const PolygonResult result = try_polygon(polygon_of("star:n=30,seed=1"), trial);
  EXPECT_EQ(result.outcome, PolygonOutcome::kFinding);
  EXPECT_EQ(result.claim, "min-angle");
}

TEST(PolygonCampaign, ABudgetIsARefusal) {
  PolygonTrial trial;
  trial.budget.max_cells = 100;
  const PolygonResult result = try_polygon(polygon_of("star:n=30,seed=1"), trial);
  EXPECT_EQ(result.outcome, PolygonOutcome::kTooManyCells);
  EXPECT_NE(result.detail, "");
}

// --- tallies -------------------------------------------------------------------------------------

struct TallyCase {
  std::uint64_t index;
  std::string family;
  PolygonResult result;
};

std::vector<TallyCase> tally_cases() {
  std::vector<TallyCase> cases;
  for (const char* recipe : {"star:n=12,seed=1", "regular:n=6,seed=1", "star:n=9,seed=2",
                             "regular:n=6,seed=1", "star:n=12,seed=1", "regular:n=5,seed=1"}) {
    PolygonResult result = try_polygon(polygon_of(recipe), {});
    result.recipe = recipe;
    cases.push_back({cases.size(), parse_polygon_recipe(recipe).family, result});
  }
  return cases;
}

/// What a tally tells, with the first cases of its records.
std::string told(const PolygonTally& tally) {
  std::ostringstream text;
  const auto tell = [&text](const Record& record) {
    text << record.index << " " << record.recipe << " "
         << (record.corner ? quadbound::to_text(record.corner->cross) : "") << "\n";
  };
  for (const auto& [family, t] : tally.families) {
    text << family << " " << t.cases << " " << t.cells << " " << t.cells_per_vertex.mean() << " "
         << t.quads_per_cell.largest << "\n";
    tell(t.smallest);
    tell(t.largest);
  }
  for (const ConstructionTally& t : tally.constructions) {
    text << t.quads << " " << t.cases << "\n";
    tell(t.smallest);
    tell(t.largest);
  }
  for (const auto& [bin, count] : tally.cells_per_vertex) text << bin << ":" << count << "\n";
  return text.str();
}

TEST(PolygonTally, TheOrderMakesNoDifferenceAndTiesGoToTheFirstCase) {
  std::vector<TallyCase> cases = tally_cases();
  PolygonTally tally;
  for (const TallyCase& c : cases) tally.add(c.index, c.result, c.family);
  const std::string once = told(tally);
  EXPECT_EQ(once.find("3 regular"), std::string::npos);  // the same polygon as case 1
  for (int turn = 0; turn < 5; ++turn) {
    std::rotate(cases.begin(), cases.begin() + 1, cases.end());
    PolygonTally other;
    for (const TallyCase& c : cases) other.add(c.index, c.result, c.family);
    EXPECT_EQ(told(other), once);
  }
}

TEST(PolygonTally, NewsComeToTheSameAsTheWholeAndSayNothingTwice) {
  std::vector<TallyCase> cases = tally_cases();
  std::reverse(cases.begin(), cases.end());
  PolygonTally whole;
  PolygonTally by_news;
  for (const TallyCase& c : cases) {
    whole.add(c.index, c.result, c.family);
    by_news.add(c.index, by_news.news(c.index, c.result, c.family), c.family);
  }
  EXPECT_EQ(told(by_news), told(whole));
  const PolygonResult nothing_new = by_news.news(100, cases.front().result, cases.front().family);
  EXPECT_TRUE(nothing_new.recipe.empty());
  EXPECT_FALSE(nothing_new.smallest.has_value());
  EXPECT_EQ(nothing_new.quads, cases.front().result.quads);
}

TEST(PolygonTally, BinsOfRatiosAreFourToAnOctave) {
  EXPECT_EQ(ratio_bin_start(0), 1);
  EXPECT_EQ(ratio_bin_start(1), 1.25);
  EXPECT_EQ(ratio_bin_start(4), 2);
  EXPECT_EQ(ratio_bin_start(-1), 0.875);
  EXPECT_EQ(ratio_bin_start(-4), 0.5);
}

// --- climbs --------------------------------------------------------------------------------------

TEST(PolygonSearch, ChangesAreValidPolygonsOnTheLattice) {
  RandomIntegers random(1);
  Polygon polygon = polygon_of("star:n=20,seed=1,holes=2");
  int changes = 0;
  for (int i = 0; i < 400; ++i) {
    const std::optional<Polygon> next = changed(polygon, random, 40);
    if (!next) continue;
    ++changes;
    polygon = *next;
    EXPECT_NO_THROW(validate(polygon));
    EXPECT_LE(vertex_count(polygon), 40U);
    for (const Ring& ring : polygon.rings)
      for (const Point& p : ring) EXPECT_EQ(std::ldexp(p.x, 24), std::round(std::ldexp(p.x, 24)));
  }
  EXPECT_GT(changes, 100);
}

TEST(PolygonSearch, AClimbKeepsWhatIsFurtherAndSurvivesItsTextForm) {
  ClimbPlan plan;
  plan.campaign.families = {"regular"};
  plan.campaign.max_n = 8;
  plan.objective = Objective::kCells;
  plan.steps = 60;
  std::uint64_t most = 0;
  const auto by_area = [&most](const Polygon& polygon) {  // no mesher: the widest polygon wins
    PolygonResult result;
    result.vertices = vertex_count(polygon);
    for (const Point& p : polygon.rings[0])
      result.cells = std::max(result.cells, static_cast<std::uint64_t>(1000 * (p.x + 10)));
    most = std::max(most, result.cells);
    return result;
  };
  const Climb once = climb(plan, 3, by_area);
  EXPECT_EQ(once.best.result.cells, most);
  EXPECT_GT(once.best.result.cells, once.start.cells);
  EXPECT_EQ(to_text(climb(plan, 3, by_area)), to_text(once));
  EXPECT_EQ(to_text(climb_from_text(to_text(once))), to_text(once));
}

// --- child processes -----------------------------------------------------------------------------

TEST(IsolatedTask, AnswersHoweverLong) {
  std::string long_text(1 << 20, 'x');
  const TaskOutcome outcome = run_isolated([&] { return long_text; }, {});
  EXPECT_EQ(outcome.end, TaskEnd::kAnswered);
  EXPECT_EQ(outcome.answer, long_text);
}

TEST(IsolatedTask, ACrashIsAnOutcome) {
  const TaskOutcome outcome = run_isolated([]() -> std::string { std::abort(); }, {});
  EXPECT_EQ(outcome.end, TaskEnd::kCrashed);
  EXPECT_NE(outcome.detail.find("signal 6"), std::string::npos) << outcome.detail;
}

TEST(IsolatedTask, AnEndWithoutAnAnswerIsACrash) {
  const TaskOutcome outcome = run_isolated([]() -> std::string { ::_exit(3); }, {});
  EXPECT_EQ(outcome.end, TaskEnd::kCrashed);
}

TEST(IsolatedTask, AHangIsAnOutcomeWhetherItWorksOrWaits) {
  const auto works = []() -> std::string {
    for (volatile bool forever = true; forever;) {
    }
    return {};
  };
  EXPECT_EQ(run_isolated(works, {1, 4096}).end, TaskEnd::kTimedOut);
  const auto waits = []() -> std::string {
    std::this_thread::sleep_for(std::chrono::hours(1));
    return {};
  };
  EXPECT_EQ(run_isolated(waits, {0.05, 4096}).end, TaskEnd::kTimedOut);
}

TEST(IsolatedTask, OutOfMemoryIsAnOutcome) {
  const TaskOutcome outcome =
      run_isolated([]() -> std::string { throw std::bad_alloc(); }, TaskLimits{});
  EXPECT_EQ(outcome.end, TaskEnd::kNoMemory);
}

// --- the shrinker --------------------------------------------------------------------------------

TEST(ShrinkPolygon, LeavesATriangleWhereAnythingFails) {
  const Polygon small = shrunk(
      polygon_of("star:n=60,seed=1,holes=5"), [](const Polygon&) { return true; }, 1000);
  ASSERT_EQ(small.rings.size(), 1U);
  EXPECT_EQ(small.rings[0].size(), 3U);
  EXPECT_NO_THROW(validate(small));
}

/// The artificial fault: three vertices or more right of x = 1/4, and a hole.
bool has_fault(const Polygon& polygon) {
  const auto right = std::ranges::count_if(polygon.rings[0], [](Point p) { return p.x > 0.25; });
  return right >= 3 && polygon.rings.size() >= 2;
}

TEST(ShrinkPolygon, KeepsTheFaultAndNothingElse) {
  const Polygon polygon = polygon_of("star:n=60,seed=2,holes=6");
  ASSERT_TRUE(has_fault(polygon));
  const Polygon small = shrunk(polygon, has_fault, 10000);
  EXPECT_NO_THROW(validate(small));
  EXPECT_TRUE(has_fault(small));
  EXPECT_EQ(small.rings.size(), 2U);
  EXPECT_EQ(small.rings[1].size(), 3U);
  EXPECT_LE(small.rings[0].size(), 8U);
}

TEST(ShrinkPolygon, ChecksOnlyValidPolygonsWithinItsTries) {
  std::size_t tries = 0;
  const auto counts = [&tries](const Polygon& polygon) {
    ++tries;
    EXPECT_NO_THROW(validate(polygon));
    return polygon.rings[0].size() > 30;
  };
  const Polygon small = shrunk(polygon_of("coast:n=100,seed=1"), counts, 25);
  EXPECT_LE(tries, 25U);
  EXPECT_GT(small.rings[0].size(), 30U);
}

TEST(ShrinkPolygon, ReturnsThePolygonItselfWhereNothingSmallerFails) {
  const Polygon polygon = polygon_of("star:n=20,seed=1,holes=1");
  EXPECT_EQ(shrunk(
                polygon, [](const Polygon&) { return false; }, 1000)
                .rings,
            polygon.rings);
}

}  // namespace
}  // namespace quadbound::cli
