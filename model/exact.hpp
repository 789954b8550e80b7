// SPDX-License-Identifier: Apache-2.0
#pragma once
// Exact coordinates: integers on a dyadic lattice for almost every mesh vertex, rationals for the
// rest.
//
// A lattice of exponent u holds the points (x * 2^u, y * 2^u) with integers |x|, |y| <= 2^60. The
// bound keeps every angle test of this project inside 128 bits: differences are at most 2^61, their
// products 2^122, cross and dot products 2^123, and seven times those (the bound arctan(1/7))
// stays below 2^127. Why this representation: model/exact-coordinates.md.

#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace quadbound {

__extension__ using Int128 = __int128;
using Rational = boost::multiprecision::mpq_rational;

/// A point of the plane in doubles: input as read, or a coordinate rounded for an exporter.
struct Point {
  double x = 0;
  double y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

struct RationalPoint {
  Rational x;
  Rational y;
  friend bool operator==(const RationalPoint&, const RationalPoint&) = default;
};

/// Integer coordinates in units of some lattice.
struct LatticePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
};

/// A coordinate in units of a lattice: floor + remainder / denominator, not necessarily in lowest
/// terms; remainder < denominator.
struct LatticeFraction {
  std::int64_t floor = 0;
  std::uint64_t remainder = 0;
  std::uint64_t denominator = 1;
};
struct FractionPoint {
  LatticeFraction x;
  LatticeFraction y;
};

inline constexpr int kLatticeBits = 60;
inline constexpr std::int64_t kMaxLatticeCoordinate = std::int64_t{1} << kLatticeBits;

/// The exact value of a finite double. Requires: std::isfinite(value).
Rational exact_value(double value);
RationalPoint exact_value(const Point& point);

/// mantissa * 2^exponent, exactly.
Rational dyadic(std::int64_t mantissa, int exponent);

/// In units of 2^exponent.
Rational exact_value(const LatticeFraction& value, int exponent);

/// value / 2^exponent rounded down to an integer, and whether nothing was cut off. nullopt where
/// the integer lies outside [-2^60, 2^60]. Requires: std::isfinite(value).
struct LatticeFloor {
  std::int64_t floor = 0;
  bool exact = false;
};
std::optional<LatticeFloor> lattice_floor(double value, int exponent);
std::optional<LatticeFloor> lattice_floor(const Rational& value, int exponent);

/// The largest e such that value is an integer multiple of 2^e; nullopt for zero.
std::optional<int> dyadic_exponent(double value);

/// The double nearest to a value, ties to even (as the hardware rounds); infinite on overflow.
double nearest_double(const Rational& value);
double nearest_double(std::int64_t mantissa, int exponent);

/// "num/den" in lowest terms, or "num" where the denominator is one.
std::string to_text(const Rational& value);

/// Reads what to_text writes: an optional sign, decimal digits, and optionally "/" and digits of a
/// positive denominator. nullopt for anything else, white space included.
std::optional<Rational> parse_rational(std::string_view text);

}  // namespace quadbound
