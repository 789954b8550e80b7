// SPDX-License-Identifier: Apache-2.0
#pragma once
// Polygons and exact arithmetic for the tests of the parts of the mesher of polygons.

#include <string>
#include <vector>

#include "algo/domain.hpp"
#include "algo/kites.hpp"
#include "algo/point_separation.hpp"
#include "generators/polygons.hpp"
#include "model/validate.hpp"

namespace quadbound {

inline std::vector<Point> vertices_of(const Polygon& polygon) {
  std::vector<Point> points;
  for (const Ring& ring : polygon.rings) points.insert(points.end(), ring.begin(), ring.end());
  return points;
}

/// Without kites, in a shifted root square.
inline Domain domain_of(const Polygon& polygon, RootShift shift = {3, 5}) {
  const std::vector<Point> points = vertices_of(polygon);
  return cut_kites(polygon, place_root(points, shift).root, std::vector<bool>(points.size()));
}

/// With a kite at every acute vertex.
inline Domain non_acute_domain_of(const Polygon& polygon, RootShift shift = {3, 5}) {
  const Domain whole = domain_of(polygon, shift);
  std::vector<bool> cut;
  for (EdgeId v = 0; v < whole.size(); ++v) cut.push_back(whole.is_acute(v));
  return cut_kites(polygon, whole.root(), cut);
}

/// Its small coordinates have bits below the lattice.
inline Polygon polygon_off_the_lattice() {
  return normalised(
      {"off", {{{1e-7 / 3, -1e-9 / 7}, {1, 0.1}, {0.7, 1e-5 / 3 + 0.9}, {-1e-6 / 9, 0.5}}}});
}

inline std::vector<Polygon> samples() {
  std::vector<Polygon> polygons{polygon_off_the_lattice()};
  for (const char* recipe : {"regular:n=5", "star:n=8,seed=1,holes=1", "slopes:n=10,seed=2",
                             "grid-aligned:n=8,seed=3,level=3", "growth:n=9,seed=4"})
    polygons.push_back(normalised(generate_polygon(parse_polygon_recipe(recipe))));
  return polygons;
}

inline RationalPoint in_units(const Domain& domain, EdgeId vertex) {
  const Rational unit = dyadic(1, domain.root().exponent);
  const RationalPoint at = domain.vertices().exact(vertex);
  return {at.x / unit, at.y / unit};
}

inline RationalPoint rational(LatticePoint p) { return {Rational(p.x), Rational(p.y)}; }

inline Rational cross_of(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline int sign_of(const Rational& value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

}  // namespace quadbound
