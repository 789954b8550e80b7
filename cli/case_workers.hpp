// SPDX-License-Identifier: Apache-2.0
#pragma once
// Who tries the cases of a campaign: child processes of this one, or those of other ranks.

#include <cstdint>
#include <functional>

#include "cli/isolated_task.hpp"

namespace quadbound::cli {

class CaseWorkers {
 public:
  using Done = std::function<void(std::uint64_t index, const TaskOutcome& outcome)>;

  CaseWorkers() = default;
  CaseWorkers(const CaseWorkers&) = delete;
  CaseWorkers& operator=(const CaseWorkers&) = delete;
  virtual ~CaseWorkers() = default;

  /// Whether one of them has nothing to do.
  [[nodiscard]] virtual bool has_room() const = 0;
  /// Whether none of them is at work.
  [[nodiscard]] virtual bool is_idle() const = 0;
  /// Requires: has_room().
  virtual void start(std::uint64_t index) = 0;
  /// Waits for a short while, and tells of each case that is over, once.
  virtual void wait(const Done& done) = 0;
};

}  // namespace quadbound::cli
