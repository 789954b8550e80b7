// SPDX-License-Identifier: Apache-2.0
// The campaign of point sets: threads that mesh and judge, its table and its report.
#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "cli/campaign.hpp"
#include "cli/fuzz_points.hpp"
#include "model/files.hpp"

namespace quadbound::cli {
namespace {

// --- findings ------------------------------------------------------------------------------------

std::string_view grid_name(GridRefinement refinement) {
  return refinement == GridRefinement::kFiveByFive ? "5x5" : "6x6";
}

/// The recipe, the transform and what else made the case, in one line.
std::string origin(const PointCase& made) {
  return fmt::format("{} {} grid={}", to_text(made.recipe), to_text(made.transform),
                     grid_name(made.refinement));
}

/// Puts every finding on disk at once: a campaign that crashes later loses none.
class PointFindings {
 public:
  PointFindings(const FuzzOptions& options, const PointCampaign& campaign)
      : folder_(options), campaign_(campaign) {}

  [[nodiscard]] std::string replay(const PointCase& made) const {
    return fmt::format("quadbound mesh --points {} --grid {}{}", case_path(made),
                       grid_name(made.refinement),
                       campaign_.mesh.warping == Warping::kPaper ? " --warp paper" : "");
  }

  void add(const PointCase& made, const CaseResult& result) {
    const std::lock_guard lock(mutex_);
    folder_.write_case(case_path(made), [&made](std::ostream& stream) {
      stream << "x,y\n";
      for (const Point& p : made.points.points) stream << fmt::format("{},{}\n", p.x, p.y);
    });
    folder_.note({result.claim, origin(made), replay(made), result.detail});
  }

 private:
  [[nodiscard]] std::string case_path(const PointCase& made) const {
    return folder_.path(fmt::format("points-{}-{}.csv", campaign_.seed, made.index));
  }

  FindingsFolder folder_;
  const PointCampaign& campaign_;
  std::mutex mutex_;
};

// --- the campaign --------------------------------------------------------------------------------

CampaignTally work(const PointCampaign& campaign, CaseNumbers& numbers, PointFindings& findings) {
  CampaignTally tally;
  try {
    while (const auto index = numbers.next()) {
      const PointCase made = random_point_case(campaign, *index);
      const CaseResult result = try_point_case(made, campaign.mesh);
      if (result.outcome == CaseOutcome::kFinding) findings.add(made, result);
      tally.add(made, result);
    }
  } catch (...) {
    numbers.stop();
    throw;
  }
  return tally;
}

CampaignTally run_campaign(const FuzzOptions& options, const PointCampaign& campaign,
                           PointFindings& findings) {
  CaseNumbers numbers(options);
  std::vector<std::future<CampaignTally>> workers;
  for (unsigned i = 0; i < workers_of(options); ++i)
    workers.push_back(
        std::async(std::launch::async, [&] { return work(campaign, numbers, findings); }));
  CampaignTally tally;
  for (auto& worker : workers) tally.merge(worker.get());
  return tally;
}

// --- the table -----------------------------------------------------------------------------------

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

// --- the report ----------------------------------------------------------------------------------

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
          {"smallest_angle", angle_json(t.smallest)},
          {"largest_angle", angle_json(t.largest)},
          {"stored_beyond_rounding", t.beyond_rounding}};
}

/// No times and no threads: the same campaign gives the same bytes.
std::string report_text(const PointCampaign& campaign, const PointFindings& folder,
                        const CampaignTally& tally) {
  Json json{{"format", "quadbound-fuzz-report"},
            {"version", 1},
            {"seed", campaign.seed},
            {"max_n", campaign.max_n},
            {"max_cells", campaign.mesh.budget.max_cells}};
  json["all"] = json_of(tally.total());
  for (const auto& [family, of_family] : tally.families)
    json["families"][family] = json_of(of_family);
  json["templates"] = counts_json(kTemplateNames, tally.counters.templates);
  json["stitching_cases"] = counts_json(kStitchCaseNames, tally.counters.stitch_cases);
  json["quads"] = counts_json(kConstructionNames, tally.counters.quads);
  json["never_reached"] = tally.never_reached();
  json["findings"] = Json::array();
  for (const Finding& finding : tally.findings)
    json["findings"].push_back({{"index", finding.made.index},
                                {"claim", finding.claim},
                                {"origin", origin(finding.made)},
                                {"replay", folder.replay(finding.made)},
                                {"detail", finding.detail}});
  return json.dump(1) + "\n";
}

constexpr std::uint64_t kSetsThatReachAll = 100;

PointCampaign campaign_of(const FuzzOptions& options) {
  PointCampaign campaign;
  campaign.seed = options.seed;
  campaign.max_n = options.max_n.value_or(campaign.max_n);
  campaign.families = chosen_families(options, point_families());
  campaign.mesh.warping = options.warping;
  constexpr std::uint64_t kMostCellsOfASet = 10'000'000;
  campaign.mesh.budget.max_cells = options.max_cells.value_or(kMostCellsOfASet);
  return campaign;
}

}  // namespace

ExitStatus fuzz_points(const FuzzOptions& options) {
  const PointCampaign campaign = campaign_of(options);
  PointFindings findings(options, campaign);
  const CampaignTally tally = run_campaign(options, campaign, findings);
  if (!options.summary.empty()) {
    write_file(options.summary,
               [&](std::ostream& stream) { stream << report_text(campaign, findings, tally); });
  }
  if (!options.quiet) fmt::print("{}", table(tally));
  const bool is_wide = tally.total().sets < kSetsThatReachAll || reached_all(tally.never_reached());
  return tally.findings.empty() && is_wide ? kGood : kClaimFailed;
}

}  // namespace quadbound::cli
