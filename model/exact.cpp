// SPDX-License-Identifier: Apache-2.0
#include "model/exact.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace quadbound {
namespace {

using Integer = boost::multiprecision::mpz_int;

constexpr int kMantissaBits = std::numeric_limits<double>::digits;

struct Decomposed {
  std::int64_t mantissa;
  int exponent;
};

Decomposed decompose(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {static_cast<std::int64_t>(std::ldexp(fraction, kMantissaBits)), exponent - kMantissaBits};
}

int bit_length(const Integer& value) {
  return value == 0 ? 0 : static_cast<int>(boost::multiprecision::msb(value)) + 1;
}

bool is_digits(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Leading zeros are dropped, since Boost would read them as the mark of an octal number.
Integer decimal(std::string_view digits) {
  const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
  return Integer(std::string(digits.substr(first)));
}

}  // namespace

Rational dyadic(std::int64_t mantissa, int exponent) {
  const Integer wide = mantissa;
  if (exponent >= 0) return Rational(Integer(wide << exponent));
  return Rational(wide, Integer(1) << -exponent);
}

Rational exact_value(double value) {
  if (value == 0) return 0;
  const Decomposed parts = decompose(value);
  return dyadic(parts.mantissa, parts.exponent);
}

Rational exact_value(const LatticeFraction& value, int exponent) {
  Integer numerator = value.floor;
  numerator = numerator * value.denominator + value.remainder;
  Integer denominator = value.denominator;
  (exponent < 0 ? denominator : numerator) <<= static_cast<unsigned>(std::abs(exponent));
  return {numerator, denominator};
}

RationalPoint exact_value(const Point& point) {
  return {exact_value(point.x), exact_value(point.y)};
}

std::optional<int> dyadic_exponent(double value) {
  if (value == 0) return std::nullopt;
  const Decomposed parts = decompose(value);
  return parts.exponent + std::countr_zero(static_cast<std::uint64_t>(parts.mantissa));
}

std::optional<LatticeFloor> lattice_floor(double value, int exponent) {
  if (value == 0) return LatticeFloor{0, true};
  const Decomposed parts = decompose(value);
  const int shift = parts.exponent - exponent;
  if (shift >= 0) {
    // |mantissa| >= 2^52, so that any larger shift leaves the lattice.
    if (shift > kLatticeBits - kMantissaBits + 1) return std::nullopt;
    const std::int64_t floor = parts.mantissa * (std::int64_t{1} << shift);
    if (std::abs(floor) > kMaxLatticeCoordinate) return std::nullopt;
    return LatticeFloor{floor, true};
  }
  if (-shift >= kMantissaBits) return LatticeFloor{value < 0 ? -1 : 0, false};
  const std::int64_t floor = parts.mantissa >> -shift;  // arithmetic shift: rounds down
  return LatticeFloor{floor, floor * (std::int64_t{1} << -shift) == parts.mantissa};
}

std::optional<LatticeFloor> lattice_floor(const Rational& value, int exponent) {
  Integer numerator = boost::multiprecision::numerator(value);
  Integer denominator = boost::multiprecision::denominator(value);
  if (exponent >= 0) {
    denominator <<= exponent;
  } else {
    numerator <<= -exponent;
  }
  Integer floor;
  Integer remainder;
  mpz_fdiv_qr(floor.backend().data(), remainder.backend().data(), numerator.backend().data(),
              denominator.backend().data());
  if (boost::multiprecision::abs(floor) > kMaxLatticeCoordinate) return std::nullopt;
  return LatticeFloor{floor.convert_to<std::int64_t>(), remainder == 0};
}

double nearest_double(std::int64_t mantissa, int exponent) {
  const double rounded = static_cast<double>(mantissa);
  // Rounding twice would be wrong only among subnormal results; those take the exact way.
  if (mantissa == 0 ||
      std::ilogb(rounded) + exponent >= std::numeric_limits<double>::min_exponent - 1)
    return std::ldexp(rounded, exponent);
  return nearest_double(dyadic(mantissa, exponent));
}

double nearest_double(const Rational& value) {
  if (value == 0) return 0;
  const bool negative = value < 0;
  Integer numerator = boost::multiprecision::abs(boost::multiprecision::numerator(value));
  Integer denominator = boost::multiprecision::denominator(value);
  // Scale so that the integer quotient has kMantissaBits + 1 or + 2 bits, but never counts
  // finer than half of the smallest subnormal number.
  constexpr int kFinest = std::numeric_limits<double>::min_exponent - kMantissaBits - 1;
  const int exponent =
      std::max(bit_length(numerator) - bit_length(denominator) - kMantissaBits - 1, kFinest);
  if (exponent >= 0) {
    denominator <<= exponent;
  } else {
    numerator <<= -exponent;
  }
  Integer quotient;
  Integer remainder;
  boost::multiprecision::divide_qr(numerator, denominator, quotient, remainder);
  // Round to even by hand, on the bits that a double cannot hold.
  const int surplus = std::max({bit_length(quotient) - kMantissaBits, kFinest + 1 - exponent, 0});
  const Integer half = surplus == 0 ? Integer(0) : Integer(1) << (surplus - 1);
  Integer kept = quotient >> surplus;
  const Integer cut = quotient - (kept << surplus);
  const bool above = cut > half || (cut == half && remainder != 0);
  const bool tie = cut == half && remainder == 0 && surplus > 0;
  if (above || (tie && boost::multiprecision::bit_test(kept, 0))) ++kept;
  const double magnitude = std::ldexp(kept.convert_to<double>(), exponent + surplus);
  return negative ? -magnitude : magnitude;
}

std::string to_text(const Rational& value) { return value.str(); }

std::optional<Rational> parse_rational(std::string_view text) {
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  const std::size_t slash = text.find('/');
  const std::string_view numerator = text.substr(0, slash);
  if (!is_digits(numerator)) return std::nullopt;
  Rational value{decimal(numerator)};
  if (slash != std::string_view::npos) {
    const std::string_view denominator = text.substr(slash + 1);
    if (!is_digits(denominator)) return std::nullopt;
    const Integer divisor = decimal(denominator);
    if (divisor == 0) return std::nullopt;
    value /= Rational(divisor);
  }
  return negative ? Rational(-value) : value;
}

}  // namespace quadbound
