// SPDX-License-Identifier: Apache-2.0
#include "algo/domain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace quadbound {
namespace {

Int128 cross_of(LatticePoint a, LatticePoint b, LatticePoint x) {
  return Int128{b.x - a.x} * (x.y - a.y) - Int128{b.y - a.y} * (x.x - a.x);
}

template <class Number>
int sign_of(const Number& value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

Rational cross_of(const RationalPoint& a, const RationalPoint& b, const RationalPoint& x) {
  return (b.x - a.x) * (x.y - a.y) - (b.y - a.y) * (x.x - a.x);
}

VertexId add_to(Vertices& vertices, const RationalPoint& point) {
  return vertices.add_exact(point);
}
VertexId add_to(Vertices& vertices, const Point& point) { return vertices.add_double(point); }

/// Requires: the quotient fits into 64 bits.
LatticeFraction divided(Int128 numerator, std::int64_t denominator) {
  if (denominator < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  Int128 quotient = numerator / denominator;
  Int128 remainder = numerator % denominator;
  if (remainder < 0) {
    remainder += denominator;
    --quotient;
  }
  return {static_cast<std::int64_t>(quotient), static_cast<std::uint64_t>(remainder),
          static_cast<std::uint64_t>(denominator)};
}

}  // namespace

Domain::Domain(const RootSquare& root, const Polygon& polygon)
    : root_(root), vertices_(root.exponent), ring_count_(polygon.rings.size()) {
  add_rings(polygon.rings);
}

Domain::Domain(const RootSquare& root, const std::vector<std::vector<RationalPoint>>& rings)
    : root_(root), vertices_(root.exponent), ring_count_(rings.size()) {
  add_rings(rings);
}

template <class Rings>
void Domain::add_rings(const Rings& rings) {
  for (const auto& ring : rings) {
    const auto first = static_cast<EdgeId>(vertices_.size());
    const auto count = static_cast<EdgeId>(ring.size());
    for (EdgeId k = 0; k < count; ++k) {
      const EdgeId id = add_to(vertices_, ring[k]);
      ring_.push_back(static_cast<std::uint32_t>(&ring - rings.data()));
      next_.push_back(first + (k + 1) % count);
      previous_.push_back(first + (k + count - 1) % count);
      fine_.push_back(fine_point(id));
    }
  }
  for (EdgeId e = 0; e < size(); ++e) {
    const Vector d = direction(e);
    runs_in_x_.push_back(std::abs(d.x) >= std::abs(d.y));
    backwards_.push_back((runs_in_x_[e] ? d.x : d.y) < 0);
  }
}

FinePoint Domain::fine_point(EdgeId vertex) const {
  if (vertices_.on_lattice(vertex)) return quadbound::on_lattice(vertices_.lattice(vertex));
  const RationalPoint units = in_units(vertex);
  const LatticeFloor x = *lattice_floor(units.x, 0);
  const LatticeFloor y = *lattice_floor(units.y, 0);
  return {
      {x.floor, y.floor},
      {nearest_double(units.x - Rational(x.floor)), nearest_double(units.y - Rational(y.floor))}};
}

RationalPoint Domain::in_units(EdgeId vertex) const {
  const Rational unit = dyadic(1, root_.exponent);
  const RationalPoint at = vertices_.exact(vertex);
  return {at.x / unit, at.y / unit};
}

int Domain::side_exact(EdgeId e, const RationalPoint& point) const {
  return sign_of(cross_of(in_units(e), in_units(next_[e]), point));
}

int Domain::side(EdgeId e, LatticePoint point) const {
  if (on_lattice_edge(e)) return sign_of(cross_of(floor(e), floor(next_[e]), point));
  const Vector d = direction(e);
  const Vector to = on_lattice(point) - at(e);
  const double value = cross(d, to);
  if (is_certain(value, d, to)) return value > 0 ? 1 : -1;
  return side_exact(e, {Rational(point.x), Rational(point.y)});
}

int Domain::side(EdgeId e, EdgeId vertex) const {
  if (vertex == e || vertex == next_[e]) return 0;
  if (!rounded(vertex)) return side(e, floor(vertex));
  return side_exact(e, in_units(vertex));
}

bool Domain::holds(EdgeId e, LatticePoint point) const {
  const auto is_between = [](std::int64_t at, std::int64_t a, double a_rest, std::int64_t b,
                             double b_rest) {
    const bool beyond_a = a < at || (a == at && a_rest == 0);
    const bool beyond_b = b < at || (b == at && b_rest == 0);
    return (beyond_a && (b >= at)) || (beyond_b && (a >= at));
  };
  const FinePoint& a = fine_[e];
  const FinePoint& b = fine_[next_[e]];
  return is_between(point.x, a.floor.x, a.fraction.x, b.floor.x, b.fraction.x) &&
         is_between(point.y, a.floor.y, a.fraction.y, b.floor.y, b.fraction.y);
}

int Domain::turn(LatticePoint from, LatticePoint to, EdgeId vertex) const {
  if (!rounded(vertex)) return sign_of(cross_of(from, to, floor(vertex)));
  const Vector d = on_lattice(to) - on_lattice(from);
  const Vector here = at(vertex) - on_lattice(from);
  const double value = cross(d, here);
  if (is_certain(value, d, here)) return value > 0 ? 1 : -1;
  return sign_of(cross_of({Rational(from.x), Rational(from.y)}, {Rational(to.x), Rational(to.y)},
                          in_units(vertex)));
}

/// The sign of cross(d, (e, e^2)) = e^2 d.x - e d.y for its direction d.
int Domain::moved_off(EdgeId e) const {
  // Where the floors differ, the vertices do.
  const LatticePoint whole{floor(next_[e]).x - floor(e).x, floor(next_[e]).y - floor(e).y};
  if (whole.y != 0) return sign_of(-whole.y);
  if (on_lattice_edge(e)) return sign_of(whole.x);
  const RationalPoint from = in_units(e);
  const RationalPoint to = in_units(next_[e]);
  const int rise = sign_of(Rational(to.y - from.y));
  return rise != 0 ? -rise : sign_of(Rational(to.x - from.x));
}

int Domain::moved_turn(LatticePoint from, LatticePoint to, EdgeId vertex) const {
  const int unmoved = turn(from, to, vertex);
  if (unmoved != 0) return unmoved;
  // The sign of -cross(to - from, (e, e^2)).
  return sign_of(to.y != from.y ? to.y - from.y : from.x - to.x);
}

double Domain::height(EdgeId e, LatticePoint point) const {
  // The cross product of the floors is exact; what the fractions add is no larger than the edge.
  const FinePoint& a = fine_[e];
  const FinePoint& b = fine_[next_[e]];
  const Vector whole = on_lattice(b.floor) - on_lattice(a.floor);
  const Vector rest = b.fraction - a.fraction;
  const Vector to = on_lattice(point) - on_lattice(a.floor);
  const double added = cross(rest, to - a.fraction) - cross(whole, a.fraction);
  return (static_cast<double>(cross_of(a.floor, b.floor, point)) + added) / length(whole + rest);
}

bool Domain::is_acute(EdgeId vertex) const {
  const Vector out = direction(vertex);
  const Vector back = at(previous_[vertex]) - at(vertex);
  // The dot product is a cross product with a turned vector.
  if (is_certain(dot(out, back), turned_left(out), back)) {
    if (dot(out, back) < 0) return false;
    if (is_certain(cross(out, back), out, back)) return cross(out, back) > 0;
  }
  const RationalPoint at = in_units(vertex);
  const RationalPoint n = in_units(next_[vertex]);
  const RationalPoint p = in_units(previous_[vertex]);
  const Rational dot = (n.x - at.x) * (p.x - at.x) + (n.y - at.y) * (p.y - at.y);
  return dot > 0 && cross_of(at, n, p) > 0;
}

bool Domain::is_kite_foot(EdgeId vertex) const {
  // q comes before p in a kite, with nothing but v between.
  const auto kite = std::lower_bound(kites.begin(), kites.end(), vertex,
                                     [](const Kite& k, EdgeId v) { return k.p < v; });
  return kite != kites.end() && (kite->p == vertex || kite->q == vertex);
}

std::int64_t Domain::foot(EdgeId e, LatticePoint point, double offset) const {
  const Vector d = direction(e);
  const double across = height(e, point) / length(d);
  // From the point down to the line, then along it. On a line parallel to an axis nothing is added.
  if (runs_in_x_[e]) return point.x + std::llround(across * d.y + offset * d.x / length(d));
  return point.y + std::llround(-across * d.x + offset * d.y / length(d));
}

bool Domain::on_edge(EdgeId e, std::int64_t foot) const {
  const FinePoint& a = fine_[e];
  const FinePoint& b = fine_[next_[e]];
  const bool x = runs_in_x_[e];
  const std::int64_t low = std::min(x ? a.floor.x : a.floor.y, x ? b.floor.x : b.floor.y);
  const std::int64_t high = std::max(x ? a.floor.x : a.floor.y, x ? b.floor.x : b.floor.y);
  return low < foot && foot < high;
}

FinePoint Domain::foot_point(EdgeId e, std::int64_t foot) const {
  const bool x = runs_in_x_[e];
  const FinePoint& a = fine_[e];
  const FinePoint& b = fine_[next_[e]];
  // Along the edge and across: whole units, then the fractions.
  const std::int64_t along = x ? b.floor.x - a.floor.x : b.floor.y - a.floor.y;
  const std::int64_t across = x ? b.floor.y - a.floor.y : b.floor.x - a.floor.x;
  const std::int64_t from = foot - (x ? a.floor.x : a.floor.y);
  const LatticeFraction ratio = divided(Int128{from} * across, along);
  std::int64_t floor = ratio.floor + (x ? a.floor.y : a.floor.x);
  double fraction = static_cast<double>(ratio.remainder) / static_cast<double>(ratio.denominator);
  if (!on_lattice_edge(e)) {
    const Vector rest = b.fraction - a.fraction;
    const double slope = static_cast<double>(across) / static_cast<double>(along);
    const double rest_along = x ? rest.x : rest.y;
    const double rest_across = x ? rest.y : rest.x;
    const double start_along = x ? a.fraction.x : a.fraction.y;
    const double start_across = x ? a.fraction.y : a.fraction.x;
    // (from - start)(across + rest across) / (along + rest along), less from across / along:
    const double added = (static_cast<double>(from) * (rest_across - slope * rest_along) -
                          start_along * (static_cast<double>(across) + rest_across)) /
                         (static_cast<double>(along) + rest_along);
    fraction = fraction + start_across + added;
    const double whole = std::floor(fraction);
    floor += static_cast<std::int64_t>(whole);
    fraction -= whole;
  }
  return x ? FinePoint{{foot, floor}, {0, fraction}} : FinePoint{{floor, foot}, {fraction, 0}};
}

VertexId Domain::add_foot(Vertices& vertices, EdgeId e, std::int64_t foot) const {
  if (!on_lattice_edge(e)) return vertices.add_exact(foot_exact(e, foot));
  const bool x = runs_in_x_[e];
  const LatticePoint a = floor(e);
  const LatticePoint b = floor(next_[e]);
  const std::int64_t along = x ? b.x - a.x : b.y - a.y;
  const Int128 rise = Int128{foot - (x ? a.x : a.y)} * (x ? b.y - a.y : b.x - a.x);
  LatticeFraction other = divided(rise, along);
  other.floor += x ? a.y : a.x;
  if (other.remainder == 0)
    return vertices.add(x ? LatticePoint{foot, other.floor} : LatticePoint{other.floor, foot});
  const LatticeFraction here{foot};
  return vertices.add_fraction(x ? FractionPoint{here, other} : FractionPoint{other, here});
}

RationalPoint Domain::foot_exact(EdgeId e, std::int64_t foot) const {
  const RationalPoint a = vertices_.exact(e);
  const RationalPoint b = vertices_.exact(next_[e]);
  const Rational here = dyadic(foot, root_.exponent);
  if (runs_in_x_[e]) return {here, a.y + (here - a.x) * (b.y - a.y) / (b.x - a.x)};
  return {a.x + (here - a.y) * (b.x - a.x) / (b.y - a.y), here};
}

PlacedPoints placed_vertices(const Domain& domain) {
  PlacedPoints placed;
  placed.root = domain.root();
  for (EdgeId v = 0; v < domain.size(); ++v) {
    placed.floors.push_back(domain.floor(v));
    placed.rounded.push_back(domain.rounded(v));
  }
  return placed;
}

}  // namespace quadbound
