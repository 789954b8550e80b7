// SPDX-License-Identifier: Apache-2.0
// quadbound fuzz: random point sets through the mesher and the judge.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "algo/theorem_1.hpp"
#include "cli/commands.hpp"
#include "cli/fuzz_points.hpp"
#include "cli/progress.hpp"
#include "model/files.hpp"
#include "verify/report.hpp"

namespace quadbound::cli {
namespace {

struct FuzzOptions {
  bool points = false;
  std::uint64_t count = 1000;
  double seconds = 0;  ///< 0: go by the count
  PointCampaign campaign;
  std::string findings = "findings";
  std::string report;
  unsigned threads = 1;
  bool quiet = false;
};

const std::map<std::string, Warping> kWarpings{{"aligned", Warping::kAligned},
                                               {"paper", Warping::kPaper}};

// --- findings
// -------------------------------------------------------------------------------------

std::string_view grid_name(GridRefinement refinement) {
  return refinement == GridRefinement::kFiveByFive ? "5x5" : "6x6";
}

/// The recipe, the transform and what else made the case, in one line.
std::string origin(const PointCase& made) {
  return fmt::format("{} {} grid={}", to_text(made.recipe), to_text(made.transform),
                     grid_name(made.refinement));
}

/// Puts every finding on disk at once: a campaign that crashes later loses none.
class FindingsFolder {
 public:
  explicit FindingsFolder(const FuzzOptions& options) : options_(options) {}

  [[nodiscard]] std::string case_path(const PointCase& made) const {
    return fmt::format("{}/points-{}-{}.csv", options_.findings, options_.campaign.seed,
                       made.index);
  }
  [[nodiscard]] std::string replay(const PointCase& made) const {
    return fmt::format("quadbound mesh --points {} --grid {}{}", case_path(made),
                       grid_name(made.refinement),
                       options_.campaign.mesh.warping == Warping::kPaper ? " --warp paper" : "");
  }

  void add(const PointCase& made, const CaseResult& result) {
    const std::lock_guard lock(mutex_);
    make_folder();
    write_file(case_path(made), [&made](std::ostream& stream) {
      stream << "x,y\n";
      for (const Point& p : made.points.points) stream << fmt::format("{},{}\n", p.x, p.y);
    });
    const std::string index = options_.findings + "/INDEX";
    std::ofstream stream(index, std::ios::binary | std::ios::app);
    stream << fmt::format("{}\t{}\t{}\t{}\n", result.claim, origin(made), replay(made),
                          result.detail);
    if (!stream.flush()) throw OutputError(index + ": cannot be written");
    if (!options_.quiet)
      fmt::print(stderr, "quadbound: finding: {}: {}\n", result.claim, replay(made));
  }

 private:
  void make_folder() const {
    std::error_code error;
    std::filesystem::create_directories(options_.findings, error);
    if (error)
      throw OutputError(fmt::format("{}: cannot be made: {}", options_.findings, error.message()));
  }

  const FuzzOptions& options_;
  std::mutex mutex_;
};

// --- the campaign
// ---------------------------------------------------------------------------------

/// Hands out the numbers of the cases until the count or the time is over.
class CaseNumbers {
 public:
  explicit CaseNumbers(const FuzzOptions& options) : options_(options) {}

  std::optional<std::uint64_t> next() {
    const double elapsed =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const bool by_time = options_.seconds > 0;
    if (stopped_ || (by_time && elapsed >= options_.seconds)) return std::nullopt;
    const std::uint64_t index = next_++;
    if (!by_time && index >= options_.count) return std::nullopt;
    if (by_time)
      progress_.steps(static_cast<std::size_t>(elapsed),
                      static_cast<std::size_t>(std::ceil(options_.seconds)));
    else
      progress_.steps(index, options_.count);
    return index;
  }
  void stop() { stopped_ = true; }

