// SPDX-License-Identifier: Apache-2.0
#include "cli/property_cases.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ostream>
#include <set>
#include <span>
#include <sstream>
#include <variant>

#include "generators/random.hpp"
#include "model/errors.hpp"
#include "model/validate.hpp"
#include "model/write_json.hpp"
#include "model/write_points.hpp"
#include "model/write_polygon.hpp"

namespace quadbound::cli {
namespace {

// The same random inputs in every run, unless the environment asks for others.
[[maybe_unused]] const int kFixedSeed = ::setenv("RC_PARAMS", "seed=20120901", 0);

// --- recipes -------------------------------------------------------------------------------------

constexpr std::int64_t kFewRings = 3;
constexpr std::int64_t kFewOfAKind = 12;
constexpr std::int64_t kShallow = 3;

/// The parameters that make vertices by the thousand or cells by the million stay small.
Parameter bounded(Parameter parameter) {
  std::int64_t most = parameter.largest;
  if (parameter.name == "holes") most = kFewRings;
  if (parameter.name == "sides" || parameter.name == "slits" || parameter.name == "clusters")
    most = kFewOfAKind;
  if (parameter.name == "depth" || parameter.name == "octaves")
    most = std::max(parameter.smallest, kShallow);
  parameter.largest = std::max(parameter.smallest, std::min(parameter.largest, most));
  parameter.default_value = std::min(parameter.default_value, parameter.largest);
  return parameter;
}

Recipe any_recipe(RandomIntegers& random, std::span<const FamilyDescription> families,
                  std::int64_t most) {
  const FamilyDescription& family = families[random.below(families.size())];
  Recipe recipe;
  recipe.family = family.name;
  recipe.n = fitting(family.sizes, static_cast<std::uint64_t>(random.between(3, most)));
  recipe.seed = static_cast<std::uint64_t>(random.bits(32));
  for (const Parameter& any : family.parameters) {
    const Parameter p = bounded(any);
    recipe.parameters[std::string(p.name)] =
        random.chance(50) ? p.default_value : random.between(p.smallest, p.largest);
  }
  return recipe;
}

/// Nothing where the recipe cannot be carried out.
std::optional<PolygonSample> sample_of(const PolygonRecipe& recipe) {
  try {
    return PolygonSample{recipe, generate_polygon(recipe)};
  } catch (const RecipeError&) {
    return std::nullopt;
  }
}

std::optional<PointSample> point_sample_of(const PointRecipe& recipe) {
  try {
    PointSample sample{recipe, generate_points(recipe)};
    validate(sample.points);
    return sample;
  } catch (const std::exception&) {  // no such points, or out of range
    return std::nullopt;
  }
}

/// Down to `least`, the largest steps first.
template <class Integer>
std::vector<Integer> towards(Integer value, Integer least) {
  std::vector<Integer> values;
  for (Integer step = value - least; step > 0; step /= 2) values.push_back(value - step);
  return values;
}

std::vector<Recipe> smaller_recipes(const Recipe& recipe, const FamilyDescription& family) {
  std::vector<Recipe> smaller;
  for (const std::uint64_t n : towards(recipe.n, family.sizes.smallest)) {
    smaller.push_back(recipe);
    smaller.back().n = fitting(family.sizes, n);
  }
  for (const Parameter& parameter : family.parameters) {
    const std::string name(parameter.name);
    for (const std::int64_t value : towards(recipe.parameters.at(name), parameter.smallest)) {
      smaller.push_back(recipe);
      smaller.back().parameters[name] = value;
    }
  }
  for (const std::uint64_t seed : towards(recipe.seed, std::uint64_t{1})) {
    smaller.push_back(recipe);
    smaller.back().seed = seed;
  }
  return smaller;
}

// --- shrinking -----------------------------------------------------------------------------------

template <class Sample>
rc::Seq<Sample> smaller_by_recipe(const Sample& sample, std::span<const FamilyDescription> families,
                                  std::optional<Sample> (*make)(const Recipe&)) {
  if (!sample.recipe) return {};
  return rc::seq::mapMaybe(rc::seq::fromContainer(smaller_recipes(
                               *sample.recipe, find_family(families, sample.recipe->family))),
                           [make](const Recipe& recipe) -> rc::Maybe<Sample> {
                             if (const auto made = make(recipe)) return *made;
                             return rc::Nothing;
                           });
}

/// Without one ring or vertex: the holes first, then all vertices.
rc::Maybe<PolygonSample> without(const Polygon& polygon, std::size_t number) {
  Polygon smaller = polygon;
  const std::size_t holes = polygon.rings.size() - 1;
  if (number < holes) {
    smaller.rings.erase(smaller.rings.begin() + 1 + static_cast<std::ptrdiff_t>(number));
  } else {
    number -= holes;
    std::size_t ring = 0;
    while (number >= smaller.rings[ring].size()) number -= smaller.rings[ring++].size();
    if (smaller.rings[ring].size() == 3) return rc::Nothing;
    smaller.rings[ring].erase(smaller.rings[ring].begin() + static_cast<std::ptrdiff_t>(number));
  }
  try {
    return PolygonSample{std::nullopt, normalised(std::move(smaller))};
  } catch (const InputError&) {
    return rc::Nothing;
  }
}

rc::Seq<PolygonSample> smaller_polygons(const PolygonSample& sample) {
  std::size_t parts = sample.polygon.rings.size() - 1;
  for (const Ring& ring : sample.polygon.rings) parts += ring.size();
  return rc::seq::concat(
      smaller_by_recipe<PolygonSample>(sample, polygon_families(), sample_of),
      rc::seq::mapMaybe(rc::seq::range<std::size_t>(0, parts),
                        [polygon = sample.polygon](std::size_t i) { return without(polygon, i); }));
}

rc::Seq<PointSample> smaller_point_sets(const PointSample& sample) {
  const std::size_t size = sample.points.points.size();
  return rc::seq::concat(smaller_by_recipe<PointSample>(sample, point_families(), point_sample_of),
                         rc::seq::map(rc::seq::range<std::size_t>(0, size == 1 ? 0 : size),
                                      [points = sample.points](std::size_t i) {
                                        PointSample smaller{std::nullopt, points};
                                        smaller.points.points.erase(smaller.points.points.begin() +
                                                                    static_cast<std::ptrdiff_t>(i));
                                        return smaller;
                                      }));
}

/// The number of vertices or points that goes with a size of rapidcheck, which grows to 100.
std::int64_t most_at(int size, int full) { return 4 + full * size / rc::kNominalSize; }

// --- names of constructions ----------------------------------------------------------------------

template <class Counts, class Names>
void add_each(std::map<std::string, std::uint64_t>& cases, const char* prefix, const Names& names,
              const Counts& counts) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (counts[i] > 0) ++cases[prefix + std::string(names[i])];
}

template <class Names>
void expect_each(Reached& reached, const char* prefix, const Names& names) {
  for (const std::string_view name : names) reached.expect(prefix + std::string(name));
}

}  // namespace

