// SPDX-License-Identifier: Apache-2.0
#include "bench/resident_memory.hpp"

#include <fstream>
#include <limits>
#include <string>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace quadbound {
namespace {

void give_back_freed_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

/// Sets the peak to the present size; see clear_refs in proc(5).
bool reset_peak() {
  std::ofstream file("/proc/self/clear_refs");
  return static_cast<bool>(file << '5' << std::flush);
}

/// A line such as "VmHWM:      1234 kB".
std::optional<std::uint64_t> status_bytes(const std::string& key) {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;) {
    std::uint64_t kilobytes = 0;
    if (word == key + ":" && file >> kilobytes) return kilobytes * 1024;
    file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return std::nullopt;
}

}  // namespace

ResidentPeak::ResidentPeak() {
  give_back_freed_memory();
  if (reset_peak()) start_ = status_bytes("VmRSS");
}

std::optional<std::uint64_t> ResidentPeak::beyond_start() const {
  const auto peak = status_bytes("VmHWM");
  if (!start_ || !peak) return std::nullopt;
  return *peak > *start_ ? *peak - *start_ : 0;
}

}  // namespace quadbound