 private:
  const FuzzOptions& options_;
  Progress progress_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::atomic<std::uint64_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
};

CampaignTally work(const FuzzOptions& options, CaseNumbers& numbers, FindingsFolder& findings) {
  CampaignTally tally;
  try {
    while (const auto index = numbers.next()) {
      const PointCase made = random_point_case(options.campaign, *index);
      const CaseResult result = try_point_case(made, options.campaign.mesh);
      if (result.outcome == CaseOutcome::kFinding) findings.add(made, result);
      tally.add(made, result);
    }
  } catch (...) {
    numbers.stop();
    throw;
  }
  return tally;
}

CampaignTally run_campaign(const FuzzOptions& options) {
  CaseNumbers numbers(options);
  FindingsFolder findings(options);
  const unsigned threads =
      options.threads == 0 ? std::max(1U, std::thread::hardware_concurrency()) : options.threads;
  std::vector<std::future<CampaignTally>> workers;
  for (unsigned i = 0; i < threads; ++i)
    workers.push_back(
        std::async(std::launch::async, [&] { return work(options, numbers, findings); }));
  CampaignTally tally;
  for (auto& worker : workers) tally.merge(worker.get());
  return tally;
}

// --- the table
// ------------------------------------------------------------------------------------

/// "arctan(1/2)"; where the fraction is long, degrees instead.
std::string angle_text(const std::optional<Corner<Rational>>& corner) {
  if (!corner) return "-";
  constexpr std::size_t kLongest = 20;
  std::string exact = arctangent_text(*corner);
  if (exact.size() <= kLongest) return exact;
  return fmt::format("{:.6f} degrees", JudgedCorner{{}, corner->cross, corner->dot}.degrees());
}

std::string table_row(const std::string& family, const FamilyTally& t) {
  return fmt::format(
      "{:<16} {:>6} {:>6} {:>6} {:>7} {:>6} {:>6} {:>5} {:>7} {:>10} {:>7.2f} {:>7.2f} {:>8.2f} "
      "{:>7.4f}  {:<20}  {}\n",
      family, t.sets, t.count(CaseOutcome::kProved), t.count(CaseOutcome::kTooDeep),
      t.count(CaseOutcome::kTooFarOut), t.count(CaseOutcome::kTooManyCells),
      t.count(CaseOutcome::kOutOfRange), t.count(CaseOutcome::kFinding), t.merged, t.cells,
      t.smallest_cells_per_point, t.mean_cells_per_point(), t.largest_cells_per_point,
      t.largest_quads_per_cell, angle_text(t.smallest), angle_text(t.largest));
}

template <class Names, class Values>
std::string counts_line(const std::string& title, const Names& names, const Values& values) {
  std::string text = title;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{} {}: {}", i == 0 ? "" : ",", names[i], values[i]);
  return text + "\n";
}

std::string table(const CampaignTally& tally) {
  std::string text = fmt::format(
      "{:<16} {:>6} {:>6} {:>6} {:>7} {:>6} {:>6} {:>5} {:>7} {:>10} {:>7} {:>7} {:>8} {:>7}  "
      "{:<20}  {}\n",
      "family", "sets", "proved", "deep", "far out", "budget", "range", "found", "merged", "cells",
      "N/n min", "mean", "max", "quads/N", "smallest angle", "largest angle");
  for (const auto& [family, of_family] : tally.families) text += table_row(family, of_family);
  const FamilyTally total = tally.total();
  text += table_row("all", total);
  text += counts_line("templates:", kTemplateNames, tally.counters.templates);
  text += counts_line("stitching cases:", kStitchCaseNames, tally.counters.stitch_cases);
  text += counts_line("quads:", kConstructionNames, tally.counters.quads);
  return text + fmt::format(
                    "sets with an angle beyond its bound by more than rounding once stored "
                    "as doubles: {}\n",
                    total.beyond_rounding);
}

// --- the report
// -----------------------------------------------------------------------------------

using Json = nlohmann::ordered_json;

Json json_of(const std::optional<Corner<Rational>>& corner) {
  return corner ? Json(arctangent_text(*corner)) : Json(nullptr);
}

Json json_of(const FamilyTally& t) {
  return {{"sets", t.sets},
          {"proved", t.count(CaseOutcome::kProved)},
          {"refused",
           {{"too_deep", t.count(CaseOutcome::kTooDeep)},
            {"too_far_out", t.count(CaseOutcome::kTooFarOut)},
            {"too_many_cells", t.count(CaseOutcome::kTooManyCells)},
            {"out_of_range", t.count(CaseOutcome::kOutOfRange)}}},
          {"findings", t.count(CaseOutcome::kFinding)},
          {"merged_points", t.merged},
          {"points", t.points},
          {"cells", t.cells},
          {"cells_per_point",
           {{"min", t.smallest_cells_per_point},
            {"mean", t.mean_cells_per_point()},
            {"max", t.largest_cells_per_point}}},
          {"quads_per_cell_max", t.largest_quads_per_cell},
          {"smallest_angle", json_of(t.smallest)},
          {"largest_angle", json_of(t.largest)},
          {"stored_beyond_rounding", t.beyond_rounding}};
}

template <class Names, class Values>
Json json_of_counts(const Names& names, const Values& values) {
  Json json = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) json[std::string(names[i])] = values[i];
  return json;
}

/// No times and no threads: the same campaign gives the same bytes.
std::string report_text(const FuzzOptions& options, const CampaignTally& tally) {
  Json json{{"format", "quadbound-fuzz-report"},
            {"version", 1},
            {"seed", options.campaign.seed},
            {"max_n", options.campaign.max_n},
            {"max_cells", options.campaign.mesh.budget.max_cells}};
  json["all"] = json_of(tally.total());
  for (const auto& [family, of_family] : tally.families)
    json["families"][family] = json_of(of_family);
  json["templates"] = json_of_counts(kTemplateNames, tally.counters.templates);
  json["stitching_cases"] = json_of_counts(kStitchCaseNames, tally.counters.stitch_cases);
  json["quads"] = json_of_counts(kConstructionNames, tally.counters.quads);
  json["never_reached"] = tally.never_reached();
  json["findings"] = Json::array();
  const FindingsFolder folder(options);
  for (const Finding& finding : tally.findings)
    json["findings"].push_back({{"index", finding.made.index},
                                {"claim", finding.claim},
                                {"origin", origin(finding.made)},
                                {"replay", folder.replay(finding.made)},
                                {"detail", finding.detail}});
  return json.dump(1) + "\n";
}

// --- the command
// ----------------------------------------------------------------------------------

constexpr std::uint64_t kSetsThatReachAll = 100;

ExitStatus verdict(const CampaignTally& tally) {
  bool good = tally.findings.empty();
  if (tally.total().sets >= kSetsThatReachAll) {
    for (const std::string& name : tally.never_reached()) {
      fmt::print(stderr, "quadbound: {} was never reached: the campaign is too narrow\n", name);
      good = false;
    }
  }
  return good ? kGood : kClaimFailed;
}

ExitStatus fuzz(FuzzOptions& options) {
  if (options.campaign.families.empty()) options.campaign.families = all_point_families();
  for (const std::string& family : options.campaign.families)
    (void)find_family(point_families(), family);  // refuse before the work
  const CampaignTally tally = run_campaign(options);
  if (!options.report.empty()) {
    write_file(options.report,
               [&](std::ostream& stream) { stream << report_text(options, tally); });
  }
  if (!options.quiet) fmt::print("{}", table(tally));
  return verdict(tally);
}

constexpr const char* kFooter =
    R"(Every set is moved, turned and scaled at random, meshed and judged on every claim. Columns:
deep, far out: refused as the closest points are closer than 2^-50 of the extent, or of the largest
coordinate only; budget: refused by --max-cells; range: coordinates beyond 2^-1000 to 2^1000;
merged: points left out as moving the set rounded them onto others.

A finding is written at once to the folder of --findings, with its replay command in INDEX there.

Examples:
  quadbound fuzz --points --count 1000 --seed 7
  quadbound fuzz --points --seconds 60 --families line,grid --threads 0 --report fuzz.json
  quadbound fuzz --points --warp paper   (ends with status 1: the paper's warping))";

void add_campaign_options(CLI::App& command, FuzzOptions& options) {
  auto* count = command.add_option("--count", options.count, "number of sets");
  count->capture_default_str();
  command.add_option("--seconds", options.seconds, "go on for so long instead")
      ->check(CLI::PositiveNumber)
      ->excludes(count);
  command.add_option("--seed", options.campaign.seed, "the same seed gives the same sets")
      ->capture_default_str();
  command.add_option("--families", options.campaign.families, "only these, separated by commas")
      ->delimiter(',');
  command.add_option("--max-n", options.campaign.max_n, "the most points of a set")
      ->check(CLI::Range(std::uint64_t{1}, kMaxRecipeSize))
      ->capture_default_str();
  command.add_option("--warp", options.campaign.mesh.warping, "warping to the points")
      ->transform(CLI::CheckedTransformer(kWarpings))
      ->option_text("aligned|paper (default aligned)");
  options.campaign.mesh.budget.max_cells = 10'000'000;
  command
      .add_option("--max-cells", options.campaign.mesh.budget.max_cells,
                  "refuse sets beyond so many quadtree cells")
      ->capture_default_str();
}

}  // namespace

void add_fuzz_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<FuzzOptions>();
  CLI::App* command = app.add_subcommand("fuzz", "mesh and judge random inputs");
  command->footer(kFooter);
  command->add_flag("--points", options->points, "random sets of points (thm-1)")->required();
  add_campaign_options(*command, *options);
  command->add_option("--findings", options->findings, "folder for findings")
      ->capture_default_str();
  command->add_option("--report", options->report, "write the table as JSON");
  command->add_option("--threads", options->threads, "threads, 0 for all cores")
      ->capture_default_str();
  command->add_flag("-q,--quiet", options->quiet, "only the exit status");
  command->callback([options, &outcome] { outcome.status = fuzz(*options); });
}

}  // namespace quadbound::cli
