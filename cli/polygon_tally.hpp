// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a campaign of polygons counts. Nothing depends on the order in which cases are added, so
// that threads, restarts and shards make no difference. Prints nothing.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/fuzz_polygons.hpp"

namespace quadbound::cli {

/// Smallest, mean and largest of ratios.
struct Spread {
  std::uint64_t count = 0;
  double smallest = 0;
  double largest = 0;
  Int128 sum = 0;  ///< in units of 2^-32, each ratio rounded down: a sum of doubles has an order

  /// Requires: 0 < part, whole < 2^64.
  void add(std::uint64_t part, std::uint64_t whole);
  [[nodiscard]] double mean() const;
};

/// The most extreme corner so far, and the first case that has it.
struct Record {
  std::optional<Corner<Rational>> corner;
  std::uint64_t index = 0;
  std::string recipe;

  /// Whether it would be kept.
  [[nodiscard]] bool is_smaller(const std::optional<Corner<Rational>>& candidate,
                                std::uint64_t of) const;
  [[nodiscard]] bool is_larger(const std::optional<Corner<Rational>>& candidate,
                               std::uint64_t of) const;
  void keep_smaller(const std::optional<Corner<Rational>>& candidate, std::uint64_t of,
                    const std::string& with);
  void keep_larger(const std::optional<Corner<Rational>>& candidate, std::uint64_t of,
                   const std::string& with);
};

/// How many meshes fall into each bin.
using Histogram = std::map<std::int64_t, std::uint64_t>;
/// Bins of half a degree, of which one begins at the lower bound of thm-13: bin 0 holds the bound.
double smallest_angle_bin_start(std::int64_t bin);
/// One ends at the upper bound: bin -1 holds the bound.
double largest_angle_bin_start(std::int64_t bin);
/// Four bins from each power of two to the next, of the same width.
double ratio_bin_start(std::int64_t bin);
/// Bins of a twentieth.
double quads_bin_start(std::int64_t bin);

struct PolygonFamilyTally {
  std::uint64_t cases = 0;
  std::array<std::uint64_t, kPolygonOutcomeNames.size()> outcomes{};
  std::uint64_t vertices = 0;  ///< this and all below: of the polygons that were meshed
  std::uint64_t cells = 0;
  std::uint64_t quads = 0;
  Spread cells_per_vertex;
  Spread quads_per_cell;
  Record smallest;
  Record largest;

  [[nodiscard]] std::uint64_t count(PolygonOutcome outcome) const {
    return outcomes[static_cast<std::size_t>(outcome)];
  }
  void add(std::uint64_t index, const PolygonResult& result);
};

struct ConstructionTally {
  std::uint64_t quads = 0;
  std::uint64_t cases = 0;  ///< with at least one such quad
  Record smallest;
  Record largest;
};

struct PolygonTally {
  /// What is told of a finding or a refusal.
  struct Remark {
    std::string recipe;
    std::string claim;
    std::string detail;
  };
  PolygonFamilyTally all;
  std::map<std::string, PolygonFamilyTally> families;
  std::array<ConstructionTally, kPolygonConstructionCount> constructions;
  PolygonCounts counts{};
  Histogram smallest_angles;  ///< new angles; of each mesh that has them
  Histogram largest_angles;
  Histogram cells_per_vertex;
  Histogram quads_per_cell;
  std::map<std::uint64_t, Remark> findings;  ///< by the index of the case
  std::map<std::uint64_t, Remark> refusals;

  /// Guarantees: 1. the order of calls makes no difference. Requires: an index comes once.
  void add(std::uint64_t index, const PolygonResult& result, const std::string& family);

  /// The result without corners that are no records here, and without a recipe where neither a
  /// record nor a remark needs it: adding it instead comes to the same.
  [[nodiscard]] PolygonResult news(std::uint64_t index, PolygonResult result,
                                   const std::string& family) const;

  /// Names of constructions without a quad, but for "kite whole", which is rare.
  [[nodiscard]] std::vector<std::string> never_reached() const;
};

}  // namespace quadbound::cli
