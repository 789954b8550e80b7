// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lines, fields and numbers of text formats, for the readers.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quadbound {

/// A finite double, or what is wrong with the text ("is not a number").
struct ParsedNumber {
  double value = 0;
  const char* fault = nullptr;
};

/// The double nearest to a decimal number, in every locale.
///
/// Guarantees: 1. the whole text is one number, with an optional sign of either kind. 2. Infinities
/// and NaN, overflow, and nonzero numbers that would become zero are faults.
ParsedNumber parse_number(std::string_view text);

/// Decimal digits, nothing else; nullopt also where 64 bits are too few.
std::optional<std::uint64_t> parse_count(std::string_view text);

/// The text in quotation marks for a message: shortened, and without control characters.
std::string excerpt(std::string_view text);

/// The text after a UTF-8 byte-order mark, where there is one.
std::string_view without_byte_order_mark(std::string_view text);

/// The number of the line that holds text[offset], counted from 1.
std::size_t line_of(std::string_view text, std::size_t offset);

std::string_view trimmed(std::string_view text);
bool equals_ignoring_case(std::string_view left, std::string_view right);

/// "standard input" for "-"; the path itself otherwise. For messages.
std::string file_name_of(const std::string& path);

/// The last part of a path from its last dot, in lower case ("" where there is none).
std::string extension_of(const std::string& path);

/// Walks over the lines of a text that are not blank, and over their white-space separated fields.
///
/// Guarantees: 1. line feeds with or without carriage returns end a line, a byte-order mark is
/// skipped. 2. The returned views point into the text. 3. Each failure names the line.
class TextScanner {
 public:
  enum class Comments { kNone, kHash };

  TextScanner(std::string_view text, std::string file, Comments comments);

  /// Moves to the next line with a field in it; false at the end of the text.
  bool next_line();
  [[nodiscard]] std::string_view line() const { return line_; }
  [[nodiscard]] const std::vector<std::string_view>& fields() const { return fields_; }

  /// Whether next_field finds another one.
  bool has_more() { return used_fields_ < fields_.size() || next_line(); }
  /// The next field, wherever lines end. Errors: InputError that says the file ends before `what`.
  std::string_view next_field(const char* what);
  double next_number(const char* what) { return number(next_field(what)); }
  std::uint64_t next_count(const char* what) { return count(next_field(what)); }
  /// Errors: InputError where the text is used up.
  void require_line(const char* what);

  [[nodiscard]] double number(std::string_view field, std::optional<std::size_t> vertex = {}) const;
  [[nodiscard]] std::uint64_t count(std::string_view field,
                                    std::optional<std::size_t> vertex = {}) const;

  [[nodiscard]] const std::string& file() const { return file_; }
  /// Throws InputError: "FILE[: vertex V]: line N: MESSAGE".
  [[noreturn]] void fail(const std::string& message, std::optional<std::size_t> vertex = {}) const;

 private:
  std::string_view rest_;
  std::string file_;
  Comments comments_;
  std::size_t line_number_ = 0;
  std::string_view line_;
  std::vector<std::string_view> fields_;
  std::size_t used_fields_ = 0;
};

}  // namespace quadbound
