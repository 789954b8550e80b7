// SPDX-License-Identifier: Apache-2.0
#pragma once
// JSON from strangers: bounded nesting, no repeated keys, errors in one line.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace quadbound {

/// Base of the handlers of a JSON text, event by event.
///
/// Guarantees: 1. containers nested deeper than kDeepest, a key that an object repeats, and text
/// that is no JSON throw InputError; nothing recurses. 2. number_float gets numbers rounded
/// correctly; overflow is an error with its line.
class JsonEvents : public nlohmann::json_sax<nlohmann::json> {
 public:
  static constexpr std::size_t kDeepest = 100;

  JsonEvents(std::string_view text, std::string file);

  /// Sends all events of the text. Errors: InputError.
  void run();

  bool start_object(std::size_t elements) final;
  bool key(std::string& name) final;
  bool end_object() final;
  bool start_array(std::size_t elements) final;
  bool end_array() final;
  bool binary(binary_t&) final { return true; }
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::json::exception& error) final;

 protected:
  /// Number of containers that are open, the new one or the one that ends included.
  [[nodiscard]] std::size_t depth() const { return depth_; }
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  virtual void on_object() = 0;
  virtual void on_key(const std::string& name) = 0;
  virtual void on_object_end() = 0;
  virtual void on_array() = 0;
  virtual void on_array_end() = 0;
  void open();

  std::string_view text_;
  std::string file_;
  std::size_t depth_ = 0;
  std::vector<std::unordered_set<std::string>> keys_;  ///< of each open object
};

/// A whole JSON text as a tree. Nonzero numbers that are too small for a double become NaN, which
/// JSON cannot write itself, so that whoever uses them can say where they stand.
/// Errors: InputError as above.
nlohmann::json parse_json(std::string_view text, const std::string& file);

}  // namespace quadbound
