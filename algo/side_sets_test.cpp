// SPDX-License-Identifier: Apache-2.0
#include "algo/side_sets.hpp"

#include <gtest/gtest.h>

#include <random>

namespace quadbound {
namespace {

TEST(SideSets, TellJoinedThingsApartByParity) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::mt19937_64 engine(seed);
    constexpr std::uint32_t kSize = 400;
    // Sides and groups that the joins agree with; within a group all are joined in a random tree.
    std::vector<bool> side(kSize);
    std::vector<std::uint32_t> group(kSize);
    std::vector<std::vector<std::uint32_t>> members(5);
    SideSets sets(kSize);
    for (std::uint32_t i = 0; i < kSize; ++i) {
      side[i] = engine() % 2 == 0;
      group[i] = static_cast<std::uint32_t>(engine() % members.size());
      members[group[i]].push_back(i);
    }
    for (const std::vector<std::uint32_t>& of_group : members) {
      for (std::size_t k = 1; k < of_group.size(); ++k) {
        const std::uint32_t other = of_group[engine() % k];
        sets.join(of_group[k], other, side[of_group[k]] != side[other]);
      }
    }
    for (std::uint32_t i = 0; i < kSize; ++i) {
      const std::uint32_t j = static_cast<std::uint32_t>(engine() % kSize);
      const SideSets::Place a = sets.find(i);
      const SideSets::Place b = sets.find(j);
      EXPECT_EQ(a.set == b.set, group[i] == group[j]);
      if (a.set == b.set) {
        EXPECT_EQ(a.other_side != b.other_side, side[i] != side[j]);
      }
    }
  }
}

}  // namespace
}  // namespace quadbound
