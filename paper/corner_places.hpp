// SPDX-License-Identifier: Apache-2.0
#pragma once
// lemma-12, where it is hardest: corners whose vertex has the same place, or the same few places, in
// its cell at every level of the tree. There a dead end of the insertion comes back however often
// the cells are split, so these are the corners that might never be meshed.

#include <cstdint>
#include <string>
#include <vector>

#include "paper/watcher.hpp"

namespace quadbound {

/// A share of the side of a cell. Split, the cell has the vertex at twice the share, less 1 if that
/// is more: 1/2 is a corner of cells from then on, others go round in a circle.
struct Share {
  std::int64_t over;
  std::int64_t under;
};

struct DeadEndTally {
  std::uint64_t corners = 0;
  std::uint64_t acute = 0;
  std::uint64_t with_dead_ends = 0;
  std::uint64_t most_rounds = 0;
  std::uint64_t refused = 0;
  std::uint64_t not_proved = 0;

  void add(const DeadEndTally& other);
};

struct CornerPlace {
  Share x;
  Share y;
  DeadEndTally tally;
};

struct CornerPlaces {
  std::vector<CornerPlace> rows;
  std::string worst;  ///< the corner that took the most rounds, or the first that failed
  [[nodiscard]] DeadEndTally total() const;
  /// All were meshed and proved.
  [[nodiscard]] bool hold() const;
};

/// Corners at each of 36 places, half of them a few lattice units off: two long edges of simple
/// slopes, of any, or nearly in line, with an interior angle from 1 to 360 degrees, closed far
/// away. Each is meshed in one root square, whatever it takes, and judged.
/// Guarantees: 1. depends on the arguments alone. Complexity: about a millisecond a corner.
CornerPlaces search_corner_places(std::uint64_t corners_at_each, Watcher& watcher);

/// A Markdown table.
std::string to_text(const CornerPlaces& places);

}  // namespace quadbound
