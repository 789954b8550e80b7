// SPDX-License-Identifier: Apache-2.0
// Judging the judge by hand: for every claim a mesh that breaks it, and nothing else where that is
// possible. Where it is not, the test lists what must break with it.
#include "verify/verify.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "verify/test_meshes.hpp"

namespace quadbound::test {
namespace {

using Names = std::set<std::string>;

Names with_verdict(const Report& report, Verdict verdict) {
  Names names;
  for (const Claim& claim : report.claims)
    if (claim.id != report.theorem && claim.exact == verdict) names.insert(claim.id);
  return names;
}

/// Judges a mesh of which exactly these claims must fail and these others be undecided.
Report expect(const Case& made, const Names& failing, const Names& undecided = {}) {
  Report report = verify_points(made.points, made.mesh);
  EXPECT_EQ(with_verdict(report, Verdict::fails), failing) << made.name << "\n" << to_text(report);
  EXPECT_EQ(with_verdict(report, Verdict::not_decided), undecided) << made.name << "\n"
                                                                   << to_text(report);
  const Verdict theorem = !failing.empty()     ? Verdict::fails
                          : !undecided.empty() ? Verdict::not_decided
                                               : Verdict::holds;
  EXPECT_EQ(report.find("thm-1")->exact, theorem);
  return report;
}

const Names kMalformed{"distinct-vertices",
                       "conforming",
                       "strictly-convex",
                       "one-boundary",
                       "no-overlap",
                       "euler",
                       "area",
                       "points-kept",
                       "min-angle",
                       "max-angle"};

Case empty_case(const char* name, int exponent = 0) {
  Case made;
  made.name = name;
  made.mesh.vertices = Vertices(exponent);
  made.mesh.cells = 1000;
  return made;
}

TEST(VerifyPoints, ValidMeshesHold) {
  for (const Case& made : valid_cases(1)) {
    ASSERT_LE(made.mesh.quads.size(), 60U);
    const Report report = expect(made, {});
    EXPECT_TRUE(report.holds());
    EXPECT_EQ(report.used_vertices + report.quads, report.edges + 1);
    EXPECT_EQ(report.boundary_loops, 1U);
  }
}

TEST(VerifyPoints, UnusedVerticesAreCountedAndBreakNothing) {
  Case made = square_grid(2, 2);
  add(made.mesh, 0, 0);
  add(made.mesh, 1, Rational(1, 3));
  EXPECT_EQ(expect(made, {}).unused_vertices, 2U);
}

// --- all-quad ------------------------------------------------------------------------------------

TEST(AllQuad, TriangleBreaksIt) {
  Case made = square_grid(2, 2);
  made.mesh.other_faces.push_back({0, 1, add(made.mesh, 0, -1)});
  EXPECT_EQ(expect(made, {"all-quad"}).find("all-quad")->detail,
            "1 faces are no quads; the first has 3 sides");
}

TEST(AllQuad, PentagonBreaksIt) {
  Case made = square_grid(2, 2);
  const VertexId below = add(made.mesh, 0, -1);
  made.mesh.other_faces.push_back({0, below, add(made.mesh, 1, -1), 2, 1});
  EXPECT_EQ(expect(made, {"all-quad"}).find("all-quad")->detail,
            "1 faces are no quads; the first has 5 sides");
}

TEST(AllQuad, EmptyMeshBreaksIt) { expect(empty_case("empty"), {"all-quad"}, kMalformed); }

TEST(AllQuad, VertexThatDoesNotExistBreaksIt) {
  Case made = square_grid(2, 2);
  made.mesh.quads[3][1] = 99;
  const Report report = expect(made, {"all-quad"}, kMalformed);
  EXPECT_EQ(report.find("all-quad")->place->quad, 3U);
  made.mesh.quads[3][1] = kNoVertex;
  expect(made, {"all-quad"}, kMalformed);
}

TEST(AllQuad, RepeatedVertexBreaksIt) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Case made = square_grid(2, 2);
      made.mesh.quads[2][i] = made.mesh.quads[2][j];
      EXPECT_EQ(expect(made, {"all-quad"}, kMalformed).find("all-quad")->place->quad, 2U);
    }
  }
}

// --- conforming and distinct-vertices ------------------------------------------------------------

TEST(Conforming, DoubledQuadBreaksIt) {
  Case made = square_grid(3, 3);
  made.mesh.quads.push_back(made.mesh.quads[4]);
  made.mesh.cells = 9;
  const Report report = expect(made, {"conforming", "euler", "area"}, {"no-overlap"});
  EXPECT_EQ(report.find("conforming")->detail, "directed edge 5 -> 6 belongs to quads 4 and 9");
}

