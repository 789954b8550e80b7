// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the libFuzzer targets share.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace quadbound::fuzzer {

/// Ends the program with a line on what was found: that is how libFuzzer sees a finding.
[[noreturn]] inline void found(const std::string& what) {
  std::fprintf(stderr, "found: %s\n", what.c_str());
  std::abort();
}

inline void require(bool condition, const std::string& what) {
  if (!condition) found(what);
}

inline void require_one_line(const std::string& message) {
  require(!message.empty() && message.find_first_of("\n\r") == std::string::npos,
          "a message of several lines: " + message);
}

}  // namespace quadbound::fuzzer
