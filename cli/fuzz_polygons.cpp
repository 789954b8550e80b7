// SPDX-License-Identifier: Apache-2.0
#include "cli/fuzz_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <variant>

#include "cli/fuzz_cases.hpp"
#include "verify/verify.hpp"

namespace quadbound::cli {
namespace {

// --- making a case -------------------------------------------------------------------------------

constexpr std::uint64_t kSmallestN = 4;

/// Mostly small, as small polygons have as many kinds of corners for less time: the range of sizes
/// begins with 8 and doubles with a chance of 2 in 5 each time, so that the sizes' mean is some 15
/// whatever max_n, and one case in 10,000 has its size from all that 8,192 and more allow.
std::uint64_t any_n(RandomIntegers& random, std::uint64_t max_n) {
  const std::uint64_t most = std::max(kSmallestN, max_n) - kSmallestN + 1;
  std::uint64_t range = 8;
  while (range < most && random.below(5) < 2) range *= 2;
  return kSmallestN + random.below(std::min(range, most));
}

/// Parameters that count vertices or rings would make nearly all polygons huge.
Parameter bounded(Parameter parameter) {
  constexpr std::int64_t kMostHoles = 12;
  constexpr std::int64_t kMostOfAKind = 40;
  const bool counts =
      parameter.name == "sides" || parameter.name == "slits" || parameter.name == "clusters";
  if (parameter.name == "holes") parameter.largest = std::min(parameter.largest, kMostHoles);
  if (counts) parameter.largest = std::min(parameter.largest, kMostOfAKind);
  parameter.default_value = std::min(parameter.default_value, parameter.largest);
  return parameter;
}

PolygonRecipe any_recipe(RandomIntegers& random, const std::string& family, std::uint64_t max_n) {
  const FamilyDescription& description = find_family(polygon_families(), family);
  PolygonRecipe recipe;
  recipe.family = family;
  recipe.n = fitting(description.sizes, any_n(random, max_n));
  recipe.seed = static_cast<std::uint64_t>(random.bits(32));
  for (const Parameter& parameter : description.parameters)
    recipe.parameters[std::string(parameter.name)] = any_value(random, bounded(parameter));
  return recipe;
}

// --- angles by construction ----------------------------------------------------------------------

/// A vertex as an integer part and a fraction in units of the lattice, so that differences between
/// neighbours are accurate to the last digits of a double.
struct SplitPoint {
  LatticePoint whole;
  Point fraction;
};

double fraction_of(const Rational& value, int exponent, std::int64_t floor) {
  return std::ldexp(nearest_double(Rational(value - dyadic(floor, exponent))), -exponent);
}

SplitPoint split_point(const Vertices& vertices, VertexId vertex) {
  if (vertices.on_lattice(vertex)) return {vertices.lattice(vertex), {}};
  const RationalPoint exact = vertices.exact(vertex);
  const int e = vertices.exponent();
  const LatticePoint whole{lattice_floor(exact.x, e).value_or(LatticeFloor{}).floor,
                           lattice_floor(exact.y, e).value_or(LatticeFloor{}).floor};
  return {whole, {fraction_of(exact.x, e, whole.x), fraction_of(exact.y, e, whole.y)}};
}

Point difference(const SplitPoint& a, const SplitPoint& b) {
  return {static_cast<double>(b.whole.x - a.whole.x) + (b.fraction.x - a.fraction.x),
          static_cast<double>(b.whole.y - a.whole.y) + (b.fraction.y - a.fraction.y)};
}

/// Where the extreme corner of a construction is, found in floating point; ties go to the first.
struct ExtremeCorner {
  double cotangent;
  std::size_t quad = 0;
  std::size_t corner = 0;
};

class ConstructionSurvey {
 public:
  explicit ConstructionSurvey(const Mesh& mesh) : mesh_(mesh), degree_(mesh.vertices.size()) {
    for (const Quad& quad : mesh.quads)
      for (const VertexId v : quad) ++degree_[v];
    for (VertexId v = 0; v < mesh.vertices.size(); ++v)
      points_.push_back(split_point(mesh.vertices, v));
    constexpr double kNone = std::numeric_limits<double>::infinity();
    smallest_.fill({-kNone});
    largest_.fill({kNone});
  }

  void fill(std::array<ConstructionUse, kPolygonConstructionCount>& uses) {
    for (std::size_t quad = 0; quad < mesh_.quads.size(); ++quad) {
      ++uses[mesh_.construction[quad]].quads;
      for (std::size_t corner = 0; corner < 4; ++corner) look_at(quad, corner);
    }
    for (std::size_t i = 0; i < uses.size(); ++i) {
      if (std::isfinite(smallest_[i].cotangent)) uses[i].smallest = exact(smallest_[i]);
      if (std::isfinite(largest_[i].cotangent)) uses[i].largest = exact(largest_[i]);
    }
  }