rc::Gen<PolygonSample> any_polygon() {
  constexpr int kVertices = 32;
  return [](const rc::Random& bits, int size) {
    RandomIntegers random(rc::Random(bits).next());
    std::optional<PolygonSample> sample;
    while (!sample)  // some draws have no room for their holes
      sample = sample_of(any_recipe(random, polygon_families(), most_at(size, kVertices)));
    return rc::shrinkable::shrinkRecur(*std::move(sample),
                                       [](const PolygonSample& s) { return smaller_polygons(s); });
  };
}

rc::Gen<PointSample> any_point_set() {
  constexpr int kPoints = 56;
  return [](const rc::Random& bits, int size) {
    RandomIntegers random(rc::Random(bits).next());
    std::optional<PointSample> sample;
    while (!sample)
      sample = point_sample_of(any_recipe(random, point_families(), most_at(size, kPoints)));
    return rc::shrinkable::shrinkRecur(*std::move(sample),
                                       [](const PointSample& s) { return smaller_point_sets(s); });
  };
}

void showValue(const PolygonSample& sample, std::ostream& stream) {
  if (sample.recipe)
    stream << to_text(*sample.recipe);
  else
    write_wkt(stream, sample.polygon);
}

void showValue(const PointSample& sample, std::ostream& stream) {
  if (sample.recipe)
    stream << to_text(*sample.recipe);
  else
    write_points(stream, sample.points, PointFormat::kCsv);
}

