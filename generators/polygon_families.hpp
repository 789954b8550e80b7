// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the families of polygons share; private to generators/.

#include <cstdint>
#include <vector>

#include "generators/random.hpp"
#include "generators/recipe.hpp"
#include "model/exact.hpp"

namespace quadbound::generators {

/// Lattice units in the unit of length: polygons are made of integers below 2^24, so that products
/// of two coordinates stay far inside 64 bits.
inline constexpr std::int64_t kUnit = std::int64_t{1} << 20;

using LatticeRing = std::vector<LatticePoint>;

/// The outer ring counter-clockwise; holes in any orientation.
struct LatticePolygon {
  LatticeRing outer;
  std::vector<LatticeRing> holes;
};

/// A recipe at work: its parameters by name and its random integers.
struct PolygonMaker {
  explicit PolygonMaker(const Recipe& completed_recipe)
      : recipe(completed_recipe),
        random(completed_recipe.seed),
        n(static_cast<std::int64_t>(completed_recipe.n)) {}

  [[nodiscard]] std::int64_t parameter(const char* name) const {
    return recipe.parameters.at(name);
  }
  /// Errors: RecipeError of the recipe and `what` unless the condition holds.
  void require(bool condition, const char* what) const;

  const Recipe& recipe;
  RandomIntegers random;
  std::int64_t n;
};

/// Twice the area of the triangle abc, positive where it turns counter-clockwise.
inline std::int64_t turn(LatticePoint a, LatticePoint b, LatticePoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// (b - a) . (c - a)
inline std::int64_t dot(LatticePoint a, LatticePoint b, LatticePoint c) {
  return (b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y);
}

/// The lattice point nearest to a place.
LatticePoint rounded(double x, double y);

/// The lattice point nearest to centre + radius * direction.
LatticePoint at(LatticePoint centre, double radius, Point direction);

/// A regular polygon, turned by first / (sides * 64) of a turn.
LatticeRing regular(LatticePoint centre, double radius, std::int64_t sides, std::int64_t first = 0);

/// Whether no angle on the left of a ring is below 90 degrees.
bool non_acute(const LatticeRing& ring);

// As many small hexagons as the parameter "holes" says.
// Errors: RecipeError where they would be too small for the lattice.

/// Evenly spaced on a circle around the origin, none near another.
std::vector<LatticeRing> holes_on_circle(const PolygonMaker& maker, double radius);

/// Evenly spaced on the segment from (left, y) to (right, y), at most `room` high.
std::vector<LatticeRing> holes_in_row(const PolygonMaker& maker, std::int64_t left,
                                      std::int64_t right, std::int64_t y, std::int64_t room);

/// At random places inside a simple ring, each as large as a random share of the room there.
/// Expected time O(holes * sqrt(n)) after O(n).
std::vector<LatticeRing> holes_anywhere(PolygonMaker& maker, const LatticeRing& outer);

// What each makes is said in the table of polygons.cpp.
LatticePolygon make_star(PolygonMaker& maker);
LatticePolygon make_regular(PolygonMaker& maker);
LatticePolygon make_gear(PolygonMaker& maker);
LatticePolygon make_annulus(PolygonMaker& maker);
LatticePolygon make_sharp(PolygonMaker& maker);
LatticePolygon make_notch(PolygonMaker& maker);
LatticePolygon make_slit(PolygonMaker& maker);
LatticePolygon make_blob(PolygonMaker& maker);
LatticePolygon make_x_monotone(PolygonMaker& maker);
LatticePolygon make_orthogonal(PolygonMaker& maker);
LatticePolygon make_grid_aligned(PolygonMaker& maker);
LatticePolygon make_near_grid(PolygonMaker& maker);
LatticePolygon make_comb(PolygonMaker& maker);
LatticePolygon make_plate(PolygonMaker& maker);
LatticePolygon make_needle(PolygonMaker& maker);
LatticePolygon make_clusters(PolygonMaker& maker);
LatticePolygon make_spiral_band(PolygonMaker& maker);
LatticePolygon make_obtuse_spiral(PolygonMaker& maker);
LatticePolygon make_collinear(PolygonMaker& maker);
LatticePolygon make_slopes(PolygonMaker& maker);
LatticePolygon make_coast(PolygonMaker& maker);
LatticePolygon make_koch(PolygonMaker& maker);
LatticePolygon make_glyph(PolygonMaker& maker);

/// Auer and Held, Heuristics for the Generation of Random Polygons, CCCG 1996, pp. 38-43: 2-opt
/// Moves (which is also what CGAL's random_polygon_2 does), Space Partitioning and Steady Growth.
LatticePolygon make_two_opt(PolygonMaker& maker);
LatticePolygon make_space_partition(PolygonMaker& maker);
LatticePolygon make_growth(PolygonMaker& maker);

}  // namespace quadbound::generators
