// SPDX-License-Identifier: Apache-2.0
// Judging the judge of polygon meshes by hand: for every claim a mesh that breaks it, and nothing
// else where that is possible. Where it is not, the test lists what must break with it.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "model/validate.hpp"
#include "verify/test_polygons.hpp"
#include "verify/verify.hpp"

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
  EXPECT_NO_THROW(validate(made.polygon)) << made.name;
  Report report = verify_polygon(made.polygon, made.mesh);
  EXPECT_EQ(with_verdict(report, Verdict::fails), failing) << made.name << "\n" << to_text(report);
  EXPECT_EQ(with_verdict(report, Verdict::not_decided), undecided) << made.name << "\n"
                                                                   << to_text(report);
  const Verdict theorem = !failing.empty()     ? Verdict::fails
                          : !undecided.empty() ? Verdict::not_decided
                                               : Verdict::holds;
  EXPECT_EQ(report.find("thm-13")->exact, theorem);
  EXPECT_EQ(report.polygon->steiner.has_value(),
            report.find("boundary-kept")->exact == Verdict::holds);
  return report;
}

std::string departure(const Report& report) { return report.find("boundary-kept")->detail; }

void move_by(Case& made, VertexId v, const Rational& dx, const Rational& dy) {
  const RationalPoint p = made.mesh.vertices.exact(v);
  made.mesh.vertices.move_to_exact(v, {p.x + dx, p.y + dy});
}

void drop_vertex(Case& made, std::size_t ring, const Point& vertex) {
  Ring& points = made.polygon.rings[ring];
  ASSERT_EQ(std::erase(points, vertex), 1U);
}

const Rational kUnit = dyadic(1, -10);  // of the lattice of the test meshes

TEST(VerifyPolygon, ValidMeshesHold) {
  for (const Case& made : valid_polygon_cases()) {
    ASSERT_LE(made.mesh.quads.size(), 30U);
    const Report report = expect(made, {});
    EXPECT_TRUE(report.holds());
    EXPECT_EQ(report.theorem, "thm-13");
    EXPECT_EQ(report.boundary_loops, made.polygon.rings.size());
    EXPECT_EQ(report.used_vertices + report.quads + report.polygon->rings, report.edges + 2);
  }
}

TEST(VerifyPolygon, ClaimsAreThoseOfTheTheorem) {
  const Report report = expect(square_with_hole(), {});
  Names ids;
  for (const Claim& claim : report.claims) ids.insert(claim.id);
  const Names expected{"all-quad",      "distinct-vertices", "conforming", "strictly-convex",
                       "boundary-kept", "no-overlap",        "euler",      "area",
                       "min-angle",     "max-angle",         "size-5N",    "thm-13"};
  EXPECT_EQ(ids, expected);
  EXPECT_EQ(report.claims.back().id, "thm-13");
}

TEST(VerifyPolygon, MalformedQuadsLeaveTheRestUndecided) {
  Case made = square();
  made.mesh.quads[3][1] = 99;
  expect(made, {"all-quad"},
         {"distinct-vertices", "conforming", "strictly-convex", "boundary-kept", "no-overlap",
          "euler", "area", "min-angle", "max-angle"});
}

TEST(VerifyPolygon, TriangleBreaksAllQuad) {
  Case made = square();
  made.mesh.other_faces.push_back({0, 1, 2});
  expect(made, {"all-quad"});
}

// --- boundary-kept: what holds -------------------------------------------------------------------

TEST(BoundaryKept, SteinerPointsAreCountedPerEdge) {
  const Report report = expect(hole_with_thirds(0), {});
  const PolygonFacts::Steiner& steiner = *report.polygon->steiner;
  // Outer edges: lines at 1/3, 1, 2 or at 1, 4/3, 2; of the hole, two sides have one at 4/3.
  EXPECT_EQ(steiner.edges, 8U);
  EXPECT_EQ(steiner.fewest, 0U);
  EXPECT_EQ(steiner.most, 3U);
  EXPECT_EQ(steiner.total, 14U);
  EXPECT_EQ(steiner.mean(), Rational(7, 4));
}

