// SPDX-License-Identifier: Apache-2.0
// The cases of a campaign of polygons in child processes, and its findings.
#include <fmt/format.h>

#include <exception>
#include <sstream>

#include "cli/polygon_campaign.hpp"
#include "cli/shrink_polygon.hpp"
#include "model/files.hpp"
#include "model/write_polygon.hpp"

namespace quadbound::cli {
namespace {

constexpr std::uint64_t kDefaultMaxCells = 2'000'000;

}  // namespace

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

TaskLimits limits_of(const FuzzOptions& options) {
  return {3 * options.max_seconds, options.max_megabytes};
}

const std::string& family_of(const PolygonCampaign& campaign, std::uint64_t index) {
  return campaign.families[index % campaign.families.size()];
}

std::string journal_path(const FuzzOptions& options) {
  if (!options.journal.empty()) return options.journal;
  const Shard& shard = options.shard;
  const std::string part = shard.of == 1 ? "" : fmt::format("-{}-of-{}", shard.number, shard.of);
  return fmt::format("{}/journal-{}{}.jsonl", options.findings, options.seed, part);
}

bool is_in_shard(const PolygonCampaign& campaign, const Shard& shard, std::uint64_t index) {
  // Families take turns; so do shards, from one round of the families to the next.
  const std::uint64_t families = campaign.families.size();
  return (index % families + index / families) % shard.of == shard.number - 1;
}

std::string try_case(const PolygonCampaign& campaign, std::uint64_t index,
                     const PolygonTrial& trial) {
  const PolygonCase made = random_polygon_case(campaign, index);
  PolygonResult result = try_polygon(made.polygon, trial);
  result.recipe = to_text(made.recipe);
  return to_text(result);
}

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

std::string replay_command(const std::string& what, const FuzzOptions& options) {
  std::string command = "quadbound fuzz --replay " + what;
  if (options.max_cells.value_or(kDefaultMaxCells) != kDefaultMaxCells)
    command += fmt::format(" --max-cells {}", *options.max_cells);
  if (options.max_seconds != FuzzOptions{}.max_seconds)
    command += fmt::format(" --max-seconds {}", options.max_seconds);
  if (options.min_tangent && *options.min_tangent != kTheorem13.smallest)
    command += fmt::format(" --min-tangent {}/{}", options.min_tangent->numerator,
                           options.min_tangent->denominator);
  return command;
}

std::string PolygonFindings::case_path(std::uint64_t index) const {
  return folder_.path(fmt::format("polygon-{}-{}.geojson", options_.seed, index));
}

std::string PolygonFindings::small_path(std::uint64_t index) const {
  return folder_.path(fmt::format("polygon-{}-{}-small.geojson", options_.seed, index));
}

std::string PolygonFindings::replay(std::uint64_t index) const {
  return replay_command(case_path(index), options_);
}

void PolygonFindings::add(std::uint64_t index, const PolygonResult& result,
                          const Polygon& polygon) const {
  try {
    folder_.write_case(case_path(index),
                       [&](std::ostream& stream) { write_geojson(stream, polygon); });
    folder_.note({result.claim, result.recipe, replay(index), result.detail});
  } catch (const OutputError&) {
    fmt::print(stderr, "quadbound: finding that cannot be kept: {}: {}\n", result.claim,
               replay_command(result.recipe, options_));
    throw;
  }
}

void PolygonFindings::add_without_polygon(std::uint64_t index, const PolygonResult& result) const {
  folder_.write_case(folder_.path(fmt::format("polygon-{}-{}.txt", options_.seed, index)),
                     [&](std::ostream& stream) { stream << result.detail << "\n"; });
  folder_.note({result.claim, "no polygon", fmt::format("case {}", index), result.detail});
}

void PolygonFindings::add_small(std::uint64_t index, const std::string& geojson) const {
  if (!geojson.empty())
    folder_.write_case(small_path(index), [&](std::ostream& stream) { stream << geojson; });
  if (options_.quiet) return;
  if (geojson.empty())
    fmt::print(stderr, "quadbound: {} did not fail again\n", case_path(index));
  else
    fmt::print(stderr, "quadbound: shrunk to {}\n", small_path(index));
}

}  // namespace quadbound::cli
