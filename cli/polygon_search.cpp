// SPDX-License-Identifier: Apache-2.0
#include "cli/polygon_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "cli/fuzz_cases.hpp"
#include "model/errors.hpp"
#include "model/validate.hpp"
#include "model/write_polygon.hpp"
#include "verify/report.hpp"

namespace quadbound::cli {
namespace {

// --- objectives ----------------------------------------------------------------------------------

constexpr std::size_t kFallBacks = 6;

std::array<std::uint64_t, kFallBacks> fall_backs(const PolygonResult& result) {
  const auto count = [&result](std::string_view name) {
    const auto* const found = std::ranges::find(kPolygonCounterNames, name);
    return result.counts.at(static_cast<std::size_t>(found - kPolygonCounterNames.begin()));
  };
  return {count("restarts") + count("other roots"),
          count("widening level 3"),
          count("widening level 2"),
          count("widening level 1"),
          count("dead-end splits"),
          count("kite splits")};
}

double seconds_per_vertex(const PolygonResult& result) {
  return static_cast<double>(result.microseconds) / 1e6 / static_cast<double>(result.vertices);
}

double degrees(const Corner<Rational>& corner) {
  return JudgedCorner{{}, corner.cross, corner.dot}.degrees();
}

// --- changes of a polygon ------------------------------------------------------------------------

constexpr int kLattice = -24;  // finer than that of the generators: 2^-20

double on_grid(double value, int exponent) {
  return std::ldexp(std::round(std::ldexp(value, -exponent)), exponent);
}

std::size_t vertex_count(const Polygon& polygon) {
  std::size_t count = 0;
  for (const Ring& ring : polygon.rings) count += ring.size();
  return count;
}

/// Changes of a copy; what they come to may not be a valid polygon.
class Change {
 public:
  Change(Polygon& polygon, RandomIntegers& random) : polygon_(polygon), random_(random) {}

  /// Whether there was anything to change.
  bool run(std::size_t max_vertices) {
    const std::uint64_t kind = random_.below(16);
    if (kind < 9) return move_vertex();
    if (kind < 11) return align_vertex();
    if (kind < 12) return drop_vertex();
    if (kind < 13) return vertex_count(polygon_) < max_vertices && add_vertex();
    if (kind < 14) return drop_hole();
    if (kind < 15) return move_ring();
    return move_all();
  }

 private:
  struct Place {
    Ring& ring;
    std::size_t vertex;
    [[nodiscard]] Point& at() const { return ring[vertex]; }
    [[nodiscard]] const Point& next() const { return ring[(vertex + 1) % ring.size()]; }
  };

  Place any_vertex() {
    std::uint64_t number = random_.below(vertex_count(polygon_));
    std::size_t ring = 0;
    while (number >= polygon_.rings[ring].size()) number -= polygon_.rings[ring++].size();
    return {polygon_.rings[ring], number};
  }

  static double length(const Place& place) {
    return std::max(std::abs(place.next().x - place.at().x),
                    std::abs(place.next().y - place.at().y));
  }

  /// All magnitudes from `scale` down to 2^-12 of it.
  double amount(double scale) {
    constexpr std::int64_t kParts = 1024;
    const auto halvings = static_cast<int>(random_.below(13));
    const auto part = static_cast<double>(random_.between(-kParts, kParts)) / kParts;
    return on_grid(std::ldexp(part * scale, -halvings), kLattice);
  }

  bool move_vertex() {
    const Place place = any_vertex();
    const double scale = length(place);
    const std::uint64_t axes = 1 + random_.below(3);
    if ((axes & 1) != 0) place.at().x += amount(scale);
    if ((axes & 2) != 0) place.at().y += amount(scale);
    return true;
  }

  /// To the lines of a coarse lattice, or level with the next vertex.
  bool align_vertex() {
    const Place place = any_vertex();
    Point& at = place.at();
    const auto exponent = -static_cast<int>(random_.below(12));
    switch (random_.below(4)) {
      case 0:
        at.x = on_grid(at.x, exponent);
        return true;
      case 1:
        at.y = on_grid(at.y, exponent);
        return true;
      case 2:
        at.x = place.next().x;
        return true;
      default:
        at.y = place.next().y;
        return true;
    }
  }

