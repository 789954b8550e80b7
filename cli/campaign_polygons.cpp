// SPDX-License-Identifier: Apache-2.0
// The campaign of polygons: child processes that mesh and judge, its table and its report; replay
// and corpus.
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/campaign.hpp"
#include "cli/fuzz_polygons.hpp"
#include "cli/isolated_task.hpp"
#include "cli/shrink_polygon.hpp"
#include "model/errors.hpp"
#include "model/files.hpp"
#include "model/read_polygon.hpp"
#include "model/validate.hpp"
#include "model/write_polygon.hpp"
#include "verify/report.hpp"

namespace quadbound::cli {
namespace {

constexpr std::uint64_t kDefaultMaxCells = 2'000'000;

PolygonTrial trial_of(const FuzzOptions& options) {
  PolygonTrial trial;
  trial.budget = {options.max_cells.value_or(kDefaultMaxCells), options.max_seconds};
  if (options.min_tangent) trial.angles.smallest = *options.min_tangent;
  return trial;
}

PolygonCampaign campaign_of(const FuzzOptions& options) {
  PolygonCampaign campaign;
  campaign.seed = options.seed;
  campaign.max_n = options.max_n.value_or(campaign.max_n);
  campaign.families = chosen_families(options, polygon_families());
  return campaign;
}

/// The mesher gives up at --max-seconds; the rest is for the judge.
TaskLimits limits_of(const FuzzOptions& options) {
  return {3 * options.max_seconds, options.max_megabytes};
}

// --- a case in a process of its own
// ---------------------------------------------------------------

PolygonResult result_of(const TaskOutcome& outcome) {
  if (outcome.end == TaskEnd::kAnswered) return result_from_text(outcome.answer);
  PolygonResult result;
  result.outcome = PolygonOutcome::kFinding;
  result.claim = outcome.end == TaskEnd::kCrashed    ? "crash"
                 : outcome.end == TaskEnd::kTimedOut ? "hang"
                                                     : "memory";
  result.detail = outcome.detail;
  return result;
}

PolygonResult try_isolated(const Polygon& polygon, const FuzzOptions& options) {
  return result_of(run_isolated([&] { return to_text(try_polygon(polygon, trial_of(options))); },
                                limits_of(options)));
}

/// Runs in a process of its own: a shrunk polygon as GeoJSON, empty where the polygon does not fail
/// again. Every try has a process as well.
std::string shrunk_text(const Polygon& polygon, const std::string& claim,
                        const FuzzOptions& options) {
  const auto still_fails = [&](const Polygon& smaller) {
    const PolygonResult result = try_isolated(smaller, options);
    return result.outcome == PolygonOutcome::kFinding && result.claim == claim;
  };
  if (!still_fails(polygon)) return {};
  std::ostringstream stream;
  write_geojson(stream, shrunk(polygon, still_fails, options.shrink_tries));
  return stream.str();
}

// --- findings
// -------------------------------------------------------------------------------------

std::string replay_command(const std::string& what, const FuzzOptions& options) {
  std::string command = "quadbound fuzz --replay " + what;
  if (options.max_cells) command += fmt::format(" --max-cells {}", *options.max_cells);
  if (options.max_seconds != FuzzOptions{}.max_seconds)
    command += fmt::format(" --max-seconds {}", options.max_seconds);
  if (options.min_tangent)
    command += fmt::format(" --min-tangent {}/{}", options.min_tangent->numerator,
                           options.min_tangent->denominator);
  return command;
}

class PolygonFindings {
 public:
  explicit PolygonFindings(const FuzzOptions& options) : options_(options), folder_(options) {}

  [[nodiscard]] std::string case_path(std::uint64_t index) const {
    return folder_.path(fmt::format("polygon-{}-{}.geojson", options_.seed, index));
  }
  [[nodiscard]] std::string small_path(std::uint64_t index) const {
    return folder_.path(fmt::format("polygon-{}-{}-small.geojson", options_.seed, index));
  }
  [[nodiscard]] std::string replay(std::uint64_t index) const {
    return replay_command(case_path(index), options_);
  }

