// SPDX-License-Identifier: Apache-2.0
#include "verify/chunks.hpp"

#include <atomic>
#include <exception>
#include <thread>

namespace quadbound::judge {

Threads::Threads(unsigned count) {
  const unsigned most = std::max(1U, std::thread::hardware_concurrency());
  count_ = count == 0 ? most : std::min(count, most);
}

void Threads::run(std::size_t count, void (*call)(const void*, std::size_t),
                  const void* context) const {
  std::atomic<std::size_t> next{0};
  std::atomic_flag failed;
  std::exception_ptr failure;  // written by the one who sets the flag, read after the join
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) call(context, i);
    } catch (...) {
      if (!failed.test_and_set()) failure = std::current_exception();
      next = count;  // nobody begins another
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min<std::size_t>(count_, count); ++i)
      others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace quadbound::judge
