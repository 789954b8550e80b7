// SPDX-License-Identifier: Apache-2.0
#include "bench/feature_size.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/polygons.hpp"

namespace quadbound {
namespace {

/// On a side of the unit square it is the larger of the distances to the ends: 2 ln 2 for each.
TEST(FeatureSize, OfASquareIsKnown) {
  const Polygon square{"square", {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
  const double exact = 8 * std::log(2.0);
  EXPECT_NEAR(inverse_feature_size_integral(square), exact, exact / 8);
}

/// It is 1 on the long sides of a slab 1 high, and as in the square on the short ones.
TEST(FeatureSize, OfASlabIsItsLengthTwice) {
  const Polygon slab{"slab", {{{0, 0}, {1000, 0}, {1000, 1}, {0, 1}}}};
  EXPECT_NEAR(inverse_feature_size_integral(slab), 2000 + 4 * std::log(2.0), 0.5);
}

/// It has no unit.
TEST(FeatureSize, ScalingChangesNothing) {
  Polygon polygon = generate_polygon(parse_polygon_recipe("star:n=200,seed=1,holes=2"));
  const double before = inverse_feature_size_integral(polygon);
  for (Ring& ring : polygon.rings)
    for (Point& p : ring) p = {p.x / 1024, p.y / 1024};
  EXPECT_EQ(inverse_feature_size_integral(polygon), before);
}

TEST(FeatureSize, ATriangleHasNone) {
  const Polygon triangle{"triangle", {{{0, 0}, {1, 0}, {0, 1}}}};
  const double value = inverse_feature_size_integral(triangle);
  EXPECT_GT(value, 3);
  EXPECT_LT(value, 6);
}

}  // namespace
}  // namespace quadbound
