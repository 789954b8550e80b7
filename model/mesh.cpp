// SPDX-License-Identifier: Apache-2.0
#include "model/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadbound {

LatticePoint Vertices::encode(const RationalPoint& point) {
  const auto x = lattice_floor(point.x, exponent_);
  const auto y = lattice_floor(point.y, exponent_);
  if (x && y && x->exact && y->exact) return {x->floor, y->floor};
  rationals_.push_back(point);
  return {kElsewhere, static_cast<std::int64_t>(rationals_.size() - 1)};
}

VertexId Vertices::add_exact(const RationalPoint& point) { return add(encode(point)); }

VertexId Vertices::add_fraction(const FractionPoint& point) {
  fractions_.push_back(point);
  return add({kElsewhere, -static_cast<std::int64_t>(fractions_.size())});
}

VertexId Vertices::add_double(const Point& point) {
  const auto x = lattice_floor(point.x, exponent_);
  const auto y = lattice_floor(point.y, exponent_);
  if (x && y && x->exact && y->exact) return add({x->floor, y->floor});
  return add_exact(exact_value(point));
}

void Vertices::move_to_exact(VertexId vertex, const RationalPoint& point) {
  const LatticePoint before = entries_[vertex];
  if (on_lattice(vertex) || before.y < 0) {
    entries_[vertex] = encode(point);
    return;
  }
  const auto x = lattice_floor(point.x, exponent_);
  const auto y = lattice_floor(point.y, exponent_);
  if (x && y && x->exact && y->exact) {
    entries_[vertex] = {x->floor, y->floor};
  } else {
    rationals_[index_of(before)] = point;
  }
}

RationalPoint Vertices::exact(VertexId vertex) const {
  const LatticePoint entry = entries_[vertex];
  if (on_lattice(vertex)) return {dyadic(entry.x, exponent_), dyadic(entry.y, exponent_)};
  if (const FractionPoint* point = fraction(vertex))
    return {exact_value(point->x, exponent_), exact_value(point->y, exponent_)};
  return rationals_[index_of(entry)];
}

Point Vertices::rounded(VertexId vertex) const {
  const LatticePoint entry = entries_[vertex];
  if (on_lattice(vertex))
    return {nearest_double(entry.x, exponent_), nearest_double(entry.y, exponent_)};
  const RationalPoint point = exact(vertex);
  return {nearest_double(point.x), nearest_double(point.y)};
}

std::size_t Vertices::off_lattice_count() const {
  return static_cast<std::size_t>(std::count_if(
      entries_.begin(), entries_.end(), [](const LatticePoint& p) { return p.x == kElsewhere; }));
}

int common_exponent(const std::vector<Point>& points) {
  std::optional<int> finest;
  double largest = 0;
  for (const Point& point : points) {
    for (const double value : {point.x, point.y}) {
      largest = std::max(largest, std::abs(value));
      const auto exponent = dyadic_exponent(value);
      if (exponent && (!finest || *exponent < *finest)) finest = exponent;
    }
  }
  if (!finest) return 0;
  // largest < 2^(ilogb + 1), which is at most 2^60 units of this:
  return std::max(*finest, std::ilogb(largest) + 1 - kLatticeBits);
}

}  // namespace quadbound
