// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 2.2 and 2.3: the quadrangulation Q of a balanced quadtree.

#include "algo/apply_template.hpp"
#include "algo/counters.hpp"
#include "algo/quadtree.hpp"
#include "algo/template_tree.hpp"
#include "model/mesh.hpp"

namespace quadbound {

/// Walks applyTemplate from the root and returns all quads, counter-clockwise.
///
/// Guarantees: 1. every leaf has its centre as a vertex, found by tree.centre(...) afterwards.
/// 2. all vertices are used and lie on the lattice. 3. with TwoTwoVariant::kExact all angles are
/// within thm-1's interval (proved case by case in theorem-1) and there are at most 3 N quads.
/// 4. the result depends on the set of nodes alone. Of a tree with holes, 1 and 3 hold, and quads
/// that reach into a hole are left out. 5. leaves that are left out, and their quads, are missing
/// as TemplateTree says; the others keep their order. The counters count them all. Requires: a
/// balanced tree (condition C). Complexity: linear.
Mesh quadrangulate(TemplateTree& tree, const RootSquare& root, TwoTwoVariant variant,
                   Counters& counters);

}  // namespace quadbound
