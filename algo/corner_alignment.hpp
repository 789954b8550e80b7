// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lemma 12, Case 3: the centre beside the cell of a corner is aligned with the corner, so that the
// edge between them is parallel to an axis.

#include <vector>

#include "algo/domain.hpp"
#include "algo/edge_insertion.hpp"
#include "algo/kept_quads.hpp"
#include "algo/tree_mesh.hpp"

namespace quadbound {

/// A centre that was moved.
struct AlignedCentre {
  EdgeId site;  ///< the corner it is aligned with
  VertexId centre;
  LatticePoint before;
};

/// For each vertex of the domain, moves those of the four centres beside its cell that lie between
/// its edges: parallel to the side of their cell, in line with the vertex. One is moved only if the
/// angles beside the line are arctan(1/3) at least and the kept quads stay in the bounds, exactly.
///
/// Guarantees: 1. centres stay in their cells. 2. what was moved is returned, by ascending site; to
/// move it back keeps the bounds, too. Complexity: linear.
std::vector<AlignedCentre> align_with_corners(const Domain& domain, TreeMesh& tree_mesh,
                                              const CutQuads& cut_quads, const KeptQuads& kept,
                                              InsertionCounters& counters);

}  // namespace quadbound