 private:
  void look_at(std::size_t quad, std::size_t corner) {
    const Quad& q = mesh_.quads[quad];
    // Alone at its vertex, the corner is a whole input angle: any other would be a straight angle.
    if (degree_[q[corner]] == 1) return;
    const SplitPoint& at = points_[q[corner]];
    const Point u = difference(at, points_[q[(corner + 1) % 4]]);
    const Point v = difference(at, points_[q[(corner + 3) % 4]]);
    const double cotangent = (u.x * v.x + u.y * v.y) / (u.x * v.y - u.y * v.x);
    const std::uint8_t construction = mesh_.construction[quad];
    ExtremeCorner& smallest = smallest_[construction];
    ExtremeCorner& largest = largest_[construction];
    if (cotangent > smallest.cotangent) smallest = {cotangent, quad, corner};
    if (cotangent < largest.cotangent) largest = {cotangent, quad, corner};
  }

  [[nodiscard]] Corner<Rational> exact(const ExtremeCorner& extreme) const {
    const Quad& q = mesh_.quads[extreme.quad];
    const Vertices& vertices = mesh_.vertices;
    return corner_at<Rational>(vertices.exact(q[extreme.corner]),
                               vertices.exact(q[(extreme.corner + 1) % 4]),
                               vertices.exact(q[(extreme.corner + 3) % 4]));
  }

