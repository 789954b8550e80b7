// SPDX-License-Identifier: Apache-2.0
// The chains beta against the paper's rules, leaf by leaf in exact arithmetic.
#include "algo/quadtree_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "algo/chain_sample_for_tests.hpp"

namespace quadbound {
namespace {

struct Square {
  std::int64_t west, south, east, north;
};

Square square_of(const ChainSample& sample, Cell leaf) {
  const LatticePoint low = sample.tree().corner(leaf);
  const std::int64_t side = std::int64_t{1} << sample.tree().side_bits(leaf);
  return {low.x, low.y, low.x + side, low.y + side};
}

bool same(Cell a, Cell b) { return a.block == b.block && a.quadrant == b.quadrant; }

/// Section 3.1 for one edge, by looking at every leaf.
class Rules {
 public:
  Rules(const ChainSample& sample, EdgeId edge)
      : sample_(sample), edge_(edge), axes_(axes_of(sample.domain(), edge)) {
    const RationalPoint d = sample.direction(edge);
    rises_ = d.x * Rational(axes_.north.x) + d.y * Rational(axes_.north.y) >= 0;
  }

  std::set<VertexId> run() {
    const std::vector<Cell> leaves = sample_.leaves();
    for (const Cell leaf : leaves) {
      if (!is_crossed(leaf)) continue;
      ++crossed;
      if (add(leaf)) continue;  // rule 1
      ++below;
      for (const Cell other : leaves) {  // rules 2 and 3
        if (is_beside(leaf, other, axes_.north)) add(other);
        const LatticePoint east = axes_.east;
        if (is_beside(leaf, other, rises_ ? LatticePoint{-east.x, -east.y} : east)) add(other);
      }
    }
    return found_;
  }

  std::size_t crossed = 0;
  std::size_t below = 0;

 private:
  bool add(Cell leaf) {
    const TreeMesh& tree_mesh = sample_.tree_mesh();
    if (!tree_mesh.has(leaf) || !sample_.is_above(edge_, tree_mesh.centre(leaf))) return false;
    if (!tree_mesh.is_site(tree_mesh.centre(leaf))) found_.insert(tree_mesh.centre(leaf));
    return true;
  }

  /// Not a cell of an end; corners on both sides or on the line, one of them above; and the line's
  /// way through it is between the ends.
  [[nodiscard]] bool is_crossed(Cell leaf) const {
    const TreeMesh& tree_mesh = sample_.tree_mesh();
    if (same(leaf, tree_mesh.cell_of(edge_)) ||
        same(leaf, tree_mesh.cell_of(sample_.domain().next(edge_))))
      return false;
    const Square s = square_of(sample_, leaf);
    if (is_far(s)) return false;
    int above = 0;
    for (const LatticePoint corner : {LatticePoint{s.west, s.south}, LatticePoint{s.east, s.south},
                                      LatticePoint{s.west, s.north}, LatticePoint{s.east, s.north}})
      above += sample_.height(edge_, corner) > 0 ? 1 : 0;
    if (above == 0 || above == 4) return false;
    const RationalPoint a = sample_.at(edge_);
    const RationalPoint d = sample_.direction(edge_);
    std::vector<std::pair<Rational, Rational>> ways;  // parameters of the line between two sides
    if (d.x != 0)
      ways.push_back(std::minmax(Rational((Rational(s.west) - a.x) / d.x),
                                 Rational((Rational(s.east) - a.x) / d.x)));
    if (d.y != 0)
      ways.push_back(std::minmax(Rational((Rational(s.south) - a.y) / d.y),
                                 Rational((Rational(s.north) - a.y) / d.y)));
    Rational first = ways.front().first;
    Rational last = ways.front().second;
    for (const auto& [from, to] : ways) {
      first = std::max(first, from);
      last = std::min(last, to);
    }
    return first + last > 0 && first + last < 2;
  }

  /// Outside the box of the edge's ends, so that no point of the edge is in it.
  [[nodiscard]] bool is_far(const Square& s) const {
    const LatticePoint a = sample_.domain().floor(edge_);
    const LatticePoint b = sample_.domain().floor(sample_.domain().next(edge_));
    return std::max(a.x, b.x) + 1 < s.west || s.east < std::min(a.x, b.x) ||
           std::max(a.y, b.y) + 1 < s.south || s.north < std::min(a.y, b.y);
  }