  bool drop_vertex() {
    const Place place = any_vertex();
    if (place.ring.size() == 3) return false;
    place.ring.erase(place.ring.begin() + static_cast<std::ptrdiff_t>(place.vertex));
    return true;
  }

  bool add_vertex() {
    const Place place = any_vertex();
    const double scale = length(place);
    const Point middle{on_grid((place.at().x + place.next().x) / 2, kLattice) + amount(scale),
                       on_grid((place.at().y + place.next().y) / 2, kLattice) + amount(scale)};
    place.ring.insert(place.ring.begin() + static_cast<std::ptrdiff_t>(place.vertex) + 1, middle);
    return true;
  }

  bool drop_hole() {
    if (polygon_.rings.size() == 1) return false;
    const auto hole = 1 + static_cast<std::ptrdiff_t>(random_.below(polygon_.rings.size() - 1));
    polygon_.rings.erase(polygon_.rings.begin() + hole);
    return true;
  }

  static void shift(Ring& ring, const Point& by) {
    for (Point& p : ring) p = {p.x + by.x, p.y + by.y};
  }

  bool move_ring() {
    const Place place = any_vertex();
    shift(place.ring, {amount(length(place)), amount(length(place))});
    return true;
  }

  /// The same shape elsewhere among the lines of the quadtree.
  bool move_all() {
    const Point by{amount(1), amount(1)};
    for (Ring& ring : polygon_.rings) shift(ring, by);
    return true;
  }

