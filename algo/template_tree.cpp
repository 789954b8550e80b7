// SPDX-License-Identifier: Apache-2.0
#include "algo/template_tree.hpp"

namespace quadbound {

TemplateTree::TemplateTree(const Quadtree& tree, const Window& window)
    : node_of_block_(tree.blocks().size(), kNoNode) {
  const std::size_t nodes = window.is_whole() ? tree.blocks().size() : window.size();
  children_.reserve(nodes);
  fates_.assign(nodes, 0);
  copy(tree, window, 0);
}

// The recursion is as deep as the tree, i.e. at most kLatticeBits levels.
NodeId TemplateTree::copy(const Quadtree& tree, const Window& window, BlockId block) {
  const NodeId node = static_cast<NodeId>(children_.size());
  node_of_block_[block] = node;
  children_.push_back({Quadtree::kLeaf, Quadtree::kLeaf, Quadtree::kLeaf, Quadtree::kLeaf});
  for (const Quadrant q : kQuadrants) {
    if (tree.is_leaf({block, q})) continue;
    const BlockId inner = tree.content({block, q});
    const NodeId child = window.has(inner) ? copy(tree, window, inner) : CellRef::kHole;
    children_[node][q] = child;
  }
  return node;
}

void TemplateTree::forget() {
  std::vector<std::array<std::uint32_t, 4>>().swap(children_);
  std::vector<std::uint8_t>().swap(fates_);
  std::vector<NodeId>().swap(node_of_block_);
  std::vector<bool>().swap(is_extra_);
  std::vector<std::pair<VertexId, VertexId>>().swap(halves_extras_);
}

void TemplateTree::set_fate(NodeId node, Quadrant q, ExtraFate fate) {
  const unsigned shift = 2U * q;
  fates_[node] = static_cast<std::uint8_t>((fates_[node] & ~(3U << shift)) |
                                           (static_cast<unsigned>(fate) << shift));
}

}  // namespace quadbound
