// SPDX-License-Identifier: Apache-2.0
// The campaign of polygons: child processes that mesh and judge, and what becomes of their answers.
#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/campaign.hpp"
#include "cli/case_workers.hpp"
#include "cli/interruption.hpp"
#include "cli/isolated_task.hpp"
#include "cli/polygon_campaign.hpp"
#include "cli/polygon_journal.hpp"
#include "cli/task_pool.hpp"

namespace quadbound::cli {
namespace {

constexpr const char* kNoPolygon = "generator";  ///< the claim of a case without a polygon

/// Child processes of this one, as many as there are threads.
class LocalWorkers : public CaseWorkers {
 public:
  explicit LocalWorkers(const FuzzOptions& options)
      : options_(options), campaign_(campaign_of(options)), pool_(workers_of(options)) {}

  [[nodiscard]] bool has_room() const override { return pool_.has_room(); }
  [[nodiscard]] bool is_idle() const override { return pool_.is_idle(); }
  void start(std::uint64_t index) override {
    const auto work = [&] { return try_case(campaign_, index, trial_of(options_)); };
    pool_.start(work, limits_of(options_),
                [this, index](const TaskOutcome& outcome) { over_.emplace_back(index, outcome); });
  }
  void wait(const Done& done) override {
    pool_.wait(kGlance);
    for (const auto& [index, outcome] : std::exchange(over_, {})) done(index, outcome);
  }

 private:
  const FuzzOptions& options_;
  PolygonCampaign campaign_;
  TaskPool pool_;
  std::vector<std::pair<std::uint64_t, TaskOutcome>> over_;
};

/// Keeps the workers at work. What they answer goes to the folder of findings, then to the journal,
/// then to the tally: a case that is in the journal is done.
class PolygonRunner {
 public:
  PolygonRunner(const FuzzOptions& options, CaseWorkers& workers)
      : options_(options),
        workers_(workers),
        campaign_(campaign_of(options)),
        findings_(options),
        journal_(options, tally_),
        done_before_(tally_.all.cases),
        numbers_(options) {
    shrink_the_rest();
  }

  /// Ends where there is no case left, or on an interruption.
  const PolygonTally& run() {
    while (!Interruption::came()) {
      start_shrinking();
      while (workers_.has_room() && start_case()) {
      }
      if (workers_.is_idle() && shrinkers_.is_idle()) break;
      workers_.wait(
          [this](std::uint64_t index, const TaskOutcome& outcome) { finish_case(index, outcome); });
      shrinkers_.wait(workers_.is_idle() ? kGlance : std::chrono::milliseconds(0));
    }
    if (!Interruption::came()) journal_.end(options_);
    return tally_;
  }

  [[nodiscard]] const std::string& journal() const { return journal_.path(); }

 private:
  struct ToShrink {
    std::uint64_t index;
    std::string claim;
    std::string recipe;
  };

  /// Findings of the journal that the program did not come to shrink.
  void shrink_the_rest() {
    if (options_.shrink_tries == 0) return;
    for (const auto& [index, finding] : tally_.findings)
      if (finding.claim != kNoPolygon && !std::filesystem::exists(findings_.small_path(index)))
        to_shrink_.push_back({index, finding.claim, finding.recipe});
  }

  /// One finding at a time, beside the cases.
  void start_shrinking() {
    if (to_shrink_.empty() || !shrinkers_.has_room()) return;
    const ToShrink finding = std::move(to_shrink_.front());
    to_shrink_.pop_front();
    const auto work = [&] {
      const Polygon polygon = generate_polygon(parse_polygon_recipe(finding.recipe));
      return shrunk_text(polygon, finding.claim, options_);
    };
    // Tries have their own limits; a shrinker that takes longer is given up.
    shrinkers_.start(work, {kSecondsOfAShrinker, 2 * options_.max_megabytes},
                     [this, index = finding.index](const TaskOutcome& outcome) {
                       if (outcome.end == TaskEnd::kAnswered)
                         findings_.add_small(index, outcome.answer);
                     });
  }

  /// Of a case of this shard that is not yet in the journal.
  std::optional<std::uint64_t> next_index() {
    while (const auto index = numbers_.next())
      if (is_in_shard(campaign_, options_.shard, *index) && !journal_.has(*index)) return index;
    return std::nullopt;
  }

  bool start_case() {
    const auto index = next_index();
    if (index) workers_.start(*index);
    return index.has_value();
  }

  void finish_case(std::uint64_t index, const TaskOutcome& outcome) {
    const std::string& family = family_of(campaign_, index);
    PolygonResult result = result_of(outcome);
    if (result.outcome == PolygonOutcome::kFinding) report(index, result);
    result = tally_.news(index, std::move(result), family);
    journal_.add(index, result);
    tally_.add(index, result, family);
    say_how_far();
  }

  /// The child's polygon is made again, first in another child, as what makes it may be at fault.
  void report(std::uint64_t index, PolygonResult& result) {
    const TaskOutcome made = run_isolated(
        [&] { return to_text(random_polygon_case(campaign_, index).recipe); }, limits_of(options_));
    if (made.end != TaskEnd::kAnswered) {
      result.claim = kNoPolygon;
      findings_.add_without_polygon(index, result);
      return;
    }
    result.recipe = made.answer;
    findings_.add(index, result, generate_polygon(parse_polygon_recipe(made.answer)));
    if (options_.shrink_tries != 0) to_shrink_.push_back({index, result.claim, made.answer});
  }

  void say_how_far() {
    const auto& all = tally_.all;
    numbers_.say(fmt::format("{:.1f} cases/s, {} findings, {} refused, angles {} to {}",
                             static_cast<double>(all.cases - done_before_) / numbers_.elapsed(),
                             tally_.findings.size(), tally_.refusals.size(),
                             angle_text(all.smallest.corner), angle_text(all.largest.corner)));
  }

  const FuzzOptions& options_;
  CaseWorkers& workers_;
  PolygonCampaign campaign_;
  PolygonFindings findings_;
  PolygonTally tally_;
  PolygonJournal journal_;
  std::uint64_t done_before_;
  CaseNumbers numbers_;
  std::deque<ToShrink> to_shrink_;
  TaskPool shrinkers_{1};
};

}  // namespace

ExitStatus run_campaign(const FuzzOptions& options, CaseWorkers& workers,
                        const std::function<void()>& on_end) {
  const Interruption interruption;
  PolygonTally tally;
  std::string journal;
  {
    PolygonRunner runner(options, workers);
    tally = runner.run();
    journal = runner.journal();
  }
  on_end();
  const bool has_ended = !Interruption::came();
  const ExitStatus status = conclude(options, tally, has_ended);
  if (has_ended) return status;
  fmt::print(stderr,
             "quadbound: interrupted after {} cases, which are in {}; the same command with "
             "--resume goes on\n",
             tally.all.cases, journal);
  Interruption::carry_out();
}

ExitStatus fuzz_polygons(const FuzzOptions& options) {
  if (!options.replay.empty()) return replay_polygon(options);
  if (!options.corpus.empty()) return replay_corpus(options);
  if (!options.merge.empty()) return merge_journals(options);
  if (!options.search.empty()) return search_polygons(options);
  LocalWorkers workers(options);
  return run_campaign(options, workers, [] {});
}

}  // namespace quadbound::cli
