// SPDX-License-Identifier: Apache-2.0
#pragma once
// Peak memory of a piece of a program, as the operating system counts it.

#include <cstdint>
#include <optional>

namespace quadbound {

/// Watches the resident memory of the process from its construction on.
///
/// Guarantees: 1. freed memory that the allocator had kept is given back first, so that what is
/// needed anew is counted anew. 2. Pages are counted when they are written, not when they are
/// reserved.
/// Not promised: anything below some hundred kilobytes; other threads count as well. Only one
/// object at a time gives an answer worth having.
class ResidentPeak {
 public:
  ResidentPeak();
  /// Bytes of the highest resident size since then beyond the size at the start; nullopt where the
  /// system does not tell (it takes Linux's /proc).
  [[nodiscard]] std::optional<std::uint64_t> beyond_start() const;

 private:
  std::optional<std::uint64_t> start_;
};

}  // namespace quadbound
