// SPDX-License-Identifier: Apache-2.0
#pragma once
// Text for a stream, put together in large pieces.

#include <fmt/format.h>

#include <concepts>
#include <cstddef>
#include <ostream>
#include <string_view>

namespace quadbound {

/// Guarantees: 1. doubles are written with the fewest digits that read back as the same double.
/// 2. The stream is touched once per megabyte; the rest of the text goes out with the destructor or
/// with flush(). Errors show in the stream's state.
class TextOut {
 public:
  explicit TextOut(std::ostream& stream) : stream_(stream) { buffer_.reserve(2 * kPiece); }
  TextOut(const TextOut&) = delete;
  TextOut& operator=(const TextOut&) = delete;
  ~TextOut() { flush(); }

  TextOut& operator<<(std::string_view text) {
    buffer_.append(text.data(), text.data() + text.size());
    if (buffer_.size() >= kPiece) flush();
    return *this;
  }
  TextOut& operator<<(char character) {
    buffer_.push_back(character);
    return *this;
  }
  template <std::integral Integer>
  TextOut& operator<<(Integer value) {
    const fmt::format_int digits(value);
    return *this << std::string_view(digits.data(), digits.size());
  }
  TextOut& operator<<(double value) {
    fmt::format_to(fmt::appender(buffer_), "{}", value);
    return *this;
  }

  void flush() {
    stream_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 20;
  std::ostream& stream_;
  fmt::memory_buffer buffer_;
};

}  // namespace quadbound
