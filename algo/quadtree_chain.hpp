// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 3.1: the quadtree chain beta of each edge.
//
// Used only where a polygon is meshed by the paper's own cases (EdgeInsertion::kLemmas).

#include <vector>

#include "algo/domain.hpp"
#include "algo/tree_mesh.hpp"

namespace quadbound {

/// The direction among the four of the axes that an edge runs in, within 45 degrees: the paper's x
/// axis, and its y axis.
struct EdgeAxes {
  LatticePoint east;
  LatticePoint north;
  Vector slope;  ///< of the edge, in these axes
};
EdgeAxes axes_of(const Domain& domain, EdgeId edge);

/// By edge the centres of its chain.
///
/// Guarantees: 1. All are strictly above their edge, and none is a vertex of the domain. 2. They
/// are those of the paper's rules 1 to 3, but for what rule 2 names and is not above. 3. They come
/// by x and then y, falling for theta < 0. Both repairs: paper/departures.md.
/// Complexity: n log n in the leaves that edges meet.
std::vector<std::vector<VertexId>> quadtree_chains(const Domain& domain, const TreeMesh& tree_mesh);

}  // namespace quadbound
