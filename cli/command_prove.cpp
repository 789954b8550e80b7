// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "algo/theorem_1.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "generators/points.hpp"

namespace quadbound::cli {
namespace {

struct ProveCommand {
  std::string theorem;
  std::uint64_t trees = 500;
};

/// Random trees reach the templates and stitching cases, point sets the warped quads.
ConfigurationCensus take_census(std::uint64_t trees) {
  constexpr std::uint64_t kLeavesPerTree = 400;
  constexpr std::uint64_t kPointsPerSet = 40;
  ConfigurationCensus census;
  Progress progress;
  progress.stage("census");
  for (std::uint64_t seed = 0; seed < trees; ++seed) {
    progress.steps(seed, trees);
    census.add_tree(random_balanced_tree(seed, kLeavesPerTree));
    const auto recipe = fmt::format("uniform:n={},seed={}", kPointsPerSet, seed);
    census.add_points(generate_points(parse_point_recipe(recipe)).points,
                      seed % 2 == 0 ? GridRefinement::kSixBySix : GridRefinement::kFiveByFive);
  }
  return census;
}

ExitStatus prove(const ProveCommand& options) {
  const ConfigurationCensus census = take_census(options.trees);
  fmt::print(
      "thm-1: every angle is in [arctan(1/2), 180 - arctan(1/2)] = [26.57, 153.43] degrees\n\n");
  fmt::print("{:<18} {:<28} {:<12} {:<22} {:<10} {}\n", "construction", "quad", "smallest",
             "largest", "verdict", "met");
  bool good = census.unlisted() == 0;
  for (std::size_t i = 0; i < census.configurations().size(); ++i) {
    const Configuration& c = census.configurations()[i];
    good = good && c.proved && (census.count(i) > 0 || options.trees == 0);
    const std::string quad = c.name + (c.moves() ? ", warped" : "");
    fmt::print("{:<18} {:<28} {:<12} {:<22} {:<10} {}\n",
               kConstructionNames[static_cast<std::size_t>(c.construction)], quad,
               arctangent_text(c.smallest), arctangent_text(c.largest),
               c.proved ? "proved" : "BROKEN", census.count(i));
  }
  fmt::print(
      "\nWarped quads: the worst of the closed range of positions; proved for all of them.\n"
      "Census: {} quads of {} random trees and {} point sets, {} of them of a shape not listed.\n",
      census.quads(), options.trees, options.trees, census.unlisted());
  return good ? kGood : kClaimFailed;
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
