// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sets of things of which it is known, pair by pair, whether they are on the same side or not.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadbound {

/// Union-find with parities.
///
/// Guarantees: 1. find(a) and find(b) have the same set exactly if joins lead from a to b; then
/// their sides differ exactly if an odd number of those joins says so (the same along all ways if
/// the joins agree). Complexity: logarithmic, amortised, by halved paths alone.
/// Requires: fewer than 2^31 of them.
class SideSets {
 public:
  struct Place {
    std::uint32_t set;
    bool other_side;  ///< than the set
  };

  explicit SideSets(std::size_t size) : links_(size) {
    for (std::size_t i = 0; i < size; ++i) links_[i] = static_cast<std::uint32_t>(i) << 1U;
  }

  Place find(std::uint32_t i) {
    std::uint32_t link = links_[i];
    for (std::uint32_t parent = link >> 1U; links_[parent] >> 1U != parent; parent = link >> 1U) {
      link = links_[parent] ^ (link & 1U);
      links_[i] = link;
    }
    return {link >> 1U, (link & 1U) != 0};
  }

  void join(std::uint32_t a, std::uint32_t b, bool other_side) {
    const Place pa = find(a);
    const Place pb = find(b);
    if (pa.set == pb.set) return;
    const bool odd = other_side != (pa.other_side != pb.other_side);
    // The earlier one stays the root: neighbours in number are neighbours in the plane.
    const auto [root, leaf] = std::minmax(pa.set, pb.set);
    links_[leaf] = root << 1U | (odd ? 1U : 0U);
  }

 private:
  std::vector<std::uint32_t> links_;  ///< parent << 1 | on the other side than it
};

}  // namespace quadbound
