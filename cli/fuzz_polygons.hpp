// SPDX-License-Identifier: Apache-2.0
#pragma once
// Random polygons and what the mesher and the judge make of them; behind `quadbound fuzz`. Prints
// nothing.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algo/construction.hpp"
#include "algo/mesh_polygon.hpp"
#include "generators/polygons.hpp"
#include "generators/random.hpp"
#include "model/angle.hpp"

namespace quadbound::cli {

struct PolygonCase {
  PolygonRecipe recipe;
  Polygon polygon;
};

struct PolygonCampaign {
  std::uint64_t seed = 1;
  std::uint64_t max_n = 10'000;
  std::vector<std::string> families;  ///< must not be empty
};

/// Guarantees: 1. depends on the campaign and the index alone. 2. Families take turns. 3. Six of
/// seven outer rings have at most 60 vertices; holes have a few dozen at most, and there are a
/// dozen at most.
/// Errors: RecipeError for a family that does not exist.
PolygonCase random_polygon_case(const PolygonCampaign& campaign, std::uint64_t index);

/// A recipe near another: with another n, seed or parameter.
/// Requires: a completed recipe. Guarantees: 1. the result is completed; generate_polygon may
/// refuse it.
PolygonRecipe varied(PolygonRecipe recipe, RandomIntegers& random, std::uint64_t max_n);

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
  std::int64_t smallest_microdegrees = 0;  ///< of the same, rounded
  std::int64_t largest_microdegrees = 0;
  std::array<ConstructionUse, kPolygonConstructionCount> constructions;
  PolygonCounts counts{};
  std::uint64_t microseconds = 0;  ///< of processor time, where they were measured
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

/// As JSON in one line; what is empty takes no room.
/// Guarantees: 1. result_from_text(to_text(r)) == r in every member. 2. other members of the object
/// are ignored. Errors of result_from_text: std::exception for anything else.
std::string to_text(const PolygonResult& result);
PolygonResult result_from_text(const std::string& text);

}  // namespace quadbound::cli
