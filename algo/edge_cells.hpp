// SPDX-License-Identifier: Apache-2.0
#pragma once
// The leaves of a quadtree that the edges of a domain meet.

#include <functional>
#include <span>
#include <vector>

#include "algo/domain.hpp"
#include "algo/quadtree.hpp"
#include "algo/window.hpp"

namespace quadbound {

/// Calls visit for each leaf that some edges may meet, with these edges, in the order given.
///
/// Guarantees: 1. every edge that meets the leaf grown by a quarter of its side (how far outside a
/// mirrored extra point lies) is listed; some that do not may be, too.
/// Complexity: linear in the pairs of an edge and a node of the tree that meet.
void for_leaves_with_edges(const Domain& domain, const Quadtree& tree, const Window& window,
                           const std::vector<EdgeId>& edges,
                           const std::function<void(Cell, std::span<const EdgeId>)>& visit);
/// All of them, ascending.
std::vector<EdgeId> edges_of(const Domain& domain);

/// Leaves that no quadrangulation can separate two edges in: both run through the leaf, the inside
/// between them, and come closer to each other than a quarter of its side there. To be split before
/// there is a quadrangulation, which costs far more to make; what this leaves to
/// separation_faults is the last levels.
///
/// Guarantees: 1. edges with a common vertex are not looked at. 2. each leaf of the window once.
std::vector<Cell> leaves_too_large(const Domain& domain, const Quadtree& tree,
                                   const Window& window = {});

}  // namespace quadbound
