// SPDX-License-Identifier: Apache-2.0
#include "verify/wide.hpp"

#include <gtest/gtest.h>

#include <random>

namespace quadbound::judge {
namespace {

/// Values of every size up to 2^126, both signs, with many repetitions and zeros.
Int128 random_value(std::mt19937_64& random) {
  const auto bits = static_cast<int>(random() % 127);
  const UInt128 wide = (UInt128{random()} << 64) | random();
  const auto value = static_cast<Int128>(bits == 0 ? 0 : wide >> (128 - bits));
  return random() % 2 == 0 ? value : -value;
}

TEST(Wide, ComparesProductsAsRationalsDo) {
  std::mt19937_64 random(1);
  int effective = 0;
  for (int i = 0; i < 20000; ++i) {
    const Int128 a = random_value(random);
    const Int128 b = random_value(random);
    const bool equal = i % 4 == 0;
    const Int128 c = equal ? b : random_value(random);
    const Int128 d = equal ? a + i % 3 - 1 : random_value(random);
    const Rational left = to_rational(a) * to_rational(b);
    const Rational right = to_rational(c) * to_rational(d);
    EXPECT_EQ(compare_products(a, b, c, d), left.compare(right) <=> 0);
    effective += !fits_64_bits(a) && !fits_64_bits(b) ? 1 : 0;
  }
  EXPECT_GT(effective, 2000);
}

TEST(Wide, SumsAsRationalsDo) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 50; ++i) {
    WideSum sum;
    WideSum part;
    Rational expected = 0;
    for (int k = 0; k < 200; ++k) {
      const Int128 value = random_value(random) - (Int128{1} << 125);
      (k % 2 == 0 ? sum : part).add(value);
      expected += to_rational(value);
    }
    part.add(Rational(1, 3));
    sum.add(part);
    EXPECT_EQ(sum.value(), Rational(expected + Rational(1, 3)));
  }
}

TEST(Wide, SumsOfManyDenominatorsAreExact) {
  for (const int count : {0, 1, 2, 3, 64, 301}) {
    RationalSum sum;
    Rational expected = 0;
    for (int k = 1; k <= count; ++k) {
      sum.add(Rational(1, k));
      expected += Rational(1, k);
    }
    EXPECT_EQ(sum.value(), expected) << count;
  }
}

}  // namespace
}  // namespace quadbound::judge