  void add(std::uint64_t index, const PolygonResult& result, const Polygon& polygon) const {
    folder_.write_case(case_path(index),
                       [&](std::ostream& stream) { write_geojson(stream, polygon); });
    folder_.note({result.claim, result.recipe, replay(index), result.detail});
  }
  /// Where not even the polygon could be made.
  void add_without_polygon(std::uint64_t index, const PolygonResult& result) const {
    folder_.write_case(folder_.path(fmt::format("polygon-{}-{}.txt", options_.seed, index)),
                       [&](std::ostream& stream) { stream << result.detail << "\n"; });
    folder_.note({result.claim, "no polygon", fmt::format("case {}", index), result.detail});
  }
  /// What the shrinker came to.
  void add_small(std::uint64_t index, const std::string& geojson) const {
    if (!geojson.empty())
      folder_.write_case(small_path(index), [&](std::ostream& stream) { stream << geojson; });
    if (options_.quiet) return;
    if (geojson.empty())
      fmt::print(stderr, "quadbound: {} did not fail again\n", case_path(index));
    else
      fmt::print(stderr, "quadbound: shrunk to {}\n", small_path(index));
  }

 private:
  const FuzzOptions& options_;
  FindingsFolder folder_;
};

// --- the campaign
// ---------------------------------------------------------------------------------

/// Keeps as many child processes at work as there are threads, and tallies what they answer in the
/// order of the cases.
class PolygonRunner {
 public:
  explicit PolygonRunner(const FuzzOptions& options)
      : options_(options), campaign_(campaign_of(options)), findings_(options), numbers_(options) {}

  PolygonTally run() {
    while (start_tasks()) {
      wait();
      finish_tasks();
    }
    return std::move(tally_);
  }

 private:
  struct Running {
    std::uint64_t index;
    bool shrinks;
    std::unique_ptr<IsolatedTask> task;
  };
  struct ToShrink {
    std::uint64_t index;
    std::string claim;
    Polygon polygon;
  };

  /// Whether there are any.
  bool start_tasks() {
    while (running_.size() < workers_of(options_) && (start_shrinking() || start_case())) {
    }
    return !running_.empty();
  }

  bool start_shrinking() {
    if (to_shrink_.empty()) return false;
    const ToShrink finding = std::move(to_shrink_.front());
    to_shrink_.pop_front();
    const auto work = [&] { return shrunk_text(finding.polygon, finding.claim, options_); };
    // Tries have their own limits; a shrinker that takes longer is given up.
    constexpr double kSecondsOfAShrinker = 60;
    running_.push_back({finding.index, true,
                        std::make_unique<IsolatedTask>(
                            work, TaskLimits{kSecondsOfAShrinker, 2 * options_.max_megabytes})});
    return true;
  }

  bool start_case() {
    const auto index = numbers_.next();
    if (!index) return false;
    const auto work = [&] {
      const PolygonCase made = random_polygon_case(campaign_, *index);
      PolygonResult result = try_polygon(made.polygon, trial_of(options_));
      result.recipe = to_text(made.recipe);
      return to_text(result);
    };
    running_.push_back({*index, false, std::make_unique<IsolatedTask>(work, limits_of(options_))});
    return true;
  }

  void wait() const {
    std::vector<pollfd> waiting;
    for (const Running& running : running_)
      waiting.push_back({running.task->descriptor(), POLLIN, 0});
    constexpr int kMilliseconds = 500;  // deadlines are looked at so often
    ::poll(waiting.data(), waiting.size(), kMilliseconds);
  }

  void finish_tasks() {
    for (std::size_t i = 0; i < running_.size();) {
      const std::optional<TaskOutcome> outcome = running_[i].task->outcome();
      if (!outcome) {
        ++i;
        continue;
      }
      const Running done = std::move(running_[i]);
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
      if (!done.shrinks)
        finish_case(done.index, *outcome);
      else if (outcome->end == TaskEnd::kAnswered)
        findings_.add_small(done.index, outcome->answer);
    }
  }

