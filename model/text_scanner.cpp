// SPDX-License-Identifier: Apache-2.0
#include "model/text_scanner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include "model/errors.hpp"

namespace quadbound {
namespace {

constexpr std::string_view kSpace = " \t\r\n\v\f";

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

void split(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  for (;;) {
    const std::size_t begin = line.find_first_not_of(kSpace);
    if (begin == std::string_view::npos) return;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(kSpace), line.size());
    fields.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

}  // namespace

ParsedNumber parse_number(std::string_view text) {
  constexpr const char* kNoNumber = "is not a number";
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return {0, kNoNumber};
  }
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error == std::errc::invalid_argument || end != last) return {0, kNoNumber};
  if (error == std::errc::result_out_of_range) return {0, "is out of the range of a double"};
  if (!std::isfinite(value)) return {0, "is not a finite number"};
  return {value, nullptr};
}

std::optional<std::uint64_t> parse_count(std::string_view text) {
  std::uint64_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc() || end != last) return std::nullopt;
  return value;
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown(text.substr(0, kLongest));
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return (c >= 0 && c < ' ') || c == 127; }, '?');
  return fmt::format("\"{}{}\"", shown, text.size() > kLongest ? "..." : "");
}

std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

std::size_t line_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpace) + 1 - begin);
}

bool equals_ignoring_case(std::string_view left, std::string_view right) {
  return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                    [](char a, char b) { return lower(a) == lower(b); });
}

std::string file_name_of(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), lower);
  return extension;
}

TextScanner::TextScanner(std::string_view text, std::string file, Comments comments)
    : rest_(without_byte_order_mark(text)), file_(std::move(file)), comments_(comments) {}

bool TextScanner::next_line() {
  while (!rest_.empty()) {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_number_;
    if (comments_ == Comments::kHash) line_ = line_.substr(0, line_.find('#'));
    line_ = trimmed(line_);
    split(line_, fields_);
    used_fields_ = 0;
    if (!fields_.empty()) return true;
  }
  line_ = {};
  fields_.clear();
  used_fields_ = 0;
  return false;
}

void TextScanner::require_line(const char* what) {
  if (!next_line()) fail(fmt::format("the file ends before {}", what));
}

std::string_view TextScanner::next_field(const char* what) {
  if (used_fields_ == fields_.size()) require_line(what);
  return fields_[used_fields_++];
}

double TextScanner::number(std::string_view field, std::optional<std::size_t> vertex) const {
  const ParsedNumber parsed = parse_number(field);
  if (parsed.fault) fail(excerpt(field) + ' ' + parsed.fault, vertex);
  return parsed.value;
}

std::uint64_t TextScanner::count(std::string_view field, std::optional<std::size_t> vertex) const {
  const auto value = parse_count(field);
  if (!value) fail(excerpt(field) + " is not a whole number", vertex);
  return *value;
}

void TextScanner::fail(const std::string& message, std::optional<std::size_t> vertex) const {
  throw InputError({file_, {}, vertex}, fmt::format("line {}: {}", line_number_, message));
}

}  // namespace quadbound
