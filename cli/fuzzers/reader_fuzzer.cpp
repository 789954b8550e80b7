// SPDX-License-Identifier: Apache-2.0
// libFuzzer target for one reader, QUADBOUND_READER.
#include "cli/fuzzers/fuzzer.hpp"
#include "cli/fuzzers/readers.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // libFuzzer's own type for bytes.
  quadbound::fuzzer::QUADBOUND_READER({reinterpret_cast<const char*>(data), size});
  return 0;
}
