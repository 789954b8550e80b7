// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the parts of the campaigns of polygons share: their cases, findings, table and summary.

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "cli/campaign.hpp"
#include "cli/case_workers.hpp"
#include "cli/fuzz_polygons.hpp"
#include "cli/isolated_task.hpp"
#include "cli/polygon_tally.hpp"
#include "model/polygon.hpp"

namespace quadbound::cli {

PolygonTrial trial_of(const FuzzOptions& options);
/// Errors: RecipeError for a family that does not exist.
PolygonCampaign campaign_of(const FuzzOptions& options);
/// The mesher gives up at --max-seconds; the rest is for the judge.
TaskLimits limits_of(const FuzzOptions& options);
const std::string& family_of(const PolygonCampaign& campaign, std::uint64_t index);
/// Guarantees: 1. each case is in one of the shards. 2. Every shard has all families, in turn, and
/// as many cases as the others, up to the number of families.
bool is_in_shard(const PolygonCampaign& campaign, const Shard& shard, std::uint64_t index);
/// That of --journal, or one in the folder of --findings.
std::string journal_path(const FuzzOptions& options);

// --- a case in a process of its own --------------------------------------------------------------

/// The result as text of a case of a campaign; the work of a child process.
std::string try_case(const PolygonCampaign& campaign, std::uint64_t index,
                     const PolygonTrial& trial);
/// Of a child process whose answer is a result; other ends are findings.
PolygonResult result_of(const TaskOutcome& outcome);
PolygonResult try_isolated(const Polygon& polygon, const FuzzOptions& options);
/// Runs in a process of its own: a shrunk polygon as GeoJSON, empty where the polygon does not fail
/// again. Every try has a process as well.
std::string shrunk_text(const Polygon& polygon, const std::string& claim,
                        const FuzzOptions& options);

inline constexpr double kSecondsOfAShrinker = 60;
/// Deadlines and signals are looked at so often.
inline constexpr std::chrono::milliseconds kGlance{500};

// --- findings ------------------------------------------------------------------------------------

/// The command that tries a file or a recipe as the campaign does.
std::string replay_command(const std::string& what, const FuzzOptions& options);

/// The findings of a campaign on disk; whatever its order or its restarts, the same names.
class PolygonFindings {
 public:
  explicit PolygonFindings(const FuzzOptions& options) : options_(options), folder_(options) {}

  [[nodiscard]] std::string case_path(std::uint64_t index) const;
  [[nodiscard]] std::string small_path(std::uint64_t index) const;
  /// The command that tries the case again.
  [[nodiscard]] std::string replay(std::uint64_t index) const;

  /// Errors: OutputError; then the finding has at least been said on standard error.
  void add(std::uint64_t index, const PolygonResult& result, const Polygon& polygon) const;
  /// Where not even the polygon could be made.
  void add_without_polygon(std::uint64_t index, const PolygonResult& result) const;
  /// What the shrinker came to.
  void add_small(std::uint64_t index, const std::string& geojson) const;

 private:
  const FuzzOptions& options_;
  FindingsFolder folder_;
};

// --- what is told at the end ---------------------------------------------------------------------

std::string table(const PolygonTally& tally);

/// No times and no threads: the same campaign gives the same bytes.
std::string summary_text(const FuzzOptions& options, const PolygonTally& tally, bool has_ended);

/// Writes the summary, the picture and the worst ever seen, and prints the table. A wide campaign
/// that never reached a construction is not good, nor is one with findings. Errors: OutputError.
ExitStatus conclude(const FuzzOptions& options, const PolygonTally& tally, bool has_ended);

/// "thm-13 proved: ...", "claim ...", or "refused: ...".
std::string verdict_text(const PolygonResult& result);

// --- other ways to run ---------------------------------------------------------------------------

/// The campaign of the options with these workers. `on_end` is called when no case is left, or on
/// an interruption, before the summary is written. After an interruption it does not return.
ExitStatus run_campaign(const FuzzOptions& options, CaseWorkers& workers,
                        const std::function<void()>& on_end);
ExitStatus replay_polygon(const FuzzOptions& options);
ExitStatus replay_corpus(const FuzzOptions& options);
/// The table and summary of the campaign that these journals are shards of, as one run would have
/// given them.
ExitStatus merge_journals(const FuzzOptions& options);

}  // namespace quadbound::cli
