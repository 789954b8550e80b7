// SPDX-License-Identifier: Apache-2.0
#pragma once
// K and the strips put together to the mesh of a domain.

#include <vector>

#include "algo/domain_mesh.hpp"
#include "algo/edge_insertion.hpp"
#include "algo/kept_quads.hpp"
#include "algo/quadtree.hpp"
#include "model/mesh.hpp"

namespace quadbound {

/// Guarantees: 1. the vertices of K and of alpha first, in the order of Q, then those of the
/// domain, then the feet by edge and place, then Steiner points. 2. a foot that two pieces share is
/// one vertex. Complexity: linear, and sorting the feet. The memory of the quads of Q is used
/// again.
DomainMesh assemble(const Domain& domain, const Quadtree& tree, Mesh q, const KeptQuads& kept,
                    const std::vector<Strip>& strips);

}  // namespace quadbound
