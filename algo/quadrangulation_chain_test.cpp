// SPDX-License-Identifier: Apache-2.0
// The chains alpha_i between the centres of beta, against Q in exact arithmetic.
#include "algo/quadrangulation_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "algo/chain_sample_for_tests.hpp"
#include "algo/quadtree_chain.hpp"

namespace quadbound {
namespace {

using Chain = std::vector<VertexId>;

std::pair<VertexId, VertexId> pair_of(VertexId a, VertexId b) { return std::minmax({a, b}); }

/// The edges of some quads, and of all of Q.
std::set<std::pair<VertexId, VertexId>> edges_of(const Mesh& mesh, const std::set<QuadId>& quads) {
  std::set<std::pair<VertexId, VertexId>> edges;
  for (const QuadId q : quads)
    for (unsigned k = 0; k < 4; ++k)
      edges.insert(pair_of(mesh.quads[q][k], mesh.quads[q][(k + 1) & 3U]));
  return edges;
}

void expect_chain(const Chain& chain, VertexId from, VertexId to,
                  const std::set<std::pair<VertexId, VertexId>>& edges) {
  ASSERT_GE(chain.size(), 2U);
  EXPECT_EQ(chain.front(), from) << "guarantee 1";
  EXPECT_EQ(chain.back(), to) << "guarantee 1";
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    EXPECT_TRUE(edges.contains(pair_of(chain[i], chain[i + 1]))) << "guarantee 1";
  for (std::size_t i = 0; i + 2 < chain.size(); ++i)
    EXPECT_NE(chain[i], chain[i + 2]) << "guarantee 3";
}

/// Calls check(edge, its cuts, c_i, c_(i+1)).
template <class Check>
void for_centres(const ChainSample& sample, const Check& check) {
  const auto betas = quadtree_chains(sample.domain(), sample.tree_mesh());
  const auto cuts = cuts_by_edge(sample.domain(), sample.cut_quads());
  for (EdgeId e = 0; e < betas.size(); ++e)
    for (std::size_t i = 0; i + 1 < betas[e].size(); ++i)
      check(e, cuts[e], betas[e][i], betas[e][i + 1]);
}

TEST(QuadrangulationChain, CutsByEdgeGuarantee1EachIsThereOnceWithItsEdge) {
  using Entry = std::pair<QuadId, EdgeId>;
  for_chain_samples([](const ChainSample& sample) {
    std::multiset<Entry> expected;
    for (const Cut& cut : sample.cut_quads().cuts()) expected.emplace(cut.quad, cut.edge);
    std::multiset<Entry> found;
    const auto by_edge = cuts_by_edge(sample.domain(), sample.cut_quads());
    ASSERT_EQ(by_edge.size(), sample.domain().size());
    for (EdgeId e = 0; e < by_edge.size(); ++e)
      for (const Cut& cut : by_edge[e]) {
        EXPECT_EQ(cut.edge, e);
        found.emplace(cut.quad, cut.edge);
      }
    EXPECT_EQ(found, expected);
    EXPECT_FALSE(found.empty());
  });
}

TEST(QuadrangulationChain, CutsByEdgeGuarantee2TheyComeByTheirBeginningAndEnd) {
  for_chain_samples([](const ChainSample& sample) {
    const auto ends = [&](const Cut& cut) {
      const auto [from, to] = sample.cut_quads().passage(cut);
      return std::pair{from, to};
    };
    for (const std::vector<Cut>& cuts : cuts_by_edge(sample.domain(), sample.cut_quads()))
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) EXPECT_LE(ends(cuts[i]), ends(cuts[i + 1]));
  });
}

TEST(QuadrangulationChain, PartGuarantees1And3LeadAlongCutQuadsAndNotBack) {
  std::size_t longer = 0;
  for_chain_samples([&](const ChainSample& sample) {
    for_centres(sample, [&](EdgeId, const std::vector<Cut>& cuts, VertexId c, VertexId next) {
      const QuadrangulationChain alpha(sample.domain(), sample.tree_mesh(), cuts);
      const std::optional<Chain> part = alpha.part(c, next);
      ASSERT_TRUE(part) << "lemma-3";
      std::set<QuadId> quads;
      for (const Cut& cut : cuts) quads.insert(cut.quad);
      expect_chain(*part, c, next, edges_of(sample.tree_mesh().mesh(), quads));
      longer += part->size() > 2 ? 1U : 0U;
    });
  });
  EXPECT_GT(longer, 1000U);
}

TEST(QuadrangulationChain, PartGuarantee2AllVerticesAreAbove) {
  std::size_t vertices = 0;
  for_chain_samples([&](const ChainSample& sample) {
    for_centres(sample, [&](EdgeId e, const std::vector<Cut>& cuts, VertexId c, VertexId next) {
      const auto part =
          QuadrangulationChain(sample.domain(), sample.tree_mesh(), cuts).part(c, next);
      ASSERT_TRUE(part) << "lemma-3";
      for (const VertexId v : *part) EXPECT_TRUE(sample.is_above(e, v));
      vertices += part->size();
    });
  });
  EXPECT_GT(vertices, 5000U);
}

TEST(QuadrangulationChain, ThereIsNoPartBackwardsNorOfStrangers) {
  const ChainSample sample("blob:n=12,seed=1", 0);
  for_centres(sample, [&](EdgeId, const std::vector<Cut>& cuts, VertexId c, VertexId next) {
    const QuadrangulationChain alpha(sample.domain(), sample.tree_mesh(), cuts);
    EXPECT_TRUE(alpha.part(c, next));
    EXPECT_FALSE(alpha.part(next, c));
    EXPECT_FALSE(alpha.part(kNoVertex - 1, next));
  });
}

TEST(QuadrangulationChain, ChainAboveGuarantees1To3) {
  std::size_t instead = 0;
  for_chain_samples([&](const ChainSample& sample) {
    const TreeMesh& tree_mesh = sample.tree_mesh();
    std::set<QuadId> all;
    for (QuadId q = 0; q < tree_mesh.mesh().quads.size(); ++q) all.insert(q);
    const auto edges = edges_of(tree_mesh.mesh(), all);
    for_centres(sample, [&](EdgeId, const std::vector<Cut>& cuts, VertexId c, VertexId next) {
      const auto part = QuadrangulationChain(sample.domain(), tree_mesh, cuts).part(c, next);
      ASSERT_TRUE(part);
      const std::optional<Chain> above = chain_above(tree_mesh, c, next);
      ASSERT_TRUE(above) << "lemma-6";
      expect_chain(*above, c, next, edges);
      EXPECT_FALSE(runs_under(tree_mesh, *above)) << "guarantee 2";
      instead += runs_under(tree_mesh, *part) ? 1U : 0U;
    });
  });
  EXPECT_GT(instead, 5U);  // there only is it asked for
}

TEST(QuadrangulationChain, RunsUnderIsExact) {
  std::size_t under = 0;
  for_chain_samples([&](const ChainSample& sample) {
    const TreeMesh& tree_mesh = sample.tree_mesh();
    for_centres(sample, [&](EdgeId, const std::vector<Cut>& cuts, VertexId c, VertexId next) {
      const auto part = QuadrangulationChain(sample.domain(), tree_mesh, cuts).part(c, next);
      ASSERT_TRUE(part);
      const LatticePoint a = tree_mesh.at(c);
      const LatticePoint b = tree_mesh.at(next);
      const bool expected = std::any_of(part->begin(), part->end(), [&](VertexId v) {
        const LatticePoint p = tree_mesh.at(v);
        return Rational(b.x - a.x) * Rational(p.y - a.y) <
               Rational(b.y - a.y) * Rational(p.x - a.x);
      });
      EXPECT_EQ(runs_under(tree_mesh, *part), expected);
      under += expected ? 1U : 0U;
    });
  });
  EXPECT_GT(under, 5U);
}

TEST(QuadrangulationChain, WithoutRepeatedLeavesOutWhatRunsThereAndBack) {
  EXPECT_EQ(without_repeated({}), Chain());
  EXPECT_EQ(without_repeated({1, 2, 3}), Chain({1, 2, 3}));
  EXPECT_EQ(without_repeated({1, 2, 3, 2, 4}), Chain({1, 2, 4}));
  EXPECT_EQ(without_repeated({1, 2, 3, 4, 3, 2, 5}), Chain({1, 2, 5}));
  EXPECT_EQ(without_repeated({1, 2, 3, 1}), Chain({1, 2, 3, 1}));
}

}  // namespace
}  // namespace quadbound
