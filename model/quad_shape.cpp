// SPDX-License-Identifier: Apache-2.0
#include "model/quad_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace quadbound {
namespace {

double cross(const Point& u, const Point& v) { return u.x * v.y - u.y * v.x; }
double dot(const Point& u, const Point& v) { return u.x * v.x + u.y * v.y; }
double length(const Point& u) { return std::sqrt(dot(u, u)); }

/// The edge in units of the lattice, which keeps its size away from overflow and underflow.
Point lattice_edge(const LatticePoint& from, const LatticePoint& to) {
  return {static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y)};
}

Point rational_edge(const RationalPoint& from, const RationalPoint& to, int exponent) {
  const Rational unit = dyadic(1, -exponent);
  return {nearest_double(Rational((to.x - from.x) * unit)),
          nearest_double(Rational((to.y - from.y) * unit))};
}

/// Divides by the largest component: squares of what is left neither overflow nor all vanish.
std::array<Point, 4> normalised(std::array<Point, 4> edges) {
  double largest = 0;
  for (const Point& edge : edges) largest = std::max({largest, std::abs(edge.x), std::abs(edge.y)});
  if (largest == 0) return edges;
  for (Point& edge : edges) edge = {edge.x / largest, edge.y / largest};
  return edges;
}

/// Degrees of the angle between the edge into a corner and the edge out of it, inside the quad.
double corner_degrees(const Point& in, const Point& out) {
  const Point back{-in.x, -in.y};
  const double sine = cross(out, back);
  const double cosine = dot(out, back);
  if (sine == 0 && cosine == 0) return 0;  // a side of length zero; its sign could make it 180
  const double degrees = std::atan2(sine, cosine) * (180 / std::numbers::pi);
  return degrees < 0 ? degrees + 360 : degrees;
}

double robinson_aspect_ratio(const std::array<Point, 4>& e) {
  const Point first{(e[0].x - e[2].x) / 2, (e[0].y - e[2].y) / 2};
  const Point second{(e[1].x - e[3].x) / 2, (e[1].y - e[3].y) / 2};
  const double area = cross(first, second);
  if (!(area > 0)) return std::numeric_limits<double>::infinity();
  return std::max(dot(first, first), dot(second, second)) / area;
}

}  // namespace

QuadShape quad_shape(const std::array<Point, 4>& edges) {
  const std::array<Point, 4> e = normalised(edges);
  QuadShape shape{360, 0, 1, robinson_aspect_ratio(e)};
  for (std::size_t i = 0; i < 4; ++i) {
    const Point& in = e[(i + 3) % 4];
    const Point& out = e[i];
    const double degrees = corner_degrees(in, out);
    shape.min_angle = std::min(shape.min_angle, degrees);
    shape.max_angle = std::max(shape.max_angle, degrees);
    const double lengths = length(in) * length(out);
    const double sine = lengths > 0 ? cross(in, out) / lengths : 0;
    shape.scaled_jacobian = std::min(shape.scaled_jacobian, sine);
  }
  return shape;
}

QuadShape quad_shape(const Vertices& vertices, const Quad& quad) {
  std::array<Point, 4> edges;
  const bool integers = std::all_of(quad.begin(), quad.end(),
                                    [&](VertexId corner) { return vertices.on_lattice(corner); });
  for (std::size_t i = 0; i < 4; ++i) {
    const VertexId from = quad[i];
    const VertexId to = quad[(i + 1) % 4];
    edges[i] = integers
                   ? lattice_edge(vertices.lattice(from), vertices.lattice(to))
                   : rational_edge(vertices.exact(from), vertices.exact(to), vertices.exponent());
  }
  return quad_shape(edges);
}

}  // namespace quadbound
