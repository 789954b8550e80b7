// SPDX-License-Identifier: Apache-2.0
#include "cli/interruption.hpp"

#include <array>
#include <csignal>
#include <cstddef>
#include <cstdlib>

namespace quadbound::cli {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t noted = 0;

extern "C" void note_signal(int number) {
  noted = number;
  std::signal(number, SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
  noted = 0;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    before_[i] = std::signal(kSignals[i], note_signal);
    if (before_[i] == SIG_IGN) std::signal(kSignals[i], SIG_IGN);
  }
}

Interruption::~Interruption() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) std::signal(kSignals[i], before_[i]);
}

bool Interruption::came() { return noted != 0; }

void Interruption::carry_out() {
  std::signal(noted, SIG_DFL);
  std::raise(noted);
  std::abort();  // not reached: nothing catches it any more
}

}  // namespace quadbound::cli
