// SPDX-License-Identifier: Apache-2.0
// quadbound fuzz: random polygons, or point sets, through the mesher and the judge.
#include <fmt/format.h>

#include <charconv>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "cli/campaign.hpp"

namespace quadbound::cli {
namespace {

const std::map<std::string, Warping> kWarpings{{"aligned", Warping::kAligned},
                                               {"paper", Warping::kPaper}};

constexpr const char* kFooter =
    R"(Polygons: each case has a child process with limits on memory and time, so that a crash or a
hang is a finding like a claim that fails. A finding is written at once to the folder of --findings,
with its replay command in INDEX there, and then shrunk to NAME-small.geojson beside it. Refusals
for --max-cells and --max-seconds are counted apart. A campaign of 1000 cases or more in which a
construction was never reached fails. --corpus replays all polygons of a folder; those below a
folder with the name known-failing must fail.

Points: every set is moved, turned and scaled at random, meshed and judged on every claim. Columns:
deep, far out: refused as the closest points are closer than 2^-50 of the extent, or of the largest
coordinate only; budget: refused by --max-cells; range: coordinates beyond 2^-1000 to 2^1000;
merged: points left out as moving the set rounded them onto others.

Examples:
  quadbound fuzz --count 1000 --seed 7 --summary fuzz.json
  quadbound fuzz --seconds 60 --family star,comb --threads 0
  quadbound fuzz --replay findings/polygon-1-17.geojson
  quadbound fuzz --replay star:n=30,seed=1
  quadbound fuzz --count 100 --min-tangent 2/5   (ends with status 1: a stricter bound)
  quadbound fuzz --points --count 1000 --seed 7
  quadbound fuzz --points --warp paper   (ends with status 1: the paper's warping))";

/// A/B with positive integers.
std::optional<Arctangent> parse_tangent(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  Arctangent tangent{};
  const auto reads = [](std::string_view word, int& value) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    constexpr int kLargest = 7;  // as far as the 128 bits of the judge go
    return error == std::errc{} && end == word.data() + word.size() && value > 0 &&
           value <= kLargest;
  };
  if (!reads(text.substr(0, slash), tangent.numerator) ||
      !reads(text.substr(slash + 1), tangent.denominator))
    return std::nullopt;
  return tangent;
}

void add_campaign_options(CLI::App& command, FuzzOptions& options) {
  auto* count = command.add_option("--count", options.count, "number of cases");
  count->capture_default_str();
  command.add_option("--seconds", options.seconds, "go on for so long instead")
      ->check(CLI::PositiveNumber)
      ->excludes(count);
  command.add_option("--seed", options.seed, "the same seed gives the same cases")
      ->capture_default_str();
  command.add_option("--families,--family", options.families, "only these, separated by commas")
      ->delimiter(',');
  command.add_option("--max-n", options.max_n, "the most vertices outside (400) or points (300)")
      ->check(CLI::Range(std::uint64_t{1}, kMaxRecipeSize));
  command.add_option("--max-cells", options.max_cells,
                     "refuse cases beyond so many quadtree cells (2000000; points 10000000)");
  command.add_option("--findings", options.findings, "folder for findings")->capture_default_str();
  command.add_option("--summary,--report", options.summary, "write the table as JSON");
  command.add_option("--threads", options.threads, "cases at the same time, 0: as many as cores")
      ->capture_default_str();
  command.add_flag("-q,--quiet", options.quiet, "only the exit status");
}

void add_polygon_options(CLI::App& command, FuzzOptions& options) {
  command.add_option("--max-seconds", options.max_seconds, "refuse cases that take longer")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--max-memory", options.max_megabytes, "of a case, in MiB")
      ->check(CLI::Range(std::uint64_t{64}, std::uint64_t{1} << 20))
      ->capture_default_str();
  command
      .add_option("--shrink-tries", options.shrink_tries, "how often a finding is tried to shrink")
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--min-tangent",
          [&options](const std::string& text) { options.min_tangent = parse_tangent(text); },
          "judge as if no angle might be below arctan(A/B); what comes near the bound is found")
      ->check(CLI::Validator(
          [](std::string& text) -> std::string {
            return parse_tangent(text) ? "" : "A/B with integers from 1 to 7 is expected";
          },
          "A/B"));
  auto* replay = command.add_option("--replay", options.replay, "try this file, or recipe, alone");
  command.add_option("--corpus", options.corpus, "try all polygons in this folder")
      ->check(CLI::ExistingDirectory)
      ->excludes(replay);
  for (const char* name :
       {"--max-seconds", "--max-memory", "--shrink-tries", "--min-tangent", "--replay", "--corpus"})
    command.get_option(name)->excludes("--points");
}

}  // namespace

void add_fuzz_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<FuzzOptions>();
  CLI::App* command = app.add_subcommand("fuzz", "mesh and judge random polygons or point sets");
  command->footer(kFooter);
  command->add_flag("--points", options->points, "random sets of points (thm-1), not polygons");
  add_campaign_options(*command, *options);
  add_polygon_options(*command, *options);
  command->add_option("--warp", options->warping, "warping to the points")
      ->transform(CLI::CheckedTransformer(kWarpings))
      ->option_text("aligned|paper (default aligned)")
      ->needs("--points");
  command->callback([options, &outcome] {
    outcome.status = options->points ? fuzz_points(*options) : fuzz_polygons(*options);
  });
}

}  // namespace quadbound::cli
