// SPDX-License-Identifier: Apache-2.0
#include "generators/polygons.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "generators/polygon_families.hpp"
#include "model/errors.hpp"
#include "model/validate.hpp"

namespace quadbound {
namespace {

using namespace generators;

struct Family {
  FamilyDescription description;
  LatticePolygon (*make)(PolygonMaker&);
};

constexpr std::uint64_t kMillion = 1'000'000;

Parameter holes(std::int64_t largest = 10'000) {
  return {"holes", 0, 0, largest, largest == 0 ? "it has none" : "small holes inside"};
}

Parameter level() { return {"level", 5, 3, 20, "coordinates are multiples of 2^-level"}; }

std::vector<Family> round_families() {
  return {
      {{"star",
        "seen whole from its centre, radii at random",
        {holes(), {"low", 30, 5, 100, "smallest radius in percent"}},
        {4, kMillion}},
       make_star},
      {{"regular",
        "a regular polygon",
        {holes(), {"turn", 0, 0, 63, "turned by so many 64ths of a side's angle"}},
        {3, kMillion}},
       make_regular},
      {{"gear",
        "teeth around a disk",
        {holes(), {"low", 80, 20, 99, "radius between the teeth in percent"}},
        {12, kMillion, 4}},
       make_gear},
      {{"annulus",
        "a ring between two regular polygons",
        {holes(0), {"low", 50, 1, 90, "inner radius in percent"}},
        {5, kMillion}},
       make_annulus},
      {{"sharp",
        "tips around a small body",
        {holes(), {"depth", 4, 1, 16, "the body's radius is 2^-depth"}},
        {6, kMillion, 2}},
       make_sharp},
      {{"notch",
        "a regular polygon with a slit in each side",
        {holes(), {"depth", 6, 4, 18, "half the slit's mouth is 2^-depth"}},
        {16, kMillion, 4}},
       make_notch},
      {{"slit",
        "a regular polygon with slits of one reflex angle, short where sides are",
        {holes(),
         {"slits", 4, 1, 100'000, "number of slits, 3 vertices each"},
         {"reflex", 35'500, 34'000, 35'999, "their angle in hundredths of a degree"}},
        {8, kMillion}},
       make_slit},
      {{"blob",
        "smooth, no acute angle",
        {holes(),
         {"waves", 6, 1, 64, "terms of the radius as a Fourier series"},
         {"swing", 50, 0, 90, "how much the radius varies at most, in percent"}},
        {5, 200'000}},
       make_blob},
  };
}

std::vector<Family> axis_families() {
  return {
      {{"x-monotone", "two chains that run from left to right", {holes()}, {4, kMillion}},
       make_x_monotone},
      {{"orthogonal", "columns of random heights", {holes()}, {4, kMillion, 2}}, make_orthogonal},
      {{"grid-aligned",
        "orthogonal, vertices on corners of quadtree cells",
        {holes(), level()},
        {4, kMillion, 2}},
       make_grid_aligned},
      {{"near-grid",
        "grid-aligned, each vertex moved a little",
        {holes(), level(), {"amplitude", 4, 2, 20, "moves are up to 2^-amplitude of the grid"}},
        {4, kMillion, 2}},
       make_near_grid},
      {{"comb",
        "teeth with narrow gaps",
        {holes(), {"depth", 1, 1, 16, "a gap is 2^-depth of the pitch"}},
        {8, kMillion, 4}},
       make_comb},
      {{"spiral-band", "a right-angled band wound around itself", {holes(0)}, {6, kMillion, 2}},
       make_spiral_band},
      {{"obtuse-spiral",
        "a band wound around itself, no acute angle",
        {holes(), {"sides", 8, 7, 1000, "bends in a turn"}},
        {8, 200'000}},
       make_obtuse_spiral},
      {{"collinear",
        "a star with many vertices along its sides, on every other one exactly",
        {holes(),
         {"corners", 8, 3, 64, "corners of the star"},
         {"off", 1, 0, 64, "how far those of the rest lie off, in units of 2^-20"}},
        {3, kMillion}},
       make_collinear},
      {{"slopes",
        "edges with the slopes 0, 1/7, 1/3, 1/2, 3/4, 1 and their mirror images",
        {holes(),
         {"turn", 0, 0, 3, "quarter turns"},
         {"off", 0, 0, 8, "each vertex is moved by so many units of 2^-20 at most"}},
        {4, 100'000, 2}},
       make_slopes},
  };
}

std::vector<Family> random_families() {
  return {
      {{"two-opt", "random points on a tour, untangled by 2-opt moves", {holes()}, {3, 20'000}},
       make_two_opt},
      {{"space-partition",
        "random points joined by cutting the plane into parts",
        {holes()},
        {3, kMillion}},
       make_space_partition},
      {{"growth", "random points taken into a growing polygon", {holes()}, {3, kMillion}},
       make_growth},
      {{"coast",
        "a fractal: midpoints displaced at random",
        {holes(), {"rough", 30, 0, 60, "largest displacement in percent of the edge"}},
        {3, kMillion}},
       make_coast},
      {{"koch",
        "Koch's snowflake; n = 3 * 4^depth is complete to that depth",
        {holes(), {"height", 289, 20, 289, "of a tip, in thousandths of the edge"}},
        {3, 800'000, 3}},
       make_koch},
  };
}

std::vector<Family> hole_families() {
  return {
      {{"plate",
        "a square with round holes",
        {{"holes", 1, 0, 100'000, "number of holes, one at least"},
         {"sides", 32, 3, 100'000, "vertices of a hole"}},
        {4, 4}},
       make_plate},
      {{"needle",
        "a regular polygon with needle-shaped holes",
        {{"holes", 9, 0, 10'000, "number of needles, 4 vertices each"},
         {"depth", 10, 4, 17, "needles are 2^-depth wide"}},
        {3, kMillion}},
       make_needle},
      {{"clusters",
        "a regular polygon with small holes close to each other",
        {{"holes", 40, 0, 10'000, "number of holes"},
         {"clusters", 4, 1, 100, "number of clusters"},
         {"spread", 4, 3, 9, "a cluster is 2^(1-spread) wide"}},
        {6, kMillion}},
       make_clusters},
      {{"glyph",
        "the outline of a letter of DejaVu 2.37; at least as many vertices as it has",
        {{"holes", 0, 0, 0, "those of the letter"},
         {"character", 0, 0, 0xFFFF, "its number in Unicode; 0: one by the seed"},
         {"font", 0, 0, 5, "Sans, Sans Bold, Mono, Mono Bold, Serif, Serif Bold"},
         {"pieces", 4, 1, 16, "vertices of a hole on each of its curves"}},
        {4, 100'000}},
       make_glyph},
  };
}

const std::vector<Family>& families() {
  static const std::vector<Family> table = [] {
    std::vector<Family> all;
    for (const auto part : {round_families, axis_families, random_families, hole_families})
      for (Family& family : part()) all.push_back(std::move(family));
    return all;
  }();
  return table;
}

const std::vector<FamilyDescription>& descriptions() {
  static const std::vector<FamilyDescription> table = [] {
    std::vector<FamilyDescription> result;
    for (const Family& family : families()) result.push_back(family.description);
    return result;
  }();
  return table;
}

Ring to_ring(const LatticeRing& lattice) {
  Ring ring;
  ring.reserve(lattice.size());
  for (const LatticePoint p : lattice)
    ring.push_back(
        {std::ldexp(static_cast<double>(p.x), -20), std::ldexp(static_cast<double>(p.y), -20)});
  return ring;
}

}  // namespace

std::span<const FamilyDescription> polygon_families() { return descriptions(); }

PolygonRecipe parse_polygon_recipe(std::string_view text) {
  return parse_recipe(text, polygon_families());
}

Polygon generate_polygon(const PolygonRecipe& recipe) {
  const Recipe full = completed(recipe, polygon_families());
  const auto index = &find_family(polygon_families(), full.family) - descriptions().data();
  PolygonMaker maker(full);
  const LatticePolygon made = families()[static_cast<std::size_t>(index)].make(maker);
  Polygon polygon{to_text(full), {to_ring(made.outer)}};
  for (const LatticeRing& hole : made.holes) polygon.rings.push_back(to_ring(hole));
  try {
    return normalised(std::move(polygon));
  } catch (const InputError& error) {
    // Extreme parameters can ask for more than the lattice resolves; a font can have anything.
    throw RecipeError(fmt::format("{}; {}", error.what(),
                                  full.family == "glyph"
                                      ? "the outlines meet, or are divided too finely"
                                      : "multiples of 2^-20 are too coarse"));
  }
}

}  // namespace quadbound