  Polygon& polygon_;
  RandomIntegers& random_;
};

// --- the climb -----------------------------------------------------------------------------------

/// Another input near the one before; nullopt where the change came to nothing valid.
std::optional<Climber> neighbour(const ClimbPlan& plan, const Climber& from, bool by_recipe,
                                 RandomIntegers& random) {
  Climber to;
  if (by_recipe && !from.recipe.empty()) {
    try {
      const PolygonRecipe recipe =
          varied(parse_polygon_recipe(from.recipe), random, plan.campaign.max_n);
      to.recipe = to_text(recipe);
      to.polygon = generate_polygon(recipe);
    } catch (const RecipeError&) {
      return std::nullopt;
    }
    return to;
  }
  constexpr std::size_t kHolesPerOuterVertex = 2;  // room for holes beside max_n
  std::optional<Polygon> polygon =
      changed(from.polygon, random, kHolesPerOuterVertex * plan.campaign.max_n);
  if (!polygon) return std::nullopt;
  to.polygon = *std::move(polygon);
  return to;
}

void note_extremes(const Climber& of, Climb& climb) {
  std::string input;
  for (std::size_t i = 0; i < climb.extremes.size(); ++i) {
    const ConstructionUse& use = of.result.constructions[i];
    ConstructionTally& extremes = climb.extremes[i];
    const bool is_new = extremes.smallest.is_smaller(use.smallest, climb.tries) ||
                        extremes.largest.is_larger(use.largest, climb.tries);
    if (is_new && input.empty()) input = of.input();
    extremes.smallest.keep_smaller(use.smallest, climb.tries, input);
    extremes.largest.keep_larger(use.largest, climb.tries, input);
  }
}

// --- climbs as text ------------------------------------------------------------------------------

using Json = nlohmann::json;

Json json_of(const Record& record) {
  if (!record.corner) return nullptr;
  return {quadbound::to_text(record.corner->cross), quadbound::to_text(record.corner->dot),
          record.index, record.recipe};
}

Record record_from(const Json& json) {
  if (json.is_null()) return {};
  return {Corner<Rational>{parse_rational(json.at(0).get<std::string>()).value(),
                           parse_rational(json.at(1).get<std::string>()).value()},
          json.at(2).get<std::uint64_t>(), json.at(3).get<std::string>()};
}

Json json_of(const Polygon& polygon) {
  Json json = Json::array();
  for (const Ring& ring : polygon.rings) {
    Json& points = json.emplace_back(Json::array());
    for (const Point& p : ring) points.push_back({p.x, p.y});
  }
  return json;
}

Polygon polygon_from(const Json& json) {
  Polygon polygon;
  for (const Json& ring : json) {
    Ring& points = polygon.rings.emplace_back();
    for (const Json& p : ring) points.push_back({p.at(0).get<double>(), p.at(1).get<double>()});
  }
  return polygon;
}

}  // namespace

bool is_further(Objective objective, const PolygonResult& a, const PolygonResult& b) {
  if (a.cells == 0 || b.cells == 0) return a.cells != 0 && b.cells == 0;
  switch (objective) {
    case Objective::kSmallestAngle:
      return a.smallest && (!b.smallest || smaller_angle(*a.smallest, *b.smallest));
    case Objective::kLargestAngle:
      return a.largest && (!b.largest || smaller_angle(*b.largest, *a.largest));
    case Objective::kCells:
      return a.cells > b.cells;
    case Objective::kSecondsPerVertex:
      return seconds_per_vertex(a) > seconds_per_vertex(b);
    case Objective::kFallBackLevels:
      return fall_backs(a) > fall_backs(b);
  }
  return false;
}

std::string value_text(Objective objective, const PolygonResult& result) {
  if (result.cells == 0) return "no mesh";
  switch (objective) {
    case Objective::kSmallestAngle:
      return result.smallest ? fmt::format("{:.9f} degrees", degrees(*result.smallest)) : "-";
    case Objective::kLargestAngle:
      return result.largest ? fmt::format("{:.9f} degrees", degrees(*result.largest)) : "-";
    case Objective::kCells:
      return fmt::format("{} cells", result.cells);
    case Objective::kSecondsPerVertex:
      return fmt::format("{:.6f} s", seconds_per_vertex(result));
    case Objective::kFallBackLevels:
      return fmt::format("{}", fmt::join(fall_backs(result), "/"));
  }
  return {};
}

std::optional<Polygon> changed(const Polygon& polygon, RandomIntegers& random,
                               std::size_t max_vertices) {
  Polygon after = polygon;
  if (!Change(after, random).run(max_vertices)) return std::nullopt;
  try {
    return normalised(std::move(after));
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::string Climber::input() const {
  if (!recipe.empty()) return recipe;
  std::ostringstream stream;
  write_geojson(stream, polygon);
  return stream.str();
}

Climb climb(const ClimbPlan& plan, std::uint64_t index,
            const std::function<PolygonResult(const Polygon&)>& try_it) {
  RandomIntegers random(
      case_seed(case_seed(plan.campaign.seed, index), static_cast<std::uint64_t>(plan.objective)));
  PolygonCase first = random_polygon_case(plan.campaign, index);
  Climb result;
  Climber here{to_text(first.recipe), std::move(first.polygon), {}};
  here.result = try_it(here.polygon);
  result.start = here.result;
  result.tries = 1;
  note_extremes(here, result);
  for (std::uint64_t step = 0; step < plan.steps && here.result.outcome != PolygonOutcome::kFinding;
       ++step) {
    std::optional<Climber> next = neighbour(plan, here, step < plan.steps / 3, random);
    if (!next) continue;
    next->result = try_it(next->polygon);
    ++result.tries;
    note_extremes(*next, result);
    if (next->result.outcome == PolygonOutcome::kFinding ||
        !is_further(plan.objective, here.result, next->result))
      here = *std::move(next);
  }
  result.best = std::move(here);
  return result;
}

std::string to_text(const Climb& climb) {
  Json json{{"tries", climb.tries},
            {"start", to_text(climb.start)},
            {"recipe", climb.best.recipe},
            {"polygon", json_of(climb.best.polygon)},
            {"best", to_text(climb.best.result)},
            {"extremes", Json::array()}};
  for (const ConstructionTally& extremes : climb.extremes)
    json["extremes"].push_back({json_of(extremes.smallest), json_of(extremes.largest)});
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Climb climb_from_text(const std::string& text) {
  const Json json = Json::parse(text);
  Climb climb;
  json.at("tries").get_to(climb.tries);
  climb.start = result_from_text(json.at("start").get<std::string>());
  json.at("recipe").get_to(climb.best.recipe);
  climb.best.polygon = polygon_from(json.at("polygon"));
  climb.best.result = result_from_text(json.at("best").get<std::string>());
  for (std::size_t i = 0; i < climb.extremes.size(); ++i) {
    climb.extremes[i].smallest = record_from(json.at("extremes").at(i).at(0));
    climb.extremes[i].largest = record_from(json.at("extremes").at(i).at(1));
  }
  return climb;
}

}  // namespace quadbound::cli
