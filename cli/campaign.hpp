// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the campaigns of `quadbound fuzz` have in common: options, numbers of cases, findings on
// disk, and pieces of tables and reports.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "algo/warping.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "generators/recipe.hpp"
#include "model/angle.hpp"
#include "model/exact.hpp"

namespace quadbound::cli {

/// A part of a campaign: number 1 to `of`.
struct Shard {
  std::uint64_t number = 1;
  std::uint64_t of = 1;
};

struct FuzzOptions {
  bool points = false;
  std::uint64_t count = 1000;
  double seconds = 0;  ///< 0: go by the count
  std::uint64_t seed = 1;
  std::vector<std::string> families;       ///< empty: all
  std::optional<std::uint64_t> max_n;      ///< empty: that of the campaign
  std::optional<std::uint64_t> max_cells;  ///< the same
  std::string findings = "findings";
  std::string summary;
  unsigned threads = 1;
  bool quiet = false;

  Warping warping = Warping::kAligned;  ///< points only; polygons only:
  double max_seconds = 20;
  std::uint64_t max_megabytes = 4096;
  std::size_t shrink_tries = 300;
  std::optional<Arctangent> min_tangent;  ///< empty: that of the theorem
  std::string journal;                    ///< empty: in the folder of findings
  bool resume = false;
  Shard shard;
  std::vector<std::string> merge;  ///< journals
  std::string picture;
  std::string worst_ever;
  std::string search;         ///< an objective; empty: no search
  std::uint64_t steps = 300;  ///< of a climb
  std::string replay;
  std::string corpus;
};

ExitStatus fuzz_points(const FuzzOptions& options);
ExitStatus fuzz_polygons(const FuzzOptions& options);
ExitStatus search_polygons(const FuzzOptions& options);

unsigned workers_of(const FuzzOptions& options);

/// Errors: RecipeError for a family that does not exist.
std::vector<std::string> chosen_families(const FuzzOptions& options,
                                         std::span<const FamilyDescription> families);

/// Whether there is no such name; says on standard error which there are.
bool reached_all(const std::vector<std::string>& never_reached);

/// Hands out the numbers of the cases until the count or the time is over. May be asked by several
/// threads.
class CaseNumbers {
 public:
  explicit CaseNumbers(const FuzzOptions& options) : options_(options) {}

  std::optional<std::uint64_t> next();
  void stop() { stopped_ = true; }
  /// What the line on the terminal says besides how far the campaign is.
  void say(const std::string& text) { progress_.stage(text); }
  [[nodiscard]] double elapsed() const;

 private:
  const FuzzOptions& options_;
  Progress progress_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::atomic<std::uint64_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
};

/// Makes the folder of --findings where there is none. Errors: OutputError.
void make_findings_folder(const FuzzOptions& options);

/// The folder of --findings: a file per case, and INDEX with a line per finding. Not for several
/// threads at once.
class FindingsFolder {
 public:
  explicit FindingsFolder(const FuzzOptions& options) : options_(options) {}

  [[nodiscard]] std::string path(const std::string& name) const {
    return options_.findings + "/" + name;
  }
  /// Makes the folder where there is none. Errors: OutputError.
  void write_case(const std::string& path, const std::function<void(std::ostream&)>& write) const;

  struct Entry {
    std::string claim;
    std::string origin;
    std::string replay;
    std::string detail;
  };
  /// Adds a line to INDEX, unless a campaign that goes on finds it there, and says so on standard
  /// error. Errors: OutputError.
  void note(const Entry& entry) const;

 private:
  const FuzzOptions& options_;
};

// --- tables and reports --------------------------------------------------------------------------

using Json = nlohmann::ordered_json;

/// "arctan(1/2)"; where the fraction is long, degrees instead.
std::string angle_text(const std::optional<Corner<Rational>>& corner);
Json angle_json(const std::optional<Corner<Rational>>& corner);

/// "TITLE NAME: VALUE, NAME: VALUE" and a line's end.
std::string counts_line(const std::string& title, std::span<const std::string_view> names,
                        std::span<const std::uint64_t> values);
Json counts_json(std::span<const std::string_view> names, std::span<const std::uint64_t> values);

}  // namespace quadbound::cli
