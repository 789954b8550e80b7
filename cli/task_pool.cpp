// SPDX-License-Identifier: Apache-2.0
#include "cli/task_pool.hpp"

#include <poll.h>

#include <optional>
#include <utility>

namespace quadbound::cli {

void TaskPool::start(const std::function<std::string()>& work, const TaskLimits& limits,
                     Done done) {
  running_.push_back({std::make_unique<IsolatedTask>(work, limits), std::move(done)});
}

void TaskPool::wait(std::chrono::milliseconds longest) {
  if (running_.empty()) return;
  std::vector<pollfd> waiting;
  for (const Running& running : running_)
    waiting.push_back({running.task->descriptor(), POLLIN, 0});
  ::poll(waiting.data(), waiting.size(), static_cast<int>(longest.count()));
  for (std::size_t i = 0; i < running_.size();) {
    const std::optional<TaskOutcome> outcome = running_[i].task->outcome();
    if (!outcome) {
      ++i;
      continue;
    }
    const Running over = std::move(running_[i]);
    running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
    over.done(*outcome);
  }
}

}  // namespace quadbound::cli
