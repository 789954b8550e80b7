// SPDX-License-Identifier: Apache-2.0
#include "verify/off_lattice.hpp"

#include <algorithm>

#include "verify/wide.hpp"

namespace quadbound::judge {
namespace {

static_assert(std::numeric_limits<unsigned long>::digits == 64, "GMP takes 64 bits at a time");

/// Requires: small, see is_small.
Fixed to_fixed(const LatticeFraction& fraction) {
  const UInt128 rest = static_cast<UInt128>(fraction.remainder) << Fixed::kBits;
  const UInt128 bits = rest / fraction.denominator;
  return {judge::to_fixed(fraction.floor).value + static_cast<Int128>(bits),
          bits * fraction.denominator == rest};
}

/// What the table promises of a fraction. Who made the mesh need not have.
bool is_small(const LatticeFraction& fraction) {
  return -kMaxLatticeCoordinate <= fraction.floor && fraction.floor <= kMaxLatticeCoordinate &&
         fraction.remainder < fraction.denominator && fraction.denominator < std::uint64_t{1} << 62;
}

/// Divides rationals by the unit of the lattice; keeps its memory from one to the next.
class Divider {
 public:
  explicit Divider(int exponent) : exponent_(exponent) {}

  /// nullopt where the coordinate is beyond 2^60 units. The value is used up.
  std::optional<Fixed> divide(Rational& value, LatticeFraction& fraction) {
    mpz_ptr numerator = mpq_numref(value.backend().data());
    mpz_ptr denominator = mpq_denref(value.backend().data());
    if (exponent_ > 0) {
      shift(numerator, denominator, static_cast<mp_bitcnt_t>(exponent_));
    } else {
      shift(denominator, numerator, static_cast<mp_bitcnt_t>(-exponent_));
    }
    return mpz_sizeinbase(denominator, 2) <= 62 ? divide_short(numerator, denominator, fraction)
                                                : divide_long(numerator, denominator);
  }

 private:
  /// Multiplies up / down by 2^bits, in small numbers where that is possible.
  static void shift(mpz_ptr down, mpz_ptr up, mp_bitcnt_t bits) {
    const mp_bitcnt_t common = mpz_sgn(down) == 0 ? bits : std::min(mpz_scan1(down, 0), bits);
    mpz_tdiv_q_2exp(down, down, common);
    mpz_mul_2exp(up, up, bits - common);
  }

  static std::optional<Fixed> divide_short(mpz_ptr numerator, mpz_srcptr denominator,
                                           LatticeFraction& fraction) {
    fraction.denominator = mpz_get_ui(denominator);
    fraction.remainder = mpz_fdiv_q_ui(numerator, numerator, fraction.denominator);
    if (mpz_cmpabs_ui(numerator, std::uint64_t{1} << kLatticeBits) > 0) return std::nullopt;
    fraction.floor = mpz_get_si(numerator);
    return to_fixed(fraction);
  }

  std::optional<Fixed> divide_long(mpz_ptr numerator, mpz_srcptr denominator) {
    mpz_ptr remainder = remainder_.backend().data();
    mpz_mul_2exp(numerator, numerator, Fixed::kBits);
    mpz_fdiv_qr(numerator, remainder, numerator, denominator);
    if (mpz_sizeinbase(numerator, 2) > kLatticeBits + Fixed::kBits) return std::nullopt;
    const UInt128 size =
        (static_cast<UInt128>(mpz_getlimbn(numerator, 1)) << 64) | mpz_getlimbn(numerator, 0);
    const auto value = static_cast<Int128>(size);
    return Fixed{mpz_sgn(numerator) < 0 ? -value : value, mpz_sgn(remainder) == 0};
  }

  int exponent_;
  Integer remainder_;
};

}  // namespace

OffLattice::OffLattice(const Vertices& vertices, const Threads& threads) {
  constexpr FractionPoint kNoFractions{{0, 0, 0}, {0, 0, 0}};
  std::vector<VertexId> ids;
  for (VertexId v = 0; v < vertices.size(); ++v)
    if (!vertices.on_lattice(v)) ids.push_back(v);
  if (ids.empty()) return;
  slots_.resize(vertices.size(), kNone);
  points_.resize(ids.size());
  fractions_.resize(ids.size(), kNoFractions);
  threads.for_each((ids.size() + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    Divider divider(vertices.exponent());
    const std::size_t end = std::min(ids.size(), (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i) {
      const FractionPoint* kept = vertices.fraction(ids[i]);
      if (kept != nullptr && is_small(kept->x) && is_small(kept->y)) {
        fractions_[i] = *kept;
        points_[i] = {to_fixed(kept->x), to_fixed(kept->y)};
      } else {
        RationalPoint exact = vertices.exact(ids[i]);
        const auto x = divider.divide(exact.x, fractions_[i].x);
        const auto y = divider.divide(exact.y, fractions_[i].y);
        if (!x || !y) continue;
        points_[i] = {*x, *y};
      }
      slots_[ids[i]] = static_cast<std::uint32_t>(i);
    }
  });
}

}  // namespace quadbound::judge
