// SPDX-License-Identifier: Apache-2.0
#pragma once
// Several child processes at work at the same time.

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/isolated_task.hpp"

namespace quadbound::cli {

class TaskPool {
 public:
  using Done = std::function<void(const TaskOutcome&)>;

  explicit TaskPool(unsigned most) : most_(most) {}

  [[nodiscard]] bool has_room() const { return running_.size() < most_; }
  [[nodiscard]] bool is_idle() const { return running_.empty(); }
  /// Requires: has_room(). Errors: those of IsolatedTask.
  void start(const std::function<std::string()>& work, const TaskLimits& limits, Done done);
  /// Waits until a task is over or so much time has gone, and calls what belongs to those that are
  /// over. Deadlines of tasks are looked at here.
  void wait(std::chrono::milliseconds longest);

 private:
  struct Running {
    std::unique_ptr<IsolatedTask> task;
    Done done;
  };
  std::size_t most_;
  std::vector<Running> running_;
};

}  // namespace quadbound::cli
