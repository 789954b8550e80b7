// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the vertices of a mesh are, in units of its lattice: exactly, or rounded to doubles as a
// file would store them. A point rounded to doubles is on the lattice again, since rounding an
// integer to 53 bits leaves an integer.

#include <array>
#include <cmath>
#include <vector>

#include "model/mesh.hpp"

namespace quadbound::judge {

inline bool in_range(LatticePoint p) {
  constexpr auto kBound = static_cast<std::uint64_t>(kMaxLatticeCoordinate);
  return static_cast<std::uint64_t>(p.x) + kBound <= 2 * kBound &&
         static_cast<std::uint64_t>(p.y) + kBound <= 2 * kBound;
}

/// Positions as they are. A vertex that someone put on the lattice outside of its bounds counts as
/// one off the lattice.
class ExactPlane {
 public:
  explicit ExactPlane(const Vertices& vertices)
      : vertices_(vertices), unit_(dyadic(1, -vertices.exponent())) {}

  [[nodiscard]] bool on_lattice(VertexId v) const {
    return vertices_.on_lattice(v) && in_range(vertices_.lattice(v));
  }
  /// Requires: on_lattice(v).
  [[nodiscard]] LatticePoint lattice(VertexId v) const { return vertices_.lattice(v); }
  [[nodiscard]] RationalPoint rational(VertexId v) const {
    const RationalPoint point = vertices_.exact(v);
    return {point.x * unit_, point.y * unit_};
  }
  /// Rounded to nearest, hence monotone: no box of rounded points loses a point.
  [[nodiscard]] Point approximate(VertexId v) const {
    if (on_lattice(v)) {
      const LatticePoint p = lattice(v);
      return {static_cast<double>(p.x), static_cast<double>(p.y)};
    }
    const RationalPoint p = rational(v);
    return {nearest_double(p.x), nearest_double(p.y)};
  }

 private:
  const Vertices& vertices_;
  Rational unit_;
};

/// Positions rounded to doubles.
class StoredPlane {
 public:
  explicit StoredPlane(const Vertices& vertices)
      : vertices_(vertices),
        unit_(dyadic(1, -vertices.exponent())),
        exponent_is_plain_(vertices.exponent() >= kSmallestExponent &&
                           vertices.exponent() <= kLargestExponent) {}

  [[nodiscard]] bool on_lattice(VertexId v) const {
    return exponent_is_plain_ && vertices_.on_lattice(v) && in_range(vertices_.lattice(v));
  }
  /// Requires: on_lattice(v).
  [[nodiscard]] LatticePoint lattice(VertexId v) const {
    const LatticePoint p = vertices_.lattice(v);
    return {static_cast<std::int64_t>(static_cast<double>(p.x)),
            static_cast<std::int64_t>(static_cast<double>(p.y))};
  }
  /// Requires: is_finite(v).
  [[nodiscard]] RationalPoint rational(VertexId v) const {
    const RationalPoint point = exact_value(vertices_.rounded(v));
    return {point.x * unit_, point.y * unit_};
  }
  [[nodiscard]] bool is_finite(VertexId v) const {
    if (on_lattice(v)) return true;
    const Point point = vertices_.rounded(v);
    return std::isfinite(point.x) && std::isfinite(point.y);
  }
  [[nodiscard]] bool changes(VertexId v) const {
    if (on_lattice(v)) {
      const LatticePoint p = vertices_.lattice(v);
      return !(is_small(p.x) && is_small(p.y)) && lattice(v) != p;
    }
    return !is_finite(v) || exact_value(vertices_.rounded(v)) != vertices_.exact(v);
  }

 private:
  static bool is_small(std::int64_t x) { return -(1LL << 53) <= x && x <= 1LL << 53; }

  // All integer multiples of 2^-1074 below 2^53 units are doubles, and 2^60 * 2^963 is one.
  static constexpr int kSmallestExponent = -1074;
  static constexpr int kLargestExponent = 1023 - kLatticeBits;

  const Vertices& vertices_;
  Rational unit_;
  bool exponent_is_plain_;
};

}  // namespace quadbound::judge
