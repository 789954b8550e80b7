// SPDX-License-Identifier: Apache-2.0
// paper/departures.md: the inputs that break what the paper says, and that ours withstands them.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "model/angle.hpp"
#include "model/read_points.hpp"
#include "model/read_polygon.hpp"
#include "model/validate.hpp"
#include "paper/experiment.hpp"
#include "paper/polygon_experiment.hpp"
#include "paper/theorem_1_table.hpp"

namespace quadbound {
namespace {

using Ids = std::vector<std::string>;

PointSet case_file(const std::string& name) {
  return read_points(std::string(QUADBOUND_PAPER_CASES) + "/" + name);
}

Measurement with(const std::string& name, Warping warping, TwoTwoVariant two_two) {
  Trial trial;
  trial.set = name;
  trial.warping = warping;
  trial.two_two = two_two;
  return run_trial(trial, case_file(name), 1).measurement;
}

Measurement ours(const std::string& name) {
  return with(name, Warping::kAligned, TwoTwoVariant::kExact);
}

TEST(Departures, WarpingBreaksMaxAngleAlone) {
  const Measurement paper = with("warp-two-points.csv", Warping::kPaper, TwoTwoVariant::kExact);
  EXPECT_EQ(paper.broken, Ids{"max-angle"});
  EXPECT_NEAR(degrees(paper.largest), 156.50, 0.01);
  EXPECT_TRUE(ours("warp-two-points.csv").proved());
}

/// On the corner of its cell: the quad at the point has a straight angle.
TEST(Departures, WarpingOfOnePointReaches180Degrees) {
  const Measurement paper = with("warp-one-point.csv", Warping::kPaper, TwoTwoVariant::kExact);
  EXPECT_FALSE(paper.proved());
  EXPECT_EQ(paper.largest.cross, 0);
  EXPECT_LT(paper.largest.dot, 0);
  EXPECT_TRUE(ours("warp-one-point.csv").proved());
}

/// Fig. 8a moves a centre into the reach of warping: 180 - arctan(1/3) = 161.57 degrees.
TEST(Departures, MovedCentreOfTwoTwoBreaksMaxAngleAlone) {
  const Measurement paper =
      with("two-two-two-points.csv", Warping::kAligned, TwoTwoVariant::kPaper);
  EXPECT_EQ(paper.broken, Ids{"max-angle"});
  EXPECT_EQ(3 * paper.largest.cross, -paper.largest.dot);
  EXPECT_TRUE(ours("two-two-two-points.csv").proved());
}

/// The outer extras at the root's corners are left out.
TEST(Departures, NoVertexWithoutAQuad) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Trial trial;
    trial.set = "uniform";
    trial.seed = seed;
    EXPECT_EQ(run_trial(trial, points_of(trial, 20), 1).report.unused_vertices, 0U) << seed;
  }
}

/// Both departures on random sets: ours always holds, the paper's warping does not.
TEST(Departures, RandomSetsHoldWithOurs) {
  std::size_t broken = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Trial trial;
    trial.set = "uniform";
    trial.seed = seed;
    const PointSet points = points_of(trial, 60);
    EXPECT_TRUE(run_trial(trial, points, 1).measurement.proved()) << seed;
    trial.warping = Warping::kPaper;
    broken += run_trial(trial, points, 1).measurement.proved() ? 0U : 1U;
  }
  EXPECT_EQ(broken, 5U);
}

// --- Sections 3 and 4 ----------------------------------------------------------------------------

Polygon polygon_case(const std::string& name) {
  return normalised(read_polygon(std::string(QUADBOUND_PAPER_CASES) + "/" + name));
}

/// A half-size north neighbour of a cell below an edge of slope 1 need not be above the edge.
TEST(Departures, NorthNeighbourBelowTheEdge) {
  const Rational offset(9, 10);  // the edge is y = x + offset, and cuts the cell [0, 1] x [0, 1]
  const auto height = [&](const Rational& x, const Rational& y) {
    return Rational(y - x - offset);
  };
  EXPECT_LT(height(Rational(1, 2), Rational(1, 2)), 0);
  EXPECT_GT(height(Rational(1, 4), Rational(5, 4)), 0);
  EXPECT_LT(height(Rational(3, 4), Rational(5, 4)), 0);
}

/// With right angles at p' and q', as in the paper, the quad at the tip has 180 degrees less the
/// tip at v': beyond 171.87 for the tip arctan(1/12).
TEST(Departures, KiteOfASharpTipBreaksMaxAngle) {
  const RationalPoint tip{0, 0};
  const RationalPoint v{1, Rational(1, 24)};
  const RationalPoint p{1, 0};
  const Rational along = Rational(12 * v.x + v.y) / 145;  // the foot on the edge towards (12, 1)
  const RationalPoint q{Rational(12 * along), along};
  const auto corner = corner_at<Rational>(v, q, p);
  EXPECT_EQ(12 * corner.cross, -corner.dot);
  EXPECT_FALSE(within(corner, kTheorem13));
  const JudgedPolygonMesh made = judge_polygon_mesh(polygon_case("tip-one-twelfth.geojson"), 1);
  EXPECT_TRUE(made.measurement.proved());
  EXPECT_EQ(made.measurement.kites, 1U);
  EXPECT_EQ(quads_made_by(made.mesh, "kite tip"), 1U);
}

/// At a corner u = w happens: Lemma 12's E has no edge.
TEST(Departures, CornerWithoutAnEdgeOfAlpha) {
  const JudgedPolygonMesh made = judge_polygon_mesh(polygon_case("square.geojson"), 1);
  EXPECT_TRUE(made.measurement.proved());
  EXPECT_GE(quads_made_by(made.mesh, "corner quad"), 1U);
}

/// Two of the three angles are acute; the corner construction does them all.
TEST(Departures, AcuteVerticesWithoutKites) {
  const JudgedPolygonMesh made = judge_polygon_mesh(polygon_case("right-triangle.geojson"), 1);
  EXPECT_TRUE(made.measurement.proved());
  EXPECT_EQ(made.measurement.kites, 0U);
}

}  // namespace
}  // namespace quadbound
