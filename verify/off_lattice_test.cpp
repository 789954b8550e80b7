// SPDX-License-Identifier: Apache-2.0
// What stands in front of rationals against rationals: fixed point, fractions, rounding to doubles,
// and the survey of meshes with vertices off the lattice.
#include "verify/off_lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "verify/links.hpp"
#include "verify/places.hpp"
#include "verify/plane.hpp"
#include "verify/survey.hpp"
#include "verify/test_meshes.hpp"

namespace quadbound::judge {
namespace {

using Random = std::mt19937_64;

const Threads kOne(1);
const Rational kTiny = Rational(1) / boost::multiprecision::pow(Integer(10), 30);

/// Of all sizes up to 2^60 and beyond, near to integers and not, with short and long denominators.
Rational random_coordinate(Random& random) {
  const Rational size = dyadic(1, static_cast<int>(random() % 64) - 2);
  Rational value = dyadic(static_cast<std::int64_t>(random()), -63) * size;
  if (random() % 2 == 0) value = std::floor(nearest_double(value));
  switch (random() % 4) {
    case 0:
      return value + Rational(static_cast<int>(random() % 7), 3);
    case 1:
      return value + Rational(static_cast<int>(random() % 3) - 1) * kTiny;
    case 2:
      return value + dyadic(static_cast<int>(random() % 3) - 1, -64);
    default:
      return value + Rational(1 + random() % 1000) / Rational(1 + random() % (1ULL << 62));
  }
}

Rational value_of(const Fixed& fixed) {
  return to_rational(fixed.value) * dyadic(1, -Fixed::kBits);
}

void expect_encloses(const Fixed& fixed, const Rational& exact) {
  const Rational value = value_of(fixed);
  EXPECT_LE(value, exact);
  EXPECT_LT(exact, value + dyadic(1, -Fixed::kBits));
  EXPECT_EQ(fixed.is_exact, value == exact);
}

void expect_equal(const LatticeFraction& fraction, const Rational& exact, bool& is_long) {
  is_long |= fraction.denominator == 0;
  if (fraction.denominator == 0) return;
  EXPECT_LT(fraction.remainder, fraction.denominator);
  EXPECT_LT(fraction.denominator, std::uint64_t{1} << 62);
  EXPECT_EQ(fraction.floor + Rational(fraction.remainder) / Rational(fraction.denominator), exact);
}

TEST(OffLattice, EnclosesEveryCoordinate) {
  Random random(1);
  for (const int exponent : {-1060, -80, -3, 0, 5, 70, 900}) {
    Vertices vertices(exponent);
    const Rational unit = dyadic(1, exponent);
    std::vector<RationalPoint> exact;
    for (int i = 0; i < 2000; ++i) {
      exact.push_back({random_coordinate(random), random_coordinate(random)});
      vertices.add_exact({exact.back().x * unit, exact.back().y * unit});
    }
    const OffLattice table(vertices, kOne);
    int found = 0;
    bool is_long = false;
    for (VertexId v = 0; v < vertices.size(); ++v) {
      const Rational size = std::max(Rational(abs(exact[v].x)), Rational(abs(exact[v].y)));
      const FixedPoint* point = table.find(v);
      EXPECT_EQ(point != nullptr, !vertices.on_lattice(v) && size < kMaxLatticeCoordinate);
      if (point == nullptr) continue;
      ++found;
      expect_encloses(point->x, exact[v].x);
      expect_encloses(point->y, exact[v].y);
      expect_equal(table.fractions(v).x, exact[v].x, is_long);
      expect_equal(table.fractions(v).y, exact[v].y, is_long);
    }
    EXPECT_GT(found, 1000);
    EXPECT_TRUE(is_long);
  }
}

TEST(OffLattice, TakesFractionsAsTheyAre) {
  Random random(4);
  for (const int exponent : {-80, 0, 5}) {
    Vertices vertices(exponent);
    const Rational unit = dyadic(1, exponent);
    for (int i = 0; i < 2000; ++i) {
      const std::uint64_t denominator = (random() >> (2 + random() % 60)) | 2U;
      const LatticeFraction x{static_cast<std::int64_t>(random() >> 4) - (1LL << 59),
                              1 + random() % (denominator - 1), denominator};
      const LatticeFraction y{static_cast<std::int64_t>(random() % 3) - 1};
      vertices.add_fraction(i % 2 == 0 ? FractionPoint{x, y} : FractionPoint{y, x});
    }
    const OffLattice table(vertices, kOne);
    bool is_long = false;
    for (VertexId v = 0; v < vertices.size(); ++v) {
      const RationalPoint exact = vertices.exact(v);
      ASSERT_NE(table.find(v), nullptr);
      expect_encloses(table.find(v)->x, exact.x / unit);
      expect_encloses(table.find(v)->y, exact.y / unit);
      expect_equal(table.fractions(v).x, exact.x / unit, is_long);
      expect_equal(table.fractions(v).y, exact.y / unit, is_long);
    }
    EXPECT_FALSE(is_long);
  }
}

TEST(OffLattice, NothingIsKeptOfVerticesOnTheLatticeOrBeyondIt) {
  Vertices vertices(0);
  vertices.add({1, 2});
  vertices.add({kMaxLatticeCoordinate + 1, 0});  // as foreign code may do
  EXPECT_EQ(OffLattice(vertices, kOne).find(1), nullptr);
  vertices.add_exact({Rational(1, 3), Rational(kMaxLatticeCoordinate) + Rational(3, 2)});
  const OffLattice table(vertices, kOne);
  for (VertexId v = 0; v < 3; ++v) EXPECT_EQ(table.find(v), nullptr);
}

TEST(OffLattice, SignsOfDifferencesAreThoseOfTheRationals) {
  Random random(2);
  Vertices vertices(0);
  for (int i = 0; i < 4000; ++i) {
    const Rational x = random_coordinate(random) / dyadic(1, static_cast<int>(random() % 40));
    const int nudge = static_cast<int>(random() % 3) - 1;
    vertices.add_exact({x, Rational(x + nudge * kTiny)});
  }
  const ExactPlane plane(vertices, kOne);
  int hidden = 0;
  for (VertexId v = 0; v < vertices.size(); ++v) {
    const auto point = plane.fixed(v);
    if (!point) continue;
    const RationalPoint exact = plane.rational(v);
    const auto sign = sign_of_difference(point->x, point->y);
    hidden += sign ? 0 : 1;
    EXPECT_EQ(sign.value_or(exact.y.compare(exact.x)) <=> 0, exact.y.compare(exact.x) <=> 0);
  }
  EXPECT_GT(hidden, 100);
}

/// Coordinates whose rounding to doubles is close: ties, and next to ties.
Rational near_tie(Random& random) {
  const auto mantissa = static_cast<std::int64_t>((random() >> 11) | (1ULL << 52));
  const Rational tie = Rational(2 * mantissa + 1) * dyadic(1, static_cast<int>(random() % 7) - 1);
  const Rational value = tie + (static_cast<int>(random() % 3) - 1) * kTiny;
  return random() % 2 == 0 ? value : Rational(-value);
}

TEST(StoredPlane, RoundsInFixedPointAsInRationals) {
  Random random(3);
  for (const int exponent : {-1040, -1010, -20, 0, 963, 990}) {
    Vertices vertices(exponent);
    const Rational unit = dyadic(1, exponent);
    for (int i = 0; i < 3000; ++i) {
      const Rational x = i % 2 == 0 ? near_tie(random) : random_coordinate(random);
      vertices.add_exact({x * unit, (Rational(1, 3) - x / dyadic(1, i % 80)) * unit});
    }
    const ExactPlane exact(vertices, kOne);
    const StoredPlane stored(vertices, exact);
    int found = 0;
    for (VertexId v = 0; v < vertices.size(); ++v) {
      const Point rounded = vertices.rounded(v);
      const bool is_finite = std::isfinite(rounded.x) && std::isfinite(rounded.y);
      EXPECT_EQ(stored.is_finite(v), is_finite);
      if (!is_finite) continue;
      EXPECT_EQ(stored.changes(v), exact_value(rounded) != vertices.exact(v));
      const auto point = stored.fixed(v);
      if (!point) continue;
      ++found;
      EXPECT_TRUE(point->x.is_exact && point->y.is_exact);
      EXPECT_EQ((RationalPoint{value_of(point->x), value_of(point->y)}), stored.rational(v));
    }
    EXPECT_EQ(found > 1000, -1010 <= exponent && exponent <= 963) << exponent << " " << found;
  }
}

// --- the survey ----------------------------------------------------------------------------------

struct Expected {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  CornerId smallest{};
  CornerId largest{};
  std::vector<std::uint8_t> passes;
};

/// All in rationals; of convex quads.
template <class Plane>
Expected survey_slowly(const Plane& plane, const std::vector<Quad>& quads,
                       const AngleInterval& interval) {
  Expected expected;
  std::optional<Corner<Rational>> smallest;
  std::optional<Corner<Rational>> largest;
  for (std::size_t q = 0; q < quads.size(); ++q) {
    unsigned lower = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const CornerId id{q, static_cast<int>(i)};
      const RationalPoint at = plane.rational(quads[q][i]);
      const RationalPoint next = plane.rational(quads[q][(i + 1) % 4]);
      const auto corner = corner_at<Rational>(at, next, plane.rational(quads[q][(i + 3) % 4]));
      if (!at_least(corner, interval.smallest)) ++expected.low;
      if (!at_most_straight_minus(corner, interval.from_straight)) ++expected.high;
      if (!smallest || is_smaller(corner, *smallest)) {
        smallest = corner;
        expected.smallest = id;
      }
      if (!largest || is_smaller(*largest, corner)) {
        largest = corner;
        expected.largest = id;
      }
      const bool down = next.y < at.y || (next.y == at.y && next.x < at.x);
      lower |= static_cast<unsigned>(down) << i;
    }
    expected.passes.push_back(lower & ((lower << 1) | (lower >> 3)) & 15U);
  }
  return expected;
}

template <class Plane>
Survey expect_as_in_rationals(const Plane& plane, const std::vector<Quad>& quads,
                              const AngleInterval& interval) {
  const Expected expected = survey_slowly(plane, quads, interval);
  std::vector<std::uint8_t> passes;
  Survey survey = survey_quads(plane, quads, interval, {}, kOne, passes);
  EXPECT_EQ(survey.smallest.broken, expected.low);
  EXPECT_EQ(survey.largest.broken, expected.high);
  EXPECT_EQ(survey.smallest.extreme->id, expected.smallest);
  EXPECT_EQ(survey.largest.extreme->id, expected.largest);
  EXPECT_EQ(survey.not_convex, 0U);
  EXPECT_EQ(passes, expected.passes);
  return survey;
}

/// Where a corner of the sheared grid is exactly on the bound, at many places, and nearly there.
std::vector<test::Case> close_cases() {
  Random random(4);
  std::vector<test::Case> bases{test::square_grid(6, 5), test::sheared_grid(6, 5, 2),
                                test::sheared_grid(6, 5, Rational(-1, 2)),
                                test::perturbed_grid(6, 5, random)};
  for (const Rational& nudge : {kTiny, Rational(-kTiny)})
    bases.push_back(test::sheared_grid(6, 5, 2 + nudge));
  const Rational far = dyadic(1, 59) + Rational(1, 7);
  std::vector<test::Case> cases;
  for (const test::Case& base : bases) {
    for (const Rational& shift : {Rational(0), Rational(1, 7), far, Rational(-far)}) {
      for (const Rational& scale : {Rational(1), Rational(100, 3), Rational(dyadic(1, 55) / 3)})
        cases.push_back(test::mapped(base, "moved", scale, shift, 0));
      cases.push_back(
          test::mapped(base, "shorter than the filter takes", Rational(1, 99), shift, 0));
    }
  }
  return cases;
}

TEST(Survey, CornersOnABoundAndNextToItAreDecidedAsInRationals) {
  for (const test::Case& made : close_cases()) {
    SCOPED_TRACE(made.name);
    const ExactPlane plane(made.mesh.vertices, kOne);
    for (const AngleInterval& interval : {kTheorem1, kTheorem13})
      expect_as_in_rationals(plane, made.mesh.quads, interval);
  }
}

TEST(Survey, RoundedCornersAreDecidedAsInRationals) {
  for (const test::Case& made : close_cases()) {
    SCOPED_TRACE(made.name);
    const ExactPlane exact(made.mesh.vertices, kOne);
    const StoredPlane stored(made.mesh.vertices, exact);
    const Expected convex = survey_slowly(stored, made.mesh.quads, {{1, 1000}, {1, 1000}});
    if (convex.low + convex.high > 0) continue;  // rounding flattened it
    expect_as_in_rationals(stored, made.mesh.quads, kTheorem1);
  }
}

/// Every third vertex is moved off the lattice, by less than the others notice.
Mesh with_every_third_moved(const Mesh& mesh) {
  Mesh moved = mesh;
  moved.vertices = Vertices(mesh.vertices.exponent());
  for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
    RationalPoint point = mesh.vertices.exact(v);
    if (v % 3 == 0) point.x += kTiny / 3;
    moved.vertices.add_exact(point);
  }
  return moved;
}

