// SPDX-License-Identifier: Apache-2.0
#include "algo/template_tree.hpp"

namespace quadbound {

TemplateTree::TemplateTree(const Quadtree& tree) : node_of_block_(tree.blocks().size()) {
  children_.reserve(tree.blocks().size());
  fates_.assign(tree.blocks().size(), 0);
  copy(tree, 0);
}

// The recursion is as deep as the tree, i.e. at most kLatticeBits levels.
NodeId TemplateTree::copy(const Quadtree& tree, BlockId block) {
  const NodeId node = static_cast<NodeId>(children_.size());
  node_of_block_[block] = node;
  children_.push_back({Quadtree::kLeaf, Quadtree::kLeaf, Quadtree::kLeaf, Quadtree::kLeaf});
  for (const Quadrant q : kQuadrants) {
    if (tree.is_leaf({block, q})) continue;
    const NodeId child = copy(tree, tree.content({block, q}));
    children_[node][q] = child;
  }
  return node;
}

void TemplateTree::set_fate(NodeId node, Quadrant q, ExtraFate fate) {
  const unsigned shift = 2U * q;
  fates_[node] = static_cast<std::uint8_t>((fates_[node] & ~(3U << shift)) |
                                           (static_cast<unsigned>(fate) << shift));
}

Template which_template(const std::array<std::uint32_t, 4>& children) {
  unsigned leaves = 0;
  for (const Quadrant q : kQuadrants)
    leaves |= ((children[q] & Quadtree::kLeaf) != 0 ? 1U : 0U) << q;
  switch (leaves) {
    case 0b0000:
      return Template::kT0;
    case 0b0001:
    case 0b0010:
    case 0b0100:
    case 0b1000:
      return Template::kT1;
    case 0b0101:
    case 0b1010:
      return Template::kT2b;
    case 0b1111:
      return Template::kT4;
    case 0b0011:
    case 0b0110:
    case 0b1100:
    case 0b1001:
      return Template::kT2a;
    default:
      return Template::kT3;
  }
}

}  // namespace quadbound
