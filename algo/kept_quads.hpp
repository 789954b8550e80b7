// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 3.1.2: the quads that are kept, K, and the chains alpha along which the strip between K
// and the edges begins.

#include <vector>

#include "algo/cut_quads.hpp"
#include "algo/domain.hpp"
#include "algo/tree_mesh.hpp"

namespace quadbound {

/// The boundary of K as closed chains with K on their left: one for each ring of the domain, in its
/// direction. The paper's spikes (edges that alpha runs along twice) do not occur.
struct KeptQuads {
  std::vector<bool> is_kept;                  ///< by quad
  std::vector<std::vector<VertexId>> alphas;  ///< empty where the boundary of K is broken
  std::vector<VertexId> pinched;              ///< see pinched_vertices
};

/// K: the quads that no edge cuts and whose vertices all lie strictly inside the domain.
/// Requires: the window is whole. Complexity: linear.
KeptQuads keep_quads(const TreeMesh& tree_mesh, const CutQuads& cut_quads);

/// Vertices where the boundary of K meets itself, in the core of the window: leaves there are to be
/// split. Complexity: linear.
std::vector<VertexId> pinched_vertices(const TreeMesh& tree_mesh, const CutQuads& cut_quads);

}  // namespace quadbound
