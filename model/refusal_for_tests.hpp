// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the tests of readers and validation share.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

#include "model/errors.hpp"

namespace quadbound {

/// The message of the InputError that action throws, or "accepted".
template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// Calls action with many small corruptions of a text: cut off, bytes changed, pieces repeated. An
/// InputError is fine, and so is no error; anything else escapes. Returns how many were refused.
template <class Action>
int corrupted(const std::string& text, Action action) {
  std::mt19937_64 engine(text.size());
  const std::string bytes = "0123456789-+.eE/,:;[](){}\"\n\r\t #$x\xEF\x80";
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string bad = text;
    for (auto changes = 1 + engine() % 3; changes > 0; --changes) {
      const std::size_t at = engine() % bad.size();
      const std::size_t length = 1 + engine() % 6;
      const auto kind = engine() % 4;
      if (kind == 0) bad[at] = bytes[engine() % bytes.size()];
      if (kind == 1) bad.insert(at, bad.substr(at, length));
      if (kind == 2) bad.erase(at, length);
      if (kind == 3 && at > 0 && engine() % 4 == 0) bad.resize(at);
      if (bad.empty()) bad = text;
    }
    refused += refusal([&] { action(bad); }) != "accepted";
  }
  return refused;
}

/// A folder of its own for a test, removed at its end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = testing::TempDir() + "quadbound-XXXXXX";
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = pattern + '/';
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  [[nodiscard]] std::string path(const std::string& name) const { return path_ + name; }

  /// Writes a file and returns its path.
  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

 private:
  std::string path_;
};

}  // namespace quadbound
