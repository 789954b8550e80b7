// SPDX-License-Identifier: Apache-2.0
#pragma once
// What Lemmas 2 to 11 are used on: trees of polygons, cut by the lines of their own edges.

#include <cstdint>
#include <optional>
#include <vector>

#include "model/polygon.hpp"
#include "paper/cut_tree.hpp"
#include "paper/lemma_audit.hpp"
#include "paper/watcher.hpp"

namespace quadbound {

struct PolygonTree {
  Quadtree tree;
  std::vector<LatticePoint> vertices;
  /// Of the edges with -45 <= theta <= 45 degrees and the inside above, as Section 3.1 asks.
  std::vector<CutLine> lines;
};

/// The polygon turned by so many right angles, the longer side of its bounding box from 3/8 to 5/8
/// of the root's, and its vertices rounded to 2^-16 of that side.
///
/// Guarantees: 1. the tree is the one that a mesh of that polygon starts from: conditions A, B, C,
/// the 5x5 grids, and the part of edge separation that needs no quads. 2. over four turns every
/// edge has its line, which goes through both of its vertices exactly. 3. nullopt exactly where the
/// rounded polygon is not valid, or the tree needs finer cells than the lattice has.
/// Requires: validate(polygon), normalised.
std::optional<PolygonTree> tree_of_polygon(const Polygon& polygon, int turns);

struct PolygonTreesAudit {
  LemmaAudit audit;
  std::uint64_t polygons = 0;  ///< each turned four times
  std::uint64_t refused = 0;   ///< of them, without a tree
};

/// So many polygons of 24 families in turns, with the seeds from 1 on, and some more.
/// Guarantees: 1. the same arguments give the same counts. Complexity: about 0.1 s for a polygon.
PolygonTreesAudit audit_polygon_trees(std::uint64_t count, const std::vector<Polygon>& more,
                                      Watcher& watcher);

}  // namespace quadbound
