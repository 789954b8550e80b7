// SPDX-License-Identifier: Apache-2.0
#include "algo/domain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algo/polygon_samples_for_tests.hpp"
#include "generators/random.hpp"

namespace quadbound {
namespace {

/// Lattice points all over the root square, next to edges, and at vertices.
std::vector<LatticePoint> probes(const Domain& domain, EdgeId e, RandomIntegers& random) {
  const RootSquare& root = domain.root();
  std::vector<LatticePoint> points;
  points.reserve(10);
  for (int i = 0; i < 10; ++i)
    points.push_back(
        {root.corner.x + random.bits(root.side_bits), root.corner.y + random.bits(root.side_bits)});
  const LatticePoint a = domain.floor(e);
  const LatticePoint b = domain.floor(domain.next(e));
  for (int i = 0; i <= 8; ++i)
    points.push_back({a.x + (b.x - a.x) / 8 * i + random.between(-1, 1),
                      a.y + (b.y - a.y) / 8 * i + random.between(-1, 1)});
  points.push_back(a);
  points.push_back(b);
  return points;
}

TEST(Domain, VerticesAreExactAndOffTheLatticeWhereTheyMustBe) {
  for (const Polygon& polygon : samples()) {
    const Domain domain = domain_of(polygon);
    const std::vector<Point> points = vertices_of(polygon);
    ASSERT_EQ(domain.size(), points.size());
    EXPECT_EQ(domain.ring_count(), polygon.rings.size());
    for (EdgeId v = 0; v < domain.size(); ++v) {
      EXPECT_EQ(domain.vertices().exact(v), exact_value(points[v]));
      EXPECT_EQ(domain.previous(domain.next(v)), v);
      EXPECT_EQ(domain.ring(domain.next(v)), domain.ring(v));
    }
  }
  const Domain off = domain_of(polygon_off_the_lattice());
  EXPECT_TRUE(off.rounded(0));
  EXPECT_FALSE(off.rounded(1));
}

TEST(Domain, SideAndHeightAgainstRationals) {
  RandomIntegers random(1);
  for (const Polygon& polygon : samples()) {
    const Domain domain = domain_of(polygon);
    for (EdgeId e = 0; e < domain.size(); ++e) {
      const RationalPoint a = in_units(domain, e);
      const RationalPoint b = in_units(domain, domain.next(e));
      for (const LatticePoint p : probes(domain, e, random)) {
        const Rational exact = cross_of(a, b, rational(p));
        EXPECT_EQ(domain.side(e, p), sign_of(exact));
        const double height = nearest_double(exact) /
                              std::hypot(nearest_double(b.x - a.x), nearest_double(b.y - a.y));
        EXPECT_NEAR(domain.height(e, p), height, 0x1p-49 * std::abs(height));
      }
      for (EdgeId v = 0; v < domain.size(); ++v)
        EXPECT_EQ(domain.side(e, v), sign_of(cross_of(a, b, in_units(domain, v))));
    }
  }
}

TEST(Domain, MovedPointsAgainstRationalsMovedByLittle) {
  const auto moved = [](const RationalPoint& p) {
    const int exponent = -200;  // far below what the coordinates differ by
    return RationalPoint{p.x + dyadic(1, exponent), p.y + dyadic(1, 2 * exponent)};
  };
  int on_line = 0;
  for (const Polygon& polygon : samples()) {
    const Domain domain = domain_of(polygon);
    for (EdgeId e = 0; e < domain.size(); ++e) {
      const RationalPoint a = in_units(domain, e);
      EXPECT_EQ(domain.moved_off(e),
                sign_of(cross_of(a, in_units(domain, domain.next(e)), moved(a))));
      const LatticePoint p = domain.floor(e);
      for (const LatticePoint to : {domain.floor(domain.next(e)), LatticePoint{p.x + 8, p.y},
                                    LatticePoint{p.x, p.y - 8}, LatticePoint{p.x - 8, p.y + 8}}) {
        for (EdgeId v = 0; v < domain.size(); ++v) {
          on_line += domain.turn(p, to, v) == 0 ? 1 : 0;
          EXPECT_EQ(
              domain.moved_turn(p, to, v),
              sign_of(cross_of(moved(rational(p)), moved(rational(to)), in_units(domain, v))));
        }
      }
    }
  }
  EXPECT_GT(on_line, 100);
}

TEST(Domain, AcuteVertices) {
  const Polygon polygon =
      normalised({"p", {{{0, 0}, {4, 0}, {4, 3}, {2, 1}, {1, 1}, {0.5, 3}, {0, 3}}}});
  const Domain domain = domain_of(polygon);
  std::vector<EdgeId> acute;
  for (EdgeId v = 0; v < domain.size(); ++v)
    if (domain.is_acute(v)) acute.push_back(v);
  EXPECT_EQ(acute, (std::vector<EdgeId>{2}));
}

TEST(Domain, FeetAreExactlyOnTheirEdgeAndNearestToThePoint) {
  RandomIntegers random(2);
  std::uint64_t tried = 0;
  for (const Polygon& polygon : samples()) {
    const Domain domain = domain_of(polygon);
    for (EdgeId e = 0; e < domain.size(); ++e) {
      const RationalPoint a = in_units(domain, e);
      const RationalPoint b = in_units(domain, domain.next(e));
      const Rational dx = b.x - a.x;
      const Rational dy = b.y - a.y;
      const Rational square = dx * dx + dy * dy;
      const bool x = domain.runs_in_x(e);
      EXPECT_EQ(x, abs(dx) >= abs(dy));
      for (const LatticePoint p : probes(domain, e, random)) {
        const std::int64_t foot = domain.foot(e, p);
        const RationalPoint q = rational(p);
        const Rational t = ((q.x - a.x) * dx + (q.y - a.y) * dy) / square;
        const Rational nearest = x ? a.x + t * dx : a.y + t * dy;
        const double distance = std::abs(nearest_double(nearest - Rational(foot)));
        EXPECT_LE(distance, 0.5 + 0x1p-49 * std::abs(domain.height(e, p)));
        if (!domain.on_edge(e, foot)) continue;
        ++tried;
        const Rational unit = dyadic(1, domain.root().exponent);
        const RationalPoint exact = domain.foot_exact(e, foot);
        const RationalPoint units{exact.x / unit, exact.y / unit};
        EXPECT_EQ(cross_of(a, b, units), 0);
        Vertices vertices(domain.root().exponent);
        EXPECT_EQ(vertices.exact(domain.add_foot(vertices, e, foot)), exact);
        EXPECT_EQ(x ? units.x : units.y, Rational(foot));
        const Rational along = ((units.x - a.x) * dx + (units.y - a.y) * dy) / square;
        EXPECT_TRUE(0 < along && along < 1);
        const FinePoint fine = domain.foot_point(e, foot);
        EXPECT_TRUE(0 <= fine.fraction.x && fine.fraction.x <= 1);
        EXPECT_TRUE(0 <= fine.fraction.y && fine.fraction.y <= 1);
        EXPECT_NEAR(nearest_double(units.x - Rational(fine.floor.x)), fine.fraction.x, 0x1p-50);
        EXPECT_NEAR(nearest_double(units.y - Rational(fine.floor.y)), fine.fraction.y, 0x1p-50);
        // Their order is that along the edge; the height of the point is rounded twice.
        const double step = 1000 * std::sqrt(nearest_double((x ? dx * dx : dy * dy) / square));
        const std::int64_t further = domain.foot(e, p, 1000);
        EXPECT_NEAR(static_cast<double>(domain.along(e, further) - domain.along(e, foot)), step,
                    2 + 0x1p-48 * std::abs(domain.height(e, p)));
      }
    }
  }
  EXPECT_GT(tried, 200U);
}

double side_of(const RootSquare& root) { return std::ldexp(1.0, root.side_bits + root.exponent); }

TEST(PlaceRoot, AShiftedSquareHoldsThePointsWithATwelfthToSpare) {
  for (const Polygon& polygon : samples())
    for (const RootShift shift :
         {RootShift{3, 5}, RootShift{5, 3}, RootShift{7, 11}, RootShift{11, 9}}) {
      const std::vector<Point> points = vertices_of(polygon);
      const RootSquare root = place_root(points, shift).root;
      const double side = side_of(root);
      const Rational unit = dyadic(1, root.exponent);
      const RationalPoint corner{Rational(root.corner.x) * unit, Rational(root.corner.y) * unit};
      const Rational step = exact_value(side) * dyadic(1, -26);
      EXPECT_EQ(denominator(Rational(corner.x / step)), 1);
      EXPECT_EQ(denominator(Rational(corner.y / step)), 1);
      const Rational border = exact_value(side) / 12;
      for (const Point& point : points) {
        const RationalPoint p = exact_value(point);
        for (const Rational& inside : {Rational(p.x - corner.x), Rational(p.y - corner.y)})
          EXPECT_TRUE(border <= inside && inside <= exact_value(side) - border);
      }
      for (const Point& p : points)
        for (const Point& q : points) EXPECT_LE(1.5 * std::max(p.x - q.x, p.y - q.y), side);
    }
}

TEST(PlaceRoot, AShiftMovesTheSquareByPartsOfASixteenth) {
  const std::vector<Point> points{{0, 0}, {1, 1}};
  const RootSquare plain = place_root(points).root;
  const RootSquare shifted = place_root(points, {3, 5}).root;
  const double sixteenth = side_of(plain) / 16;
  const auto corner_x = [](const RootSquare& r) { return nearest_double(r.corner.x, r.exponent); };
  const auto corner_y = [](const RootSquare& r) { return nearest_double(r.corner.y, r.exponent); };
  EXPECT_NEAR(corner_x(plain) - corner_x(shifted), sixteenth / 3, 0x1p-25 * side_of(plain));
  EXPECT_NEAR(corner_y(plain) - corner_y(shifted), sixteenth / 5, 0x1p-25 * side_of(plain));
}

}  // namespace
}  // namespace quadbound
