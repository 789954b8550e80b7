// SPDX-License-Identifier: Apache-2.0
// Observations 1 and 2, Table 1, Lemmas 2 to 12: the audit and its counterexamples.
#include "paper/lemma_audit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "generators/polygons.hpp"
#include "paper/corner_audit.hpp"
#include "paper/edge_chains.hpp"
#include "paper/lemma_claims.hpp"
#include "paper/lemma_counterexamples.hpp"
#include "paper/polygon_trees.hpp"

namespace quadbound {
namespace {

constexpr std::int64_t kUnit = kCutTreeSide / 64;

/// Four by four cells of 16 units.
CutTree uniform_tree() {
  const std::vector<TreeNode> split{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}};
  return {tree_with(split), TwoTwoVariant::kExact};
}

TEST(LemmaAudit, EveryCounterexampleFailsItsCheck) {
  for (const LemmaCounterexample& c : lemma_counterexamples()) {
    const LemmaAudit audit = audit_case(c.cut_case);
    EXPECT_GT(audit.of(c.check).failed, 0U) << describe(c.check).name << to_text(c.cut_case);
    EXPECT_EQ(audit.of(c.check).failed_in_general_position > 0, c.general)
        << describe(c.check).name;
  }
}

/// In full: balance adds no node.
TEST(LemmaAudit, CounterexamplesAreWhole) {
  for (const LemmaCounterexample& c : lemma_counterexamples()) {
    const std::size_t nodes = nodes_of(tree_with(c.cut_case.split)).size();
    EXPECT_EQ(nodes, c.cut_case.split.size()) << describe(c.check).name;
  }
}

TEST(LemmaAudit, SmallerCaseDropsWhatIsNotNeeded) {
  const LemmaCounterexample& known = lemma_counterexamples().front();
  CutTreeCase larger = known.cut_case;
  for (const TreeNode& node : {TreeNode{1, 0, 0}, {2, 0, 0}, {3, 1, 1}, {2, 3, 3}})
    larger.split.push_back(node);
  larger.line.point.y += 3;
  const CutTreeCase smaller = smaller_case(larger, known.check);
  EXPECT_LE(smaller.split.size(), known.cut_case.split.size());
  EXPECT_GT(audit_case(smaller).of(known.check).failed_in_general_position, 0U);
}

TEST(LemmaAudit, VerdictsAreThoseThatAreSaid) {
  NoWatcher nobody;
  const LemmaAudits audits = audit_paper_lemmas(300, {}, nobody);
  for (const PaperClaim& claim : lemma_claims(audits))
    EXPECT_NE(claim.verdict, PaperVerdict::kFails) << claim.id << ": " << claim.what << claim.ours;
  EXPECT_TRUE(lemmas_hold(audits));
  EXPECT_EQ(audits.polygon_trees.polygons, 2U);
}

/// Every family has trees, on which every check is asked often.
TEST(PolygonTrees, OfAllFamilies) {
  NoWatcher nobody;
  const PolygonTreesAudit audit = audit_polygon_trees(24, {}, nobody);
  EXPECT_EQ(audit.polygons, 24U);
  EXPECT_EQ(audit.refused, 0U);
  EXPECT_EQ(audit.audit.trees, 96U);
  for (const CheckTally& tally : audit.audit.checks) EXPECT_GT(tally.looked_at, 1000U);
}

/// In one of the four turns, through both vertices; twice where it is a diagonal of cells.
TEST(PolygonTrees, EveryEdgeHasItsLine) {
  const Polygon polygon = generate_polygon(parse_polygon_recipe("blob:n=13,seed=1,holes=1"));
  std::size_t lines = 0;
  for (int turns = 0; turns < 4; ++turns) {
    const auto made = tree_of_polygon(polygon, turns);
    ASSERT_TRUE(made);
    ASSERT_EQ(made->vertices.size(), 19U);
    for (const CutLine& line : made->lines) {
      EXPECT_GT(line.dx, 0);
      EXPECT_LE(std::abs(line.dy), line.dx);
      const auto on_line = [&line](LatticePoint p) { return framed(line, p).h == 0; };
      EXPECT_GE(std::count_if(made->vertices.begin(), made->vertices.end(), on_line), 2);
    }
    lines += made->lines.size();
  }
  EXPECT_EQ(lines, 19U);
}

/// Equal leaves around each vertex, and none has two.
TEST(PolygonTrees, VerticesAreSeparated) {
  const Polygon polygon = generate_polygon(parse_polygon_recipe("growth:n=48,seed=1"));
  const auto made = tree_of_polygon(polygon, 1);
  ASSERT_TRUE(made);
  const CutTree tree(made->tree, TwoTwoVariant::kExact);
  for (const LatticePoint& vertex : made->vertices) {
    const CellSquare cell = tree.square(tree.tree().leaf_at(vertex));
    for (std::int64_t i = -2; i <= 2; ++i)
      for (std::int64_t j = -2; j <= 2; ++j)
        EXPECT_EQ(
            tree.square(tree.tree().leaf_at({vertex.x + i * cell.side, vertex.y + j * cell.side}))
                .side,
            cell.side);
    EXPECT_EQ(std::count_if(made->vertices.begin(), made->vertices.end(),
                            [&](LatticePoint other) {
                              return tree.square(tree.tree().leaf_at(other)).low == cell.low;
                            }),
              1);
  }
}

TEST(PolygonTrees, NoneWhereRoundingMergesVertices) {
  EXPECT_FALSE(tree_of_polygon({"close", {{{0, 0}, {1, 0}, {1, 0x1p-30}}}}, 0));
  EXPECT_TRUE(tree_of_polygon({"wide", {{{0, 0}, {1, 0}, {1, 0.5}}}}, 0));
}

/// Effective cases: every check was asked often, every delta of Table 1 and every chain of Lemma 11
/// that the paper draws was met.
TEST(LemmaAudit, ReachesWhatThePaperDraws) {
  NoWatcher nobody;
  const LemmaAudit audit = audit_lemmas({300}, nobody);
  for (const CheckTally& tally : audit.checks) EXPECT_GT(tally.looked_at, 100U);
  for (const char* const turns : {"", "C", "CC", "CR", "RC", "CRC", "RCR"})
    EXPECT_TRUE(audit.strips.contains(turns)) << turns;
  for (std::size_t slope = 3; slope <= 8; ++slope) EXPECT_GT(audit.slopes[0][slope], 0U) << slope;
  for (std::size_t slope = 0; slope <= 5; ++slope) EXPECT_GT(audit.slopes[4][slope], 0U) << slope;
  EXPECT_GT(audit.under, 0U);
  EXPECT_GT(audit.spikes, 0U);
}

TEST(LemmaAudit, SameCountsTwice) {
  NoWatcher nobody;
  EXPECT_EQ(to_text(audit_lemmas({20}, nobody)), to_text(audit_lemmas({20}, nobody)));
}

/// By hand: a horizontal line below the centres of the third row.
TEST(EdgeChains, AreThoseOfAUniformGrid) {
  const CutTree tree = uniform_tree();
  const EdgeChains chains = edge_chains(tree, {{0, 35 * kUnit}, 1, 0});
  ASSERT_EQ(chains.alpha.size(), 4U);
  ASSERT_EQ(chains.beta.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const LatticePoint expected{(8 + 16 * static_cast<std::int64_t>(i)) * kUnit, 40 * kUnit};
    EXPECT_EQ(tree.at(chains.alpha[i]), expected);
    EXPECT_EQ(tree.at(tree.centre(chains.beta[i])), expected);
  }
  EXPECT_TRUE(chains.broken.empty());
  EXPECT_EQ(chains.most_edges, 1U);
}

/// Through the lower left corners of cells and their centres: what is on the line is not above it.
TEST(EdgeChains, OnADiagonalThroughCentres) {
  const CutTree tree = uniform_tree();
  const EdgeChains chains = edge_chains(tree, {{0, 0}, 1, 1});
  EXPECT_TRUE(chains.broken.empty());
  for (const VertexId v : chains.alpha) EXPECT_GT(tree.at(v).y, tree.at(v).x);
  for (const Cell c : chains.beta) EXPECT_GT(tree.at(tree.centre(c)).y, tree.at(tree.centre(c)).x);
  EXPECT_FALSE(in_general_position(tree, {{0, 0}, 1, 1}));
  EXPECT_TRUE(in_general_position(tree, {{0, kUnit}, 1, 1}));
}

TEST(CutTree, NeighboursAreThoseOfTheTree) {
  const std::vector<TreeNode> split{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 2, 2}};
  const CutTree tree(tree_with(split), TwoTwoVariant::kExact);
  const Cell west = tree.tree().leaf_at({24 * kUnit, 40 * kUnit});
  EXPECT_EQ(tree.square(west).side, 16 * kUnit);
  EXPECT_EQ(tree.neighbours(west, kEast).size(), 2U);
  EXPECT_EQ(tree.neighbours(west, kSouth).size(), 1U);
  const Cell small = tree.neighbours(west, kEast).front();
  ASSERT_EQ(tree.neighbours(small, kWest).size(), 1U);
  EXPECT_EQ(tree.neighbours(small, kWest).front(), west);
  EXPECT_EQ(touch(tree.square(small), tree.square(west)), Touch::kEdge);
  EXPECT_TRUE(tree.neighbours(tree.tree().leaf_at({0, 0}), kWest).empty());
}