  const Mesh& mesh_;
  std::vector<std::uint32_t> degree_;
  std::vector<SplitPoint> points_;
  std::array<ExtremeCorner, kPolygonConstructionCount> smallest_{};
  std::array<ExtremeCorner, kPolygonConstructionCount> largest_{};
};

// --- trying it -----------------------------------------------------------------------------------

PolygonCounts counts_of(const PolygonCounters& c) {
  const auto& widened = c.insertion.alpha_vertices_by_level;
  return {c.rounds,
          c.separation_splits,
          c.dead_end_splits,
          c.kite_splits,
          c.restarts,
          c.other_roots,
          widened[0],
          widened[1],
          widened[2],
          widened[3],
          c.insertion.other_cuts,
          c.insertion.moves,
          c.insertion.moves_refused,
          c.kites,
          c.kite_filling.whole,
          c.kite_filling.plain_sides,
          c.kite_filling.stepped_sides,
          c.kite_filling.moved_along_edge,
          c.kite_filling.moved_in_plane,
          c.kite_filling.moved_with_neighbours};
}

PolygonResult without_mesh(PolygonOutcome outcome, std::string claim, std::string detail) {
  PolygonResult result;
  result.outcome = outcome;
  result.claim = std::move(claim);
  result.detail = std::move(detail);
  return result;
}

PolygonResult refused(const Refusal& refusal) {
  switch (refusal.kind) {
    case RefusalKind::kTooManyCells:
      return without_mesh(PolygonOutcome::kTooManyCells, {}, refusal.message);
    case RefusalKind::kTooMuchTime:
      return without_mesh(PolygonOutcome::kTooMuchTime, {}, refusal.message);
    case RefusalKind::kTooDeep:
      break;
  }
  return without_mesh(PolygonOutcome::kFinding, "refusal", refusal.message);
}

std::int64_t microdegrees(const std::optional<Corner<Rational>>& corner) {
  return corner ? std::llround(1e6 * JudgedCorner{{}, corner->cross, corner->dot}.degrees()) : 0;
}

bool is_convex(const Report& report) {
  const Claim* claim = report.find("strictly-convex");
  return claim != nullptr && claim->exact == Verdict::holds;
}

PolygonResult judged(const Polygon& polygon, const PolygonMesh& made, const PolygonTrial& trial) {
  VerifyOptions options;
  options.angles = trial.angles;
  const Report report = verify_polygon(polygon, made.mesh, options);
  PolygonResult result;
  result.vertices = made.mesh.input_vertices;
  result.cells = made.mesh.cells;
  result.quads = made.mesh.quads.size();
  result.counts = counts_of(made.counters);
  if (is_convex(report)) {  // a corner that does not turn left has no cotangent to compare
    result.smallest = extreme(report, "min-angle");
    result.largest = extreme(report, "max-angle");
    result.smallest_microdegrees = microdegrees(result.smallest);
    result.largest_microdegrees = microdegrees(result.largest);
    ConstructionSurvey(made.mesh).fill(result.constructions);
  }
  if (const auto broken = broken_claim(report)) {
    result.outcome = PolygonOutcome::kFinding;
    result.claim = broken->id;
    result.detail = broken->detail;
  }
  return result;
}

// --- results as text -----------------------------------------------------------------------------

using Json = nlohmann::json;

Json to_json(const std::optional<Corner<Rational>>& corner) {
  if (!corner) return nullptr;
  return {quadbound::to_text(corner->cross), quadbound::to_text(corner->dot)};
}

std::optional<Corner<Rational>> corner_from(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return Corner<Rational>{parse_rational(json.at(0).get<std::string>()).value(),
                          parse_rational(json.at(1).get<std::string>()).value()};
}

/// Of a mesh: what it counts, and the extreme corners by the number of the construction.
void add_mesh(const PolygonResult& result, Json& json) {
  json["sizes"] = {result.vertices, result.cells, result.quads};
  json["microdegrees"] = {result.smallest_microdegrees, result.largest_microdegrees};
  json["counts"] = result.counts;
  if (result.microseconds != 0) json["microseconds"] = result.microseconds;
  if (result.smallest) json["smallest"] = to_json(result.smallest);
  if (result.largest) json["largest"] = to_json(result.largest);
  for (std::size_t i = 0; i < result.constructions.size(); ++i) {
    const ConstructionUse& use = result.constructions[i];
    json["made_by"].push_back(use.quads);
    if (use.smallest || use.largest)
      json["extremes"].push_back({i, to_json(use.smallest), to_json(use.largest)});
  }
}

void read_mesh_of(const Json& json, PolygonResult& result) {
  json.at("sizes").at(0).get_to(result.vertices);
  json.at("sizes").at(1).get_to(result.cells);
  json.at("sizes").at(2).get_to(result.quads);
  json.at("microdegrees").at(0).get_to(result.smallest_microdegrees);
  json.at("microdegrees").at(1).get_to(result.largest_microdegrees);
  json.at("counts").get_to(result.counts);
  result.microseconds = json.value("microseconds", std::uint64_t{0});
  result.smallest = corner_from(json.value("smallest", Json()));
  result.largest = corner_from(json.value("largest", Json()));
  for (std::size_t i = 0; i < result.constructions.size(); ++i)
    json.at("made_by").at(i).get_to(result.constructions[i].quads);
  for (const Json& extremes : json.value("extremes", Json::array())) {
    ConstructionUse& use = result.constructions.at(extremes.at(0).get<std::size_t>());
    use.smallest = corner_from(extremes.at(1));
    use.largest = corner_from(extremes.at(2));
  }
}

PolygonOutcome outcome_from(const std::string& name) {
  const auto* const found = std::ranges::find(kPolygonOutcomeNames, name);
  if (found == kPolygonOutcomeNames.end()) throw std::invalid_argument("no outcome: " + name);
  return static_cast<PolygonOutcome>(found - kPolygonOutcomeNames.begin());
}

}  // namespace

PolygonCase random_polygon_case(const PolygonCampaign& campaign, std::uint64_t index) {
  RandomIntegers random(case_seed(campaign.seed, index));
  const std::string& family = campaign.families[index % campaign.families.size()];
  PolygonCase made{any_recipe(random, family, campaign.max_n), {}};
  for (;;) {
    try {
      made.recipe = completed(std::move(made.recipe), polygon_families());
      made.polygon = generate_polygon(made.recipe);
      return made;
    } catch (const RecipeError&) {
      // Mostly no room for that many holes, or needs that the lattice is too coarse for.
      auto holes = made.recipe.parameters.find("holes");
      if (holes != made.recipe.parameters.end() && holes->second > 1)
        holes->second /= 2;
      else
        made.recipe = any_recipe(random, family, campaign.max_n);
    }
  }
}

PolygonRecipe varied(PolygonRecipe recipe, RandomIntegers& random, std::uint64_t max_n) {
  const FamilyDescription& description = find_family(polygon_families(), recipe.family);
  const std::uint64_t choice = random.below(2 + description.parameters.size());
  if (choice == 0) {
    recipe.n = fitting(description.sizes, any_n(random, max_n));
  } else if (choice == 1) {
    recipe.seed = static_cast<std::uint64_t>(random.bits(32));
  } else {
    const Parameter& parameter = description.parameters[choice - 2];
    recipe.parameters[std::string(parameter.name)] = any_value(random, bounded(parameter));
  }
  return completed(std::move(recipe), polygon_families());
}

std::string_view polygon_construction_name(std::size_t construction) {
  return construction < kConstructionCount
             ? kConstructionNames[construction]
             : kStripConstructionNames[construction - kConstructionCount];
}

PolygonResult try_polygon(const Polygon& polygon, const PolygonTrial& trial) {
  try {
    const PolygonMeshResult outcome = mesh_polygon(polygon, {trial.budget, {}});
    if (const auto* refusal = std::get_if<Refusal>(&outcome)) return refused(*refusal);
    return judged(polygon, std::get<PolygonMesh>(outcome), trial);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return without_mesh(PolygonOutcome::kFinding, "exception", error.what());
  }
}

std::string to_text(const PolygonResult& result) {
  Json json{{"outcome", kPolygonOutcomeNames[static_cast<std::size_t>(result.outcome)]}};
  if (!result.recipe.empty()) json["recipe"] = result.recipe;
  if (!result.claim.empty()) json["claim"] = result.claim;
  if (!result.detail.empty()) json["detail"] = result.detail;
  if (result.cells != 0) add_mesh(result, json);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

PolygonResult result_from_text(const std::string& text) {
  const Json json = Json::parse(text);
  PolygonResult result;
  result.outcome = outcome_from(json.at("outcome").get<std::string>());
  result.recipe = json.value("recipe", "");
  result.claim = json.value("claim", "");
  result.detail = json.value("detail", "");
  if (json.contains("sizes")) read_mesh_of(json, result);
  return result;
}

}  // namespace quadbound::cli