TEST(BoundaryKept, VertexMayMoveAlongItsEdge) {
  for (const Rational& step : {kUnit, Rational(1, 3), Rational(-1, 7)}) {
    Case made = square();
    move_by(made, 1, step, 0);
    expect(made, {});
    Case slanted = hole_with_thirds(1);
    move_by(slanted, 5, step / 4, step / 4);  // on the left edge, at (1, 1)
    expect(slanted, {});
  }
}

TEST(BoundaryKept, StraightVertexOfThePolygonIsNoSteinerPoint) {
  const Case made = with_polygon(square_grid(3, 3), 1);
  EXPECT_EQ(expect(made, {}).polygon->steiner->total, 0U);
}

TEST(BoundaryKept, RingsMayComeInAnyOrderAndStartAnywhere) {
  Case made = rectangles("two holes", {0, 1, 2, 3, 4, 5}, {0, 1, 2, 3}, {{1, 1}, {3, 1}});
  std::swap(made.polygon.rings[1], made.polygon.rings[2]);
  for (Ring& ring : made.polygon.rings) std::rotate(ring.begin(), ring.begin() + 2, ring.end());
  expect(made, {});
}

// --- boundary-kept: what fails -------------------------------------------------------------------

TEST(BoundaryKept, VertexOffItsEdgeByAUnitOrAThirdIsNamed) {
  for (const Rational& step :
       {kUnit, Rational(-kUnit), Rational(1, 3), Rational(-1, 3), Rational(dyadic(1, -80))}) {
    Case made = square();
    move_by(made, 1, 0, step);
    const Report report = expect(made, {"boundary-kept", "area"}, {"no-overlap"});
    EXPECT_EQ(departure(report), "vertex 1 is off edge 0 of ring 0, (0, 0) to (3, 0)");
    EXPECT_EQ(report.find("boundary-kept")->place->vertex, 1U);
  }
}

TEST(BoundaryKept, VertexOffASlantedEdgeOfAHoleIsNamed) {
  Case made = hole_with_thirds(1);
  move_by(made, 12, dyadic(1, -70), 0);  // at (1, 4/3), sheared
  const Report report = expect(made, {"boundary-kept", "area"}, {"no-overlap"});
  EXPECT_EQ(report.find("boundary-kept")->place->vertex, 12U);
  EXPECT_NE(departure(report).find("of ring 1"), std::string::npos) << departure(report);
}

/// Edges from (0, 0) and (2, 0) up to (1, 3) and (3, 3) with feet at y = 1 and y = 2; the left ones
/// are vertices 3 and 6.
Case with_feet(const Rational& scale, const Rational& shift) {
  return with_polygon(mapped(rectangles("feet", {0, 1, 2}, {0, 1, 2, 3}, {}, Rational(1, 3)),
                             "moved", scale, shift, 0));
}

TEST(BoundaryKept, FootWithALatticeCoordinateIsDecidedExactly) {
  const Rational tiny =
      dyadic(1, -30) / boost::multiprecision::pow(boost::multiprecision::mpz_int(5), 30);
  for (const Rational& shift : {Rational(0), Rational(dyadic(1, 59))}) {
    for (const Rational& scale : {Rational(1024), Rational(dyadic(1, 50) + 1024)}) {
      Case made = with_feet(scale, shift);
      expect(made, {});
      move_by(made, 3, Rational(1, 3), 1);  // along its edge
      expect(made, {});
      for (const Rational& step : {tiny, Rational(-tiny), Rational(1, 7), Rational(-1, 3)}) {
        Case off = made;
        move_by(off, 6, step, 0);
        const Report report = expect(off, {"boundary-kept", "area"}, {"no-overlap"});
        EXPECT_NE(departure(report).find("vertex 6 is off edge"), std::string::npos);
      }
    }
  }
}

TEST(BoundaryKept, FootAtOrJustBeyondItsNeighbourHasPassed) {
  for (const Rational& beyond : {Rational(0), Rational(1, 3), Rational(dyadic(1, -90))}) {
    Case made = with_feet(64, 0);
    move_by(made, 3, (64 + beyond) / 3, 64 + beyond);  // to vertex 6
    const Report report = verify_polygon(made.polygon, made.mesh);
    EXPECT_NE(departure(report).find("is not between its neighbours"), std::string::npos);
  }
}

