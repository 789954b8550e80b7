// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace quadbound::cli {
namespace {

constexpr std::chrono::milliseconds kQuietTime{2000};
constexpr std::chrono::milliseconds kInterval{200};

std::string bar(std::size_t done, std::size_t total, double seconds) {
  constexpr std::size_t width = 24;
  const std::size_t filled = width * done / total;
  const std::string left = done == 0
                               ? "?"
                               : fmt::format("{:.0f}", seconds * static_cast<double>(total - done) /
                                                           static_cast<double>(done));
  return fmt::format("[{}{}] {}/{}, about {} s left: ", std::string(filled, '#'),
                     std::string(width - filled, '.'), done, total, left);
}

}  // namespace

Progress::Progress() : enabled_(::isatty(STDERR_FILENO) == 1) {
  if (enabled_) thread_ = std::thread([this] { run(); });
}

Progress::~Progress() {
  if (!enabled_) return;
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  wake_.notify_all();
  thread_.join();
  if (drawn_) fmt::print(stderr, "\r\033[K");
}

void Progress::stage(const std::string& name) {
  const std::lock_guard lock(mutex_);
  stage_ = name;
}

void Progress::steps(std::size_t done, std::size_t total) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  total_ = total;
}

void Progress::run() {
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  wake_.wait_for(lock, kQuietTime, [this] { return finished_; });
  while (!finished_) {
    draw(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    wake_.wait_for(lock, kInterval, [this] { return finished_; });
  }
}

void Progress::draw(double seconds) {
  drawn_ = true;
  fmt::print(stderr, "\r\033[K{}{} ({:.0f} s)", total_ == 0 ? "" : bar(done_, total_, seconds),
             stage_, seconds);
  std::fflush(stderr);
}

}  // namespace quadbound::cli
