// SPDX-License-Identifier: Apache-2.0
#pragma once
// A small domain with its tree and Q, for the tests of the chains.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "algo/cut_quads.hpp"
#include "algo/domain.hpp"
#include "algo/edge_cells.hpp"
#include "algo/kites.hpp"
#include "algo/separation.hpp"
#include "algo/tree_mesh.hpp"
#include "generators/polygons.hpp"
#include "generators/random.hpp"
#include "model/exact.hpp"
#include "model/validate.hpp"

namespace quadbound {

/// The tree has all 5x5 grids and some further splits. No kites: acute corners stay.
class ChainSample {
 public:
  ChainSample(const std::string& recipe, std::uint64_t splits)
      : ChainSample(normalised(generate_polygon(parse_polygon_recipe(recipe))), splits) {}
  ChainSample(const Polygon& polygon, std::uint64_t splits)
      : domain_(domain_of(polygon)),
        separation_(placed_vertices(domain_), {}),
        edge_cells_(domain_, split_tree(splits)),
        tree_mesh_(domain_, separation_, edge_cells_, counters_),
        cut_quads_(domain_, tree_mesh_, edge_cells_) {}

  [[nodiscard]] const Domain& domain() const { return domain_; }
  [[nodiscard]] const Quadtree& tree() const { return separation_.tree(); }
  [[nodiscard]] const TreeMesh& tree_mesh() const { return tree_mesh_; }
  [[nodiscard]] const CutQuads& cut_quads() const { return cut_quads_; }

  [[nodiscard]] std::vector<Cell> leaves() const {
    std::vector<Cell> found;
    for (BlockId block = 0; block < tree().blocks().size(); ++block)
      for (const Quadrant q : kQuadrants)
        if (tree().is_leaf({block, q})) found.push_back({block, q});
    return found;
  }
  /// A vertex of the domain in lattice units.
  [[nodiscard]] RationalPoint at(EdgeId vertex) const {
    const Rational unit = dyadic(1, domain_.root().exponent);
    const RationalPoint point = domain_.vertices().exact(vertex);
    return {point.x / unit, point.y / unit};
  }
  [[nodiscard]] RationalPoint direction(EdgeId e) const {
    const RationalPoint a = at(e);
    const RationalPoint b = at(domain_.next(e));
    return {b.x - a.x, b.y - a.y};
  }
  /// Positive strictly above an edge: on its left.
  [[nodiscard]] Rational height(EdgeId e, LatticePoint p) const {
    const RationalPoint a = at(e);
    const RationalPoint d = direction(e);
    return d.x * (Rational(p.y) - a.y) - d.y * (Rational(p.x) - a.x);
  }
  [[nodiscard]] bool is_above(EdgeId e, VertexId v) const {
    return height(e, tree_mesh_.at(v)) > 0;
  }

 private:
  static Domain domain_of(const Polygon& polygon) {
    std::vector<Point> points;
    for (const Ring& ring : polygon.rings) points.insert(points.end(), ring.begin(), ring.end());
    const RootSquare root = place_root(points, {3, 5}).root;
    return cut_kites(polygon, root, std::vector<bool>(points.size()));
  }
  const Quadtree& split_tree(std::uint64_t splits) {
    separation_.apply_conditions();
    separation_.refine_five_by_five();
    RandomIntegers random(splits);
    for (std::uint64_t i = 0; i < splits; ++i) {
      const std::vector<Cell> all = leaves();
      separation_.refine({all[random.below(all.size())]});
    }
    return separation_.tree();
  }

  Domain domain_;
  Separation separation_;
  Counters counters_;
  EdgeCells edge_cells_;
  TreeMesh tree_mesh_;
  CutQuads cut_quads_;
};

/// Calls check(sample) for tame and for sharp polygons, with and without further splits.
template <class Check>
void for_chain_samples(const Check& check) {
  for (const char* const family : {"blob", "regular", "star", "two-opt", "grid-aligned", "slopes"})
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      for (const std::uint64_t splits : {0U, 12U}) {
        const std::string recipe = std::string(family) + ":n=12,seed=" + std::to_string(seed);
        SCOPED_TRACE(recipe + ", " + std::to_string(splits) + " splits");
        check(ChainSample(recipe, splits));
      }
}

}  // namespace quadbound
