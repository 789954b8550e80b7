// SPDX-License-Identifier: Apache-2.0
#include "model/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace quadbound {
namespace {

std::string one_line(const InputLocation& location, const std::string& message) {
  std::string text = location.file;
  if (location.ring) text += fmt::format(": ring {}", *location.ring);
  if (location.vertex)
    text += fmt::format("{} vertex {}", location.ring ? "," : ":", *location.vertex);
  text += ": " + message;
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

}  // namespace

InputError::InputError(InputLocation location, const std::string& message)
    : std::runtime_error(one_line(location, message)), location_(std::move(location)) {}

}  // namespace quadbound
