// SPDX-License-Identifier: Apache-2.0
#include "verify/chunks.hpp"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace quadbound::judge {

Threads::Threads(unsigned count) {
  // TBB prints a warning where it is asked for more threads than it has.
  const auto most = static_cast<unsigned>(tbb::info::default_concurrency());
  count_ = count == 0 ? most : std::min(count, most);
}

void Threads::run(std::size_t count, void (*call)(const void*, std::size_t),
                  const void* context) const {
  tbb::task_arena arena(static_cast<int>(count_));
  arena.execute(
      [&] { tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { call(context, i); }); });
}

}  // namespace quadbound::judge
