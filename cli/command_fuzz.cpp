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
#include <vector>

#include "cli/campaign.hpp"
#ifdef QUADBOUND_MPI
#include "cli/mpi_workers.hpp"
#endif
#include "cli/polygon_search.hpp"

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

Every finished case is a line of the journal, journal-SEED.jsonl in the folder of findings or that
of --journal. After Ctrl-C, which writes the summary so far, after kill -9 or a full disk, the same
command with --resume goes on and ends with the summary that it would have had; a larger --count
adds cases.

--shard I/N runs one of N parts of a campaign, each with a journal of its own; --merge tells their
journals as the one campaign that they are, to the byte. Built with QUADBOUND_MPI, `mpirun quadbound
fuzz --mpi` hands out the cases to its ranks.

--search climbs instead: each of --count climbs (10) starts from a random case and changes its
recipe, then its vertices, --steps times; what pushes the objective stays. Objectives:
smallest-angle, largest-angle, cells, seconds-per-vertex, fall-back-levels. The best polygon of each
climb goes to the folder of findings. --worst-ever FILE.json adds the most extreme angles of each
construction, with inputs that can be replayed, to a file and a table beside it.

Points: every set is moved, turned and scaled at random, meshed and judged on every claim. Columns:
deep, far out: refused as the closest points are closer than 2^-50 of the extent, or of the largest
coordinate only; budget: refused by --max-cells; range: coordinates beyond 2^-1000 to 2^1000;
merged: points left out as moving the set rounded them onto others.

Examples:
  quadbound fuzz --count 1000 --seed 7 --summary fuzz.json
  quadbound fuzz --seconds 60 --family star,comb --threads 0
  quadbound fuzz --count 100000 --threads 0 --summary fuzz.json --resume
  quadbound fuzz --count 100000 --shard 3/16   (and so on, on as many machines)
  quadbound fuzz --merge findings/journal-1-*-of-16.jsonl --summary fuzz.json
  quadbound fuzz --search smallest-angle --seed 3 --worst-ever worst-ever.json
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

/// I/N with 1 <= I <= N.
std::optional<Shard> parse_shard(std::string_view text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, shard.number);
  if (number.ec != std::errc{} || number.ptr == end || *number.ptr != '/') return std::nullopt;
  const auto of = std::from_chars(number.ptr + 1, end, shard.of);
  if (of.ec != std::errc{} || of.ptr != end) return std::nullopt;
  if (shard.number < 1 || shard.number > shard.of) return std::nullopt;
  return shard;
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
  command.add_option("--max-n", options.max_n, "the most vertices outside (10000) or points (300)")
      ->check(CLI::Range(std::uint64_t{1}, kMaxRecipeSize));
  command.add_option("--max-cells", options.max_cells,
                     "refuse cases beyond so many quadtree cells (2000000; points 10000000)");
  command.add_option("--findings", options.findings, "folder for findings")->capture_default_str();
  command.add_option("--summary,--report", options.summary, "write the table as JSON");
  command.add_option("--threads", options.threads, "cases at the same time, 0: as many as cores")
      ->capture_default_str();
  command.add_flag("-q,--quiet", options.quiet, "only the exit status");
}

/// --journal, --resume, --shard, --merge.
void add_journal_options(CLI::App& command, FuzzOptions& options) {
  auto* journal = command.add_option("--journal", options.journal, "file for the journal");
  auto* resume = command.add_flag("--resume", options.resume,
                                  "go on with the campaign of the journal, if any");
  auto* shard = command.add_option_function<std::string>(
      "--shard",
      [&options](const std::string& text) { options.shard = parse_shard(text).value_or(Shard{}); },
      "run part I of N parts");
  shard->check(CLI::Validator(
      [](std::string& text) -> std::string {
        return parse_shard(text) ? "" : "I/N with I from 1 to N is expected";
      },
      "I/N"));
  auto* merge = command.add_option("--merge", options.merge, "tell these journals as one campaign");
  merge->check(CLI::ExistingFile)->excludes(journal)->excludes(resume)->excludes(shard);
}

/// --search, --steps, --worst-ever, --picture.
void add_search_options(CLI::App& command, FuzzOptions& options) {
  auto* search = command.add_option("--search", options.search, "climb towards harder polygons");
  search->check(
      CLI::IsMember(std::vector<std::string>{kObjectiveNames.begin(), kObjectiveNames.end()}));
  command.add_option("--steps", options.steps, "of a climb")->capture_default_str()->needs(search);
  command
      .add_option("--worst-ever", options.worst_ever,
                  "add the most extreme angles of each construction to this .json file")
      ->check(CLI::Validator(
          [](std::string& text) -> std::string {
            return text.ends_with(".json") ? "" : "a file with the ending .json is expected";
          },
          "FILE.json"));
  command.add_option("--picture", options.picture, "draw histograms as SVG, PDF or PNG")
      ->excludes(search)
      ->check(CLI::Validator(
          [](std::string& text) -> std::string {
            const bool is_known =
                text.ends_with(".svg") || text.ends_with(".pdf") || text.ends_with(".png");
            return is_known ? "" : "a file with the ending .svg, .pdf or .png is expected";
          },
          "FILE"));
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
  add_journal_options(command, options);
  add_search_options(command, options);
  auto* replay = command.add_option("--replay", options.replay, "try this file, or recipe, alone");
  auto* corpus = command.add_option("--corpus", options.corpus, "try all polygons in this folder")
                     ->check(CLI::ExistingDirectory)
                     ->excludes(replay);
  for (const char* name : {"--max-seconds", "--max-memory", "--shrink-tries", "--min-tangent",
                           "--journal", "--resume", "--shard", "--merge", "--search", "--steps",
                           "--worst-ever", "--picture", "--replay", "--corpus"})
    command.get_option(name)->excludes("--points");
  for (const char* name : {"--journal", "--resume", "--shard", "--merge", "--search", "--picture"})
    command.get_option(name)->excludes(replay)->excludes(corpus);
  for (const char* name : {"--journal", "--resume", "--shard", "--merge"})
    command.get_option(name)->excludes("--search");
  command.get_option("--worst-ever")->excludes(corpus);
}

#ifdef QUADBOUND_MPI
std::shared_ptr<bool> add_mpi_option(CLI::App& command) {
  auto over_mpi = std::make_shared<bool>(false);
  auto* option = command.add_flag("--mpi", *over_mpi, "hand out the cases to the ranks of mpirun");
  for (const char* name : {"--points", "--merge", "--search", "--replay", "--corpus"})
    option->excludes(command.get_option(name));
  return over_mpi;
}
ExitStatus fuzz_polygons_over_mpi(const FuzzOptions& options) { return fuzz_over_mpi(options); }
#else
std::shared_ptr<bool> add_mpi_option(CLI::App& /*command*/) {
  return std::make_shared<bool>(false);
}
ExitStatus fuzz_polygons_over_mpi(const FuzzOptions& options) { return fuzz_polygons(options); }
#endif

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
  const std::shared_ptr<bool> over_mpi = add_mpi_option(*command);
  command->callback([command, options, over_mpi, &outcome] {
    if (*over_mpi) {
      outcome.status = fuzz_polygons_over_mpi(*options);
      return;
    }
    constexpr std::uint64_t kClimbs = 10;
    if (!options->search.empty() && command->count("--count") == 0) options->count = kClimbs;
    outcome.status = options->points ? fuzz_points(*options) : fuzz_polygons(*options);
  });
}

}  // namespace quadbound::cli
