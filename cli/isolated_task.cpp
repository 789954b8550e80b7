// SPDX-License-Identifier: Apache-2.0
#include "cli/isolated_task.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <new>
#include <system_error>
#include <utility>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace quadbound::cli {
namespace {

constexpr int kNoMemoryStatus = 17;  ///< what else would end with it is a crash all the same
constexpr double kClockFactor = 10;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitsMemory = false;
#else
constexpr bool kLimitsMemory = true;
#endif

void limit(int resource, rlim_t value) {
  const rlimit both{value, value};
  ::setrlimit(resource, &both);
}

void keep_limits(const TaskLimits& limits) {
  limit(RLIMIT_CORE, 0);
  // Only the soft limit: at the hard one the signal is SIGKILL, which says less.
  const auto seconds = static_cast<rlim_t>(std::ceil(limits.seconds));
  const rlimit time{seconds, seconds + 5};
  ::setrlimit(RLIMIT_CPU, &time);
  if (kLimitsMemory) limit(RLIMIT_AS, limits.megabytes << 20);
}

void send(int descriptor, const std::string& text) {
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t count = ::write(descriptor, text.data() + sent, text.size() - sent);
    if (count < 0 && errno != EINTR) return;
    if (count > 0) sent += static_cast<std::size_t>(count);
  }
}

[[noreturn]] void be_child(const std::function<std::string()>& work, const TaskLimits& limits,
                           int descriptor, pid_t parent) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (::getppid() != parent) ::_exit(1);  // it died before the line above
  // Ctrl-C reaches the whole group of processes. A child that it ended would look like a crash; the
  // parent sees to its end.
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) ::signal(number, SIG_IGN);
  keep_limits(limits);
  try {
    send(descriptor, work());
  } catch (const std::bad_alloc&) {
    ::_exit(kNoMemoryStatus);
  }
  ::_exit(0);
}

std::system_error failure(const char* what) { return {errno, std::generic_category(), what}; }

}  // namespace

IsolatedTask::IsolatedTask(const std::function<std::string()>& work, const TaskLimits& limits)
    : deadline_(std::chrono::steady_clock::now() +
                std::chrono::milliseconds(
                    static_cast<std::int64_t>(limits.seconds * kClockFactor * 1000))) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw failure("pipe");
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ == 0) {
    ::close(ends[0]);
    be_child(work, limits, ends[1], parent);
  }
  ::close(ends[1]);
  descriptor_ = ends[0];
  if (process_ < 0) {
    ::close(descriptor_);
    throw failure("fork");
  }
  ::fcntl(descriptor_, F_SETFL, O_NONBLOCK);
}

IsolatedTask::~IsolatedTask() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  ::close(descriptor_);
}

/// Whether the child has closed its end.
bool IsolatedTask::read_what_is_there() {
  std::array<char, 1 << 16> piece{};
  for (;;) {
    const ssize_t count = ::read(descriptor_, piece.data(), piece.size());
    if (count == 0) return true;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    answer_.append(piece.data(), static_cast<std::size_t>(count));
  }
}

TaskOutcome IsolatedTask::reaped() {
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (late_ || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU))
    return {TaskEnd::kTimedOut, {}, "no end within the time limit"};
  if (WIFSIGNALED(status))
    return {
        TaskEnd::kCrashed,
        {},
        fmt::format("ended by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)))};
  if (WEXITSTATUS(status) == kNoMemoryStatus)
    return {TaskEnd::kNoMemory, {}, "more memory than the limit allows"};
  if (WEXITSTATUS(status) != 0)
    return {TaskEnd::kCrashed, {}, fmt::format("ended with status {}", WEXITSTATUS(status))};
  return {TaskEnd::kAnswered, std::move(answer_), {}};
}

std::optional<TaskOutcome> IsolatedTask::outcome() {
  if (!late_ && std::chrono::steady_clock::now() >= deadline_) {
    late_ = true;
    ::kill(process_, SIGKILL);
  }
  if (!late_ && !read_what_is_there()) return std::nullopt;
  return reaped();
}

TaskOutcome run_isolated(const std::function<std::string()>& work, const TaskLimits& limits) {
  IsolatedTask task(work, limits);
  for (;;) {
    if (std::optional<TaskOutcome> outcome = task.outcome()) return *std::move(outcome);
    pollfd waiting{task.descriptor(), POLLIN, 0};
    ::poll(&waiting, 1, 1000);
  }
}

}  // namespace quadbound::cli