  /// Whether `other` has a part of the leaf's side in a direction.
  [[nodiscard]] bool is_beside(Cell leaf, Cell other, LatticePoint direction) const {
    const Square a = square_of(sample_, leaf);
    const Square b = square_of(sample_, other);
    const bool rows_meet = std::max(a.south, b.south) < std::min(a.north, b.north);
    const bool columns_meet = std::max(a.west, b.west) < std::min(a.east, b.east);
    if (direction.x != 0)
      return rows_meet && (direction.x > 0 ? b.west == a.east : b.east == a.west);
    return columns_meet && (direction.y > 0 ? b.south == a.north : b.north == a.south);
  }

  const ChainSample& sample_;
  EdgeId edge_;
  EdgeAxes axes_;
  bool rises_;
  std::set<VertexId> found_;
};

TEST(QuadtreeChain, AxesAreWithin45DegreesOfTheEdge) {
  for_chain_samples([](const ChainSample& sample) {
    for (EdgeId e = 0; e < sample.domain().size(); ++e) {
      const EdgeAxes axes = axes_of(sample.domain(), e);
      EXPECT_EQ(std::abs(axes.east.x) + std::abs(axes.east.y), 1);
      EXPECT_EQ(axes.north.x, -axes.east.y);
      EXPECT_EQ(axes.north.y, axes.east.x);
      EXPECT_GE(axes.slope.x, std::abs(axes.slope.y));
    }
  });
}

TEST(QuadtreeChain, Guarantee1CentresAreAboveAndNoVertices) {
  std::size_t centres = 0;
  for_chain_samples([&](const ChainSample& sample) {
    const auto chains = quadtree_chains(sample.domain(), sample.tree_mesh());
    ASSERT_EQ(chains.size(), sample.domain().size());
    for (EdgeId e = 0; e < chains.size(); ++e)
      for (const VertexId v : chains[e]) {
        ++centres;
        EXPECT_TRUE(sample.is_above(e, v));
        EXPECT_FALSE(sample.tree_mesh().is_site(v));
        EXPECT_EQ(sample.tree_mesh().centre(sample.tree_mesh().leaf_of(v)), v);
      }
  });
  EXPECT_GT(centres, 3000U);
}

TEST(QuadtreeChain, Guarantee2CentresAreThoseOfTheRules) {
  std::size_t crossed = 0;
  std::size_t below = 0;
  for_chain_samples([&](const ChainSample& sample) {
    const auto chains = quadtree_chains(sample.domain(), sample.tree_mesh());
    for (EdgeId e = 0; e < chains.size(); ++e) {
      Rules rules(sample, e);
      EXPECT_EQ(std::set<VertexId>(chains[e].begin(), chains[e].end()), rules.run())
          << "edge " << e;
      crossed += rules.crossed;
      below += rules.below;
    }
  });
  EXPECT_GT(crossed, 3000U);
  EXPECT_GT(below, 1000U);
}

TEST(QuadtreeChain, Guarantee3CentresComeByXAndThenYFallingWhereTheEdgeFalls) {
  std::size_t same_x = 0;
  std::size_t falling = 0;
  for_chain_samples([&](const ChainSample& sample) {
    const auto chains = quadtree_chains(sample.domain(), sample.tree_mesh());
    for (EdgeId e = 0; e < chains.size(); ++e) {
      const auto [east, north, slope] = axes_of(sample.domain(), e);
      for (std::size_t i = 0; i + 1 < chains[e].size(); ++i) {
        const LatticePoint a = sample.tree_mesh().at(chains[e][i]);
        const LatticePoint b = sample.tree_mesh().at(chains[e][i + 1]);
        const std::int64_t x = east.x * (b.x - a.x) + east.y * (b.y - a.y);
        const std::int64_t y = north.x * (b.x - a.x) + north.y * (b.y - a.y);
        EXPECT_TRUE(x > 0 || (x == 0 && (slope.y >= 0 ? y > 0 : y < 0)));
        same_x += x == 0 ? 1U : 0U;
        falling += x == 0 && slope.y < 0 ? 1U : 0U;
      }
    }
  });
  EXPECT_GT(same_x, 20U);
  EXPECT_GT(falling, 10U);
}

}  // namespace
}  // namespace quadbound
