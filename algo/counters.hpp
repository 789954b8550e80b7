// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the mesher did, in numbers that are the same on every machine, thread count and run.

#include <array>
#include <cstdint>

#include "algo/construction.hpp"

namespace quadbound {

inline constexpr int kMaxLevels = 64;

struct Counters {
  std::array<std::uint64_t, kMaxLevels> leaves_by_level{};
  std::uint64_t splits = 0;             ///< internal nodes of the quadtree
  std::uint64_t refinement_splits = 0;  ///< those of them made for the 5x5 grids around the points
  std::array<std::uint64_t, kTemplateCount> templates{};
  std::array<std::uint64_t, kStitchCaseCount> stitch_cases{};
  std::array<std::uint64_t, kConstructionCount> quads{};
  std::uint64_t extras_made = 0;
  std::uint64_t extras_moved = 0;
  std::uint64_t extras_dropped = 0;
  std::uint64_t centres_aligned = 0;  ///< by the repair of the warping step
  friend bool operator==(const Counters&, const Counters&) = default;
};

}  // namespace quadbound