TEST(CornerAudit, ARightAngleInTheUpperLeftHasNoEdge) {
  // Inside above and to the left, v in the upper left quarter of its cell.
  const CornerAudit audit =
      audit_corner({{CornerCase::kSide / 4, 3 * (CornerCase::kSide / 4)}, {-1, 0}, {0, 1}});
  EXPECT_EQ(audit.by_edges[1], 1U);
  EXPECT_EQ(audit.of(CornerCheck::kOneToSevenEdges).failed, 1U);
}

/// v t and e are less than arctan(1/7) from being one line, wherever the feet are.
TEST(CornerAudit, VInLineWithEAndTHasNoTwoQuads) {
  const CornerAudit audit =
      audit_corner({{CornerCase::kSide / 64, 63 * (CornerCase::kSide / 64)}, {-6, -5}, {1, 0}});
  EXPECT_EQ(audit.by_edges[3], 1U);
  EXPECT_EQ(audit.of(CornerCheck::kCase2).failed, 1U);
}

TEST(CornerAudit, FootBeyondV) {
  const std::int64_t part = CornerCase::kSide / 16;
  const CornerAudit audit = audit_corner({{part, 3 * part}, {-1, -2}, {0, -1}});
  EXPECT_EQ(audit.of(CornerCheck::kFeetOnEdges).failed, 1U);
}

