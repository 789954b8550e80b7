// SPDX-License-Identifier: Apache-2.0
// Single polygons and folders of polygons through the mesher and the judge.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/polygon_campaign.hpp"
#include "cli/worst_ever.hpp"
#include "model/errors.hpp"
#include "model/read_polygon.hpp"
#include "model/validate.hpp"

namespace quadbound::cli {
namespace {

/// A recipe where it looks like one and no file has that name.
Polygon replayed_polygon(const std::string& what) {
  const bool is_recipe = what.find(":n=") != std::string::npos && !std::filesystem::exists(what);
  return is_recipe ? generate_polygon(parse_polygon_recipe(what)) : normalised(read_polygon(what));
}

std::vector<std::filesystem::path> corpus_files(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    for (const char* known : {".geojson", ".json", ".poly", ".wkt"})
      if (entry.is_regular_file() && extension == known) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

bool must_fail(const std::filesystem::path& file) {
  return std::ranges::any_of(file, [](const auto& part) { return part == "known-failing"; });
}

/// Whether a case of a corpus does what it should. A polygon that is no valid input may be refused
/// with a message.
bool corpus_case(const std::filesystem::path& file, const FuzzOptions& options) {
  bool good = false;
  std::string text;
  try {
    const PolygonResult result = try_isolated(replayed_polygon(file.string()), options);
    const bool fails = result.outcome == PolygonOutcome::kFinding;
    good = must_fail(file) ? fails : result.outcome == PolygonOutcome::kProved;
    text = verdict_text(result);
  } catch (const InputError& error) {
    good = !must_fail(file);
    text = fmt::format("no valid input: {}", error.what());
  }
  if (!options.quiet) fmt::print("{} {}: {}\n", good ? "good" : "BAD ", file.string(), text);
  return good;
}

}  // namespace

std::string verdict_text(const PolygonResult& result) {
  switch (result.outcome) {
    case PolygonOutcome::kProved:
      return fmt::format("thm-13 proved: {} vertices, {} cells, {} quads, angles {} to {}",
                         result.vertices, result.cells, result.quads, angle_text(result.smallest),
                         angle_text(result.largest));
    case PolygonOutcome::kFinding:
      return fmt::format("claim {} {}", result.claim, result.detail);
    default:
      return "refused: " + result.detail;
  }
}

ExitStatus replay_polygon(const FuzzOptions& options) {
  PolygonResult result = try_isolated(replayed_polygon(options.replay), options);
  if (!options.worst_ever.empty()) {
    result.recipe = options.replay;
    PolygonTally tally;
    tally.add(0, result, {});
    WorstEver worst(options.worst_ever);
    worst.add(tally.constructions);
    worst.write();
  }
  const bool is_proved = result.outcome == PolygonOutcome::kProved;
  if (!is_proved || !options.quiet)
    fmt::print(is_proved ? stdout : stderr, "{}{}: {}\n",
               is_proved ? "" : "quadbound: ", options.replay, verdict_text(result));
  return is_proved                                    ? kGood
         : result.outcome == PolygonOutcome::kFinding ? kClaimFailed
                                                      : kBudgetRanOut;
}

ExitStatus replay_corpus(const FuzzOptions& options) {
  const std::vector<std::filesystem::path> files = corpus_files(options.corpus);
  if (files.empty())
    throw InputError({options.corpus, std::nullopt, std::nullopt}, "no polygons in this folder");
  const auto bad =
      std::ranges::count_if(files, [&](const auto& file) { return !corpus_case(file, options); });
  if (!options.quiet) fmt::print("{} cases, {} bad\n", files.size(), bad);
  return bad == 0 ? kGood : kClaimFailed;
}

}  // namespace quadbound::cli
