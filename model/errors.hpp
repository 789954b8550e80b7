// SPDX-License-Identifier: Apache-2.0
#pragma once
// Bad input, in one line that names the file and, where they are known, the ring and the vertex.

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace quadbound {

/// Rings and vertices are counted from 0 in the order of the file; ring 0 is the outer ring.
struct InputLocation {
  std::string file;
  std::optional<std::size_t> ring;
  std::optional<std::size_t> vertex;
};

/// What a reader or the validation refuses. The program turns it into exit status 2.
class InputError : public std::runtime_error {
 public:
  /// Guarantees: 1. what() is "FILE[: ring R][, vertex V]: MESSAGE" (or "FILE: vertex V: ...") on
  /// one line.
  InputError(InputLocation location, const std::string& message);

  [[nodiscard]] const InputLocation& location() const { return location_; }

 private:
  InputLocation location_;
};

}  // namespace quadbound
