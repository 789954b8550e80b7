// SPDX-License-Identifier: Apache-2.0
#pragma once
// Work in a child process with limits, so that a crash or a hang is an answer like any other.

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace quadbound::cli {

struct TaskLimits {
  /// Of processor time, and ten times so many on the clock, as other work may slow it down.
  double seconds = 60;
  /// Of address space. Not kept by builds with a sanitizer, which reserve terabytes.
  std::uint64_t megabytes = 4096;
};

enum class TaskEnd {
  kAnswered,
  kCrashed,   ///< ended by a signal or by itself
  kTimedOut,  ///< beyond TaskLimits::seconds
  kNoMemory,  ///< std::bad_alloc
};

struct TaskOutcome {
  TaskEnd end = TaskEnd::kAnswered;
  std::string answer;  ///< of kAnswered
  std::string detail;  ///< of all others, one line
};

/// A child process that computes a text.
///
/// Guarantees: 1. the child does nothing but `work` and sending its result. 2. It ends with its
/// parent's process (Linux), and at the latest with this object. 3. No core files.
/// Requires: `work` prints nothing; exceptions other than std::bad_alloc are crashes.
class IsolatedTask {
 public:
  /// Errors: std::system_error where no process can be made.
  IsolatedTask(const std::function<std::string()>& work, const TaskLimits& limits);
  ~IsolatedTask();
  IsolatedTask(const IsolatedTask&) = delete;
  IsolatedTask& operator=(const IsolatedTask&) = delete;

  /// Readable whenever outcome() has something to do.
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// The outcome once the task is over; returns at once.
  std::optional<TaskOutcome> outcome();

 private:
  bool read_what_is_there();
  TaskOutcome reaped();

  int process_ = -1;
  int descriptor_ = -1;
  bool late_ = false;
  std::chrono::steady_clock::time_point deadline_;
  std::string answer_;
};

/// Waits for the outcome.
TaskOutcome run_isolated(const std::function<std::string()>& work, const TaskLimits& limits);

}  // namespace quadbound::cli
