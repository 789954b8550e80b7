// SPDX-License-Identifier: Apache-2.0
#pragma once
// Random polygons and what the mesher and the judge make of them; behind `quadbound fuzz`. Prints
// nothing.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algo/construction.hpp"
#include "algo/mesh_polygon.hpp"
#include "generators/polygons.hpp"
#include "model/angle.hpp"

namespace quadbound::cli {

struct PolygonCase {
  PolygonRecipe recipe;
  Polygon polygon;
};

struct PolygonCampaign {
  std::uint64_t seed = 1;
  std::uint64_t max_n = 400;
  std::vector<std::string> families;  ///< must not be empty
};

/// Guarantees: 1. depends on the campaign and the index alone. 2. Families take turns. 3. Six of
/// seven outer rings have at most 60 vertices; holes have a few dozen at most, and there are a
/// dozen at most.
/// Errors: RecipeError for a family that does not exist.
PolygonCase random_polygon_case(const PolygonCampaign& campaign, std::uint64_t index);

enum class PolygonOutcome {
  kProved,
  kTooManyCells,  ///< refused
  kTooMuchTime,   ///< refused
  kFinding,
};
inline constexpr std::array<std::string_view, 4> kPolygonOutcomeNames{"proved", "too_many_cells",
                                                                      "too_much_time", "findings"};

/// Those of Section 2 and, after them, those of Sections 3 and 4; as in a mesh of a polygon.
inline constexpr std::size_t kPolygonConstructionCount =
    kConstructionCount + kStripConstructionCount;
std::string_view polygon_construction_name(std::size_t construction);

/// What PolygonCounters tells of the harder parts of Sections 3 and 4.
inline constexpr std::array<std::string_view, 20> kPolygonCounterNames{
    "rounds",
    "separation splits",
    "dead-end splits",
    "kite splits",
    "restarts",
    "other roots",
    "widening level 0",
    "widening level 1",
    "widening level 2",
    "widening level 3",
    "chains cut elsewhere",
    "centres aligned",
    "alignments refused",
    "kites",
    "kites whole",
    "kite sides plain",
    "kite sides stepped",
    "kites moved along an edge",
    "kites moved in the plane",
    "kites moved with neighbours"};
using PolygonCounts = std::array<std::uint64_t, kPolygonCounterNames.size()>;

/// The quads of a construction; angles are its new ones, that is without whole input angles.
struct ConstructionUse {
  std::uint64_t quads = 0;
  std::optional<Corner<Rational>> smallest;
  std::optional<Corner<Rational>> largest;
};

struct PolygonResult {
  PolygonOutcome outcome = PolygonOutcome::kProved;
  std::string recipe;  ///< empty where the polygon came from a file
  /// Where it is a finding: the id of the claim, "refusal", "exception", "crash", "hang" or
  /// "memory".
  std::string claim;
  std::string detail;  ///< of a finding or a refusal
  // Empty unless a mesh was judged.
  std::uint64_t vertices = 0;
  std::uint64_t cells = 0;
  std::uint64_t quads = 0;
  std::optional<Corner<Rational>> smallest;  ///< new angles only
  std::optional<Corner<Rational>> largest;
  std::array<ConstructionUse, kPolygonConstructionCount> constructions;
  PolygonCounts counts{};
};

struct PolygonTrial {
  Budget budget;
  AngleInterval angles = kTheorem13;
};

/// Meshes and judges. That exact coordinates end (kTooDeep) is a finding, as the polygons of
/// recipes are far from there; other budgets are refusals.
/// Guarantees: 1. throws nothing but std::bad_alloc: exceptions of the mesher are findings.
/// Requires: polygon valid and normalised.
PolygonResult try_polygon(const Polygon& polygon, const PolygonTrial& trial);

/// Guarantees: 1. result_from_text(to_text(r)) == r in every member.
std::string to_text(const PolygonResult& result);
PolygonResult result_from_text(const std::string& text);

/// Smallest, mean and largest of ratios.
struct Spread {
  std::uint64_t count = 0;
  double smallest = 0;
  double largest = 0;
  double sum = 0;
  void add(double value);
  [[nodiscard]] double mean() const { return count == 0 ? 0 : sum / static_cast<double>(count); }
};

/// The most extreme corner so far and the recipe that has it.
struct Record {
  std::optional<Corner<Rational>> corner;
  std::string recipe;
  void keep_smaller(const std::optional<Corner<Rational>>& candidate, const std::string& of);
  void keep_larger(const std::optional<Corner<Rational>>& candidate, const std::string& of);
};

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
  void add(const PolygonResult& result);
};

struct ConstructionTally {
  std::uint64_t quads = 0;
  std::uint64_t cases = 0;  ///< with at least one such quad
  Record smallest;
  Record largest;
};

/// Of a campaign, case by case in the order of their indices.
struct PolygonTally {
  struct Remark {
    std::uint64_t index = 0;
    PolygonResult result;
  };
  PolygonFamilyTally all;
  std::map<std::string, PolygonFamilyTally> families;
  std::array<ConstructionTally, kPolygonConstructionCount> constructions;
  PolygonCounts counts{};
  std::vector<Remark> findings;
  std::vector<Remark> refusals;

  void add(std::uint64_t index, const PolygonResult& result, const std::string& family);
  /// Names of constructions without a quad.
  /// Of those that a polygon can need: all but "kite whole".
  [[nodiscard]] std::vector<std::string> never_reached() const;
};

}  // namespace quadbound::cli
