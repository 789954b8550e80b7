// SPDX-License-Identifier: Apache-2.0
#pragma once
// Text for a stream, put together in large pieces.

#include <fmt/compile.h>

#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <ostream>
#include <string_view>
#include <vector>

namespace quadbound {

/// Guarantees: 1. doubles are written with the fewest digits that read back as the same double.
/// 2. The stream is touched once per megabyte; the rest of the text goes out with the destructor or
/// with flush(). Errors show in the stream's state.
class TextOut {
 public:
  explicit TextOut(std::ostream& stream) : stream_(stream), buffer_(kPiece) {}
  TextOut(const TextOut&) = delete;
  TextOut& operator=(const TextOut&) = delete;
  ~TextOut() { flush(); }

  TextOut& operator<<(std::string_view text) {
    if (text.size() > kPiece) {
      flush();
      stream_.write(text.data(), static_cast<std::streamsize>(text.size()));
    } else if (!text.empty()) {
      std::memcpy(room(text.size()), text.data(), text.size());
      used_ += text.size();
    }
    return *this;
  }
  TextOut& operator<<(char character) {
    *room(1) = character;
    ++used_;
    return *this;
  }
  template <std::integral Integer>
  TextOut& operator<<(Integer value) {
    char* const start = room(kLongestNumber);
    return took(std::to_chars(start, start + kLongestNumber, value).ptr);
  }
  TextOut& operator<<(double value) {
    return took(fmt::format_to(room(kLongestNumber), FMT_COMPILE("{}"), value));
  }

  void flush() {
    stream_.write(buffer_.data(), static_cast<std::streamsize>(used_));
    used_ = 0;
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 20;
  static constexpr std::size_t kLongestNumber = 32;  // a double has at most 24 characters

  /// Where the next text goes; there is room for `size` characters.
  char* room(std::size_t size) {
    if (size > kPiece - used_) flush();
    return buffer_.data() + used_;
  }
  TextOut& took(const char* end) {
    used_ = static_cast<std::size_t>(end - buffer_.data());
    return *this;
  }

  std::ostream& stream_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
};

}  // namespace quadbound