std::optional<PolygonMesh> meshed(const Polygon& polygon) {
  PolygonMeshOptions options;
  options.budget.max_cells = kMostCells;
  PolygonMeshResult result = mesh_polygon(polygon, options);
  if (auto* made = std::get_if<PolygonMesh>(&result)) return std::move(*made);
  const auto& refusal = std::get<Refusal>(result);
  RC_ASSERT(is_one_line(refusal.message));
  if (refusal.kind != RefusalKind::kTooManyCells) RC_FAIL(refusal.message);
  return std::nullopt;
}

std::optional<PointMesh> meshed(const PointSet& points, GridRefinement refinement) {
  PointMeshOptions options;
  options.refinement = refinement;
  options.budget.max_cells = kMostCells;
  PointMeshResult result = mesh_points(points, options);
  if (auto* made = std::get_if<PointMesh>(&result)) return std::move(*made);
  const auto& refusal = std::get<Refusal>(result);
  RC_ASSERT(is_one_line(refusal.message));
  RC_ASSERT(refusal.kind != RefusalKind::kTooMuchTime);
  return std::nullopt;
}

std::string broken_claims(const Report& report) {
  std::string text;
  for (const Claim& claim : report.claims)
    if (claim.exact != Verdict::holds) text += claim.id + ": " + claim.detail + "\n";
  return text;
}

std::string json_text(const Mesh& mesh) {
  std::ostringstream stream;
  write_json(stream, mesh);
  return stream.str();
}

bool is_one_line(const std::string& text) {
  return !text.empty() && text.find_first_of("\n\r") == std::string::npos;
}

Reached::Reached(Of input) {
  expect_each(*this, "template ", kTemplateNames);
  expect_each(*this, "stitching ", kStitchCaseNames);
  expect_each(*this, "quads of ", kConstructionNames);
  if (input == Of::kPoints) return;
  expect_each(*this, "quads of ", kStripConstructionNames);
  cases_.erase("quads of kite whole");
}

void Reached::add(const Counters& counters, const Mesh& mesh) {
  add_each(cases_, "template ", kTemplateNames, counters.templates);
  add_each(cases_, "stitching ", kStitchCaseNames, counters.stitch_cases);
  const std::set<std::uint8_t> used(mesh.construction.begin(), mesh.construction.end());
  for (const std::uint8_t construction : used)
    ++cases_["quads of " + mesh.construction_names[construction]];
}

void Reached::add(const PolygonMesh& made) { add(made.counters.quadtree, made.mesh); }

void Reached::add(const PointMesh& made) { add(made.counters, made.mesh); }

std::vector<std::string> Reached::never() const {
  std::vector<std::string> names;
  for (const auto& [name, count] : cases_)
    if (count == 0) names.push_back(name);
  return names;
}

std::string Reached::rarest() const {
  std::vector<std::pair<std::uint64_t, std::string>> sorted;
  for (const auto& [name, count] : cases_) sorted.emplace_back(count, name);
  std::ranges::sort(sorted);
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(sorted.size(), 4); ++i)
    text += (i == 0 ? "" : ", ") + sorted[i].second + ' ' + std::to_string(sorted[i].first);
  return text;
}

}  // namespace quadbound::cli