  void finish_case(std::uint64_t index, const TaskOutcome& outcome) {
    PolygonResult result = result_of(outcome);
    if (result.outcome == PolygonOutcome::kFinding) report(index, result);
    results_.emplace(index, std::move(result));
    for (; !results_.empty() && results_.begin()->first == next_; ++next_) {
      const std::string& family = campaign_.families[next_ % campaign_.families.size()];
      tally_.add(next_, results_.begin()->second, family);
      results_.erase(results_.begin());
    }
    say_how_far();
  }

  /// The child's polygon is made again, first in another child, as what makes it may be at fault.
  void report(std::uint64_t index, PolygonResult& result) {
    const TaskOutcome made = run_isolated(
        [&] { return to_text(random_polygon_case(campaign_, index).recipe); }, limits_of(options_));
    if (made.end != TaskEnd::kAnswered) {
      result.claim = "generator";
      findings_.add_without_polygon(index, result);
      return;
    }
    result.recipe = made.answer;
    Polygon polygon = generate_polygon(parse_polygon_recipe(made.answer));
    findings_.add(index, result, polygon);
    if (options_.shrink_tries != 0) to_shrink_.push_back({index, result.claim, std::move(polygon)});
  }

  void say_how_far() {
    const auto& all = tally_.all;
    numbers_.say(fmt::format("{:.1f} cases/s, {} findings, {} refused, angles {} to {}",
                             static_cast<double>(all.cases) / numbers_.elapsed(),
                             tally_.findings.size(), tally_.refusals.size(),
                             angle_text(all.smallest.corner), angle_text(all.largest.corner)));
  }

