// SPDX-License-Identifier: Apache-2.0
#include "model/json_input.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "model/errors.hpp"
#include "model/text_scanner.hpp"

namespace quadbound {
namespace {

using nlohmann::json;

/// Puts the events together again.
class TreeBuilder final : public JsonEvents {
 public:
  using JsonEvents::JsonEvents;

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(number_integer_t value) override { return put(value); }
  bool number_unsigned(number_unsigned_t value) override { return put(value); }
  bool number_float(number_float_t value, const std::string& text) override {
    const bool underflow = value == 0 && parse_number(text).fault;
    return put(underflow ? std::numeric_limits<double>::quiet_NaN() : value);
  }
  bool string(std::string& value) override { return put(std::move(value)); }

  json take() { return std::move(root_); }

 private:
  void on_object() override { open_.push_back(&place(json::object())); }
  void on_key(const std::string& name) override { key_ = name; }
  void on_object_end() override { open_.pop_back(); }
  void on_array() override { open_.push_back(&place(json::array())); }
  void on_array_end() override { open_.pop_back(); }

  template <class Value>
  bool put(Value&& value) {
    place(json(std::forward<Value>(value)));
    return true;
  }

  json& place(json value) {
    if (open_.empty()) return root_ = std::move(value);
    json& parent = *open_.back();
    if (parent.is_object()) return parent[key_] = std::move(value);
    parent.push_back(std::move(value));
    return parent.back();
  }

  json root_;
  std::string key_;
  std::vector<json*> open_;  ///< an open container is the last of its parent, so it does not move
};

/// The library's message without its own tag and position.
std::string_view reason(std::string_view message) {
  message.remove_prefix(std::min(message.find("] ") + 2, message.size()));
  if (message.starts_with("parse error at "))
    message.remove_prefix(std::min(message.find(": ") + 2, message.size()));
  return message;
}

}  // namespace

JsonEvents::JsonEvents(std::string_view text, std::string file)
    : text_(without_byte_order_mark(text)), file_(std::move(file)) {}

void JsonEvents::run() {
  if (trimmed(text_).empty()) throw InputError({file_, {}, {}}, "the file is empty");
  json::sax_parse(text_.begin(), text_.end(), this);
}

void JsonEvents::open() {
  if (++depth_ > kDeepest)
    throw InputError({file_, {}, {}}, fmt::format("JSON nested deeper than {}", kDeepest));
}

bool JsonEvents::start_object(std::size_t) {
  open();
  keys_.emplace_back();
  on_object();
  return true;
}

bool JsonEvents::key(std::string& name) {
  if (!keys_.back().insert(name).second)
    throw InputError({file_, {}, {}}, fmt::format("the key {} is repeated", excerpt(name)));
  on_key(name);
  return true;
}

bool JsonEvents::end_object() {
  on_object_end();
  keys_.pop_back();
  --depth_;
  return true;
}

bool JsonEvents::start_array(std::size_t) {
  open();
  on_array();
  return true;
}

bool JsonEvents::end_array() {
  on_array_end();
  --depth_;
  return true;
}

bool JsonEvents::parse_error(std::size_t position, const std::string&,
                             const json::exception& error) {
  constexpr std::size_t kLongest = 200;
  const std::size_t line = line_of(text_, position == 0 ? 0 : position - 1);
  throw InputError({file_, {}, {}},
                   fmt::format("line {}: {}", line, reason(error.what()).substr(0, kLongest)));
}

nlohmann::json parse_json(std::string_view text, const std::string& file) {
  TreeBuilder builder(text, file);
  builder.run();
  return builder.take();
}

}  // namespace quadbound
