// SPDX-License-Identifier: Apache-2.0
#include "model/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

#include "model/errors.hpp"

namespace quadbound {
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

// Fixed memory, for a signal handler to read: the name is whole while the flag is set.
std::array<char, 4096> unfinished_name{};
std::atomic<bool> unfinished = false;
std::atomic<bool> unfinished_taken = false;

/// Names a file for remove_unfinished_file; where one is named already, that one stays.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(const std::string& name)
      : ours_(name.size() < unfinished_name.size() && !unfinished_taken.exchange(true)) {
    if (!ours_) return;
    std::memcpy(unfinished_name.data(), name.c_str(), name.size() + 1);
    unfinished = true;
  }
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;
  ~UnfinishedFile() {
    if (!ours_) return;
    unfinished = false;
    unfinished_taken = false;
  }

 private:
  bool ours_;
};

/// Removes the file again unless it was renamed to its final place.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& target)
      : target_(target), name_(fmt::format("{}.{}.tmp", target, ::getpid())), unfinished_(name_) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!kept_) std::remove(name_.c_str());
  }
  [[nodiscard]] const std::string& name() const { return name_; }
  void keep() {
    std::error_code error;
    std::filesystem::rename(name_, target_, error);
    if (error)
      throw OutputError(fmt::format("{}: cannot be written: {}", target_, error.message()));
    kept_ = true;
  }

 private:
  std::string target_;
  std::string name_;
  UnfinishedFile unfinished_;  // forgotten after the file is gone
  bool kept_ = false;
};

}  // namespace

std::string read_file(const std::string& path) {
  if (path == "-") return {std::istreambuf_iterator<char>(std::cin), {}};
  if (std::filesystem::is_directory(path))
    throw InputError({path, {}, {}}, "is a folder, not a file");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError({path, {}, {}}, "cannot be read: " + reason(errno));
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw InputError({path, {}, {}}, "cannot be read to its end");
  return text;
}

void write_file(const std::string& path, const std::function<void(std::ostream&)>& write) {
  if (path == "-") {
    write(std::cout);
    if (!std::cout.flush()) throw OutputError("standard output: cannot be written");
    return;
  }
  TemporaryFile temporary(path);
  errno = 0;
  std::ofstream stream(temporary.name(), std::ios::binary);
  if (!stream) throw OutputError(fmt::format("{}: cannot be written: {}", path, reason(errno)));
  write(stream);
  stream.close();
  if (!stream) throw OutputError(fmt::format("{}: cannot be written: {}", path, reason(errno)));
  temporary.keep();
}

void remove_unfinished_file() noexcept {
  if (unfinished) ::unlink(unfinished_name.data());
}

}  // namespace quadbound