void expect_same(const BoundTally& a, const BoundTally& b) {
  EXPECT_EQ(a.broken, b.broken);
  ASSERT_EQ(a.extreme.has_value(), b.extreme.has_value());
  if (!a.extreme) return;
  EXPECT_EQ(a.extreme->id, b.extreme->id);
  const Corner<Rational> corner = a.extreme->exact();
  const Corner<Rational> other = b.extreme->exact();
  EXPECT_EQ(corner.cross, other.cross);
  EXPECT_EQ(corner.dot, other.dot);
}

void expect_same(const Survey& a, const Survey& b) {
  expect_same(a.smallest, b.smallest);
  expect_same(a.largest, b.largest);
  EXPECT_EQ(a.not_convex, b.not_convex);
  EXPECT_EQ(a.first_not_convex, b.first_not_convex);
}

/// Guarantees 1 and 2 of survey_both. Returns how many vertices rounding moves.
std::ptrdiff_t expect_both_surveys(const Mesh& mesh, const AngleInterval& interval,
                                   std::span<const CornerId> exempt) {
  const ExactPlane exact(mesh.vertices, kOne);
  const StoredPlane stored(mesh.vertices, exact);
  const CornersByVertex corners(mesh.quads, mesh.vertices.size(), kOne);
  const MovedVertices moved = find_moved(stored, corners, kOne);
  std::vector<std::uint8_t> passes;
  std::vector<std::uint8_t> expected_passes;
  std::vector<std::uint8_t> unused;
  const Surveys both =
      survey_both(exact, stored, moved.is_moved, mesh.quads, interval, exempt, kOne, passes);
  const Survey before = survey_quads(exact, mesh.quads, interval, exempt, kOne, expected_passes);
  const Survey after = survey_quads(stored, mesh.quads, interval, exempt, kOne, unused);
  expect_same(both.exact, before);
  expect_same(both.stored, after);
  EXPECT_EQ(both.exact.lattice_area.value(), before.lattice_area.value());
  EXPECT_EQ(
      both.exact.decisions.filter + both.exact.decisions.lattice + both.exact.decisions.rational,
      4 * mesh.quads.size());
  EXPECT_EQ(both.stored.smallest.beyond_slack, after.smallest.beyond_slack);
  EXPECT_EQ(both.stored.largest.beyond_slack, after.largest.beyond_slack);
  EXPECT_EQ(passes, expected_passes);
  return std::count(moved.is_moved.begin(), moved.is_moved.end(), 1);
}

