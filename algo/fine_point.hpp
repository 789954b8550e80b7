// SPDX-License-Identifier: Apache-2.0
#pragma once
// Points for the search of Section 3: a lattice point and a fraction of a unit, so that differences
// of near points keep all bits of a double wherever the points lie.
//
// Nothing is proved with these. They choose among candidates with a margin far above their
// rounding; the judge proves the mesh on exact coordinates.

#include <algorithm>
#include <array>
#include <cmath>

#include "model/exact.hpp"

namespace quadbound {

struct Vector {
  double x = 0;
  double y = 0;
};
inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
inline Vector operator*(double s, Vector a) { return {s * a.x, s * a.y}; }
inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
inline double length(Vector a) { return std::sqrt(dot(a, a)); }
/// A quarter turn counter-clockwise.
inline Vector turned_left(Vector a) { return {-a.y, a.x}; }

/// floor + (x, y of fraction); the fraction in [0, 1].
struct FinePoint {
  LatticePoint floor;
  Vector fraction;
};

inline FinePoint on_lattice(LatticePoint point) { return {point, {}}; }

inline Vector operator-(const FinePoint& a, const FinePoint& b) {
  return {static_cast<double>(a.floor.x - b.floor.x) + (a.fraction.x - b.fraction.x),
          static_cast<double>(a.floor.y - b.floor.y) + (a.fraction.y - b.fraction.y)};
}

/// The lattice point nearest to origin + offset. Requires: within the lattice.
inline LatticePoint nearest_lattice_point(const FinePoint& origin, Vector offset) {
  return {origin.floor.x + std::llround(origin.fraction.x + offset.x),
          origin.floor.y + std::llround(origin.fraction.y + offset.y)};
}

/// How far a corner is inside thm-13's interval: the smaller of sin(angle - arctan(1/3)) and
/// sin(180 degrees - arctan(1/7) - angle), which is negative exactly outside the interval. `u`
/// towards the next vertex, `v` towards the previous one.
inline double corner_slack(Vector u, Vector v) {
  const double c = cross(u, v);
  const double d = dot(u, v);
  const double norm = std::sqrt(dot(u, u) * dot(v, v));
  // sin and cos of arctan(1/3) are 1 and 3 over sqrt(10); of arctan(1/7) 1 and 7 over sqrt(50).
  const double above = (3 * c - d) / std::sqrt(10.0);
  const double below = (7 * c + d) / std::sqrt(50.0);
  return std::min(above, below) / norm;  // NaN where two vertices coincide: compares as a failure
}

/// The smallest corner_slack of a quad, counter-clockwise.
inline double quad_slack(const std::array<Vector, 4>& quad) {
  double slack = 1;
  for (unsigned k = 0; k < 4; ++k) {
    const Vector at = quad[k];
    const double here = corner_slack(quad[(k + 1) & 3U] - at, quad[(k + 3) & 3U] - at);
    if (!(here >= slack)) slack = here;
  }
  return slack;
}

inline double quad_slack(const std::array<FinePoint, 4>& quad) {
  return quad_slack(
      std::array<Vector, 4>{Vector{}, quad[1] - quad[0], quad[2] - quad[0], quad[3] - quad[0]});
}

}  // namespace quadbound
