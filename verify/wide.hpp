// SPDX-License-Identifier: Apache-2.0
#pragma once
// Products and sums that do not fit into 128 bits.

#include <compare>
#include <cstdint>
#include <utility>
#include <vector>

#include "model/exact.hpp"

namespace quadbound::judge {

__extension__ using UInt128 = unsigned __int128;
using Integer = boost::multiprecision::mpz_int;

inline UInt128 magnitude(Int128 value) {
  return value < 0 ? UInt128{0} - static_cast<UInt128>(value) : static_cast<UInt128>(value);
}

struct UInt256 {
  UInt128 high;
  UInt128 low;
  friend auto operator<=>(const UInt256&, const UInt256&) = default;
};

/// The full product.
inline UInt256 multiply(UInt128 a, UInt128 b) {
  constexpr UInt128 kMask = ~std::uint64_t{0};
  const UInt128 a0 = a & kMask, a1 = a >> 64, b0 = b & kMask, b1 = b >> 64;
  const UInt128 low = a0 * b0;
  const UInt128 middle = a1 * b0 + (low >> 64);  // at most (2^64 - 1)^2 + 2^64 - 1 < 2^128
  const UInt128 other = a0 * b1 + (middle & kMask);
  return {a1 * b1 + (middle >> 64) + (other >> 64), (other << 64) | (low & kMask)};
}

inline bool fits_64_bits(Int128 value) { return static_cast<std::int64_t>(value) == value; }

/// The sign of a * b - c * d, for any values above -2^127.
inline std::strong_ordering compare_products(Int128 a, Int128 b, Int128 c, Int128 d) {
  if (fits_64_bits(a) && fits_64_bits(b) && fits_64_bits(c) && fits_64_bits(d))
    return a * b <=> c * d;
  const auto sign = [](Int128 p, Int128 q) {
    return p == 0 || q == 0 ? 0 : ((p < 0) == (q < 0) ? 1 : -1);
  };
  const int left = sign(a, b);
  const int right = sign(c, d);
  if (left != right || left == 0) return left <=> right;
  const UInt256 ab = multiply(magnitude(a), magnitude(b));
  const UInt256 cd = multiply(magnitude(c), magnitude(d));
  return left > 0 ? ab <=> cd : cd <=> ab;
}

inline std::strong_ordering compare_products(const Rational& a, const Rational& b,
                                             const Rational& c, const Rational& d) {
  return Rational(a * b).compare(Rational(c * d)) <=> 0;
}

inline Rational to_rational(Int128 value) {
  Integer wide = static_cast<std::int64_t>(value >> 64);
  wide <<= 64;
  wide += static_cast<std::uint64_t>(value);
  return Rational(wide);
}
inline const Rational& to_rational(const Rational& value) { return value; }

/// a x b. Coordinates up to 2^60 make it 2^121 at most.
inline Int128 cross_product(LatticePoint a, LatticePoint b) {
  return static_cast<Int128>(a.x) * b.y - static_cast<Int128>(a.y) * b.x;
}
inline Rational cross_product(const RationalPoint& a, const RationalPoint& b) {
  return a.x * b.y - a.y * b.x;
}

/// A sum of rationals, added up in pairs, pairs of pairs and so on: with many different
/// denominators the long numbers are few then, and adding n values takes little more than linear
/// time.
class RationalSum {
 public:
  void add(const Rational& value) {
    Rational carry = value;
    std::size_t level = 0;
    for (std::uint64_t bits = count_++; (bits & 1U) != 0; bits >>= 1U) carry += levels_[level++];
    if (level == levels_.size()) levels_.emplace_back();
    levels_[level] = std::move(carry);
  }
  [[nodiscard]] Rational value() const {
    Rational sum = 0;
    for (std::size_t level = 0; level < levels_.size(); ++level)
      if (((count_ >> level) & 1U) != 0) sum += levels_[level];
    return sum;
  }

 private:
  std::uint64_t count_ = 0;
  std::vector<Rational> levels_;  ///< the sum of 2^i values at i, where bit i of count_ is set
};

/// A sum of up to 2^63 values of 128 bits, and of rationals.
class WideSum {
 public:
  void add(Int128 value) {
    low_ += static_cast<std::uint64_t>(value);
    high_ += value >> 64;
  }
  void add(const Rational& value) { rest_.add(value); }
  void add(const WideSum& other) {
    low_ += other.low_;
    high_ += other.high_;
    rest_.add(other.rest_.value());
  }
  [[nodiscard]] Rational value() const {
    const Integer two64 = Integer(1) << 64;
    const Rational high = to_rational(high_) * Rational(two64);
    const Rational low =
        to_rational(static_cast<Int128>(low_ >> 1)) * 2 + Rational(static_cast<unsigned>(low_ & 1));
    return high + low + rest_.value();
  }

 private:
  Int128 high_ = 0;
  UInt128 low_ = 0;
  RationalSum rest_;
};

}  // namespace quadbound::judge
