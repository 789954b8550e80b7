// SPDX-License-Identifier: Apache-2.0
// The search for polygons that are hard: climbs in child processes, their table and their report.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "cli/campaign.hpp"
#include "cli/interruption.hpp"
#include "cli/polygon_campaign.hpp"
#include "cli/polygon_search.hpp"
#include "cli/task_pool.hpp"
#include "cli/worst_ever.hpp"
#include "model/files.hpp"
#include "model/write_polygon.hpp"

namespace quadbound::cli {
namespace {

Objective objective_of(const FuzzOptions& options) {
  const auto* const found = std::ranges::find(kObjectiveNames, options.search);
  return static_cast<Objective>(found - kObjectiveNames.begin());
}

/// Tries a polygon in a process of its own, and how long that takes.
PolygonResult try_timed(const Polygon& polygon, const FuzzOptions& options) {
  const auto work = [&] {
    const std::clock_t begin = std::clock();
    PolygonResult result = try_polygon(polygon, trial_of(options));
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    result.microseconds = static_cast<std::uint64_t>(1e6 * seconds);
    return to_text(result);
  };
  return result_of(run_isolated(work, limits_of(options)));
}

class PolygonSearch {
 public:
  explicit PolygonSearch(const FuzzOptions& options)
      : options_(options),
        plan_{campaign_of(options), objective_of(options), options.steps},
        findings_(options),
        numbers_(options),
        pool_(workers_of(options)) {}

  void run() {
    for (;;) {
      while (!Interruption::came() && pool_.has_room() && start()) {
      }
      if (Interruption::came() || pool_.is_idle()) return;
      pool_.wait(kGlance);
    }
  }

  /// By the index of the case that they started from.
  [[nodiscard]] const std::map<std::uint64_t, Climb>& climbs() const { return climbs_; }
  [[nodiscard]] const std::map<std::uint64_t, std::string>& lost() const { return lost_; }
  [[nodiscard]] Objective objective() const { return plan_.objective; }

  [[nodiscard]] std::string best_path(std::uint64_t index) const {
    return fmt::format("{}/{}-{}-{}.geojson", options_.findings, options_.search, options_.seed,
                       index);
  }
  [[nodiscard]] std::string replay(std::uint64_t index) const {
    return climbs_.at(index).best.result.outcome == PolygonOutcome::kFinding
               ? findings_.replay(index)
               : replay_command(best_path(index), options_);
  }

 private:
  bool start() {
    const auto index = numbers_.next();
    if (!index) return false;
    const auto work = [&] {
      return to_text(climb(plan_, *index,
                           [&](const Polygon& polygon) { return try_timed(polygon, options_); }));
    };
    // Its tries have limits of their own.
    const TaskLimits limits{limits_of(options_).seconds * static_cast<double>(options_.steps + 1),
                            2 * options_.max_megabytes};
    pool_.start(work, limits,
                [this, index = *index](const TaskOutcome& outcome) { finish(index, outcome); });
    return true;
  }

  void finish(std::uint64_t index, const TaskOutcome& outcome) {
    if (outcome.end != TaskEnd::kAnswered) {
      lost_.emplace(index, outcome.detail);
      return;
    }
    const auto [place, is_new] = climbs_.emplace(index, climb_from_text(outcome.answer));
    const Climber& best = place->second.best;
    if (best.result.outcome == PolygonOutcome::kFinding)
      report(index, best);
    else
      write_best(index, best);
    numbers_.say(fmt::format("{} climbs, {}", climbs_.size(), options_.search));
  }

  void report(std::uint64_t index, const Climber& found) {
    PolygonResult result = found.result;
    result.recipe = found.recipe.empty() ? "climb" : found.recipe;
    findings_.add(index, result, found.polygon);
    if (options_.shrink_tries == 0) return;
    const TaskOutcome small =
        run_isolated([&] { return shrunk_text(found.polygon, result.claim, options_); },
                     {kSecondsOfAShrinker, 2 * options_.max_megabytes});
    if (small.end == TaskEnd::kAnswered) findings_.add_small(index, small.answer);
  }

