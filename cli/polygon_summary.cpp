// SPDX-License-Identifier: Apache-2.0
// The table and the summary of a campaign of polygons.
#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/campaign_picture.hpp"
#include "cli/polygon_campaign.hpp"
#include "cli/worst_ever.hpp"
#include "model/files.hpp"
#include "verify/report.hpp"

namespace quadbound::cli {
namespace {

// --- the table -----------------------------------------------------------------------------------

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
                         const std::map<std::uint64_t, PolygonTally::Remark>& remarks) {
  constexpr std::size_t kMostShown = 20;
  if (remarks.empty()) return {};
  std::string text = fmt::format("\n{}: {}\n", title, remarks.size());
  std::size_t shown = 0;
  for (const auto& [index, remark] : remarks) {
    if (shown++ == kMostShown) return text + "  ...\n";
    text += fmt::format("  case {} {} {}{}{}\n", index, remark.recipe, remark.claim,
                        remark.claim.empty() ? "" : ": ", remark.detail);
  }
  return text;
}

// --- the summary ---------------------------------------------------------------------------------

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

/// Where each bin starts, and how many meshes are in it.
Json json_of(const Histogram& histogram, double (*start)(std::int64_t)) {
  Json json = Json::array();
  for (const auto& [bin, count] : histogram) json.push_back({start(bin), count});
  return json;
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

Json json_of(std::uint64_t index, const PolygonTally::Remark& remark) {
  Json json{{"index", index}};
  if (!remark.claim.empty()) json["claim"] = remark.claim;
  json["recipe"] = remark.recipe;
  json["detail"] = remark.detail;
  return json;
}

}  // namespace

std::string table(const PolygonTally& tally) {
  return families_table(tally) + constructions_table(tally) + "\n" +
         counts_line("counters:", kPolygonCounterNames, tally.counts) +
         remarks_text("refused", tally.refusals) + remarks_text("findings", tally.findings);
}

std::string summary_text(const FuzzOptions& options, const PolygonTally& tally, bool has_ended) {
  const PolygonCampaign campaign = campaign_of(options);
  const PolygonTrial trial = trial_of(options);
  Json json{{"format", "quadbound-fuzz-polygons"},
            {"version", 1},
            {"seed", campaign.seed},
            {"max_n", campaign.max_n},
            {"max_cells", trial.budget.max_cells},
            {"max_seconds", trial.budget.max_seconds}};
  if (options.shard.of != 1) json["shard"] = {options.shard.number, options.shard.of};
  if (!has_ended) json["unfinished"] = true;
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
  json["histograms"] = {
      {"smallest_angle", json_of(tally.smallest_angles, smallest_angle_bin_start)},
      {"largest_angle", json_of(tally.largest_angles, largest_angle_bin_start)},
      {"cells_per_vertex", json_of(tally.cells_per_vertex, ratio_bin_start)},
      {"quads_per_cell", json_of(tally.quads_per_cell, quads_bin_start)}};
  json["refusals"] = Json::array();
  for (const auto& [index, refusal] : tally.refusals)
    json["refusals"].push_back(json_of(index, refusal));
  json["findings"] = Json::array();
  const PolygonFindings folder(options);
  for (const auto& [index, finding] : tally.findings) {
    json["findings"].push_back(json_of(index, finding));
    json["findings"].back()["replay"] = folder.replay(index);
  }
  return json.dump(1) + "\n";
}

ExitStatus conclude(const FuzzOptions& options, const PolygonTally& tally, bool has_ended) {
  constexpr std::uint64_t kCasesThatReachAll = 1000;
  if (!options.summary.empty())
    write_file(options.summary,
               [&](std::ostream& stream) { stream << summary_text(options, tally, has_ended); });
  if (!options.picture.empty()) write_campaign_picture(options.picture, tally);
  if (!options.worst_ever.empty()) {
    WorstEver worst(options.worst_ever);
    worst.add(tally.constructions);
    worst.write();
  }
  if (!options.quiet) fmt::print("{}", table(tally));
  const bool must_reach_all = has_ended && tally.all.cases >= kCasesThatReachAll;
  const bool is_wide = !must_reach_all || reached_all(tally.never_reached());
  return tally.findings.empty() && is_wide ? kGood : kClaimFailed;
}

}  // namespace quadbound::cli