TEST(Conforming, HangingNodeIsNamed) {
  // The left one of two unit squares becomes two; the right one keeps its whole side.
  Case made = empty_case("hanging node", -1);
  for (const int y : {0, 1})
    for (const int x : {0, 1, 2}) add(made.mesh, x, y);
  const VertexId left = add(made.mesh, 0, Rational(1, 2));
  const VertexId hanging = add(made.mesh, 1, Rational(1, 2));
  made.mesh.quads = {{0, 1, hanging, left}, {left, hanging, 4, 3}, {1, 2, 5, 4}};
  const Report report =
      expect(made, {"conforming", "one-boundary", "euler"}, {"no-overlap", "area"});
  const Claim& claim = *report.find("conforming");
  EXPECT_EQ(claim.detail, "hanging node: vertex 7 lies inside the edge 4 -> 1 of quad 2");
  EXPECT_EQ(claim.place->vertex, hanging);
  EXPECT_EQ(claim.place->position, (RationalPoint{1, Rational(1, 2)}));
}

TEST(DistinctVertices, SlitIsFound) {
  // The two quads above the inner edges 6 - 7 and 7 - 8 get a vertex of their own at the place
  // of 7.
  Case made = square_grid(4, 2);
  const VertexId second = add(made.mesh, 2, 1);
  made.mesh.quads[5][1] = second;
  made.mesh.quads[6][0] = second;
  const Report report =
      expect(made, {"distinct-vertices", "one-boundary", "euler"}, {"no-overlap"});
  EXPECT_EQ(report.find("distinct-vertices")->detail, "vertices 7 and 15 are at one place");
  EXPECT_EQ(report.find("one-boundary")->place->vertex, 6U);
}

TEST(DistinctVertices, SlitBetweenVerticesOffTheLatticeIsFound) {
  // The same, with 7 and its double a third of a unit to the right, once as rationals and once as
  // fractions.
  Case made = square_grid(4, 2);
  const LatticePoint at = made.mesh.vertices.lattice(7);
  const VertexId second = made.mesh.vertices.add_fraction({{at.x, 2, 6}, {at.y}});
  made.mesh.vertices.move_to_exact(7, made.mesh.vertices.exact(second));
  made.mesh.quads[5][1] = second;
  made.mesh.quads[6][0] = second;
  const Report report =
      expect(made, {"distinct-vertices", "one-boundary", "euler"}, {"no-overlap"});
  EXPECT_EQ(report.find("distinct-vertices")->detail, "vertices 7 and 15 are at one place");
}

TEST(DistinctVertices, TwoVerticesAtOnePlaceOnTheBoundaryAreFound) {
  // Two squares that touch along an edge without sharing its vertices.
  Case made = empty_case("two squares side by side");
  for (const int x : {0, 1, 1, 2})
    for (const int y : {0, 1}) add(made.mesh, x, y);
  made.mesh.quads = {{0, 2, 3, 1}, {4, 6, 7, 5}};
  const Report report =
      expect(made, {"distinct-vertices", "one-boundary", "euler", "area"}, {"no-overlap"});
  EXPECT_EQ(report.find("distinct-vertices")->detail, "vertices 2 and 4 are at one place");
}

// --- strictly-convex -----------------------------------------------------------------------------

TEST(StrictlyConvex, ConcaveQuadBreaksItAndTheUpperBound) {
  Case made = empty_case("concave", -4);
  add(made.mesh, 0, 0);
  add(made.mesh, 4, 0);
  add(made.mesh, Rational(3, 2), Rational(3, 2));
  add(made.mesh, 0, 4);
  made.mesh.quads = {{0, 1, 2, 3}};
  const Report report = expect(made, {"strictly-convex", "max-angle"}, {"no-overlap"});
  EXPECT_EQ(report.find("strictly-convex")->worst->place.corner, 2);
  EXPECT_GT(report.find("max-angle")->worst->degrees(), 180);
}

TEST(StrictlyConvex, CornerOf180DegreesBreaksItAndTheUpperBound) {
  Case made = empty_case("straight corner");
  add(made.mesh, 0, 0);
  add(made.mesh, 4, 0);
  add(made.mesh, 2, 2);
  add(made.mesh, 0, 4);
  made.mesh.quads = {{0, 1, 2, 3}};
  const Report report = expect(made, {"strictly-convex", "max-angle"}, {"no-overlap"});
  EXPECT_EQ(report.find("max-angle")->worst->degrees(), 180);
}