  const FuzzOptions& options_;
  PolygonCampaign campaign_;
  PolygonFindings findings_;
  CaseNumbers numbers_;
  std::vector<Running> running_;
  std::deque<ToShrink> to_shrink_;
  std::map<std::uint64_t, PolygonResult> results_;  ///< that wait for an earlier one
  std::uint64_t next_ = 0;
  PolygonTally tally_;
};

// --- the table
// ------------------------------------------------------------------------------------

std::string family_row(const std::string& family, const PolygonFamilyTally& t) {
  return fmt::format(
      "{:<16} {:>7} {:>7} {:>6} {:>5} {:>5} {:>9} {:>11} {:>8.2f} {:>8.2f} {:>9.2f} {:>6.3f} "
      "{:>6.3f} {:>6.3f}  {:<20}  {}\n",
      family, t.cases, t.count(PolygonOutcome::kProved), t.count(PolygonOutcome::kTooManyCells),
      t.count(PolygonOutcome::kTooMuchTime), t.count(PolygonOutcome::kFinding), t.vertices, t.cells,
      t.cells_per_vertex.smallest, t.cells_per_vertex.mean(), t.cells_per_vertex.largest,
      t.quads_per_cell.smallest, t.quads_per_cell.mean(), t.quads_per_cell.largest,
      angle_text(t.smallest.corner), angle_text(t.largest.corner));
}

std::string families_table(const PolygonTally& tally) {
  std::string text = fmt::format(
      "{:<16} {:>7} {:>7} {:>6} {:>5} {:>5} {:>9} {:>11} {:>8} {:>8} {:>9} {:>6} {:>6} {:>6}  "
      "{:<20}  {}\n",
      "family", "cases", "proved", "budget", "time", "found", "vertices", "cells", "N/n min",
      "mean", "max", "q/N mn", "mean", "max", "smallest angle", "largest angle");
  for (const auto& [family, of_family] : tally.families) text += family_row(family, of_family);
  return text + family_row("all", tally.all);
}

std::string constructions_table(const PolygonTally& tally) {
  std::string text =
      fmt::format("\n{:<18} {:>12} {:>8}  {:<20}  {:<24}  {}\n", "quads made by", "quads", "cases",
                  "smallest angle", "largest angle", "recipes with these");
  for (std::size_t i = 0; i < tally.constructions.size(); ++i) {
    const ConstructionTally& t = tally.constructions[i];
    text +=
        fmt::format("{:<18} {:>12} {:>8}  {:<20}  {:<24}  {} {}\n", polygon_construction_name(i),
                    t.quads, t.cases, angle_text(t.smallest.corner), angle_text(t.largest.corner),
                    t.smallest.recipe, t.largest.recipe);
  }
  return text;
}

std::string remarks_text(const std::string& title,
                         const std::vector<PolygonTally::Remark>& remarks) {
  constexpr std::size_t kMostShown = 20;
  if (remarks.empty()) return {};
  std::string text = fmt::format("\n{}: {}\n", title, remarks.size());
  for (std::size_t i = 0; i < std::min(kMostShown, remarks.size()); ++i) {
    const PolygonResult& result = remarks[i].result;
    text += fmt::format("  case {} {} {}{}{}\n", remarks[i].index, result.recipe, result.claim,
                        result.claim.empty() ? "" : ": ", result.detail);
  }
  return text + (remarks.size() > kMostShown ? "  ...\n" : "");
}

std::string table(const PolygonTally& tally) {
  return families_table(tally) + constructions_table(tally) + "\n" +
         counts_line("counters:", kPolygonCounterNames, tally.counts) +
         remarks_text("refused", tally.refusals) + remarks_text("findings", tally.findings);
}

// --- the summary
// ----------------------------------------------------------------------------------

Json json_of(const Spread& spread) {
  return {{"min", spread.smallest}, {"mean", spread.mean()}, {"max", spread.largest}};
}

Json json_of(const Record& record) {
  if (!record.corner) return nullptr;
  const JudgedCorner corner{{}, record.corner->cross, record.corner->dot};
  return {{"angle", angle_json(record.corner)},
          {"degrees", corner.degrees()},
          {"recipe", record.recipe}};
}

Json json_of(const PolygonFamilyTally& t) {
  Json json{{"cases", t.cases}};
  for (std::size_t i = 0; i < kPolygonOutcomeNames.size(); ++i)
    json[std::string(kPolygonOutcomeNames[i])] = t.outcomes[i];
  json["vertices"] = t.vertices;
  json["cells"] = t.cells;
  json["quads"] = t.quads;
  json["cells_per_vertex"] = json_of(t.cells_per_vertex);
  json["quads_per_cell"] = json_of(t.quads_per_cell);
  json["smallest_angle"] = json_of(t.smallest);
  json["largest_angle"] = json_of(t.largest);
  return json;
}

Json json_of(const PolygonTally::Remark& remark) {
  const PolygonResult& result = remark.result;
  Json json{{"index", remark.index}};
  if (!result.claim.empty()) json["claim"] = result.claim;
  json["recipe"] = result.recipe;
  json["detail"] = result.detail;
  return json;
}

/// No times and no threads: the same campaign gives the same bytes.
std::string summary_text(const FuzzOptions& options, const PolygonTally& tally) {
  const PolygonCampaign campaign = campaign_of(options);
  const PolygonTrial trial = trial_of(options);
  Json json{{"format", "quadbound-fuzz-polygons"},
            {"version", 1},
            {"seed", campaign.seed},
            {"max_n", campaign.max_n},
            {"max_cells", trial.budget.max_cells},
            {"max_seconds", trial.budget.max_seconds}};
  json["all"] = json_of(tally.all);
  for (const auto& [family, of_family] : tally.families)
    json["families"][family] = json_of(of_family);
  for (std::size_t i = 0; i < tally.constructions.size(); ++i) {
    const ConstructionTally& t = tally.constructions[i];
    json["constructions"][std::string(polygon_construction_name(i))] = {
        {"quads", t.quads},
        {"cases", t.cases},
        {"smallest_angle", json_of(t.smallest)},
        {"largest_angle", json_of(t.largest)}};
  }
  json["never_reached"] = tally.never_reached();
  json["counters"] = counts_json(kPolygonCounterNames, tally.counts);
  json["refusals"] = Json::array();
  for (const auto& refusal : tally.refusals) json["refusals"].push_back(json_of(refusal));
  json["findings"] = Json::array();
  const PolygonFindings folder(options);
  for (const auto& finding : tally.findings) {
    json["findings"].push_back(json_of(finding));
    json["findings"].back()["replay"] = folder.replay(finding.index);
  }
  return json.dump(1) + "\n";
}

// --- replay and corpus
// ----------------------------------------------------------------------------

/// A recipe where it looks like one and no file has that name.
Polygon replayed_polygon(const std::string& what) {
  const bool is_recipe = what.find(":n=") != std::string::npos && !std::filesystem::exists(what);
  return is_recipe ? generate_polygon(parse_polygon_recipe(what)) : normalised(read_polygon(what));
}

std::string verdict_text(const PolygonResult& result) {
  switch (result.outcome) {
    case PolygonOutcome::kProved:
      return fmt::format("thm-13 proved: {} vertices, {} cells, {} quads, angles {} to {}",
                         result.vertices, result.cells, result.quads, angle_text(result.smallest),
                         angle_text(result.largest));
    case PolygonOutcome::kFinding:
      return fmt::format("claim {} {}", result.claim, result.detail);
    default:
      return "refused: " + result.detail;
  }
}

ExitStatus replay(const FuzzOptions& options) {
  const PolygonResult result = try_isolated(replayed_polygon(options.replay), options);
  const bool is_proved = result.outcome == PolygonOutcome::kProved;
  if (!is_proved || !options.quiet)
    fmt::print(is_proved ? stdout : stderr, "{}{}: {}\n",
               is_proved ? "" : "quadbound: ", options.replay, verdict_text(result));
  return is_proved                                    ? kGood
         : result.outcome == PolygonOutcome::kFinding ? kClaimFailed
                                                      : kBudgetRanOut;
}

std::vector<std::filesystem::path> corpus_files(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    for (const char* known : {".geojson", ".json", ".poly", ".wkt"})
      if (entry.is_regular_file() && extension == known) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

bool must_fail(const std::filesystem::path& file) {
  return std::ranges::any_of(file, [](const auto& part) { return part == "known-failing"; });
}

/// Whether a case of a corpus does what it should. A polygon that is no valid input may be refused
/// with a message.
bool corpus_case(const std::filesystem::path& file, const FuzzOptions& options) {
  bool good = false;
  std::string text;
  try {
    const PolygonResult result = try_isolated(replayed_polygon(file.string()), options);
    const bool fails = result.outcome == PolygonOutcome::kFinding;
    good = must_fail(file) ? fails : result.outcome == PolygonOutcome::kProved;
    text = verdict_text(result);
  } catch (const InputError& error) {
    good = !must_fail(file);
    text = fmt::format("no valid input: {}", error.what());
  }
  if (!options.quiet) fmt::print("{} {}: {}\n", good ? "good" : "BAD ", file.string(), text);
  return good;
}

ExitStatus run_corpus(const FuzzOptions& options) {
  const std::vector<std::filesystem::path> files = corpus_files(options.corpus);
  if (files.empty())
    throw InputError({options.corpus, std::nullopt, std::nullopt}, "no polygons in this folder");
  const auto bad =
      std::ranges::count_if(files, [&](const auto& file) { return !corpus_case(file, options); });
  if (!options.quiet) fmt::print("{} cases, {} bad\n", files.size(), bad);
  return bad == 0 ? kGood : kClaimFailed;
}

constexpr std::uint64_t kCasesThatReachAll = 1000;

}  // namespace

ExitStatus fuzz_polygons(const FuzzOptions& options) {
  if (!options.replay.empty()) return replay(options);
  if (!options.corpus.empty()) return run_corpus(options);
  const PolygonTally tally = PolygonRunner(options).run();
  if (!options.summary.empty())
    write_file(options.summary,
               [&](std::ostream& stream) { stream << summary_text(options, tally); });
  if (!options.quiet) fmt::print("{}", table(tally));
  const bool is_wide = tally.all.cases < kCasesThatReachAll || reached_all(tally.never_reached());
  return tally.findings.empty() && is_wide ? kGood : kClaimFailed;
}

}  // namespace quadbound::cli