TEST(CornerAudit, AlignedCentreInLineWithF) {
  const std::int64_t part = CornerCase::kSide / 16;
  const CornerAudit audit = audit_corner({{part, part}, {0, 1}, {-1, 8}});
  EXPECT_EQ(audit.of(CornerCheck::kCase3Angles).failed, 1U);
  EXPECT_EQ(audit.of(CornerCheck::kCase3).looked_at, 0U);
}

TEST(CornerAudit, FootOfTheSteinerPointMoved) {
  const std::int64_t part = CornerCase::kSide / 16;
  const CornerAudit audit = audit_corner({{part, part}, {-2, 1}, {-1, 0}});
  EXPECT_EQ(audit.of(CornerCheck::kCase3AsWritten).failed, 1U);
  EXPECT_EQ(audit.of(CornerCheck::kCase3).failed, 0U);
}

TEST(CornerAudit, AReflexCornerHasManyEdges) {
  const CornerAudit audit =
      audit_corner({{CornerCase::kSide / 2, CornerCase::kSide / 2}, {1, 0}, {0, 1}});
  EXPECT_GE(std::max({audit.by_edges[4], audit.by_edges[5], audit.by_edges[6], audit.by_edges[7],
                      audit.by_edges[8]}),
            1U);
  EXPECT_EQ(audit.of(CornerCheck::kCase3).looked_at, 1U);
}

}  // namespace
}  // namespace quadbound
