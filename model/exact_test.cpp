// SPDX-License-Identifier: Apache-2.0
#include "model/exact.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "model/angle.hpp"
#include "model/mesh.hpp"

namespace quadbound {
namespace {

/// Random bit patterns: every exponent and subnormals are as likely as their patterns.
class FiniteDoubles {
 public:
  double next() {
    for (;;) {
      const double value = std::bit_cast<double>(engine_());
      if (std::isfinite(value)) return value;
    }
  }

 private:
  std::mt19937_64 engine_{1};
};

TEST(Exact, EveryDoubleSurvivesTheWayThroughRationals) {
  FiniteDoubles doubles;
  for (int i = 0; i < 20000; ++i) {
    const double value = doubles.next();
    EXPECT_EQ(nearest_double(exact_value(value)), value);
  }
  for (const double value :
       {0.0, 1.0, -1.0, 0.1, std::numeric_limits<double>::denorm_min(),
        std::numeric_limits<double>::max(), std::numeric_limits<double>::min()})
    EXPECT_EQ(nearest_double(exact_value(value)), value);
}

TEST(Exact, NearestDoubleRoundsToEvenAtMidpointsAndBesideThem) {
  FiniteDoubles doubles;
  for (int i = 0; i < 20000; ++i) {
    const double low = std::abs(doubles.next());
    const double high = std::nextafter(low, std::numeric_limits<double>::infinity());
    if (!std::isfinite(high)) continue;
    const Rational middle = (exact_value(low) + exact_value(high)) / 2;
    const Rational nudge = (exact_value(high) - exact_value(low)) / 1000003;
    EXPECT_EQ(nearest_double(Rational(middle - nudge)), low);
    EXPECT_EQ(nearest_double(Rational(middle + nudge)), high);
    const bool low_is_even = std::bit_cast<std::uint64_t>(low) % 2 == 0;
    EXPECT_EQ(nearest_double(middle), low_is_even ? low : high);
    EXPECT_EQ(nearest_double(Rational(-middle)), low_is_even ? -low : -high);
  }
}

TEST(Exact, NearestDoubleOverflowsToInfinity) {
  const Rational largest = exact_value(std::numeric_limits<double>::max());
  EXPECT_TRUE(std::isinf(nearest_double(Rational(largest * 2))));
}

TEST(Exact, LatticePointsRoundLikeRationals) {
  std::mt19937_64 engine(2);
  for (int i = 0; i < 20000; ++i) {
    const auto mantissa = static_cast<std::int64_t>(engine()) >> 3;
    const int exponent = static_cast<int>(engine() % 2300) - 1200;
    EXPECT_EQ(nearest_double(mantissa, exponent), nearest_double(dyadic(mantissa, exponent)));
  }
}

TEST(Exact, LatticeFloorAgreesWithRationalArithmetic) {
  std::mt19937_64 engine(3);
  int inside = 0;
  int cut = 0;
  for (int i = 0; i < 50000; ++i) {
    const double value = std::ldexp(static_cast<double>(static_cast<std::int64_t>(engine())),
                                    static_cast<int>(engine() % 200) - 160);
    const int exponent = static_cast<int>(engine() % 160) - 110;
    const auto fast = lattice_floor(value, exponent);
    const auto slow = lattice_floor(exact_value(value), exponent);
    ASSERT_EQ(fast.has_value(), slow.has_value()) << value << ' ' << exponent;
    if (!fast) continue;
    ++inside;
    cut += !fast->exact;
    EXPECT_EQ(fast->floor, slow->floor);
    EXPECT_EQ(fast->exact, slow->exact);
  }
  EXPECT_GT(inside, 10000);
  EXPECT_GT(cut, 5000);
}

TEST(Exact, DyadicExponentIsTheLargestThatDivides) {
  EXPECT_EQ(dyadic_exponent(0.0), std::nullopt);
  EXPECT_EQ(dyadic_exponent(-12.0), 2);
  EXPECT_EQ(dyadic_exponent(0.375), -3);
  EXPECT_EQ(dyadic_exponent(std::numeric_limits<double>::denorm_min()), -1074);
}

TEST(Exact, TextOfRationals) {
  EXPECT_EQ(to_text(Rational(6, 4)), "3/2");
  EXPECT_EQ(to_text(Rational(-4, 2)), "-2");
  for (const char* good : {"0", "-0", "12", "-7/3", "007/010", "18446744073709551617/3"})
    EXPECT_TRUE(parse_rational(good)) << good;
  EXPECT_EQ(*parse_rational("007/010"), Rational(7, 10));
  for (const char* bad :
       {"", "-", "+1", "1/", "/2", "1/0", "1/-2", "1.5", " 1", "1 ", "0x10", "1/2/3", "nan"})
    EXPECT_FALSE(parse_rational(bad)) << bad;
}

TEST(Angle, BoundsIncludeTheirEndsAndNothingBeyond) {
  // Corners at the origin from (1, 0) to the direction whose tangent is the bound.
  const auto corner = [](std::int64_t x, std::int64_t y) {
    return corner_at<Int128>(LatticePoint{0, 0}, LatticePoint{1, 0}, LatticePoint{x, y});
  };
  constexpr std::int64_t big = std::int64_t{1} << 40;
  EXPECT_TRUE(within(corner(2, 1), kTheorem1));
  EXPECT_TRUE(within(corner(-2, 1), kTheorem1));
  EXPECT_FALSE(within(corner(2 * big, big - 1), kTheorem1));
  EXPECT_FALSE(within(corner(-2 * big, big - 1), kTheorem1));
  EXPECT_TRUE(within(corner(2 * big, big + 1), kTheorem1));
  EXPECT_TRUE(within(corner(3, 1), kTheorem13));
  EXPECT_FALSE(within(corner(3 * big, big - 1), kTheorem13));
  EXPECT_TRUE(within(corner(-7, 1), kTheorem13));
  EXPECT_FALSE(within(corner(-7 * big, big - 1), kTheorem13));
  for (const auto& flat : {corner(1, 0), corner(-1, 0), corner(1, -1)})
    EXPECT_FALSE(within(flat, kTheorem13));
}

TEST(Vertices, KeepTheExactValueOfFractions) {
  for (const int exponent : {-4, 0, 3}) {
    Vertices vertices(exponent);
    const Rational unit = dyadic(1, exponent);
    // -7/3 units, which is not in lowest terms here, and a whole number.
    const VertexId v = vertices.add_fraction({{-3, 4, 6}, {5}});
    const RationalPoint exact{Rational(-7, 3) * unit, 5 * unit};
    ASSERT_NE(vertices.fraction(v), nullptr);
    EXPECT_FALSE(vertices.on_lattice(v));
    EXPECT_EQ(vertices.exact(v), exact);
    EXPECT_EQ(vertices.rounded(v), (Point{nearest_double(exact.x), nearest_double(exact.y)}));
    EXPECT_EQ(vertices.off_lattice_count(), 1U);
    // Moved: off the lattice as rationals, and onto it.
    const VertexId w = vertices.add_fraction({{0, 1, 3}, {0}});
    const RationalPoint there{Rational(1, 5) * unit, unit};
    vertices.move_to_exact(v, there);
    EXPECT_EQ(vertices.fraction(v), nullptr);
    EXPECT_EQ(vertices.exact(v), there);
    vertices.move_to_exact(w, {unit, unit});
    EXPECT_EQ(vertices.lattice(w), (LatticePoint{1, 1}));
    EXPECT_EQ(vertices.fraction(w), nullptr);
  }
}

TEST(Vertices, KeepTheExactValueOnAndOffTheLattice) {
  Vertices vertices(-4);
  const RationalPoint third{Rational(1, 3), Rational(1, 16)};
  const VertexId off = vertices.add_exact(third);
  const VertexId on = vertices.add_double({0.5, -0.0625});
  const VertexId fine = vertices.add_double({0.5, std::ldexp(1.0, -70)});
  EXPECT_FALSE(vertices.on_lattice(off));
  EXPECT_FALSE(vertices.on_lattice(fine));
  EXPECT_EQ(vertices.lattice(on), (LatticePoint{8, -1}));
  EXPECT_EQ(vertices.exact(off), third);
  EXPECT_EQ(vertices.exact(fine).y, exact_value(std::ldexp(1.0, -70)));
  EXPECT_EQ(vertices.off_lattice_count(), 2U);
  vertices.move_to_exact(off, {Rational(1), Rational(2)});
  EXPECT_EQ(vertices.lattice(off), (LatticePoint{16, 32}));
}

TEST(Vertices, CommonExponentHoldsAllThatOneLatticeCan) {
  EXPECT_EQ(common_exponent({{0, 0}}), 0);
  EXPECT_EQ(common_exponent({{0.5, 3}, {0.25, 0}}), -2);
  EXPECT_EQ(common_exponent({{1, std::ldexp(1.0, -200)}}), 1 - kLatticeBits);
}

}  // namespace
}  // namespace quadbound
