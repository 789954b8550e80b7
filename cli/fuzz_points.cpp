// SPDX-License-Identifier: Apache-2.0
#include "cli/fuzz_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <set>
#include <utility>

#include "cli/fuzz_cases.hpp"
#include "generators/random.hpp"
#include "model/errors.hpp"
#include "model/validate.hpp"
#include "verify/verify.hpp"

namespace quadbound::cli {
namespace {

// --- making a case -------------------------------------------------------------------------------

PointRecipe any_recipe(RandomIntegers& random, const std::string& family, std::uint64_t max_n) {
  const FamilyDescription& description = find_family(point_families(), family);
  PointRecipe recipe;
  recipe.family = family;
  recipe.n = std::max<std::uint64_t>(1, any_magnitude(random, max_n));
  recipe.seed = static_cast<std::uint64_t>(random.bits(32));
  for (const Parameter& parameter : description.parameters)
    recipe.parameters[std::string(parameter.name)] = any_value(random, parameter);
  return recipe;
}

/// A recipe that can be carried out, and its points: where a family has too few, fewer are asked
/// for, and other parameters where even one is too many.
void make_recipe(RandomIntegers& random, const std::string& family, std::uint64_t max_n,
                 PointCase& made) {
  made.recipe = any_recipe(random, family, max_n);
  for (;;) {
    try {
      made.points = generate_points(made.recipe);
      return;
    } catch (const RecipeError&) {
      if (made.recipe.n > 1)
        made.recipe.n /= 2;
      else
        made.recipe = any_recipe(random, family, max_n);
    }
  }
}

PointTransform any_transform(RandomIntegers& random) {
  PointTransform transform;
  if (random.chance(40)) {
    // Up to some two million, in steps of 1/32.
    const auto axes = random.between(1, 3);
    const auto amount = [&] {
      return std::ldexp(static_cast<double>(random.between(-(1 << 26), 1 << 26)), -5);
    };
    if ((axes & 1) != 0) transform.offset.x = amount();
    if ((axes & 2) != 0) transform.offset.y = amount();
  }
  transform.swap_axes = random.chance(50);
  transform.negate_x = random.chance(50);
  transform.negate_y = random.chance(50);
  if (random.chance(40)) transform.exponent = static_cast<int>(random.between(-300, 300));
  return transform;
}

Point transformed(Point point, const PointTransform& t) {
  point = {point.x + t.offset.x, point.y + t.offset.y};
  if (t.swap_axes) std::swap(point.x, point.y);
  if (t.negate_x) point.x = -point.x;
  if (t.negate_y) point.y = -point.y;
  return {std::ldexp(point.x, t.exponent), std::ldexp(point.y, t.exponent)};
}

/// Transforms the points; of those that fall together the first stays.
void transform_points(PointCase& made) {
  std::set<std::pair<double, double>> seen;
  std::vector<Point> kept;
  for (const Point& before : made.points.points) {
    const Point point = transformed(before, made.transform);
    if (seen.emplace(point.x, point.y).second)
      kept.push_back(point);
    else
      ++made.merged;
  }
  made.points.points = std::move(kept);
}

// --- trying it -----------------------------------------------------------------------------------

/// Whether a refusal for depth was due. The factor 3/2 makes up for the norm (at most the square
/// root of 2) and for all rounding.
CaseOutcome judged_depth(std::span<const Point> points) {
  const Closeness c = closeness(points);
  if (c.distance * 1.5 < std::ldexp(c.extent, -50)) return CaseOutcome::kTooDeep;
  if (c.distance * 1.5 < std::ldexp(c.magnitude, -50)) return CaseOutcome::kTooFarOut;
  return CaseOutcome::kFinding;
}

CaseResult without_mesh(CaseOutcome outcome, std::string claim, std::string detail) {
  CaseResult result;
  result.outcome = outcome;
  result.claim = std::move(claim);
  result.detail = std::move(detail);
  return result;
}

CaseResult refused(const PointCase& made, const Refusal& refusal) {
  const CaseOutcome outcome =
      refusal.kind == RefusalKind::kTooDeep        ? judged_depth(made.points.points)
      : refusal.kind == RefusalKind::kTooManyCells ? CaseOutcome::kTooManyCells
                                                   : CaseOutcome::kFinding;
  return without_mesh(outcome, outcome == CaseOutcome::kFinding ? "refusal" : "", refusal.message);
}

void note_verdicts(const Report& report, CaseResult& result) {
  for (const Claim& claim : report.claims)
    if (claim.stored && claim.stored->verdict == StoredVerdict::fails) result.stored_holds = false;
  if (const auto broken = broken_claim(report)) {
    result.outcome = CaseOutcome::kFinding;
    result.claim = broken->id;
    result.detail = broken->detail;
  }
}

CaseResult meshed(const PointCase& made, const PointMeshOptions& options) {
  PointMeshOptions mesh_options = options;
  mesh_options.refinement = made.refinement;
  mesh_options.budget.max_seconds = 1e9;  // a clock would make the outcome differ from run to run
  const PointMeshResult outcome = mesh_points(made.points, mesh_options);
  if (const auto* refusal = std::get_if<Refusal>(&outcome)) return refused(made, *refusal);
  const auto& mesh = std::get<PointMesh>(outcome);
  const Report report = verify_points(made.points, mesh.mesh);
  CaseResult result;
  result.cells = mesh.mesh.cells;
  result.quads = mesh.mesh.quads.size();
  result.counters = mesh.counters;
  result.smallest = extreme(report, "min-angle");
  result.largest = extreme(report, "max-angle");
  note_verdicts(report, result);
  return result;
}

// --- tallies -------------------------------------------------------------------------------------

void keep_smaller(std::optional<Corner<Rational>>& kept, const std::optional<Corner<Rational>>& c) {
  if (c && (!kept || smaller_angle(*c, *kept))) kept = c;
}
void keep_larger(std::optional<Corner<Rational>>& kept, const std::optional<Corner<Rational>>& c) {
  if (c && (!kept || smaller_angle(*kept, *c))) kept = c;
}

void add_counters(Counters& sums, const Counters& counters) {
  add_each(sums.templates, counters.templates);
  add_each(sums.stitch_cases, counters.stitch_cases);
  add_each(sums.quads, counters.quads);
}

}  // namespace

std::string to_text(const PointTransform& t) {
  return fmt::format("offset=({},{}) swap={} negate=({},{}) scale=2^{}", t.offset.x, t.offset.y,
                     t.swap_axes ? 1 : 0, t.negate_x ? 1 : 0, t.negate_y ? 1 : 0, t.exponent);
}

std::vector<std::string> all_point_families() { return names_of(point_families()); }

PointCase random_point_case(const PointCampaign& campaign, std::uint64_t index) {
  RandomIntegers random(case_seed(campaign.seed, index));
  const std::size_t families = campaign.families.size();
  PointCase made;
  made.index = index;
  make_recipe(random, campaign.families[index % families], campaign.max_n, made);
  made.transform = any_transform(random);
  made.refinement =
      index / families % 2 == 0 ? GridRefinement::kSixBySix : GridRefinement::kFiveByFive;
  transform_points(made);
  return made;
}

CaseResult try_point_case(const PointCase& made, const PointMeshOptions& options) {
  try {
    validate(made.points);
  } catch (const InputError& error) {
    return without_mesh(CaseOutcome::kOutOfRange, {}, error.what());
  }
  try {
    return meshed(made, options);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return without_mesh(CaseOutcome::kFinding, "exception", error.what());
  }
}

std::uint64_t FamilyTally::count(CaseOutcome outcome) const {
  const auto found = outcomes.find(outcome);
  return found == outcomes.end() ? 0 : found->second;
}

double FamilyTally::mean_cells_per_point() const {
  return meshes == 0 ? 0
                     : static_cast<double>(cells_per_point_thousandths) / 1000 /
                           static_cast<double>(meshes);
}

void FamilyTally::add(const PointCase& made, const CaseResult& result) {
  FamilyTally one;
  one.sets = 1;
  one.merged = made.merged;
  one.outcomes[result.outcome] = 1;
  if (result.cells != 0) {
    const std::uint64_t n = made.points.points.size();
    one.beyond_rounding = result.stored_holds ? 0 : 1;
    one.points = n;
    one.meshes = 1;
    one.cells = result.cells;
    one.smallest_cells_per_point = one.largest_cells_per_point =
        static_cast<double>(result.cells) / static_cast<double>(n);
    one.cells_per_point_thousandths = 1000 * result.cells / n;
    one.largest_quads_per_cell =
        static_cast<double>(result.quads) / static_cast<double>(result.cells);
    one.smallest = result.smallest;
    one.largest = result.largest;
  }
  merge(one);
}

void FamilyTally::merge(const FamilyTally& other) {
  if (meshes == 0 ||
      (other.meshes != 0 && other.smallest_cells_per_point < smallest_cells_per_point))
    smallest_cells_per_point = other.smallest_cells_per_point;
  largest_cells_per_point = std::max(largest_cells_per_point, other.largest_cells_per_point);
  largest_quads_per_cell = std::max(largest_quads_per_cell, other.largest_quads_per_cell);
  keep_smaller(smallest, other.smallest);
  keep_larger(largest, other.largest);
  sets += other.sets;
  merged += other.merged;
  for (const auto& [outcome, number] : other.outcomes) outcomes[outcome] += number;
  beyond_rounding += other.beyond_rounding;
  points += other.points;
  meshes += other.meshes;
  cells += other.cells;
  cells_per_point_thousandths += other.cells_per_point_thousandths;
}

FamilyTally CampaignTally::total() const {
  FamilyTally sum;
  for (const auto& [family, tally] : families) sum.merge(tally);
  return sum;
}

void CampaignTally::add(const PointCase& made, const CaseResult& result) {
  families[made.recipe.family].add(made, result);
  add_counters(counters, result.counters);
  if (result.outcome == CaseOutcome::kFinding)
    findings.push_back({made, result.claim, result.detail});
}

void CampaignTally::merge(const CampaignTally& other) {
  for (const auto& [family, tally] : other.families) families[family].merge(tally);
  add_counters(counters, other.counters);
  findings.insert(findings.end(), other.findings.begin(), other.findings.end());
  std::ranges::sort(findings, {}, [](const Finding& finding) { return finding.made.index; });
}

std::vector<std::string> CampaignTally::never_reached() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kTemplateCount; ++i)
    if (counters.templates[i] == 0) names.push_back(fmt::format("template {}", kTemplateNames[i]));
  for (std::size_t i = 0; i < kStitchCaseCount; ++i)
    if (counters.stitch_cases[i] == 0)
      names.push_back(fmt::format("stitching case {}", kStitchCaseNames[i]));
  return names;
}

Closeness closeness(std::span<const Point> points) {
  std::vector<Point> sorted(points.begin(), points.end());
  std::ranges::sort(sorted, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax_element(sorted, {}, &Point::y);
  Closeness result{std::numeric_limits<double>::infinity(),
                   std::max(sorted.back().x - sorted.front().x, high->y - low->y), 0};
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const Point& a = sorted[i];
    result.magnitude = std::max({result.magnitude, std::abs(a.x), std::abs(a.y)});
    for (std::size_t j = i + 1; j < sorted.size() && sorted[j].x - a.x < result.distance; ++j)
      result.distance =
          std::min(result.distance, std::max(sorted[j].x - a.x, std::abs(sorted[j].y - a.y)));
  }
  return result;
}

}  // namespace quadbound::cli
