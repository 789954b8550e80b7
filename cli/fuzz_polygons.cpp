// SPDX-License-Identifier: Apache-2.0
#include "cli/fuzz_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "cli/fuzz_cases.hpp"
#include "verify/verify.hpp"

namespace quadbound::cli {
namespace {

// --- making a case
// --------------------------------------------------------------------------------

constexpr std::uint64_t kSmallN = 60;
constexpr std::uint64_t kSmallestN = 4;

std::uint64_t any_n(RandomIntegers& random, std::uint64_t max_n) {
  const std::uint64_t small = std::max(kSmallestN, std::min(kSmallN, max_n));
  if (max_n <= small || random.below(7) != 0)
    return kSmallestN + random.below(small - kSmallestN + 1);
  return small + 1 + random.below(max_n - small);
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

// --- angles by construction
// -----------------------------------------------------------------------

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

// --- trying it
// ------------------------------------------------------------------------------------

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
    ConstructionSurvey(made.mesh).fill(result.constructions);
  }
  if (const auto broken = broken_claim(report)) {
    result.outcome = PolygonOutcome::kFinding;
    result.claim = broken->id;
    result.detail = broken->detail;
  }
  return result;
}

// --- results as text
// ------------------------------------------------------------------------------

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
  Json json{{"outcome", static_cast<int>(result.outcome)},
            {"recipe", result.recipe},
            {"claim", result.claim},
            {"detail", result.detail},
            {"sizes", {result.vertices, result.cells, result.quads}},
            {"smallest", to_json(result.smallest)},
            {"largest", to_json(result.largest)},
            {"counts", result.counts}};
  for (const ConstructionUse& use : result.constructions)
    json["constructions"].push_back({use.quads, to_json(use.smallest), to_json(use.largest)});
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

PolygonResult result_from_text(const std::string& text) {
  const Json json = Json::parse(text);
  PolygonResult result;
  result.outcome = static_cast<PolygonOutcome>(json.at("outcome").get<int>());
  json.at("recipe").get_to(result.recipe);
  json.at("claim").get_to(result.claim);
  json.at("detail").get_to(result.detail);
  json.at("sizes").at(0).get_to(result.vertices);
  json.at("sizes").at(1).get_to(result.cells);
  json.at("sizes").at(2).get_to(result.quads);
  result.smallest = corner_from(json.at("smallest"));
  result.largest = corner_from(json.at("largest"));
  json.at("counts").get_to(result.counts);
  for (std::size_t i = 0; i < result.constructions.size(); ++i) {
    const Json& use = json.at("constructions").at(i);
    result.constructions[i] = {use.at(0).get<std::uint64_t>(), corner_from(use.at(1)),
                               corner_from(use.at(2))};
  }
  return result;
}

void Spread::add(double value) {
  smallest = count == 0 ? value : std::min(smallest, value);
  largest = count == 0 ? value : std::max(largest, value);
  sum += value;
  ++count;
}

void Record::keep_smaller(const std::optional<Corner<Rational>>& candidate, const std::string& of) {
  if (!candidate || (corner && !smaller_angle(*candidate, *corner))) return;
  corner = candidate;
  recipe = of;
}

void Record::keep_larger(const std::optional<Corner<Rational>>& candidate, const std::string& of) {
  if (!candidate || (corner && !smaller_angle(*corner, *candidate))) return;
  corner = candidate;
  recipe = of;
}

void PolygonFamilyTally::add(const PolygonResult& result) {
  ++cases;
  ++outcomes[static_cast<std::size_t>(result.outcome)];
  if (result.cells == 0) return;
  vertices += result.vertices;
  cells += result.cells;
  quads += result.quads;
  cells_per_vertex.add(static_cast<double>(result.cells) / static_cast<double>(result.vertices));
  quads_per_cell.add(static_cast<double>(result.quads) / static_cast<double>(result.cells));
  smallest.keep_smaller(result.smallest, result.recipe);
  largest.keep_larger(result.largest, result.recipe);
}

void PolygonTally::add(std::uint64_t index, const PolygonResult& result,
                       const std::string& family) {
  all.add(result);
  families[family].add(result);
  add_each(counts, result.counts);
  for (std::size_t i = 0; i < constructions.size(); ++i) {
    const ConstructionUse& use = result.constructions[i];
    constructions[i].quads += use.quads;
    constructions[i].cases += use.quads == 0 ? 0 : 1;
    constructions[i].smallest.keep_smaller(use.smallest, result.recipe);
    constructions[i].largest.keep_larger(use.largest, result.recipe);
  }
  if (result.outcome == PolygonOutcome::kFinding)
    findings.push_back({index, result});
  else if (result.outcome != PolygonOutcome::kProved)
    refusals.push_back({index, result});
}

std::vector<std::string> PolygonTally::never_reached() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < constructions.size(); ++i) {
    // A whole kite needs sides without Steiner points, but condition A.3 makes every side of a kite
    // longer than 2 sqrt(2) cells: only tests of fill_kites by itself reach it.
    if (i == number_of(StripConstruction::kKiteWhole)) continue;
    if (constructions[i].quads == 0) names.emplace_back(polygon_construction_name(i));
  }
  return names;
}

}  // namespace quadbound::cli