TEST(Area, OfFeetOfManySlopesIsExact) {
  Case made = with_feet(64, 0);
  const Report kept = expect(made, {});
  EXPECT_EQ(kept.find("area")->values[0].second, 6 * 64 * 64);
  made.mesh.quads.push_back(made.mesh.quads[0]);  // at the left edge: its area once more
  const Report doubled = expect(made, {"conforming", "euler", "area"}, {"no-overlap"});
  EXPECT_EQ(doubled.find("area")->values[0].second, 7 * 64 * 64);
  made.mesh.quads.erase(made.mesh.quads.begin() + 1);
  made.mesh.quads.erase(made.mesh.quads.begin());
  const Report lost = verify_polygon(made.polygon, made.mesh);
  EXPECT_EQ(lost.find("boundary-kept")->exact, Verdict::fails);
  EXPECT_EQ(lost.find("area")->values[0].second, 5 * 64 * 64);
}

TEST(BoundaryKept, VertexThatSlidPastItsNeighbourIsNamed) {
  Case made = square();
  move_by(made, 1, Rational(3, 2), 0);  // from 1 to 5/2, beyond vertex 2
  const Report report = verify_polygon(made.polygon, made.mesh);
  EXPECT_EQ(departure(report),
            "vertex 2 is not between its neighbours on edge 0 of ring 0, (0, 0) to (3, 0)");
  EXPECT_EQ(report.find("strictly-convex")->exact, Verdict::fails);
  EXPECT_EQ(report.find("area")->exact, Verdict::holds);
}

TEST(BoundaryKept, VertexAtItsNeighbourOrAtTheEndHasPassed) {
  for (const int to : {0, 2, 3}) {
    Case made = square();
    move_by(made, 1, to - 1, 0);
    const Report report = verify_polygon(made.polygon, made.mesh);
    EXPECT_EQ(report.find("boundary-kept")->exact, Verdict::fails) << to;
    EXPECT_EQ(report.find("distinct-vertices")->exact, Verdict::fails) << to;
  }
}

TEST(BoundaryKept, FilledHoleIsNamed) {
  Case made = square_with_hole();
  made.mesh.quads.push_back({6, 7, 12, 11});
  const Report report = expect(made, {"boundary-kept", "euler", "area"}, {"no-overlap"});
  EXPECT_EQ(departure(report), "ring 1 has no loop: the hole is filled");
}

TEST(BoundaryKept, LostCornerIsNamed) {
  // The corner (0, 0) is cut off: its vertex moves onto the line of its neighbours.
  Case made = square();
  made.mesh.vertices.move_to_exact(0, {Rational(1, 2), Rational(1, 2)});
  const Report report =
      expect(made, {"boundary-kept", "area", "strictly-convex", "max-angle"}, {"no-overlap"});
  EXPECT_EQ(departure(report), "vertex 0 of ring 0 is no boundary vertex of the mesh: (0, 0)");
}

TEST(BoundaryKept, LostStraightVertexIsNamed) {
  Case made = square();
  Ring& outer = made.polygon.rings[0];
  outer.insert(outer.begin() + 1, Point{1.5, 0});
  const Report report = expect(made, {"boundary-kept"}, {"no-overlap"});
  EXPECT_EQ(departure(report), "vertex 1 of ring 0 is no boundary vertex of the mesh: (1.5, 0)");
}

TEST(BoundaryKept, VertexInsideTheMeshIsNoBoundaryVertex) {
  Case made = square();
  made.polygon.rings.push_back({{1, 1}, {1, 2}, {2, 2}, {2, 1}});
  const Report report = expect(made, {"boundary-kept", "euler", "area"}, {"no-overlap"});
  EXPECT_EQ(departure(report), "ring 1 has no loop: the hole is filled");
}

