// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lemma 12: the polygon P_v around a vertex v of the domain, between the ends u and w of the chains
// beta of its two edges, meshed by the paper's three cases.

#include <cstdint>
#include <optional>
#include <vector>

#include "algo/domain.hpp"
#include "algo/lemma_11.hpp"
#include "algo/tree_mesh.hpp"

namespace quadbound {

/// The chain E through the 3x3 cells around v, clockwise.
struct Corner {
  EdgeId site;                  ///< v; e ends there, f starts there
  std::vector<VertexId> chain;  ///< u, ..., w
  bool starts_beside;           ///< u is an edge neighbour of v's cell, not a corner neighbour
};

/// The feet of u on e and of w on f.
struct CornerFeet {
  std::int64_t of_u;
  std::int64_t of_w;
};

/// nullopt where u or w is not in the 3x3 cells around v, or where u lies beyond w
/// or a cell between them outside the domain.
std::optional<Corner> find_corner(const Domain& domain, const TreeMesh& tree_mesh, EdgeId site,
                                  VertexId u, VertexId w);

/// Case 3: moves the edge neighbours between u and w in line with v. Nothing in the other cases.
void align_edge_neighbours(const Domain& domain, TreeMesh& tree_mesh, const Corner& corner);

/// Cases 2 and 3: moves the feet of u and w along their edges where perpendicular ones do not keep
/// the bounds, to the best places. Returns how many were moved.
unsigned settle_feet(const Domain& domain, const TreeMesh& tree_mesh, const Corner& corner,
                     CornerFeet& feet);

/// Meshes P_v. E without an edge, which the paper does not have, is the quad of u, its feet and v.
///
/// Guarantees: 1. the pieces are those of Fig. 39 to 41, with t, q and s where they leave the
/// largest slack, which may be outside the bounds. 2. nullopt where there is no way: feet beyond v.
std::optional<StripPart> mesh_by_lemma_12(const Domain& domain, const TreeMesh& tree_mesh,
                                          const Corner& corner, const CornerFeet& feet);

}  // namespace quadbound
