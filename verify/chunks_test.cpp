// SPDX-License-Identifier: Apache-2.0
#include "verify/chunks.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace quadbound::judge {
namespace {

TEST(Threads, CallEveryIndexOnce) {
  for (const unsigned count : {1U, 2U, 0U})
    for (const std::size_t size : {0U, 1U, 2U, 1000U}) {
      std::vector<int> calls(size);
      Threads(count).for_each(size, [&](std::size_t i) { ++calls[i]; });
      EXPECT_EQ(calls, std::vector<int>(size, 1)) << count;
    }
}

TEST(Threads, ThrowWhatWorkThrows) {
  for (const unsigned count : {1U, 2U, 0U})
    for (const std::size_t last : {0U, 1U, 999U}) {
      const auto work = [&](std::size_t i) {
        if (i >= last) throw std::length_error(std::to_string(i));
      };
      EXPECT_THROW(Threads(count).for_each(1000, work), std::length_error) << count;
    }
}

TEST(Chunks, CoverEverythingInOrder) {
  for (const std::size_t size : {std::size_t{0}, kChunk, 5 * kChunk + 1}) {
    const auto parts = for_chunks<std::pair<std::size_t, std::size_t>>(
        Threads(0), size, [](std::size_t begin, std::size_t end) { return std::pair(begin, end); });
    std::size_t covered = 0;
    for (const auto& [begin, end] : parts) {
      EXPECT_EQ(begin, covered);
      covered = end;
    }
    EXPECT_EQ(covered, size);
  }
}

}  // namespace
}  // namespace quadbound::judge
