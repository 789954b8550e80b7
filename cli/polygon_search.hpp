// SPDX-License-Identifier: Apache-2.0
#pragma once
// A climb: a polygon is changed again and again, and changes that make it harder for the mesher
// stay. Prints nothing.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "cli/fuzz_polygons.hpp"
#include "cli/polygon_tally.hpp"
#include "generators/random.hpp"
#include "model/polygon.hpp"

namespace quadbound::cli {

/// What is pushed, in the direction that is harder.
enum class Objective {
  kSmallestAngle,
  kLargestAngle,
  kCells,
  kSecondsPerVertex,  ///< processor time of mesher and judge; not the same from run to run
  /// What the mesher falls back on, the last resort first: restarts and other roots, then the
  /// levels of widening from the highest, then dead ends, then splits at kites.
  kFallBackLevels,
};
inline constexpr std::array<std::string_view, 5> kObjectiveNames{
    "smallest-angle", "largest-angle", "cells", "seconds-per-vertex", "fall-back-levels"};

/// Whether a is further in the direction of the objective than b. What has no mesh is the least.
bool is_further(Objective objective, const PolygonResult& a, const PolygonResult& b);
/// Its value as text: degrees, cells, seconds, or numbers by fall-back.
std::string value_text(Objective objective, const PolygonResult& result);

/// A change of one vertex, hole or the place of the whole; nullopt where that is no valid polygon.
/// Guarantees: 1. the result is normalised and has at most `max_vertices`, or as many as before.
/// 2. Coordinates are multiples of 2^-24 where those before are.
std::optional<Polygon> changed(const Polygon& polygon, RandomIntegers& random,
                               std::size_t max_vertices);

struct ClimbPlan {
  PolygonCampaign campaign;  ///< whose cases the climbs start from
  Objective objective = Objective::kSmallestAngle;
  std::uint64_t steps = 300;
};

/// Where a polygon comes from: a recipe, or GeoJSON once vertices have moved.
struct Climber {
  std::string recipe;
  Polygon polygon;
  PolygonResult result;
  [[nodiscard]] std::string input() const;  ///< the recipe, or the polygon as GeoJSON
};

struct Climb {
  std::uint64_t tries = 0;
  PolygonResult start;
  Climber best;  ///< or the finding that ended the climb
  /// The extremes of all tries; `recipe` of a record is its input.
  std::array<ConstructionTally, kPolygonConstructionCount> extremes;
};

/// Starts from case `index` of the campaign. A third of the steps change its recipe, the others the
/// polygon; ties move on, so that a climb can leave a plateau. A finding ends it.
/// Guarantees: 1. depends on the plan, the index and what `try_it` answers alone. 2. try_it is
/// called 1 + steps times at most, with valid, normalised polygons.
Climb climb(const ClimbPlan& plan, std::uint64_t index,
            const std::function<PolygonResult(const Polygon&)>& try_it);

/// Guarantees: 1. climb_from_text(to_text(c)) == c. Errors: std::exception for anything else.
std::string to_text(const Climb& climb);
Climb climb_from_text(const std::string& text);

}  // namespace quadbound::cli
