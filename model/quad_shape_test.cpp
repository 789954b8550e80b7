// SPDX-License-Identifier: Apache-2.0
#include "model/quad_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace quadbound {
namespace {

/// From corners, counter-clockwise.
QuadShape shape_of(const std::array<Point, 4>& p) {
  std::array<Point, 4> edges;
  for (std::size_t i = 0; i < 4; ++i)
    edges[i] = {p[(i + 1) % 4].x - p[i].x, p[(i + 1) % 4].y - p[i].y};
  return quad_shape(edges);
}

constexpr double kDegree = 180 / std::numbers::pi;

TEST(QuadShape, OfASquare) {
  const QuadShape shape = shape_of({{{0, 0}, {3, 0}, {3, 3}, {0, 3}}});
  EXPECT_DOUBLE_EQ(shape.min_angle, 90);
  EXPECT_DOUBLE_EQ(shape.max_angle, 90);
  EXPECT_DOUBLE_EQ(shape.scaled_jacobian, 1);
  EXPECT_DOUBLE_EQ(shape.aspect_ratio, 1);
}

TEST(QuadShape, AspectRatioOfRectanglesIsTheirSides) {
  EXPECT_DOUBLE_EQ(shape_of({{{0, 0}, {6, 0}, {6, 2}, {0, 2}}}).aspect_ratio, 3);
  EXPECT_DOUBLE_EQ(shape_of({{{0, 0}, {1, 1}, {0.5, 1.5}, {-0.5, 0.5}}}).aspect_ratio, 2);
}

TEST(QuadShape, AspectRatioOfAParallelogramTakesTheWorseMedian) {
  // Medians (4, 0) and (2, 1): rectangles of 4 by 1 along the first one and of sqrt(5) by
  // 4 / sqrt(5) along the second one.
  EXPECT_DOUBLE_EQ(shape_of({{{0, 0}, {4, 0}, {6, 1}, {2, 1}}}).aspect_ratio, 4);
}

TEST(QuadShape, OfATrapezoid) {
  // Legs of slope 3: arctan(3) at the bottom.
  const QuadShape shape = shape_of({{{0, 0}, {4, 0}, {3, 3}, {1, 3}}});
  EXPECT_DOUBLE_EQ(shape.min_angle, std::atan(3.0) * kDegree);
  EXPECT_DOUBLE_EQ(shape.max_angle, 180 - std::atan(3.0) * kDegree);
  EXPECT_DOUBLE_EQ(shape.scaled_jacobian, 3 / std::sqrt(10.0));
  EXPECT_DOUBLE_EQ(shape.aspect_ratio, 1);
}

TEST(QuadShape, AReflexCornerShowsInAllMeasuresButTheAspectRatio) {
  const QuadShape shape = shape_of({{{0, 0}, {4, -4}, {1, 0}, {4, 4}}});
  EXPECT_DOUBLE_EQ(shape.max_angle, 360 - 2 * std::atan2(4.0, 3.0) * kDegree);
  EXPECT_LT(shape.scaled_jacobian, 0);
  EXPECT_TRUE(std::isfinite(shape.aspect_ratio));
}

TEST(QuadShape, ClockwiseAndFlatQuadsHaveNoAspectRatio) {
  EXPECT_TRUE(std::isinf(shape_of({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}).aspect_ratio));
  EXPECT_LT(shape_of({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}).scaled_jacobian, 0);
  EXPECT_TRUE(std::isinf(shape_of({{{0, 0}, {1, 0}, {2, 0}, {3, 0}}}).aspect_ratio));
}

TEST(QuadShape, NothingIsNotANumberWhereCornersCoincide) {
  for (const QuadShape& shape : {shape_of({{{0, 0}, {1, 0}, {1, 0}, {0, 1}}}),
                                 shape_of({{{2, 2}, {2, 2}, {2, 2}, {2, 2}}})}) {
    EXPECT_EQ(shape.min_angle, 0);
    EXPECT_FALSE(std::isnan(shape.max_angle));
    EXPECT_EQ(shape.scaled_jacobian, 0);
    EXPECT_FALSE(std::isnan(shape.aspect_ratio));
  }
}

TEST(QuadShape, SizeAndNumberingDoNotMatter) {
  const std::array<Point, 4> corners{{{0, 0}, {5, 1}, {4, 4}, {1, 2}}};
  const QuadShape expected = shape_of(corners);
  for (const double scale : {1e-200, 1e-9, 1e200})
    for (std::size_t start = 0; start < 4; ++start) {
      std::array<Point, 4> other;
      for (std::size_t i = 0; i < 4; ++i)
        other[i] = {corners[(i + start) % 4].x * scale, corners[(i + start) % 4].y * scale};
      const QuadShape shape = shape_of(other);
      EXPECT_NEAR(shape.min_angle, expected.min_angle, 1e-12);
      EXPECT_NEAR(shape.max_angle, expected.max_angle, 1e-12);
      EXPECT_NEAR(shape.scaled_jacobian, expected.scaled_jacobian, 1e-14);
      EXPECT_NEAR(shape.aspect_ratio, expected.aspect_ratio, 1e-14);
    }
}

/// A quad of size 2^-50 at 2^9 + 1/3: its doubles would all be one point.
TEST(QuadShape, FarFromTheOriginTheExactCoordinatesCount) {
  for (const bool on_lattice : {true, false}) {
    const int exponent = on_lattice ? -50 : -51;
    Vertices vertices(exponent);
    const Rational origin = on_lattice ? Rational(512) : Rational(512) + Rational(1, 3);
    const Rational unit = dyadic(1, -50);
    for (const auto& [x, y] : {std::pair{0, 0}, {3, 1}, {3, 2}, {0, 1}})
      vertices.add_exact({Rational(origin + x * unit), Rational(origin + y * unit)});
    ASSERT_EQ(vertices.off_lattice_count(), on_lattice ? 0U : 4U);
    const QuadShape shape = quad_shape(vertices, {0, 1, 2, 3});
    EXPECT_DOUBLE_EQ(shape.min_angle, 90 - std::atan2(1.0, 3.0) * kDegree);
  }
}

}  // namespace
}  // namespace quadbound
