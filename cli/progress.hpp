// SPDX-License-Identifier: Apache-2.0
#pragma once
// A line on the terminal that says what is going on; nothing at all in logs and pipes.

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace quadbound::cli {

/// Shows "stage ... seconds", and a bar where the number of steps is known, on standard error once
/// the work has taken two seconds, if standard error is a terminal; clears the line at the end.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void stage(const std::string& name);
  /// Of the work as a whole. Requires: 0 <= done <= total.
  void steps(std::size_t done, std::size_t total);

 private:
  void run();
  void draw(double seconds);

  bool enabled_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool finished_ = false;
  bool drawn_ = false;
  std::string stage_;
  std::size_t done_ = 0;
  std::size_t total_ = 0;
  std::thread thread_;
};

}  // namespace quadbound::cli