TEST(StrictlyConvex, ZeroAreaQuadBreaksIt) {
  Case made = empty_case("zero area");
  for (const int x : {0, 1, 3, 2}) add(made.mesh, x, x);
  made.mesh.quads = {{0, 1, 2, 3}};
  // Its edges lie on each other, so that the boundary meets itself and vertices hang.
  expect(made, {"strictly-convex", "min-angle", "max-angle", "one-boundary", "conforming"},
         {"no-overlap"});
}

TEST(StrictlyConvex, FlippedQuadBreaksItAndDoublesEdges) {
  Case made = square_grid(3, 3);
  std::swap(made.mesh.quads[4][1], made.mesh.quads[4][3]);
  const Report report = expect(
      made, {"strictly-convex", "conforming", "max-angle", "one-boundary", "area"}, {"no-overlap"});
  EXPECT_EQ(report.find("strictly-convex")->worst->place.quad, 4U);
}

TEST(StrictlyConvex, MirroredMeshBreaksItEverywhere) {
  Case made = square_grid(2, 2);
  for (Quad& q : made.mesh.quads) std::swap(q[1], q[3]);
  const Report report = expect(made, {"strictly-convex", "max-angle"}, {"no-overlap"});
  EXPECT_EQ(report.find("strictly-convex")->detail, "16 corners do not turn left");
}

// --- one-boundary and no-overlap -----------------------------------------------------------------

TEST(OneBoundary, DroppedQuadLeavesASecondLoop) {
  Case made = square_grid(3, 3);
  made.mesh.quads.erase(made.mesh.quads.begin() + 4);
  const Report report = expect(made, {"one-boundary", "euler", "area"}, {"no-overlap"});
  EXPECT_EQ(report.boundary_loops, 2U);
  const Claim& claim = *report.find("one-boundary");
  EXPECT_EQ(claim.place->vertex, 5U);
  EXPECT_EQ(claim.detail,
            "the unpaired edges form 2 closed loops; one that is not the outermost has 4 edges");
}

TEST(OneBoundary, RingWithAHoleHasTwoLoops) {
  Case made = square_grid(5, 4);
  std::vector<Quad> kept;
  for (std::size_t q = 0; q < 20; ++q)
    if (q / 5 == 0 || q / 5 == 3 || q % 5 == 0 || q % 5 == 4) kept.push_back(made.mesh.quads[q]);
  made.mesh.quads = kept;
  made.points.points.clear();
  EXPECT_EQ(expect(made, {"one-boundary", "euler", "area"}, {"no-overlap"}).boundary_loops, 2U);
}

TEST(OneBoundary, TwoComponentsHaveTwoLoops) {
  Case made = square_grid(3, 1);
  made.mesh.quads.erase(made.mesh.quads.begin() + 1);
  EXPECT_EQ(expect(made, {"one-boundary", "euler", "area"}, {"no-overlap"}).boundary_loops, 2U);
}

TEST(OneBoundary, PinchedBoundaryIsNamed) {
  Case made = square_grid(2, 2);
  made.mesh.quads = {made.mesh.quads[0], made.mesh.quads[3]};
  made.points.points.clear();
  const Report report = expect(made, {"one-boundary"}, {"no-overlap", "area"});
  EXPECT_EQ(report.find("one-boundary")->place->vertex, 4U);
}

/// A strip of unit squares from the origin right, up and left, whose last quad hangs down from
/// y = 2 to y = end over the first ones, between x = left and x = left + 1.
Case hooked_strip(const char* name, const Rational& left, const Rational& end) {
  Case made = empty_case(name, -8);
  const Positions positions{{0, 0},    {1, 0},      {2, 0},         {3, 0},        {0, 1},
                            {1, 1},    {2, 1},      {3, 1},         {2, 2},        {3, 2},
                            {2, 3},    {3, 3},      {left + 1, 2},  {left + 1, 3}, {left, 2},
                            {left, 3}, {left, end}, {left + 1, end}};
  for (const RationalPoint& p : positions) made.mesh.vertices.add_exact(p);
  made.mesh.quads = {{0, 1, 5, 4},   {1, 2, 6, 5},    {2, 3, 7, 6},     {6, 7, 9, 8},
                     {8, 9, 11, 10}, {12, 8, 10, 13}, {14, 12, 13, 15}, {16, 17, 12, 14}};
  return made;
}

