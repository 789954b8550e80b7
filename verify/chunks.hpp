// SPDX-License-Identifier: Apache-2.0
#pragma once
// Work in chunks whose borders do not depend on the number of threads, so that neither does the
// result.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadbound::judge {

class Threads {
 public:
  /// 0: as many as there are cores; more than those are no more.
  explicit Threads(unsigned count);
  [[nodiscard]] unsigned count() const { return count_; }

  /// Calls work(i) for all i below count, in any order. Where one throws, others may be left out,
  /// and the first exception is thrown again once all threads have ended.
  template <class Work>
  void for_each(std::size_t count, const Work& work) const {
    if (count_ == 1) {
      for (std::size_t i = 0; i < count; ++i) work(i);
    } else {
      run(
          count,
          [](const void* context, std::size_t i) { (*static_cast<const Work*>(context))(i); },
          &work);
    }
  }

 private:
  void run(std::size_t count, void (*call)(const void*, std::size_t), const void* context) const;
  unsigned count_;
};

inline constexpr std::size_t kChunk = std::size_t{1} << 15;

/// summarise(begin, end) for every chunk of [0, count); the results in order.
template <class Summary, class Summarise>
std::vector<Summary> for_chunks(const Threads& threads, std::size_t count,
                                const Summarise& summarise) {
  std::vector<Summary> results((count + kChunk - 1) / kChunk);
  threads.for_each(results.size(), [&](std::size_t i) {
    results[i] = summarise(i * kChunk, std::min(count, (i + 1) * kChunk));
  });
  return results;
}

}  // namespace quadbound::judge
