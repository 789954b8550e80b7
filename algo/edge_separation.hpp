// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 3.1.1: edge separation. Where two edges come too close for the quads between them, the
// cells there are split.

#include <vector>

#include "algo/cut_quads.hpp"
#include "algo/domain.hpp"
#include "algo/tree_mesh.hpp"

namespace quadbound {

struct SeparationFault {
  Cell split;   ///< a leaf to be split
  EdgeId edge;  ///< two edges that are too close to each other there
  EdgeId other;
};

/// What keeps the edges from being separated.
///
/// In the core of the window only. Guarantees: 1. None are found exactly if (i) a quad that two
/// edges cut with the interior between them belongs to the 5x5 grid of a vertex of both, and (ii)
/// the edges above a vertex inside are one at most, or end in the vertex of the domain in whose 5x5
/// grid it lies. 2. For each fault the largest of the leaves at the quads in question are named.
/// 3. Two faults of a leaf that come next to each other are between different edges. Complexity:
/// linear in the cuts, times the logarithm of the depth of the tree; 16 bytes for each node of it.
std::vector<SeparationFault> separation_faults(const Domain& domain, const TreeMesh& tree_mesh,
                                               const CutQuads& cut_quads);

/// Leaves along the gaps between the pairs of edges of some faults: those that one edge of the pair
/// meets, as large as the leaf of a fault of the pair at least, where the gap is no wider than
/// there. They are looked for in the whole tree.
///
/// Where a gap is one to three cells wide, equal cells separate its edges but cells of two sizes do
/// not; without this, each round would split one more cell along the gap.
/// Complexity: linear in the leaves that the edges of the pairs meet, times the pairs that an edge
/// is in.
std::vector<Cell> leaves_along_gaps(const Domain& domain, const Quadtree& tree,
                                    const std::vector<SeparationFault>& faults);

}  // namespace quadbound
