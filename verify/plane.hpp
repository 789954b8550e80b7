// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the vertices of a mesh are, in units of its lattice: exactly, or rounded to doubles as a
// file would store them. A point on the lattice that is rounded to doubles is on the lattice again,
// since rounding an integer to 53 bits leaves an integer.

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "model/mesh.hpp"
#include "verify/off_lattice.hpp"

namespace quadbound::judge {

/// Positions as they are. A vertex that someone put on the lattice outside of its bounds counts as
/// one off the lattice.
class ExactPlane {
 public:
  ExactPlane(const Vertices& vertices, const Threads& threads)
      : vertices_(vertices),
        unit_(dyadic(1, -vertices.exponent())),
        off_lattice_(vertices, threads) {}

  [[nodiscard]] bool on_lattice(VertexId v) const {
    return vertices_.on_lattice(v) && in_range(vertices_.lattice(v));
  }
  /// Requires: on_lattice(v).
  [[nodiscard]] LatticePoint lattice(VertexId v) const { return vertices_.lattice(v); }
  [[nodiscard]] RationalPoint rational(VertexId v) const {
    const RationalPoint point = vertices_.exact(v);
    return {point.x * unit_, point.y * unit_};
  }
  /// nullopt only for vertices off the lattice that are too far away.
  [[nodiscard]] std::optional<FixedPoint> fixed(VertexId v) const {
    if (on_lattice(v)) return FixedPoint{to_fixed(lattice(v).x), to_fixed(lattice(v).y)};
    if (const FixedPoint* point = off_lattice_.find(v)) return *point;
    return std::nullopt;
  }
  [[nodiscard]] const OffLattice& off_lattice() const { return off_lattice_; }
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
  OffLattice off_lattice_;
};

/// Positions rounded to doubles.
class StoredPlane {
 public:
  /// The table of `exact` is kept by reference.
  StoredPlane(const Vertices& vertices, const ExactPlane& exact)
      : vertices_(vertices),
        off_lattice_(exact.off_lattice()),
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
  /// nullopt for vertices off the lattice that are too far away, or too near to an axis for 64 bits
  /// behind the point. Otherwise exact.
  [[nodiscard]] std::optional<FixedPoint> fixed(VertexId v) const {
    if (on_lattice(v)) return FixedPoint{to_fixed(lattice(v).x), to_fixed(lattice(v).y)};
    const FixedPoint* point = off_lattice_.find(v);
    if (point == nullptr || !(exponent_is_plain_ && vertices_.exponent() >= kSmallestFixedExponent))
      return std::nullopt;
    const auto x = rounded(point->x);
    const auto y = rounded(point->y);
    if (!x || !y) return std::nullopt;
    return FixedPoint{*x, *y};
  }
  [[nodiscard]] bool is_finite(VertexId v) const {
    if (on_lattice(v) || fixed(v)) return true;
    const Point point = vertices_.rounded(v);
    return std::isfinite(point.x) && std::isfinite(point.y);
  }
  [[nodiscard]] bool changes(VertexId v) const {
    if (on_lattice(v)) {
      const LatticePoint p = vertices_.lattice(v);
      return !(is_small(p.x) && is_small(p.y)) && lattice(v) != p;
    }
    if (const auto stored = fixed(v)) {
      const FixedPoint& exact = *off_lattice_.find(v);
      return !exact.x.is_exact || !exact.y.is_exact || exact.x.value != stored->x.value ||
             exact.y.value != stored->y.value;
    }
    return !is_finite(v) || exact_value(vertices_.rounded(v)) != vertices_.exact(v);
  }

 private:
  static bool is_small(std::int64_t x) { return -(1LL << 53) <= x && x <= 1LL << 53; }

  /// A double has 53 bits. Where a coordinate between value and value + 1 has at least two more in
  /// front of the cut, both are multiples of a quarter of its last bit, so that no tie lies
  /// strictly between them; an odd number is no tie itself. nullopt where bits behind the cut
  /// matter.
  static std::optional<Fixed> rounded(const Fixed& coordinate) {
    constexpr Int128 kEnough = Int128{1} << 55;
    if (coordinate.is_exact) return to_double(coordinate.value);
    if (-kEnough < coordinate.value && coordinate.value < kEnough) return std::nullopt;
    return to_double(coordinate.value | 1);
  }
  static Fixed to_double(Int128 value) {
    return {static_cast<Int128>(static_cast<double>(value)), true};
  }

  // All integer multiples of 2^-1074 below 2^53 units are doubles, and 2^60 * 2^963 is one.
  static constexpr int kSmallestExponent = -1074;
  static constexpr int kLargestExponent = 1023 - kLatticeBits;
  // The same for multiples of 2^-64 of a unit.
  static constexpr int kSmallestFixedExponent = kSmallestExponent + Fixed::kBits;

  const Vertices& vertices_;
  const OffLattice& off_lattice_;
  Rational unit_;
  bool exponent_is_plain_;
};

}  // namespace quadbound::judge
