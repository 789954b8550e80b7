// SPDX-License-Identifier: Apache-2.0
#pragma once
// Random integers that are the same on every machine and with every standard library.

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace quadbound {

/// The bits of std::mt19937_64, which the standard fixes, mapped to integers by ourselves, because
/// it leaves the distributions and std::shuffle open.
class RandomIntegers {
 public:
  explicit RandomIntegers(std::uint64_t seed) : engine_(seed) {}

  /// Uniform on [0, 2^count). Requires: 1 <= count <= 63.
  std::int64_t bits(int count) { return static_cast<std::int64_t>(engine_() >> (64 - count)); }

  /// Uniform on [0, bound). Requires: bound > 0.
  std::uint64_t below(std::uint64_t bound) {
    // Values under `uneven` would make small results more likely than large ones.
    const std::uint64_t uneven = (0 - bound) % bound;
    std::uint64_t value = engine_();
    while (value < uneven) value = engine_();
    return value % bound;
  }

  /// Uniform on [low, high]. Requires: low <= high, and high - low < 2^63.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
  }

  /// True `percent` times in a hundred.
  bool chance(std::int64_t percent) { return between(0, 99) < percent; }

  /// Each order equally likely.
  template <class Value>
  void shuffle(std::vector<Value>& values) {
    for (std::size_t left = values.size(); left > 1; --left)
      std::swap(values[left - 1], values[below(left)]);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace quadbound
