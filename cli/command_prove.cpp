// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "paper/lemma_claims.hpp"
#include "paper/lemma_report.hpp"
#include "paper/theorem_1_table.hpp"

namespace quadbound::cli {
namespace {

struct ProveCommand {
  std::string theorem;
  std::uint64_t trees = 500;
};

constexpr const char* kLemmas = "lemmas";

/// Shows the census on the progress line.
class CensusWatcher final : public Watcher {
 public:
  void stage(const std::string& name) override { progress_.stage(name); }
  void steps(std::size_t done, std::size_t total) override { progress_.steps(done, total); }
  void finished(const std::string& /*step*/, double /*seconds*/) override {}

 private:
  Progress progress_;
};

ExitStatus audit(const ProveCommand& options) {
  const LemmaAudits audits = [&options] {
    CensusWatcher watcher;
    return audit_paper_lemmas(options.trees, watcher);
  }();
  fmt::print("{}\n", to_text(audits));
  for (const PaperClaim& claim : lemma_claims(audits))
    fmt::print("{:<14} {:<84} {}\n", claim.id, claim.what, verdict_text(claim));
  return lemmas_hold(audits) ? kGood : kClaimFailed;
}

ExitStatus prove(const ProveCommand& options) {
  if (options.theorem == kLemmas) return audit(options);
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
      "never met, or a shape is met that is not listed.\n"
      "lemmas: Observations 1 and 2, Table 1 and Lemmas 2 to 12, decided in integers on random "
      "trees "
      "cut by\n"
      "lines and on corners. Status 1 if what is said to hold was broken, or a counterexample is "
      "none.\n\n"
      "Examples:\n  quadbound prove theorem-1\n  quadbound prove lemmas --trees 100000");
  command->add_option("THEOREM", options->theorem, "theorem-1 or lemmas")
      ->required()
      ->check(CLI::IsMember({"theorem-1", kLemmas}));
  command
      ->add_option("--trees", options->trees,
                   "random trees of the census or the audit; 0 for the proof alone")
      ->capture_default_str();
  command->callback([options, &outcome] { outcome.status = prove(*options); });
}

}  // namespace quadbound::cli