TEST(NoOverlap, HookedStripWithoutContactHolds) {
  Case made = hooked_strip("no contact", 0, Rational(3, 2));
  expect(made, {});
}

TEST(NoOverlap, StripWhoseEndsOverlapIsFound) {
  Case made = hooked_strip("overlap", Rational(1, 4), Rational(1, 2));
  const Report report = expect(made, {"one-boundary", "no-overlap"});
  EXPECT_NE(report.find("no-overlap")->detail.find("cross"), std::string::npos);
}

TEST(NoOverlap, StripWhoseEndsTouchIsNoSimpleBoundary) {
  Case made = hooked_strip("touching in a vertex", -1, 1);
  expect(made, {"one-boundary", "distinct-vertices"}, {"no-overlap"});
  made = hooked_strip("touching along an edge", Rational(1, 4), 1);
  expect(made, {"one-boundary", "conforming"}, {"no-overlap"});
}

/// Eight quads around a vertex, each of a quarter turn.
Case double_turn() {
  Case made = empty_case("two turns");
  Mesh& mesh = made.mesh;
  const VertexId centre = add(mesh, 0, 0);
  const std::array<std::array<int, 2>, 4> directions{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const auto spoke = [&](int i, int k) {
    return directions[static_cast<std::size_t>(i % 4)][static_cast<std::size_t>(k)] * (8 + i % 8);
  };
  for (int i = 0; i < 8; ++i) add(mesh, spoke(i, 0), spoke(i, 1));
  for (int i = 0; i < 8; ++i) {
    const VertexId corner = add(mesh, spoke(i, 0) + spoke(i + 1, 0), spoke(i, 1) + spoke(i + 1, 1));
    const auto first = static_cast<VertexId>(1 + i);
    const auto last = static_cast<VertexId>(1 + (i + 1) % 8);
    mesh.quads.push_back({centre, first, corner, last});
  }
  return made;
}

TEST(NoOverlap, TwoTurnsAroundAVertexAreFound) {
  const Report report = expect(double_turn(), {"one-boundary", "no-overlap"});
  EXPECT_EQ(report.find("no-overlap")->detail, "the quads around vertex 0 make 2 turns");
}

TEST(NoOverlap, BoundaryVertexInsideOtherQuadsIsFound) {
  // The middle of four squares is also a corner of a fifth, which lies on them.
  Case made = square_grid(2, 2);
  const VertexId a = add(made.mesh, Rational(3, 2), Rational(5, 4));
  const VertexId b = add(made.mesh, Rational(7, 4), Rational(7, 4));
  const VertexId c = add(made.mesh, Rational(5, 4), Rational(3, 2));
  made.mesh.quads.push_back({4, a, b, c});
  const Report report = expect(made, {"one-boundary", "no-overlap", "area"});
  EXPECT_EQ(report.find("no-overlap")->place->vertex, 4U);
}

// --- points-kept ---------------------------------------------------------------------------------

TEST(PointsKept, PointNudgedByOneUlpIsFound) {
  for (const Case& base : {square_grid(3, 3), mapped(square_grid(3, 3), "moved", 3, 7, -2)}) {
    for (const double towards : {-1e9, 1e9}) {
      for (const bool in_x : {true, false}) {
        Case made = base;
        Point& point = made.points.points.back();
        double& value = in_x ? point.x : point.y;
        value = std::nextafter(value, towards);
        const Report report = expect(made, {"points-kept"});
        EXPECT_NE(report.find("points-kept")->detail.find("1 input points"), std::string::npos);
      }
    }
  }
}

TEST(PointsKept, VertexNudgedByOneLatticeUnitIsFound) {
  Case made = square_grid(3, 3);
  made.mesh.vertices.move_to(6, {2 * 1024 + 1, 1024});
  expect(made, {"points-kept"});
}

TEST(PointsKept, PointAtAnUnusedVertexIsLost) {
  Case made = square_grid(2, 2);
  add(made.mesh, 5, 5);
  made.points.points.push_back({5, 5});
  expect(made, {"points-kept"});
}

TEST(PointsKept, PointThatIsNotFiniteIsLost) {
  Case made = square_grid(2, 2);
  made.points.points.push_back({std::numeric_limits<double>::quiet_NaN(), 0});
  expect(made, {"points-kept"});
}

TEST(PointsKept, RepeatedPointsAndPointsOffTheLatticeAreFound) {
  Case made = square_grid(2, 2);
  made.mesh.vertices.move_to_exact(4, exact_value(Point{1.1, 0.9}));
  made.points.points = {{0, 0}, {1.1, 0.9}, {0, 0}, {1.1, 0.9}, {2, 1}};
  expect(made, {});
  made.points.points[3].x = std::nextafter(1.1, 2);
  expect(made, {"points-kept"});
}

// --- min-angle, max-angle ------------------------------------------------------------------------

/// One quad, from the corner at the origin.
Case one_quad(const RationalPoint& next, const RationalPoint& opposite, const RationalPoint& last) {
  Case made = empty_case("one quad");
  for (const RationalPoint& p : {RationalPoint{0, 0}, next, opposite, last})
    made.mesh.vertices.add_exact(p);
  made.mesh.quads = {{0, 1, 2, 3}};
  return made;
}

TEST(MinAngle, DecidedToTheLastUnitOnAndOffTheLattice) {
  const auto big = Rational(boost::multiprecision::mpz_int(1) << 57);
  for (const Rational& unit : {Rational(1), Rational(1, 3)}) {
    for (const Rational& size : {Rational(16), Rational(big)}) {
      const auto judged = [&](int nudge) {
        const Rational s = size * unit;
        return one_quad({2 * s, 0}, {5 * s / 2, 3 * s / 4}, {2 * s, s + nudge * unit});
      };
      expect(judged(0), {});
      expect(judged(1), {});
      const Report report = expect(judged(-1), {"min-angle"});
      EXPECT_EQ(report.find("min-angle")->worst->place.corner, 0);
      EXPECT_EQ(report.find("min-angle")->worst->tangent(), Rational((size - 1) / (2 * size)));
      const Report on = expect(judged(0), {});
      EXPECT_EQ(on.find("min-angle")->worst->tangent(), Rational(1, 2));
    }
  }
}

TEST(MaxAngle, DecidedToTheLastUnitOnAndOffTheLattice) {
  const auto big = Rational(boost::multiprecision::mpz_int(1) << 57);
  for (const Rational& unit : {Rational(1), Rational(1, 3)}) {
    for (const Rational& size : {Rational(64), Rational(big)}) {
      const auto judged = [&](int nudge) {
        const Rational s = size * unit;
        return one_quad({s, 0}, {0, 2 * s}, {-2 * s, s + nudge * unit});
      };
      expect(judged(0), {});
      expect(judged(1), {});
      const Report report = expect(judged(-1), {"max-angle"});
      EXPECT_EQ(report.find("max-angle")->worst->place.corner, 0);
      EXPECT_EQ(report.find("max-angle")->worst->tangent(), Rational((1 - size) / (2 * size)));
    }
  }
}

TEST(MaxAngle, RightAnglesHaveNoTangent) {
  const Report report = expect(square_grid(1, 1), {});
  EXPECT_EQ(report.find("max-angle")->worst->tangent(), std::nullopt);
  EXPECT_EQ(report.find("max-angle")->worst->degrees(), 90);
  EXPECT_EQ(report.find("max-angle")->worst->place.corner, 0);
}

TEST(MaxAngle, ReflexCornersBreakItAndNotTheLowerBound) {
  Case made = square_grid(1, 1);
  std::swap(made.mesh.quads[0][1], made.mesh.quads[0][3]);
  expect(made, {"strictly-convex", "max-angle"}, {"no-overlap"});
}

TEST(MinAngle, OtherIntervalsAreJudgedByTheirOwnBounds) {
  const Case made = one_quad({30, 0}, {36, 7}, {30, 10});
  expect(made, {"min-angle"});
  VerifyOptions options;
  options.angles = kTheorem13;
  EXPECT_TRUE(verify_points(made.points, made.mesh, options).holds());
}

TEST(Stored, BoundBrokenByRoundingAloneIsToldFromARealBreak) {
  const Case thirds = mapped(sheared_grid(2, 2, 2), "thirds", Rational(1, 3), Rational(1, 7), 0);
  const Report report = expect(thirds, {});
  EXPECT_FALSE(report.every_vertex_is_a_double);
  const StoredBound& low = *report.find("min-angle")->stored;
  EXPECT_EQ(low.verdict, StoredVerdict::within_rounding);
  EXPECT_GT(low.excess_radians, 0);
  EXPECT_LT(low.excess_radians, 1e-15);
  EXPECT_GE(low.slack_radians, low.excess_radians);

  const Case worse = mapped(sheared_grid(2, 2, Rational(201, 100)), "worse", Rational(1, 3), 0, 0);
  const Report broken = expect(worse, {"min-angle", "max-angle"});
  EXPECT_EQ(broken.find("min-angle")->stored->verdict, StoredVerdict::fails);
}

TEST(Stored, SameAsExactWhereAllVerticesAreDoubles) {
  const Report report = expect(sheared_grid(2, 2, 2), {});
  EXPECT_TRUE(report.every_vertex_is_a_double);
  for (const char* id : {"strictly-convex", "min-angle", "max-angle"})
    EXPECT_EQ(report.find(id)->stored->verdict, StoredVerdict::holds);
  const Report broken = expect(sheared_grid(2, 2, Rational(17, 8)), {"min-angle", "max-angle"});
  for (const char* id : {"min-angle", "max-angle"}) {
    EXPECT_EQ(broken.find(id)->stored->verdict, StoredVerdict::fails);
    EXPECT_NEAR(broken.find(id)->stored->excess_radians, std::atan(0.5) - std::atan2(8, 17), 1e-12);
  }
}

TEST(Stored, OverflowAndUnderflowFail) {
  const Report huge = expect(mapped(square_grid(1, 1), "huge", dyadic(1, 1025), 0, 1025), {});
  EXPECT_EQ(huge.find("min-angle")->stored->verdict, StoredVerdict::fails);
  const Report tiny = expect(mapped(square_grid(1, 1), "tiny", dyadic(1, -1080), 0, -1090), {});
  EXPECT_EQ(tiny.find("min-angle")->stored->verdict, StoredVerdict::fails);
}

// --- size-3N -------------------------------------------------------------------------------------

TEST(Size3N, ExactlyThreePerCellHoldsAndOneMoreFails) {
  Case made = square_grid(3, 3);
  made.mesh.cells = 3;
  expect(made, {});
  made = square_grid(5, 2);
  made.mesh.cells = 3;
  const Report report = expect(made, {"size-3N"});
  EXPECT_EQ(report.find("size-3N")->values[1].second, 9);
}

TEST(Size3N, NotDecidedWithoutCells) {
  Case made = square_grid(3, 3);
  made.mesh.cells = 0;
  expect(made, {}, {"size-3N"});
}

// --- places and the report -----------------------------------------------------------------------

TEST(Report, WorstCornerNamesConstructionAndLevel) {
  Case made = sheared_grid(2, 1, 1);
  made.mesh.construction_names = {"T4", "2|2"};
  made.mesh.construction = {1, 0};
  made.mesh.level = {5, 6};
  const Place place = expect(made, {}).find("min-angle")->worst->place;
  EXPECT_EQ(place.construction, "2|2");
  EXPECT_EQ(place.level, 5);
  EXPECT_EQ(place.vertex, 0U);
}

TEST(Report, JsonCarriesExactRationals) {
  const Report report = expect(mapped(sheared_grid(1, 1, 2), "thirds", Rational(1, 3), 0, 0), {});
  const std::string json = to_json(report);
  for (const char* text : {"\"format\": \"quadbound-report\"", "\"version\": 1",
                           "\"cross\": \"1/9\"", "\"dot\": \"2/9\"", "\"tan\": \"1/2\""})
    EXPECT_NE(json.find(text), std::string::npos) << text << "\n" << json;
}

TEST(Report, TextHasOneLinePerClaim) {
  const std::string text = to_text(expect(square_grid(2, 2), {}));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 13);
}

TEST(Report, SameBytesWhateverTheNumberOfThreads) {
  std::mt19937_64 random(7);
  Case made = perturbed_grid(300, 240, random);
  made.points.points.push_back({0.3, 0.4});
  const auto json = [&](unsigned threads) {
    VerifyOptions options;
    options.threads = threads;
    return to_json(verify_points(made.points, made.mesh, options));
  };
  const auto expect_same = [&] {
    const std::string alone = json(1);
    for (const unsigned threads : {2U, 3U, 0U}) EXPECT_EQ(alone, json(threads));
  };
  expect_same();
  std::shuffle(made.mesh.quads.begin(), made.mesh.quads.end(), random);
  expect_same();
  for (int i = 0; i < 40; ++i) {  // breaks nearly everything
    made.mesh.quads[random() % made.mesh.quads.size()] =
        made.mesh.quads[random() % made.mesh.quads.size()];
    made.mesh.vertices.move_to_exact(static_cast<VertexId>(random() % 60000),
                                     {Rational(static_cast<int>(random() % 900), 3), 5});
  }
  expect_same();
}

}  // namespace
}  // namespace quadbound::test
