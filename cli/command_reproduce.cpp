// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "paper/reproduce.hpp"

namespace quadbound::cli {
namespace {

/// The progress line, and a line that stays for every finished step.
class TerminalWatcher final : public Watcher {
 public:
  void stage(const std::string& name) override {
    progress_.stage(name);
    progress_.steps(0, 0);
  }
  void steps(std::size_t done, std::size_t total) override { progress_.steps(done, total); }
  void finished(const std::string& step, double seconds) override {
    const char* const clear = ::isatty(STDERR_FILENO) == 1 ? "\r\033[K" : "";
    fmt::print(stderr, "{}{:<32} {:6.1f} s\n", clear, step, seconds);
  }

 private:
  Progress progress_;
};

ExitStatus reproduce_paper(const ReproduceOptions& options) {
  ReproduceResult result;
  {
    TerminalWatcher watcher;
    result = reproduce(options, watcher);
  }
  constexpr const char* kRow = "{:<8} {:<40} {:<40} {:<48} {}\n";
  fmt::print(kRow, "claim", "what", "paper", "ours", "verdict");
  for (const PaperClaim& c : result.claims)
    fmt::print(kRow, c.id, c.what, c.paper, c.ours, verdict_text(c));
  fmt::print("\nReport: {}\n", result.report);
  if (result.holds) return kGood;
  fmt::print(stderr, "quadbound: A CLAIM FAILED: {} says which\n", result.report);
  return kClaimFailed;
}

constexpr const char* kFooter =
    R"(Measures the paper again: Fig. 10 (Lake Superior), cells against points, Theorem 1 case by case,
the paper's own warping, the polygons of Figures 46 to 53, and the lemmas of Section 3 audited. Every
mesh is proved. Some 50 seconds and 0.5 GB on one core.

--full is --max-n {} --trees {} --audits {}; the ones that are given stay as
given. Some 10 minutes and 4.6 GB on one core.

Examples:
  quadbound reproduce
  quadbound reproduce --out /tmp/results --max-n 1000
  quadbound reproduce --full --out /tmp/full)";

/// Sizes that are not given on the command line.
void take_full_sizes(const CLI::App& command, MeasureOptions& measure) {
  const MeasureOptions full = full_measure_options();
  if (command.count("--max-n") == 0) measure.max_n = full.max_n;
  if (command.count("--trees") == 0) measure.trees = full.trees;
  if (command.count("--audits") == 0) measure.audits = full.audits;
}

}  // namespace

void add_reproduce_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<ReproduceOptions>();
  auto full = std::make_shared<bool>(false);
  CLI::App* command =
      app.add_subcommand("reproduce", "the paper's numbers beside ours, with every mesh proved");
  const MeasureOptions sizes = full_measure_options();
  command->footer(fmt::format(kFooter, sizes.max_n, sizes.trees, sizes.audits));
  command->add_option("--out", options->out, "folder for the results")->capture_default_str();
  command->add_option("--data", options->measure.data,
                      "folder with superior-303.csv and .geojson (default paper/data)");
  command->add_option("--max-n", options->measure.max_n, "points of the largest set")
      ->check(CLI::Range(100, 100'000'000))
      ->capture_default_str();
  command->add_option("--trees", options->measure.trees, "random trees of the census")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--audits", options->measure.audits, "random trees of the lemmas' audit")
      ->capture_default_str();
  command
      ->add_option("--threads", options->measure.threads, "threads of the judge, 0 for all cores")
      ->capture_default_str();
  command->add_flag("--full", *full, "larger sizes, for a run that takes long: see below");
  command->callback([options, full, command, &outcome] {
    if (*full) take_full_sizes(*command, options->measure);
    options->command =
        fmt::format("quadbound reproduce --max-n {} --trees {} --audits {}", options->measure.max_n,
                    options->measure.trees, options->measure.audits);
    if (options->measure.data.empty()) options->measure.data = find_data_folder();
    outcome.status = reproduce_paper(*options);
  });
}

}  // namespace quadbound::cli
