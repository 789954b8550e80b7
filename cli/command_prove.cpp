// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "model/read_polygon.hpp"
#include "model/validate.hpp"
#include "paper/corner_places.hpp"
#include "paper/insertion_comparison.hpp"
#include "paper/lemma_claims.hpp"
#include "paper/lemma_report.hpp"
#include "paper/theorem_1_table.hpp"

namespace quadbound::cli {
namespace {

struct ProveCommand {
  std::string theorem;
  std::uint64_t trees = 500;
  std::uint64_t seeds = 5;
  std::uint64_t corners = 200;
  std::vector<std::string> files;
};

constexpr const char* kTheorem1 = "theorem-1";
constexpr const char* kLemmas = "lemmas";
constexpr const char* kInsertion = "insertion";
constexpr const char* kCorners = "corners";

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
    return audit_paper_lemmas(options.trees, {}, watcher);
  }();
  fmt::print("{}\n", to_text(audits));
  for (const PaperClaim& claim : lemma_claims(audits))
    fmt::print("{:<14} {:<84} {}\n", claim.id, claim.what, verdict_text(claim));
  return lemmas_hold(audits) ? kGood : kClaimFailed;
}

/// The paper's constructions are there to be counted: what they break is no failure of ours.
ExitStatus compare(const ProveCommand& options) {
  std::vector<Polygon> polygons;
  for (const std::string& file : options.files) polygons.push_back(normalised(read_polygon(file)));
  const InsertionComparison comparison = [&] {
    CensusWatcher watcher;
    return polygons.empty() ? compare_insertions(options.seeds, watcher)
                            : compare_insertions(polygons, watcher);
  }();
  fmt::print("{}", to_text(comparison));
  return kGood;
}

ExitStatus look_for_dead_ends(const ProveCommand& options) {
  const CornerPlaces places = [&options] {
    CensusWatcher watcher;
    return search_corner_places(options.corners, watcher);
  }();
  fmt::print("{}", to_text(places));
  return places.hold() ? kGood : kClaimFailed;
}

/// An option that would do nothing is an error.
void refuse_options_of_others(const CLI::App& command, const std::string& theorem) {
  const auto belongs_to = [&](const char* option, const std::vector<std::string>& theorems) {
    if (command.count(option) > 0 &&
        std::find(theorems.begin(), theorems.end(), theorem) == theorems.end())
      throw CLI::ValidationError(option, "does nothing with " + theorem);
  };
  belongs_to("--trees", {kTheorem1, kLemmas});
  belongs_to("--seeds", {kInsertion});
  belongs_to("FILES", {kInsertion});
  belongs_to("--corners", {kCorners});
}

ExitStatus prove(const ProveCommand& options) {
  if (options.theorem == kCorners) return look_for_dead_ends(options);
  if (options.theorem == kInsertion) return compare(options);
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
      "trees cut\n"
      "by lines, on trees of polygons cut by their edges' lines, and on corners. Status 1 if what "
      "is said\n"
      "to hold was broken, or a counterexample is none.\n"
      "insertion: how many polygons of all families, or of files, the paper's own constructions "
      "(Lemmas 11\n"
      "and 12 by their cases, Section 4 as written) mesh within the bounds, against ours.\n"
      "corners: single corners with the same place in their cells at every level, where a dead\n"
      "end of our search would come back for ever. Status 1 if one is not meshed, or its mesh not\n"
      "proved.\n\n"
      "Examples:\n  quadbound prove theorem-1\n  quadbound prove lemmas --trees 100000\n"
      "  quadbound prove insertion --seeds 20\n  quadbound prove insertion plate.geojson\n"
      "  quadbound prove corners --corners 20000");
  command->add_option("THEOREM", options->theorem, "theorem-1, lemmas, insertion or corners")
      ->required()
      ->check(CLI::IsMember({kTheorem1, kLemmas, kInsertion, kCorners}));
  command->add_option("FILES", options->files, "polygons of insertion, instead of random ones");
  command->add_option("--corners", options->corners, "of corners: how many at each of 36 places")
      ->capture_default_str();
  command->add_option("--seeds", options->seeds, "of insertion: polygons of each family and size")
      ->capture_default_str();
  command
      ->add_option("--trees", options->trees,
                   "random trees of the census or the audit; 0 for the proof alone")
      ->capture_default_str();
  command->callback([command, options, &outcome] {
    refuse_options_of_others(*command, options->theorem);
    outcome.status = prove(*options);
  });
}

}  // namespace quadbound::cli
