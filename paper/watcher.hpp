// SPDX-License-Identifier: Apache-2.0
#pragma once
// Who wants to know how far the work is.

#include <cstddef>
#include <string>

namespace quadbound {

/// All calls come from the thread that does the work.
class Watcher {
 public:
  Watcher() = default;
  Watcher(const Watcher&) = delete;
  Watcher& operator=(const Watcher&) = delete;
  virtual ~Watcher() = default;

  virtual void stage(const std::string& name) = 0;
  /// Of the stage. Requires: done <= total.
  virtual void steps(std::size_t done, std::size_t total) = 0;
  /// A whole step is done; `seconds` of wall clock.
  virtual void finished(const std::string& step, double seconds) = 0;
};

/// Nobody.
class NoWatcher final : public Watcher {
 public:
  void stage(const std::string& /*name*/) override {}
  void steps(std::size_t /*done*/, std::size_t /*total*/) override {}
  void finished(const std::string& /*step*/, double /*seconds*/) override {}
};

}  // namespace quadbound
