// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whole files in and out; "-" is standard input or output.

#include <exception>
#include <functional>
#include <iosfwd>
#include <string>
#include <utility>

namespace quadbound {

/// The whole content of a file. Errors: InputError naming the file and the system's reason.
std::string read_file(const std::string& path);

/// What cannot be written: disk full, no such folder, no permission.
class OutputError : public std::exception {
 public:
  explicit OutputError(std::string message) : message_(std::move(message)) {}
  [[nodiscard]] const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

/// Calls write with a binary stream and puts what it wrote at path.
///
/// Guarantees: 1. the file at path holds either all of the new content or what it held before, even
/// if write throws or the disk is full (temporary name in the same folder, then rename). 2. no
/// temporary file is left behind on an error.
/// Errors: OutputError naming the file.
void write_file(const std::string& path, const std::function<void(std::ostream&)>& write);

/// Removes the temporary file of a write_file that is under way, if any (of one of them, where
/// threads write several at once). Does nothing that a signal handler must not do.
void remove_unfinished_file() noexcept;

}  // namespace quadbound