TEST(BoundaryKept, MissingQuadIsAStrayLoop) {
  Case made = square();
  made.mesh.quads.erase(made.mesh.quads.begin() + 4);
  const Report report = expect(made, {"boundary-kept", "euler", "area"}, {"no-overlap"});
  EXPECT_EQ(departure(report), "the loop through vertex 5 belongs to no ring");
  EXPECT_EQ(report.find("boundary-kept")->place->vertex, 5U);
}

TEST(BoundaryKept, IslandIsAStrayLoop) {
  Case made = square();
  for (const auto& [x, y] : {std::pair{10, 0}, {11, 0}, {11, 1}, {10, 1}}) add(made.mesh, x, y);
  made.mesh.quads.push_back({16, 17, 18, 19});
  EXPECT_EQ(departure(expect(made, {"boundary-kept", "euler", "area"}, {"no-overlap"})),
            "the loop through vertex 16 belongs to no ring");
}

TEST(BoundaryKept, HoleInAnotherPlaceIsNamed) {
  Case made = square_with_hole();
  for (Point& p : made.polygon.rings[1]) p.x += 1;
  const Report report = expect(made, {"boundary-kept"}, {"no-overlap"});
  EXPECT_NE(departure(report).find("of ring 1 is no boundary vertex"), std::string::npos);
}

TEST(BoundaryKept, RingInTheOtherDirectionFails) {
  Case made = square_with_hole();
  std::reverse(made.polygon.rings[1].begin(), made.polygon.rings[1].end());
  const Report report = expect(made, {"boundary-kept", "area"}, {"no-overlap"});
  EXPECT_NE(departure(report).find("of ring 1"), std::string::npos);
}

TEST(BoundaryKept, SteinerPointAtAVertexOfThePolygonThatThePolygonLacksIsOffItsEdge) {
  Case made = l_shape();
  drop_vertex(made, 0, {2, 2});
  const Report report = expect(made, {"boundary-kept", "area"}, {"no-overlap"});
  EXPECT_NE(departure(report).find("is off edge"), std::string::npos);
}

TEST(BoundaryKept, PinchedBoundaryBranches) {
  Case made = square();
  made.mesh.quads.erase(made.mesh.quads.begin() + 4);
  made.mesh.quads.erase(made.mesh.quads.begin() + 0);
  const Report report = verify_polygon(made.polygon, made.mesh);
  EXPECT_EQ(departure(report), "unpaired edges branch at vertex 5");
}

TEST(BoundaryKept, DecidedAtTheLimitsOfTheLattice) {
  const Rational large = dyadic(1, 59);
  Case made = with_polygon(mapped(square_grid(2, 2), "largest", large, -large, 0));
  expect(made, {});
  move_by(made, 1, 0, 1);
  expect(made, {"boundary-kept", "area"}, {"no-overlap"});
}

// --- no-overlap, conforming, distinct-vertices, euler --------------------------------------------

TEST(NoOverlap, DoubledQuadBreaksConformity) {
  Case made = square();
  made.mesh.quads.push_back(made.mesh.quads[4]);
  expect(made, {"conforming", "euler", "area"}, {"no-overlap"});
}

TEST(NoOverlap, SlitIsAStrayLoop) {
  Case made = square();
  const VertexId second = add(made.mesh, 1, 1);
  made.mesh.quads[3][1] = second;
  made.mesh.quads[4][0] = second;
  const Report report = verify_polygon(made.polygon, made.mesh);
  EXPECT_EQ(report.find("distinct-vertices")->exact, Verdict::fails);
  EXPECT_EQ(report.find("boundary-kept")->exact, Verdict::fails);
  EXPECT_EQ(report.find("area")->exact, Verdict::holds);
}

TEST(NoOverlap, InnerVertexBeyondTheBoundaryIsNotConvex) {
  Case made = square();
  move_by(made, 5, -2, 0);
  const Report report = verify_polygon(made.polygon, made.mesh);
  EXPECT_EQ(report.find("boundary-kept")->exact, Verdict::holds);
  EXPECT_EQ(report.find("strictly-convex")->exact, Verdict::fails);
  EXPECT_EQ(report.find("no-overlap")->exact, Verdict::not_decided);
}

