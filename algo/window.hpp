// SPDX-License-Identifier: Apache-2.0
#pragma once
// The part of a quadtree that has to be looked at again after some of its cells were split.

#include <cstdint>
#include <vector>

#include "algo/quadtree.hpp"

namespace quadbound {

/// A set of internal nodes that holds the parents of all of its own.
///
/// Guarantees: 1. The quads with a vertex in a leaf of the core are those of the whole tree, if Q
/// is made of the nodes of the window alone. 2. Quads that Q did not have before the splits have a
/// vertex in a leaf of the core. Both are tested, not proved, and nothing relies on them: what a
/// window is found to be free of is looked for in the whole tree at last.
/// Complexity: the nodes in the window, times the depth at most; one byte for each node of the
/// tree.
class Window {
 public:
  /// The whole tree, all of it core.
  Window() = default;
  /// Around what was split since the tree had `known` blocks, and some cells.
  Window(const Quadtree& tree, BlockId known, const std::vector<Cell>& cells = {});

  [[nodiscard]] bool is_whole() const { return parts_.empty(); }
  [[nodiscard]] bool has(BlockId block) const { return is_whole() || parts_[block] != 0; }
  [[nodiscard]] bool is_core(Cell leaf) const {
    return is_whole() || (parts_[leaf.block] & core_bit(leaf.quadrant)) != 0;
  }
  /// Number of nodes in it; 0 if it is whole.
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  static constexpr std::uint8_t kHas = 16;
  static constexpr std::uint8_t core_bit(Quadrant q) { return static_cast<std::uint8_t>(1U << q); }
  struct Square {
    LatticePoint low;
    std::int64_t side;
  };
  class Marking;
  void mark(const Quadtree& tree, const std::vector<BlockId>& nodes);
  std::vector<std::uint8_t> parts_;  ///< by block: kHas, and the core_bit of each leaf in the core
  std::size_t size_ = 0;
};

}  // namespace quadbound