TEST(Survey, BothSurveysInOneGoAreThoseOfEitherPlane) {
  const std::vector<CornerId> exempt{{0, 1}, {3, 2}, {7, 0}};
  std::ptrdiff_t moved = 0;
  for (const test::Case& made : close_cases()) {
    SCOPED_TRACE(made.name);
    for (const AngleInterval& interval :
         {kTheorem1, kTheorem13, AngleInterval{{1, 1}, {1, 1}}, AngleInterval{{5, 1}, {5, 1}}}) {
      moved += expect_both_surveys(made.mesh, interval, {});
      moved += expect_both_surveys(with_every_third_moved(made.mesh), interval, exempt);
    }
  }
  EXPECT_GT(moved, 0);
}

TEST(Survey, FilterDecidesNearlyAllCornersOffTheLattice) {
  Random random(5);
  const test::Case made = test::mapped(test::perturbed_grid(60, 50, random), "thirds",
                                       Rational(1000, 3), dyadic(1, 40) + Rational(1, 7), 0);
  const ExactPlane plane(made.mesh.vertices, kOne);
  EXPECT_EQ(made.mesh.vertices.off_lattice_count(), made.mesh.vertices.size());
  const Survey survey = expect_as_in_rationals(plane, made.mesh.quads, kTheorem13);
  EXPECT_EQ(survey.decisions.filter + survey.decisions.rational, 4 * made.mesh.quads.size());
  EXPECT_LT(survey.decisions.rational, 200U);
  EXPECT_EQ(survey.decisions.lattice, 0U);
}

TEST(Survey, ChosenCornersAreJudgedAsInRationals) {
  for (const test::Case& made : close_cases()) {
    SCOPED_TRACE(made.name);
    const ExactPlane plane(made.mesh.vertices, kOne);
    std::vector<CornerId> corners;
    for (std::uint64_t q = 0; q < made.mesh.quads.size(); ++q)
      for (int i = 0; i < 4; ++i) corners.push_back({q, i});
    for (const AngleInterval& interval : {kTheorem1, AngleInterval{{1, 1}, {2, 1}}}) {
      const Expected expected = survey_slowly(plane, made.mesh.quads, interval);
      const Survey survey = survey_corners(plane, made.mesh.quads, interval, corners);
      EXPECT_EQ(survey.smallest.broken, expected.low);
      EXPECT_EQ(survey.largest.broken, expected.high);
      EXPECT_EQ(survey.smallest.extreme->id, expected.smallest);
      EXPECT_EQ(survey.largest.extreme->id, expected.largest);
    }
  }
}

}  // namespace
}  // namespace quadbound::judge
