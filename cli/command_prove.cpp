// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "paper/theorem_1_table.hpp"

namespace quadbound::cli {
namespace {

struct ProveCommand {
  std::string theorem;
  std::uint64_t trees = 500;
};

/// Shows the census on the progress line.
class CensusWatcher final : public Watcher {
 public:
  void stage(const std::string& name) override { progress_.stage(name); }
  void steps(std::size_t done, std::size_t total) override { progress_.steps(done, total); }
  void finished(const std::string& /*step*/, double /*seconds*/) override {}

 private:
  Progress progress_;
};

ExitStatus prove(const ProveCommand& options) {
  const Theorem1Table table = [&options] {
    CensusWatcher watcher;
    return make_theorem_1_table(options.trees, watcher);
  }();
  fmt::print("{}", to_text(table));
  return table.holds() ? kGood : kClaimFailed;
}

}  // namespace

void add_prove_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<ProveCommand>();
  CLI::App* command = app.add_subcommand("prove", "check a theorem of the paper case by case");
  command->footer(
      "theorem-1: every shape of a quad that templates, stitching and warping can make, its angles "
      "as\n"
      "exact arctangents, and how often random trees met it. Status 1 if a bound is broken, a "
      "shape is\n"
      "never met, or a shape is met that is not listed.\n\nExample:\n  quadbound prove theorem-1");
  command->add_option("THEOREM", options->theorem, "theorem-1")
      ->required()
      ->check(CLI::IsMember({"theorem-1"}));
  command
      ->add_option("--trees", options->trees, "random trees of the census; 0 for the proof alone")
      ->capture_default_str();
  command->callback([options, &outcome] { outcome.status = prove(*options); });
}

}  // namespace quadbound::cli
