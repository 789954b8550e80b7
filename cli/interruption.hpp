// SPDX-License-Identifier: Apache-2.0
#pragma once
// Ctrl-C for work that wants to end in order.

#include <array>

namespace quadbound::cli {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP is noted instead of ending the program; a
/// second one ends it. Signals that are ignored, as under nohup, stay so.
/// Requires: one at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  [[nodiscard]] static bool came();
  /// Ends the program as the signal would have, so that those who wait for it see why it ended.
  /// Requires: came().
  [[noreturn]] static void carry_out();

 private:
  using Handler = void (*)(int);
  std::array<Handler, 3> before_{};
};

}  // namespace quadbound::cli
