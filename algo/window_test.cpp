// SPDX-License-Identifier: Apache-2.0
#include "algo/window.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "algo/point_separation.hpp"
#include "algo/quadrangulation.hpp"
#include "algo/separation.hpp"
#include "algo/template_tree.hpp"

namespace quadbound {
namespace {

using PlacedQuad = std::array<std::pair<std::int64_t, std::int64_t>, 4>;

std::vector<Point> random_points(std::mt19937_64& engine, std::size_t count) {
  const auto coordinate = [&] { return std::ldexp(static_cast<double>(engine() >> 11), -53); };
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = coordinate();
    points.push_back({x, coordinate()});
  }
  return points;
}

Separation separated(std::mt19937_64& engine, std::size_t points) {
  Separation separation(place_root(random_points(engine, points)), Budget{});
  separation.apply_conditions();
  separation.refine_five_by_five();
  return separation;
}

Cell random_leaf(const Quadtree& tree, std::mt19937_64& engine) {
  for (;;) {
    const Cell cell{static_cast<BlockId>(engine() % tree.blocks().size()),
                    static_cast<Quadrant>(engine() % 4)};
    if (tree.is_leaf(cell)) return cell;
  }
}

/// The quads of Q on the nodes of a window, from their smallest vertex on.
std::set<PlacedQuad> quads_in(const Quadtree& tree, const Window& window) {
  TemplateTree template_tree(tree, window);
  Counters counters;
  const Mesh mesh = quadrangulate(template_tree, tree.root(), TwoTwoVariant::kExact, counters);
  std::set<PlacedQuad> quads;
  for (const Quad& quad : mesh.quads) {
    PlacedQuad placed{};
    for (unsigned k = 0; k < 4; ++k) {
      const LatticePoint at = mesh.vertices.lattice(quad[k]);
      placed[k] = {at.x, at.y};
    }
    std::rotate(placed.begin(), std::min_element(placed.begin(), placed.end()), placed.end());
    quads.insert(placed);
  }
  return quads;
}

bool has_vertex_in_core(const Quadtree& tree, const Window& window, const PlacedQuad& quad) {
  return std::any_of(quad.begin(), quad.end(), [&](const auto& at) {
    return window.is_core(tree.leaf_at({at.first, at.second}));
  });
}

std::set<PlacedQuad> in_core(const Quadtree& tree, const Window& window,
                             const std::set<PlacedQuad>& quads) {
  std::set<PlacedQuad> found;
  for (const PlacedQuad& quad : quads)
    if (has_vertex_in_core(tree, window, quad)) found.insert(quad);
  return found;
}

TEST(Window, HasTheQuadsOfTheWholeTreeInItsCoreAndAllThatAreNew) {
  std::size_t smaller = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    std::mt19937_64 engine(seed);
    Separation separation = separated(engine, 3 + seed);
    const Quadtree& tree = separation.tree();
    for (int round = 0; round < 5; ++round) {
      const auto known = static_cast<BlockId>(tree.blocks().size());
      const std::set<PlacedQuad> before = quads_in(tree, {});
      std::vector<Cell> leaves;
      for (std::uint64_t i = 0; i <= engine() % 4; ++i) leaves.push_back(random_leaf(tree, engine));
      separation.refine(leaves);
      const Window window(tree, known);
      smaller += window.size() < tree.blocks().size() ? 1U : 0U;
      const std::set<PlacedQuad> whole = quads_in(tree, {});
      EXPECT_EQ(in_core(tree, window, quads_in(tree, window)), in_core(tree, window, whole))
          << "guarantee 1, seed " << seed << ", round " << round;
      for (const PlacedQuad& quad : whole) {
        EXPECT_TRUE(before.contains(quad) || has_vertex_in_core(tree, window, quad))
            << "guarantee 2, seed " << seed << ", round " << round;
      }
    }
  }
  EXPECT_GT(smaller, 100U);
}

TEST(Window, OfCellsHasTheQuadsOfTheWholeTreeAtThem) {
  std::mt19937_64 engine(11);
  Separation separation = separated(engine, 200);
  const Quadtree& tree = separation.tree();
  const std::set<PlacedQuad> whole = quads_in(tree, {});
  for (int round = 0; round < 20; ++round) {
    const std::vector<Cell> cells{random_leaf(tree, engine), random_leaf(tree, engine)};
    const Window window(tree, static_cast<BlockId>(tree.blocks().size()), cells);
    EXPECT_LT(window.size(), tree.blocks().size());
    for (const Cell cell : cells) EXPECT_TRUE(window.is_core(cell));
    EXPECT_EQ(in_core(tree, window, quads_in(tree, window)), in_core(tree, window, whole));
  }
}

TEST(Window, HoldsTheParentsOfItsNodesAndIsWholeByDefault) {
  std::mt19937_64 engine(7);
  Separation separation = separated(engine, 50);
  const Quadtree& tree = separation.tree();
  const auto known = static_cast<BlockId>(tree.blocks().size());
  EXPECT_TRUE(Window().is_whole() && Window().has(0) && Window().is_core({known - 1, kNorthWest}));
  separation.refine({random_leaf(tree, engine)});
  const Window window(tree, known);
  std::size_t size = 0;
  for (BlockId block = 0; block < tree.blocks().size(); ++block) {
    size += window.has(block) ? 1U : 0U;
    EXPECT_TRUE(block == 0 || !window.has(block) || window.has(tree.blocks()[block].parent));
    for (const Quadrant q : kQuadrants)
      EXPECT_TRUE(block < known || !tree.is_leaf({block, q}) || window.is_core({block, q}));
  }
  EXPECT_EQ(window.size(), size);
}

}  // namespace
}  // namespace quadbound