TEST(StrictlyConvex, WholeInputAngleOf180DegreesOrMoreBreaksItAlone) {
  for (const Rational& rise : {Rational(1, 2), Rational(1, 4)}) {
    // A quad whose corner at (1/2, rise) is straight or reflex, and a whole input angle.
    Case made;
    made.mesh.vertices = Vertices(-10);
    for (const RationalPoint& p : Positions{{0, 0}, {1, 0}, {Rational(1, 2), rise}, {0, 1}})
      made.mesh.vertices.add_exact(p);
    made.mesh.quads = {{0, 1, 2, 3}};
    made.mesh.cells = 1;
    made = with_polygon(made, 2);
    const Report report = expect(made, {"strictly-convex"}, {"no-overlap"});
    EXPECT_EQ(report.polygon->whole_corners, 4U);
    EXPECT_EQ(report.polygon->whole_beyond_bounds, 1U);
    EXPECT_EQ(report.polygon->largest_whole->place.vertex, 2U);
  }
}

// --- corner classes, min-angle, max-angle --------------------------------------------------------

/// Two quads: the first with a whole corner at the origin, between the x axis and (run, rise).
Case acute_wedge(int run, int rise) {
  const int x = run;
  const int y = rise;
  const Positions p{
      {0, 0}, {x, 0}, {x + 100, 0}, {x + 100, Rational(y, 2)}, {x + 33, Rational(y, 2)}, {x, y}};
  return with_polygon(make_case("wedge", p, {{0, 1, 4, 5}, {1, 2, 3, 4}}));
}

TEST(CornerClasses, AcuteCornerThatIsWholeIsListedAndNotJudged) {
  const Report report = expect(acute_wedge(567, 100), {});  // 10.0 degrees
  EXPECT_EQ(report.polygon->whole_corners, 4U);
  EXPECT_EQ(report.polygon->whole_beyond_bounds, 1U);
  EXPECT_EQ(report.polygon->smallest_whole->tangent(), Rational(100, 567));
  EXPECT_EQ(report.polygon->smallest_whole->place.vertex, 0U);
  EXPECT_NE(report.find("min-angle")->worst->place.vertex, 0U);
}

TEST(CornerClasses, WholeCornersExactlyOnTheBoundAreWithinIt) {
  EXPECT_EQ(expect(acute_wedge(300, 100), {}).polygon->whole_beyond_bounds, 0U);
  EXPECT_EQ(expect(acute_wedge(301, 100), {}).polygon->whole_beyond_bounds, 1U);
}

TEST(CornerClasses, MeshOfWholeInputAnglesHasNoCornerToJudge) {
  const Case made = rectangles("one parallelogram", {0, 1}, {0, 1}, {}, 10);
  const Report report = expect(made, {});
  EXPECT_FALSE(report.find("min-angle")->worst);
  EXPECT_FALSE(report.find("max-angle")->worst);
  EXPECT_EQ(report.polygon->whole_corners, 4U);
  EXPECT_EQ(report.polygon->whole_beyond_bounds, 4U);
}

TEST(CornerClasses, BoundaryStraightCornersAreJudged) {
  const Case made = rectangles("two parallelograms", {0, 1, 2}, {0, 1}, {}, 4);
  const Report report = expect(made, {"min-angle"});
  EXPECT_EQ(report.find("min-angle")->worst->place.vertex, 4U);
  EXPECT_EQ(report.polygon->split_corners, 0U);
}

TEST(CornerClasses, SplitCornersOfAnInputAngleAreJudged) {
  const Case made = with_polygon(rectangles("two parallelograms", {0, 1, 2}, {0, 1}, {}, 4), 1);
  const Report report = expect(made, {"min-angle"});
  EXPECT_EQ(report.polygon->split_corners, 4U);
  EXPECT_EQ(report.polygon->whole_corners, 4U);
}

TEST(CornerClasses, SplitCornersAtAReflexVertexAreCounted) {
  EXPECT_EQ(expect(square_with_hole(), {}).polygon->split_corners, 12U);
  EXPECT_EQ(expect(l_shape(), {}).polygon->split_corners, 3U);
}