  void write_best(std::uint64_t index, const Climber& best) const {
    make_findings_folder(options_);
    Polygon polygon = best.polygon;
    polygon.file = fmt::format("{}-{}-{}", options_.search, options_.seed, index);
    write_file(best_path(index), [&](std::ostream& stream) { write_geojson(stream, polygon); });
  }

  const FuzzOptions& options_;
  ClimbPlan plan_;
  PolygonFindings findings_;
  CaseNumbers numbers_;
  TaskPool pool_;
  std::map<std::uint64_t, Climb> climbs_;
  std::map<std::uint64_t, std::string> lost_;
};

// --- what is told --------------------------------------------------------------------------------

std::string search_table(const FuzzOptions& options, const PolygonSearch& search) {
  std::string text = fmt::format("{:>6} {:>6} {:>22} {:>22} {:>8} {:>8}  {}\n", "climb", "tries",
                                 "start", "best", "vertices", "cells", "replay");
  for (const auto& [index, climb] : search.climbs())
    text += fmt::format("{:>6} {:>6} {:>22} {:>22} {:>8} {:>8}  {}{}\n", index, climb.tries,
                        value_text(search.objective(), climb.start),
                        value_text(search.objective(), climb.best.result),
                        climb.best.result.vertices, climb.best.result.cells,
                        climb.best.result.claim.empty() ? "" : "FINDING ", search.replay(index));
  for (const auto& [index, detail] : search.lost())
    text += fmt::format("{:>6} lost: {}\n", index, detail);
  return text +
         (options.worst_ever.empty() ? "" : fmt::format("added to {}\n", options.worst_ever));
}

Json json_of(Objective objective, const PolygonResult& result) {
  Json json{{"value", value_text(objective, result)},
            {"vertices", result.vertices},
            {"cells", result.cells},
            {"quads", result.quads}};
  if (!result.claim.empty()) json["claim"] = result.claim;
  if (!result.detail.empty()) json["detail"] = result.detail;
  return json;
}

std::string search_summary(const FuzzOptions& options, const PolygonSearch& search) {
  Json json{{"format", "quadbound-fuzz-search"},
            {"version", 1},
            {"search", options.search},
            {"seed", options.seed},
            {"steps", options.steps},
            {"climbs", Json::array()}};
  for (const auto& [index, climb] : search.climbs())
    json["climbs"].push_back({{"index", index},
                              {"tries", climb.tries},
                              {"start", json_of(search.objective(), climb.start)},
                              {"best", json_of(search.objective(), climb.best.result)},
                              {"recipe", climb.best.recipe},
                              {"replay", search.replay(index)}});
  for (const auto& [index, detail] : search.lost())
    json["lost"].push_back({{"index", index}, {"detail", detail}});
  return json.dump(1) + "\n";
}

}  // namespace

ExitStatus search_polygons(const FuzzOptions& options) {
  const Interruption interruption;
  PolygonSearch search(options);
  search.run();
  if (!options.worst_ever.empty()) {
    WorstEver worst(options.worst_ever);
    for (const auto& [index, climb] : search.climbs()) worst.add(climb.extremes);
    worst.write();
  }
  if (!options.summary.empty())
    write_file(options.summary,
               [&](std::ostream& stream) { stream << search_summary(options, search); });
  if (!options.quiet) fmt::print("{}", search_table(options, search));
  if (Interruption::came()) Interruption::carry_out();
  const bool has_findings =
      !search.lost().empty() || std::ranges::any_of(search.climbs(), [](const auto& climb) {
        return climb.second.best.result.outcome == PolygonOutcome::kFinding;
      });
  return has_findings ? kClaimFailed : kGood;
}

}  // namespace quadbound::cli
