// SPDX-License-Identifier: Apache-2.0
#include "model/validate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "model/exact.hpp"
#include "model/predicates.hpp"
#include "model/refusal_for_tests.hpp"
#include "model/ring_sweep.hpp"

namespace quadbound {
namespace {

using Rings = std::vector<Ring>;

std::string verdict(const Rings& rings) {
  return refusal([&] { validate(Polygon{"a.file", rings}); });
}

std::string point_verdict(const std::vector<Point>& points) {
  return refusal([&] { validate(PointSet{"a.file", points}); });
}

const Ring kSquare{{0, 0}, {8, 0}, {8, 8}, {0, 8}};

Ring moved(Ring ring, double dx, double dy, double scale = 1) {
  for (Point& p : ring) p = {p.x * scale + dx, p.y * scale + dy};
  return ring;
}

TEST(ValidatePoints, AcceptsOnePointAndPointsOnOneLine) {
  EXPECT_EQ(point_verdict({{0, 0}}), "accepted");
  EXPECT_EQ(point_verdict({{0, 0}, {1, 1}, {2, 2}, {-0.0, 1}}), "accepted");
  EXPECT_EQ(point_verdict({{std::ldexp(1.0, 1000), std::ldexp(-1.0, -1000)}}), "accepted");
}

TEST(ValidatePoints, Refusals) {
  EXPECT_EQ(point_verdict({}), "a.file: there is no point");
  EXPECT_EQ(point_verdict({{0, 0}, {std::nan(""), 0}}),
            "a.file: vertex 1: a coordinate is not finite");
  EXPECT_EQ(point_verdict({{0, -INFINITY}}), "a.file: vertex 0: a coordinate is not finite");
  EXPECT_EQ(point_verdict({{1e308, 0}}),
            "a.file: vertex 0: the coordinate 1e+308 is out of range: zero and magnitudes from "
            "2^-1000 to 2^1000 are allowed");
  EXPECT_EQ(point_verdict({{0, 0}, {0, 5e-324}}),
            "a.file: vertex 1: the coordinate 5e-324 is out of range: zero and magnitudes from "
            "2^-1000 to 2^1000 are allowed");
  EXPECT_EQ(point_verdict({{5, 5}, {0, 1}, {3, 3}, {-0.0, 1}, {3, 3}, {0, 1}}),
            "a.file: vertex 1: vertex 3 is at the same place");
}

TEST(ValidatePolygon, AcceptsAnyOrientationStraightAnglesAndHoles) {
  Ring clockwise = kSquare;
  std::reverse(clockwise.begin(), clockwise.end());
  EXPECT_EQ(verdict({kSquare}), "accepted");
  EXPECT_EQ(verdict({clockwise}), "accepted");
  EXPECT_EQ(verdict({{{0, 0}, {4, 0}, {8, 0}, {8, 8}, {4, 8}, {0, 8}, {0, 4}}}), "accepted");
  EXPECT_EQ(verdict({kSquare, moved(kSquare, 1, 1, 0.25), moved(clockwise, 4, 4, 0.25)}),
            "accepted");
}

TEST(ValidatePolygon, RefusesRingsThatAreNone) {
  EXPECT_EQ(verdict({}), "a.file: the polygon has no ring");
  EXPECT_EQ(verdict({{}}), "a.file: ring 0: the ring has 0 vertices; three is the least");
  EXPECT_EQ(verdict({kSquare, {{1, 1}, {2, 2}}}),
            "a.file: ring 1: the ring has 2 vertices; three is the least");
  EXPECT_EQ(verdict({{{0, 0}, {1, 0}, {std::nan(""), 1}}}),
            "a.file: ring 0, vertex 2: a coordinate is not finite");
  EXPECT_EQ(verdict({kSquare, {{1, 1}, {2, 1}, {2, 1e-310}}}),
            "a.file: ring 1, vertex 2: the coordinate 1e-310 is out of range: zero and magnitudes "
            "from 2^-1000 to 2^1000 are allowed");
  EXPECT_EQ(verdict({{{0, 0}, {1, 1}, {2, 2}, {4, 4}}}),
            "a.file: ring 0: zero area: all vertices lie on one line");
}

TEST(ValidatePolygon, RefusesEdgesOfZeroLengthSpikesAndRepeatedVertices) {
  const std::string zero = ": the next vertex is at the same place (an edge of zero length)";
  EXPECT_EQ(verdict({{{0, 0}, {8, 0}, {8, 8}, {8, 8}}}), "a.file: ring 0, vertex 2" + zero);
  EXPECT_EQ(verdict({kSquare, {{2, 2}, {4, 2}, {2, 4}, {2, 2}}}),
            "a.file: ring 1, vertex 3" + zero);
  EXPECT_EQ(verdict({{{0, 0}, {8, 0}, {8, 8}, {-0.0, -0.0}}}), "a.file: ring 0, vertex 3" + zero);
  const std::string spike = ": a spike: the edge from here folds back on the edge before it";
  EXPECT_EQ(verdict({{{0, 0}, {8, 0}, {6, 0}, {8, 8}}}), "a.file: ring 0, vertex 1" + spike);
  EXPECT_EQ(verdict({{{0, 0}, {8, 0}, {8, 8}, {8, 9}, {8, 7}, {0, 8}}}),
            "a.file: ring 0, vertex 3" + spike);
  EXPECT_EQ(verdict({{{0, 0}, {8, 0}, {0, 0}, {0, 8}}}), "a.file: ring 0, vertex 1" + spike);
  EXPECT_EQ(verdict({{{0, 0}, {4, 4}, {8, 0}, {8, 8}, {4, 4}, {0, 8}}}),
            "a.file: ring 0, vertex 1: ring 0, vertex 4 is at the same place");
  EXPECT_EQ(verdict({kSquare, {{2, 2}, {4, 2}, {0.0, 8}}}),
            "a.file: ring 0, vertex 3: ring 1, vertex 2 is at the same place");
}

TEST(ValidatePolygon, NamesTheFirstEdgesThatMeet) {
  EXPECT_EQ(verdict({{{0, 0}, {8, 8}, {8, 0}, {0, 8}}}),
            "a.file: ring 0, vertex 0: the edge from here crosses the edge from ring 0, vertex 2");
  EXPECT_EQ(verdict({{{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}}),
            "a.file: ring 0, vertex 0: the edge from here touches the edge from ring 0, vertex 2");
  EXPECT_EQ(verdict({{{0, 0}, {8, 0}, {8, 4}, {6, 4}, {6, 0}, {2, 0}, {2, 4}, {0, 4}}}),
            "a.file: ring 0, vertex 0: the edge from here touches the edge from ring 0, vertex 3");
  EXPECT_EQ(verdict({kSquare, moved(kSquare, 6, 6, 0.5)}),
            "a.file: ring 0, vertex 1: the edge from here crosses the edge from ring 1, vertex 0");
  EXPECT_EQ(verdict({kSquare, moved(kSquare, 0, 2, 0.5)}),
            "a.file: ring 0, vertex 3: the edge from here touches the edge from ring 1, vertex 0");
  EXPECT_EQ(verdict({kSquare, moved(kSquare, 1, 1, 0.25), moved(kSquare, 2, 2, 0.25)}),
            "a.file: ring 1, vertex 1: the edge from here crosses the edge from ring 2, vertex 0");
}

TEST(ValidatePolygon, RefusesHolesInWrongPlaces) {
  EXPECT_EQ(verdict({kSquare, moved(kSquare, 20, 0)}),
            "a.file: ring 1: the hole lies outside the outer ring");
  EXPECT_EQ(verdict({kSquare, moved(kSquare, 0, -20)}),
            "a.file: ring 1: the hole lies outside the outer ring");
  EXPECT_EQ(verdict({kSquare, moved(kSquare, -8, -8, 3)}),
            "a.file: ring 1: the hole surrounds the outer ring");
  EXPECT_EQ(verdict({kSquare, moved(kSquare, 2, 2, 0.25), moved(kSquare, 1, 1, 0.75)}),
            "a.file: ring 1: the hole lies inside ring 2, a hole");
}

TEST(ValidatePolygon, SeesOneUnitInTheLastPlace) {
  // The third vertex lies on the line through the others, or one unit to either side of it.
  const double y = 1.0 / 3;
  const Ring slab{{0, 0}, {3, 3 * y}, {3, 2}, {0, 2}};
  const auto with_notch = [&](double tip) {
    Ring ring = slab;
    ring.insert(ring.begin() + 3, {1.5, tip});
    return verdict({ring});
  };
  const double middle = 1.5 * y;
  const std::string touch =
      "a.file: ring 0, vertex 0: the edge from here touches the edge from ring 0, vertex 2";
  ASSERT_EQ(exact_value(middle) * 2, exact_value(3 * y));
  EXPECT_EQ(with_notch(middle), touch);
  EXPECT_EQ(with_notch(std::nextafter(middle, 2)), "accepted");
  EXPECT_EQ(with_notch(std::nextafter(middle, -2)),
            "a.file: ring 0, vertex 0: the edge from here crosses the edge from ring 0, vertex 2");
}

TEST(ValidatePolygon, HoldsAtBothEndsOfTheRange) {
  for (const int exponent : {-997, 996}) {
    const double unit = std::ldexp(1.0, exponent);
    const Ring bow{{0, 0}, {8, 8}, {8, 0}, {0, 8}};
    EXPECT_EQ(verdict({moved(kSquare, 0, 0, unit), moved(kSquare, unit, 5 * unit, unit / 4)}),
              "accepted");
    EXPECT_EQ(verdict({moved(bow, 0, 0, unit)}),
              "a.file: ring 0, vertex 0: the edge from here crosses the edge from ring 0, vertex "
              "2");
  }
}

TEST(Normalised, TurnsRingsAndKeepsTheirFirstVertices) {
  Ring clockwise = kSquare;
  std::reverse(clockwise.begin() + 1, clockwise.end());
  const Ring hole = moved(kSquare, 2, 2, 0.25);
  const Ring turned_hole = moved(clockwise, 2, 2, 0.25);
  for (const Ring& outer : {kSquare, clockwise})
    for (const Ring& inner : {hole, turned_hole})
      EXPECT_EQ(normalised({"a.file", {outer, inner}}).rings, (Rings{kSquare, turned_hole}));
  const Polygon zero = normalised({"a.file", {{{-0.0, -0.0}, {1, -0.0}, {0, 1}}}});
  EXPECT_FALSE(std::signbit(zero.rings[0][0].x) || std::signbit(zero.rings[0][1].y));
  EXPECT_THROW(normalised({"a.file", {}}), InputError);
}

int exact_orientation(const Point& a, const Point& b, const Point& c) {
  const RationalPoint p = exact_value(a);
  const RationalPoint q = exact_value(b);
  const RationalPoint r = exact_value(c);
  const Rational turn = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

TEST(Predicates, OrientationIsExactAmongAdjacentDoubles) {
  // Points of a 32 x 32 grid of adjacent doubles against a line that almost contains them.
  const Point b{12, 12};
  const Point c{24, 24};
  int zeros = 0;
  double x = 0.5;
  for (int i = 0; i < 32; ++i, x = std::nextafter(x, 1)) {
    double y = 0.5;
    for (int k = 0; k < 32; ++k, y = std::nextafter(y, 1)) {
      const int sign = orientation({x, y}, b, c);
      ASSERT_EQ(sign, exact_orientation({x, y}, b, c)) << i << ' ' << k;
      ASSERT_EQ(sign, orientation(b, c, {x, y}));
      ASSERT_EQ(sign, -orientation(b, {x, y}, c));
      zeros += sign == 0;
    }
  }
  EXPECT_EQ(zeros, 32);
}

TEST(Predicates, OrientationIsExactNearOverflowAndAmongSubnormals) {
  std::mt19937_64 engine(5);
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    const int exponent = static_cast<int>(engine() % 3) == 0 ? -1074 : 1019;
    const auto coordinate = [&] {
      return std::ldexp(static_cast<double>(engine() % 9) - 4, exponent);
    };
    const Point a{coordinate(), coordinate()};
    const Point b{coordinate(), coordinate()};
    const Point c{coordinate(), coordinate()};
    ASSERT_EQ(orientation(a, b, c), exact_orientation(a, b, c));
    zeros += orientation(a, b, c) == 0;
  }
  EXPECT_GT(zeros, 1000);
  EXPECT_LT(zeros, 10000);
}

TEST(Predicates, StrictlyInsideLeavesOutTheBoundary) {
  const Ring notched{{0, 0}, {8, 0}, {8, 8}, {4, 4}, {0, 8}};
  EXPECT_TRUE(strictly_inside({4, 3}, notched));
  EXPECT_TRUE(strictly_inside({1, 4}, notched));
  EXPECT_FALSE(strictly_inside({4, 5}, notched));
  EXPECT_FALSE(strictly_inside({-1, 4}, notched));
  EXPECT_FALSE(strictly_inside({9, 0}, notched));
  for (const Point& p : {Point{4, 4}, Point{0, 0}, Point{4, 0}, Point{8, 3}, Point{2, 6}})
    EXPECT_FALSE(strictly_inside(p, notched));
}

/// What validate should say, by comparing everything with everything.
class SlowJudge {
 public:
  explicit SlowJudge(const Rings& rings) {
    for (std::size_t r = 0; r < rings.size(); ++r)
      for (std::size_t v = 0; v < rings[r].size(); ++v)
        edges_.push_back({rings[r][v], rings[r][(v + 1) % rings[r].size()], r, v, rings[r].size()});
  }

  [[nodiscard]] std::string verdict() const {
    for (const Edge& e : edges_)
      for (const Edge& f : edges_)
        if ((e.ring != f.ring || e.vertex != f.vertex) && e.from == f.from) return "repeated";
    for (const Edge& e : edges_)
      if (const Edge& f = next(e);
          orientation(e.from, e.to, f.to) == 0 &&
          lexicographically_before(e.from, e.to) != lexicographically_before(f.from, f.to))
        return "spike";
    for (std::size_t k = 0; k < edges_.size(); ++k)
      for (std::size_t i = 0; i < k; ++i)
        if (const Meeting how = meet(edges_[i], edges_[k]); how != Meeting::kApart)
          return message(edges_[i], edges_[k], how);
    return "disjoint";
  }

 private:
  struct Edge {
    Point from;
    Point to;
    std::size_t ring;
    std::size_t vertex;
    std::size_t ring_size;
  };

  [[nodiscard]] const Edge& next(const Edge& e) const {
    return *std::find_if(edges_.begin(), edges_.end(), [&](const Edge& f) {
      return f.ring == e.ring && f.vertex == (e.vertex + 1) % e.ring_size;
    });
  }

  [[nodiscard]] Meeting meet(const Edge& e, const Edge& f) const {
    const std::size_t steps = (f.vertex + f.ring_size - e.vertex) % f.ring_size;
    if (e.ring == f.ring && (steps == 1 || steps + 1 == f.ring_size)) return Meeting::kApart;
    return meeting(e.from, e.to, f.from, f.to);
  }

  static std::string message(const Edge& e, const Edge& f, Meeting how) {
    return "a.file: ring " + std::to_string(e.ring) + ", vertex " + std::to_string(e.vertex) +
           ": the edge from here " + (how == Meeting::kCross ? "crosses" : "touches") +
           " the edge from ring " + std::to_string(f.ring) + ", vertex " + std::to_string(f.vertex);
  }

  std::vector<Edge> edges_;
};

TEST(ValidatePolygon, AgreesWithComparingAllEdgesOnSmallGrids) {
  std::mt19937_64 engine(6);
  int disjoint = 0;
  int meeting_edges = 0;
  for (int i = 0; i < 60000; ++i) {
    const auto side = 2 + engine() % 9;
    Rings rings(1 + engine() % 2);
    for (Ring& ring : rings)
      for (auto left = 3 + engine() % 5; left > 0; --left)
        ring.push_back(
            {static_cast<double>(engine() % side), static_cast<double>(engine() % side)});
    const std::string slow = SlowJudge(rings).verdict();
    const std::string fast = verdict(rings);
    if (slow == "repeated" || slow == "spike") {
      ASSERT_NE(fast, "accepted");
    } else if (slow == "disjoint") {
      ++disjoint;
      ASSERT_TRUE(fast == "accepted" || fast.find("the hole") != std::string::npos) << fast;
      const bool inside = rings.size() == 1 || (strictly_inside(rings[1][0], rings[0]) &&
                                                !strictly_inside(rings[0][0], rings[1]));
      ASSERT_EQ(fast == "accepted", inside) << fast;
    } else {
      ++meeting_edges;
      ASSERT_EQ(fast, slow);
    }
  }
  EXPECT_GT(disjoint, 2000);
  EXPECT_GT(meeting_edges, 10000);
}

/// A comb along the diagonal: long edges whose boxes all overlap.
Ring slanted_comb(std::size_t teeth) {
  Ring ring;
  for (std::size_t i = 0; i < teeth; ++i) {
    const auto at = static_cast<double>(4 * i);
    const double length = static_cast<double>(8 * teeth);
    ring.insert(ring.end(), {{at, -at},
                             {at + length, length - at},
                             {at + length + 1, length - at - 1},
                             {at + 1, -at - 1}});
  }
  const auto end = static_cast<double>(4 * teeth);
  ring.insert(ring.end(), {{end - 10, -end - 10}, {-10, -10}});
  return ring;
}

TEST(ValidatePolygon, LongSlantedEdgesAndManyHolesTakeNoQuadraticTime) {
  Ring comb = slanted_comb(25000);
  EXPECT_EQ(verdict({comb}), "accepted");
  comb.back() = {5, 0};
  EXPECT_EQ(
      verdict({comb}),
      "a.file: ring 0, vertex 4: the edge from here crosses the edge from ring 0, vertex 100000");
  Rings plate{moved(kSquare, -10, -10, 1000)};
  for (int row = 0; row < 50; ++row)
    for (int column = 0; column < 500; ++column)
      plate.push_back(moved(kSquare, column * 12, row * 12));
  EXPECT_EQ(verdict(plate), "accepted");
  plate.push_back(moved(kSquare, 14, 14, 0.5));
  EXPECT_EQ(verdict(plate), "a.file: ring 25001: the hole lies inside ring 502, a hole");
}

TEST(RingSweep, NestingOfManyLevels) {
  Rings rings;
  for (int i = 0; i < 50; ++i) rings.push_back(moved(kSquare, i, i, (1000 - 2 * i) / 8.0));
  std::reverse(rings[7].begin(), rings[7].end());
  const auto nesting = nesting_of_disjoint_rings(rings);
  ASSERT_TRUE(nesting);
  EXPECT_EQ(nesting->around[0], std::nullopt);
  for (std::size_t i = 1; i < rings.size(); ++i) EXPECT_EQ(nesting->around[i], i - 1);
}

}  // namespace
}  // namespace quadbound
