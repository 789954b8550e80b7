// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "model/errors.hpp"
#include "model/polygon_formats.hpp"
#include "model/text_scanner.hpp"

namespace quadbound {
namespace {

constexpr std::string_view kPunctuation = "(),";
constexpr std::string_view kSpace = " \t\r\n\v\f";

/// Reads the tokens "(", ")", "," and words (anything between those and white space).
class WktParser {
 public:
  WktParser(std::string_view text, std::string file)
      : text_(without_byte_order_mark(text)), file_(std::move(file)) {}

  Polygon polygon() {
    read_keyword();
    Polygon polygon{file_, {}};
    expect("(");
    do {
      ring_ = polygon.rings.size();
      polygon.rings.push_back(ring());
      ring_.reset();
    } while (list_goes_on());
    if (const auto word = next(); !word.empty())
      fail(fmt::format("{} after the end of the polygon", excerpt(word)));
    return polygon;
  }

 private:
  std::string_view next() {
    position_ = std::min(text_.find_first_not_of(kSpace, position_), text_.size());
    const std::string_view rest = text_.substr(position_);
    if (rest.empty()) return rest;
    std::size_t length = 1;
    if (kPunctuation.find(rest.front()) == std::string_view::npos)
      while (length < rest.size() && kPunctuation.find(rest[length]) == std::string_view::npos &&
             kSpace.find(rest[length]) == std::string_view::npos)
        ++length;
    position_ += length;
    return rest.substr(0, length);
  }

  std::string_view peek() {
    const std::size_t position = position_;
    const std::string_view word = next();
    position_ = position;
    return word;
  }

  void read_keyword() {
    const std::string_view type = next();
    if (!equals_ignoring_case(type, "POLYGON"))
      fail(fmt::format("{} where POLYGON is due", excerpt(type)));
    const std::string_view word = peek();
    if (equals_ignoring_case(word, "EMPTY")) fail("the polygon is empty");
    for (const char* dimension : {"Z", "M", "ZM"})
      if (equals_ignoring_case(word, dimension))
        fail(fmt::format("POLYGON {} has more than two coordinates per vertex", dimension));
  }

  void expect(std::string_view due) {
    const std::string_view word = next();
    if (word != due) fail_at(word, fmt::format("where {} is due", excerpt(due)));
  }

  /// True after a comma, false after a closing parenthesis.
  bool list_goes_on() {
    const std::string_view word = next();
    if (word == ",") return true;
    if (word != ")") fail_at(word, "where \",\" or \")\" is due");
    return false;
  }

  Ring ring() {
    if (equals_ignoring_case(peek(), "EMPTY")) fail("the ring is empty");
    expect("(");
    if (peek() == ")") fail("the ring is empty");
    Ring ring;
    do {
      vertex_ = ring.size();
      const double x = number();
      const double y = number();
      if (const auto word = peek(); word != "," && word != ")" && !word.empty())
        fail(fmt::format("a third coordinate {}", excerpt(word)));
      ring.push_back({x, y});
    } while (list_goes_on());
    vertex_.reset();
    drop_closing_vertex(ring, file_, *ring_);
    return ring;
  }

  double number() {
    const std::string_view word = next();
    if (word.empty() || word == "," || word == ")" || word == "(")
      fail_at(word, "where a coordinate is due");
    const ParsedNumber parsed = parse_number(word);
    if (parsed.fault) fail(excerpt(word) + ' ' + parsed.fault);
    return parsed.value;
  }

  [[noreturn]] void fail_at(std::string_view word, const std::string& message) {
    fail((word.empty() ? "the text ends" : excerpt(word)) + ' ' + message);
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw InputError({file_, ring_, vertex_},
                     fmt::format("line {}: {}", line_of(text_, position_), message));
  }

  std::string_view text_;
  std::string file_;
  std::size_t position_ = 0;
  std::optional<std::size_t> ring_;  ///< being read
  std::optional<std::size_t> vertex_;
};

}  // namespace

Polygon parse_wkt(std::string_view text, const std::string& file) {
  return WktParser(text, file).polygon();
}

}  // namespace quadbound