/// Two quads that split the angle at the origin.
Case split_angle(const Positions& positions, const Rational& unit, const Rational& nudge) {
  Positions p = positions;
  for (RationalPoint& at : p) at = {at.x * unit, at.y * unit};
  p[3].y += nudge;
  return with_polygon(make_case("split angle", p, {{0, 1, 2, 3}, {0, 3, 4, 5}}, 0));
}

TEST(MinAngle, DecidedToTheLastUnitAtASplitCorner) {
  const Positions p{{0, 0}, {6, 0}, {8, 1}, {6, 2}, {4, 8}, {-2, 6}};
  for (const Rational& unit : {Rational(64), Rational(dyadic(1, 50))}) {
    expect(split_angle(p, unit, 0), {});
    expect(split_angle(p, unit, 1), {});
    const Report report = expect(split_angle(p, unit, -1), {"min-angle"});
    EXPECT_EQ(report.find("min-angle")->worst->place.vertex, 0U);
    EXPECT_LT(*report.find("min-angle")->worst->tangent(), Rational(1, 3));
  }
}

TEST(MaxAngle, DecidedToTheLastUnitAtASplitCorner) {
  const Positions p{{0, 0}, {1, 0}, {-3, 4}, {-7, 1}, {-10, -3}, {-3, -4}};
  for (const Rational& unit : {Rational(64), Rational(dyadic(1, 50))}) {
    expect(split_angle(p, unit, 0), {});
    expect(split_angle(p, unit, 1), {});
    const Report report = expect(split_angle(p, unit, -1), {"max-angle"});
    EXPECT_EQ(report.find("max-angle")->worst->place.vertex, 0U);
    EXPECT_GT(*report.find("max-angle")->worst->tangent(), Rational(-1, 7));
  }
}

TEST(MinAngle, OtherBoundsMayBeAskedFor) {
  const Case made = rectangles("parallelograms", {0, 1, 2}, {0, 1, 2}, {}, 3);
  expect(made, {});
  VerifyOptions options;
  options.angles = kTheorem1;
  options.quads_per_cell = 3;
  const Report report = verify_polygon(made.polygon, made.mesh, options);
  EXPECT_EQ(report.find("min-angle")->exact, Verdict::fails);
  EXPECT_NE(report.find("size-3N"), nullptr);
}

// --- size-5N, the report -------------------------------------------------------------------------

TEST(Size5N, ExactlyFivePerCellHoldsAndOneMoreFails) {
  Case made = square_with_hole();  // 15 quads
  made.mesh.cells = 3;
  expect(made, {});
  made = rectangles("sixteen", {0, 1, 2, 3, 4}, {0, 1, 2, 3, 4}, {});
  made.mesh.cells = 3;
  EXPECT_EQ(expect(made, {"size-5N"}).find("size-5N")->values[1].second, 15);
  made.mesh.cells = 0;
  expect(made, {}, {"size-5N"});
}

TEST(PolygonReport, JsonAndTextTellOfTheBoundaryAndTheInputAngles) {
  const Report report = expect(acute_wedge(567, 100), {});
  const std::string json = to_json(report);
  for (const char* text :
       {"\"rings\": 1", "\"mean_on_an_edge\": \"1/5\"", "\"whole_input_corners\"",
        "\"beyond_bounds\": 1", "\"input_points\": 5"})
    EXPECT_NE(json.find(text), std::string::npos) << text << "\n" << json;
  EXPECT_NE(to_text(report).find("1 of them beyond the bounds; from 10.0022"), std::string::npos)
      << to_text(report);
}

TEST(PolygonReport, SameBytesWhateverTheNumberOfThreads) {
  std::mt19937_64 random(7);
  Case made = with_polygon(perturbed_grid(300, 240, random), 7);
  const auto json = [&](unsigned threads) {
    VerifyOptions options;
    options.threads = threads;
    return to_json(verify_polygon(made.polygon, made.mesh, options));
  };
  const std::string sound = json(1);
  EXPECT_EQ(sound, json(3));
  move_by(made, 5, 0, Rational(1, 3));
  EXPECT_NE(json(1), sound);
  EXPECT_EQ(json(1), json(0));
}

}  // namespace
}  // namespace quadbound::test
