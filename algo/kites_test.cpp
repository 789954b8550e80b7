// SPDX-License-Identifier: Apache-2.0
#include "algo/kites.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "algo/point_separation.hpp"
#include "generators/polygons.hpp"
#include "model/validate.hpp"

namespace quadbound {
namespace {

struct Segment {
  RationalPoint from;
  RationalPoint to;
};

std::vector<Point> all_vertices(const Polygon& polygon) {
  std::vector<Point> points;
  for (const Ring& ring : polygon.rings) points.insert(points.end(), ring.begin(), ring.end());
  return points;
}

RootSquare root_of(const Polygon& polygon) { return place_root(all_vertices(polygon)).root; }

Domain whole_of(const Polygon& polygon) {
  return cut_kites(polygon, root_of(polygon), std::vector<bool>(all_vertices(polygon).size()));
}

std::vector<bool> acute_vertices(const Domain& domain) {
  std::vector<bool> acute;
  for (EdgeId i = 0; i < domain.size(); ++i) acute.push_back(domain.is_acute(i));
  return acute;
}

Rational cross(const RationalPoint& at, const RationalPoint& a, const RationalPoint& b) {
  return (a.x - at.x) * (b.y - at.y) - (a.y - at.y) * (b.x - at.x);
}
Rational dot(const RationalPoint& at, const RationalPoint& a, const RationalPoint& b) {
  return (a.x - at.x) * (b.x - at.x) + (a.y - at.y) * (b.y - at.y);
}
int sign(const Rational& value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Whether closed segments have a point in common other than an end of both.
bool collide(const Segment& s, const Segment& t) {
  const int a = sign(cross(s.from, s.to, t.from));
  const int b = sign(cross(s.from, s.to, t.to));
  const int c = sign(cross(t.from, t.to, s.from));
  const int d = sign(cross(t.from, t.to, s.to));
  if (a * b < 0 && c * d < 0) return true;
  const auto inside = [](const RationalPoint& x, const Segment& segment) {
    return x != segment.from && x != segment.to && dot(x, segment.from, segment.to) < 0;
  };
  return (a == 0 && inside(t.from, s)) || (b == 0 && inside(t.to, s)) ||
         (c == 0 && inside(s.from, t)) || (d == 0 && inside(s.to, t));
}

std::vector<Segment> edges_of(const Domain& domain) {
  std::vector<Segment> edges;
  for (EdgeId e = 0; e < domain.size(); ++e)
    edges.push_back({domain.vertices().exact(e), domain.vertices().exact(domain.next(e))});
  return edges;
}

RationalPoint enlarged(const RationalPoint& a, const RationalPoint& x, const Rational& scale) {
  return {a.x + scale * (x.x - a.x), a.y + scale * (x.y - a.y)};
}

/// The sides of the kites at p and q, moved away from a.
std::vector<Segment> enlarged_sides(const Domain& domain, const Rational& scale) {
  std::vector<Segment> sides;
  for (const Kite& kite : domain.kites) {
    const auto corner = [&](EdgeId i) {
      return enlarged(kite.a, domain.vertices().exact(i), scale);
    };
    sides.push_back({corner(kite.p), corner(kite.v)});
    sides.push_back({corner(kite.v), corner(kite.q)});
  }
  return sides;
}

/// Guarantees 1 and 2.
void expect_right_kite(const Domain& domain, const Kite& kite) {
  EXPECT_EQ(domain.next(kite.q), kite.v);
  EXPECT_EQ(domain.next(kite.v), kite.p);
  EXPECT_TRUE(domain.vertices().on_lattice(kite.v));
  const RationalPoint p = domain.vertices().exact(kite.p);
  const RationalPoint v = domain.vertices().exact(kite.v);
  const RationalPoint q = domain.vertices().exact(kite.q);
  const RationalPoint after = domain.vertices().exact(domain.next(kite.p));
  const RationalPoint before = domain.vertices().exact(domain.previous(kite.q));
  for (const auto& [foot, beyond] : {std::pair{p, after}, std::pair{q, before}}) {
    EXPECT_EQ(cross(kite.a, foot, beyond), 0);
    EXPECT_LT(dot(foot, kite.a, beyond), 0);
    EXPECT_LE(dot(foot, beyond, v), 0);
    EXPECT_GE(dot(foot, kite.a, v), 0);
    // Within a degree of a right angle.
    const Rational side = (v.x - foot.x) * (v.x - foot.x) + (v.y - foot.y) * (v.y - foot.y);
    const Rational edge = dot(kite.a, foot, foot);
    const Rational along = dot(foot, kite.a, v);
    EXPECT_LE(along * along * 57 * 57, side * edge);
  }
  EXPECT_LE(dot(v, p, q), 0);
  EXPECT_GT(cross(kite.a, p, v), 0);
  EXPECT_GT(cross(kite.a, v, q), 0);
}

/// Guarantees 1, 2 and, for the domain with its kites and without, 4.
void expect_right_cut(const Polygon& polygon) {
  const Domain whole = whole_of(polygon);
  const std::vector<bool> acute = acute_vertices(whole);
  const Domain domain = cut_kites(polygon, whole.root(), acute);
  EXPECT_EQ(domain.kites.size(),
            static_cast<std::size_t>(std::count(acute.begin(), acute.end(), true)));
  for (const Kite& kite : domain.kites) expect_right_kite(domain, kite);
  for (const bool still : acute_vertices(domain)) EXPECT_FALSE(still);

  std::vector<Segment> plane = edges_of(domain);
  for (const Kite& kite : domain.kites) {
    plane.push_back({kite.a, domain.vertices().exact(kite.p)});
    plane.push_back({kite.a, domain.vertices().exact(kite.q)});
  }
  for (std::size_t i = 0; i < plane.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_FALSE(collide(plane[i], plane[j])) << polygon.file << ": " << i << ", " << j;
  }
  // Enlarged kites and edges; those of the same tip touch on purpose.
  for (const Segment& side : enlarged_sides(domain, Rational(149, 100))) {
    for (const Segment& edge : edges_of(whole)) {
      if (collide(side, edge)) {
        const bool own =
            cross(edge.from, edge.to, side.from) == 0 || cross(edge.from, edge.to, side.to) == 0;
        ASSERT_TRUE(own) << polygon.file;
      }
    }
  }
  const std::vector<Segment> sides = enlarged_sides(domain, Rational(124, 100));
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) ASSERT_FALSE(collide(sides[i], sides[j])) << polygon.file;
  }
}

TEST(CutKites, NothingMarkedIsThePolygon) {
  const Polygon polygon = generate_polygon(parse_polygon_recipe("star:n=20,seed=3,holes=2"));
  const Domain domain = whole_of(polygon);
  const std::vector<Point> points = all_vertices(polygon);
  ASSERT_EQ(domain.size(), points.size());
  EXPECT_EQ(domain.ring_count(), 3U);
  EXPECT_TRUE(domain.kites.empty());
  for (EdgeId i = 0; i < domain.size(); ++i)
    EXPECT_EQ(domain.vertices().exact(i), exact_value(points[i]));
}

TEST(CutKites, EveryAcuteVertexOfEveryFamily) {
  for (const char* family : {"star:n=30,low=5", "star:n=24,holes=3", "star:n=40,low=60",
                             "sharp:n=18", "sharp:n=8,depth=9", "x-monotone:n=40", "regular:n=3",
                             "gear:n=36,low=40", "notch:n=32,depth=12"}) {
    for (int seed = 1; seed <= 6; ++seed)
      expect_right_cut(generate_polygon(
          parse_polygon_recipe(family + std::string(",seed=") + std::to_string(seed))));
  }
}

/// A triangle with the tip in the origin, that leaves it between two directions.
Polygon triangle(double from_degrees, double tip_degrees, double p_length, double q_length) {
  const auto at = [](double degrees, double length) {
    const double angle = degrees * std::numbers::pi / 180;
    return Point{length * std::cos(angle), length * std::sin(angle)};
  };
  return normalised(
      {"triangle",
       {{{0, 0}, at(from_degrees, p_length), at(from_degrees + tip_degrees, q_length)}}});
}

TEST(CutKites, SharpTipsInAllDirections) {
  for (const double tip :
       {89.99999, 60.0, 30.0, 10.0, 8.0, 1.0, 0.1, 0.01, 1e-4, 1e-6, 1e-8, 1e-10}) {
    for (const double from : {0.0, 17.0, 45.0, 90.0, 133.0, 179.99, 211.0, 270.0, 300.0}) {
      for (const double q_length : {1.0, 0.9, 0.01}) {
        const Polygon polygon = triangle(from, tip, 1, q_length);
        const RootSquare root = root_of(polygon);
        const Domain domain = cut_kites(polygon, root, {true, false, false});
        ASSERT_EQ(domain.size(), 5U);
        expect_right_kite(domain, domain.kites.at(0));
      }
    }
  }
}

TEST(CutKites, RefusesWhatTheLatticeCannotHold) {
  const Polygon polygon = triangle(33, 1e-13, 1, 1);
  try {
    (void)cut_kites(polygon, root_of(polygon), {true, false, false});
    FAIL();
  } catch (const TreeBudgetExceeded& exceeded) {
    EXPECT_EQ(exceeded.kind, RefusalKind::kTooDeep);
    EXPECT_GT(exceeded.level, 45);
  }
}

TEST(CutKites, TipsOnBothSidesOfAThinWallStayLarge) {
  // Two tips on both sides of a gap that is outside: nothing may be made smaller because of it.
  const double gap = 0x1p-40;
  const Polygon polygon =
      normalised({"wall",
                  {{{-2, 0}, {2, 0}, {2, 3}, {-2, 3}},
                   {{-1, 1}, {0, 1}, {1, 1}, {1, 1 + gap}, {0, 1 + gap}, {-1, 1 + gap}}}});
  expect_right_cut(polygon);
  const Polygon comb = normalised({"comb",
                                   {{{0, 0},
                                     {4, 0},
                                     {4, 4},
                                     {2 + gap, 4},
                                     {3, 1},  // a slit beside which two tips of P point upwards
                                     {2, 4},
                                     {0, 4}}}});
  expect_right_cut(comb);
  const Domain whole = whole_of(comb);
  const Domain domain = cut_kites(comb, whole.root(), acute_vertices(whole));
  ASSERT_GE(domain.kites.size(), 1U);
  for (const Kite& kite : domain.kites) {
    const RationalPoint p = domain.vertices().exact(kite.p);
    EXPECT_GT(nearest_double(dot(kite.a, p, p)), 0.01);
  }
}

TEST(CutKites, OppositeTipsAcrossTheInside) {
  // Wide tips that face each other; their kites of a third of the edges would overlap.
  for (const double reach : {0.2, 0.5, 0.9, 1.2, 1.6}) {
    Ring left{{0, 0}, {-reach, -reach * 0.97}, {-4, -4}, {4, -4}};
    left.insert(left.end(), {{4, 4}, {-4, 4}, {-reach, reach * 0.97}});
    expect_right_cut(normalised({"tip", {left}}));
    // A notch of P towards the right, another towards the left.
    const Polygon facing =
        normalised({"facing",
                    {{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}},
                     {{-1, 0}, {2 - reach, 2.8}, {-3, 2.8}, {-3, -2.8}, {2 - reach, -2.8}},
                     {{3.2, 0}, {3.1, -0.09}, {5, -0.09}, {5, 0.09}, {3.1, 0.09}}}});
    expect_right_cut(facing);
  }
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__)
constexpr std::size_t kManyEdges = 4000;  // takes a hundred times as long there
#else
constexpr std::size_t kManyEdges = 40'000;
#endif

TEST(CutKites, TwentyThousandTipsInSeconds) {
  for (const char* family : {"sharp:n=", "star:low=5,n="}) {
    const std::string recipe = family + std::to_string(kManyEdges);
    const Polygon polygon = generate_polygon(parse_polygon_recipe(recipe));
    const RootSquare root = root_of(polygon);
    const std::vector<bool> acute =
        acute_vertices(cut_kites(polygon, root, std::vector<bool>(kManyEdges)));
    const std::clock_t start = std::clock();
    const Domain domain = cut_kites(polygon, root, acute);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    RecordProperty(recipe, std::to_string(seconds));
    EXPECT_GT(domain.kites.size(), kManyEdges / 4);
    // About a second of a processor. Trying each kite against each edge takes far longer than this.
    EXPECT_LT(seconds, 10) << recipe;
  }
}

}  // namespace
}  // namespace quadbound
