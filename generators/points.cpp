// SPDX-License-Identifier: Apache-2.0
#include "generators/points.hpp"

#include <fmt/core.h>

#include <array>
#include <bit>

#include "generators/point_families.hpp"

namespace quadbound {
namespace {

constexpr std::size_t kFamilies = 10;

const std::array<FamilyDescription, kFamilies>& descriptions() {
  static const std::array<FamilyDescription, kFamilies> table = {{
      {"uniform",
       "multiples of 2^-bits in the unit square",
       {{"bits", 53, 1, 53, "bits of a coordinate"}}},
      {"clustered",
       "bell-shaped clusters in the unit square",
       {{"clusters", 10, 1, 1'000'000, "number of clusters"},
        {"spread", 6, 2, 48, "a cluster's points lie within 2^-spread of its centre"}}},
      {"near-duplicate",
       "points and partners a few units in the last place away",
       {{"share", 50, 1, 100, "percent of the points that belong to a pair"},
        {"ulps", 1, 1, 1024, "units in the last place between the two"},
        {"offset", 0, 0, 1, "0: in [0, 1); 1: in [1, 2), where all units are the same"}}},
      {"grid",
       "integer points of a rectangle, row by row, in random order",
       {{"columns", 0, 0, 1 << 27, "points in a row; 0: as many as rows"}}},
      {"grid-perturbed",
       "integer points of a square, each moved a little",
       {{"amplitude", 4, 2, 25, "both coordinates move by at most 2^-amplitude"}}},
      {"lattice-corners",
       "points on the corners and borders of quadtree cells of the unit square",
       {{"level", 12, 1, 30, "level of the smallest such cells"},
        {"borders", 50, 0, 100, "percent that lie on a border only, not on a corner"}}},
      {"line",
       "collinear points (t dx, t dy) with random t",
       {{"dx", 3, -(1 << 20), 1 << 20, "direction"}, {"dy", 1, -(1 << 20), 1 << 20, "direction"}}},
      {"circle",
       "points of the unit circle rounded to doubles",
       {{"even", 0, 0, 1, "0: random; 1: at regular parameters, symmetric under quarter turns"}}},
      {"spiral",
       "a chain along a spiral around the origin",
       {{"turn", 64, 2, 1 << 20, "from point to point by the angle 2 arctan(1/turn)"}}},
      {"exponential",
       "distances from the origin that shrink by powers of two",
       {{"octaves", 40, 1, 900, "number of scales; the smallest is 2^-octaves"},
        {"bits", 16, 1, 53, "bits of a coordinate within its scale"}}},
  }};
  return table;
}

using Make = void (*)(PointMaker&);
/// In the order of descriptions().
constexpr std::array<Make, kFamilies> kMake = {
    make_uniform,         make_clustered, make_near_duplicate, make_grid,   make_grid_perturbed,
    make_lattice_corners, make_line,      make_circle,         make_spiral, make_exponential};

}  // namespace

std::size_t DistinctPoints::Hash::operator()(const Point& point) const {
  // Multiplying by odd constants mixes upwards, so the high half is folded down at the end.
  std::uint64_t mixed = std::bit_cast<std::uint64_t>(point.x) * 0x9E3779B97F4A7C15U;
  mixed = (mixed ^ (mixed >> 32) ^ std::bit_cast<std::uint64_t>(point.y)) * 0xC2B2AE3D27D4EB4FU;
  return static_cast<std::size_t>(mixed ^ (mixed >> 32));
}

bool DistinctPoints::add(Point point) {
  // Far above what a family needs that was not refused beforehand.
  if (++offers_ > 64 * wanted_ + 4096)
    throw RecipeError(fmt::format("{}: only {} distinct points found, {} wanted", to_text(recipe_),
                                  points_.size(), wanted_));
  // Adding zero turns -0 into 0, so that equal points have equal bytes.
  point = {point.x + 0.0, point.y + 0.0};
  if (!seen_.insert(point).second) return false;
  points_.push_back(point);
  return true;
}

void PointMaker::require_sites(double sites) const {
  if (2.0 * static_cast<double>(recipe.n) > sites)
    throw RecipeError(fmt::format("{}: n must be at most half of the {} distinct points there are",
                                  to_text(recipe), sites));
}

std::span<const FamilyDescription> point_families() { return descriptions(); }

PointRecipe parse_point_recipe(std::string_view text) {
  return parse_recipe(text, point_families());
}

PointSet generate_points(const PointRecipe& recipe) {
  const Recipe full = completed(recipe, point_families());
  const auto family = &find_family(point_families(), full.family) - descriptions().data();
  PointMaker maker(full);
  kMake.at(static_cast<std::size_t>(family))(maker);
  return {to_text(full), maker.points.take()};
}

}  // namespace quadbound
