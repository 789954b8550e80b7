// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include "model/errors.hpp"
#include "model/json_input.hpp"
#include "model/mesh_formats.hpp"
#include "model/text_scanner.hpp"

namespace quadbound {
namespace {

using Integer = boost::multiprecision::mpz_int;

/// Exact coordinates in 16 bytes each while the lattice is not known yet.
class CoordinateStore {
 public:
  /// False where the text is no rational.
  bool add(std::string_view text) {
    if (add_small(text)) return true;
    auto value = parse_rational(text);
    if (!value) return false;
    if (*value != 0) note(*value);
    entries_.push_back({static_cast<std::int64_t>(large_.size()), kLarge});
    large_.push_back(std::move(*value));
    return true;
  }

  [[nodiscard]] std::size_t size() const { return entries_.size(); }

  /// Every two coordinates make a vertex. Leaves the store empty.
  Vertices take_vertices() {
    const int exponent = finest_ ? std::max(*finest_, top_ - kLatticeBits) : 0;
    Vertices vertices(exponent);
    vertices.reserve(entries_.size() / 2);
    for (std::size_t i = 0; i + 1 < entries_.size(); i += 2) {
      const auto x = on_lattice(entries_[i], exponent);
      const auto y = on_lattice(entries_[i + 1], exponent);
      if (x && y)
        vertices.add({*x, *y});
      else
        vertices.add_exact({take_exact(entries_[i]), take_exact(entries_[i + 1])});
    }
    *this = CoordinateStore();
    return vertices;
  }

 private:
  /// mantissa * 2^exponent with an odd mantissa or zero; or an index into large_.
  struct Entry {
    std::int64_t mantissa;
    int exponent;
  };
  static constexpr int kLarge = std::numeric_limits<int>::max();

  /// The common case without big numbers: at most 18 digits over a power of two of at most 18.
  bool add_small(std::string_view text) {
    constexpr std::size_t kDigits = 18;
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    const std::size_t slash = text.find('/');
    const std::string_view above = text.substr(0, slash);
    const std::string_view below =
        slash == std::string_view::npos ? std::string_view("1") : text.substr(slash + 1);
    if (above.size() > kDigits || below.size() > kDigits) return false;
    const auto numerator = parse_count(above);
    const auto denominator = parse_count(below);
    if (!numerator || !denominator || !std::has_single_bit(*denominator)) return false;
    if (*numerator == 0) {
      entries_.push_back({0, 0});
      return true;
    }
    const int zeros = std::countr_zero(*numerator);
    const int exponent = zeros - std::countr_zero(*denominator);
    const auto mantissa = static_cast<std::int64_t>(*numerator >> zeros);
    note(exponent, exponent + static_cast<int>(std::bit_width(*numerator >> zeros)));
    entries_.push_back({negative ? -mantissa : mantissa, exponent});
    return true;
  }

  /// Takes account of a nonzero value below 2^top and, if dyadic, an odd multiple of 2^exponent.
  void note(std::optional<int> exponent, int top) {
    if (exponent) finest_ = finest_ ? std::min(*finest_, *exponent) : *exponent;
    top_ = any_ ? std::max(top_, top) : top;
    any_ = true;
  }

  void note(const Rational& value) {
    const Integer numerator = boost::multiprecision::abs(boost::multiprecision::numerator(value));
    const Integer denominator = boost::multiprecision::denominator(value);
    const int top = static_cast<int>(boost::multiprecision::msb(numerator)) + 1 -
                    static_cast<int>(boost::multiprecision::msb(denominator));
    const int twos = static_cast<int>(boost::multiprecision::lsb(denominator));
    if (denominator == Integer(1) << twos)
      note(static_cast<int>(boost::multiprecision::lsb(numerator)) - twos, top);
    else
      note(std::nullopt, top);
  }

  /// The coordinate in units of 2^exponent, if it is small and such a multiple.
  static std::optional<std::int64_t> on_lattice(const Entry& entry, int exponent) {
    if (entry.exponent == kLarge) return std::nullopt;
    if (entry.mantissa == 0) return 0;
    if (entry.exponent < exponent) return std::nullopt;
    // take_vertices() chose an exponent with which every value stays within 2^kLatticeBits.
    return entry.mantissa * (std::int64_t{1} << (entry.exponent - exponent));
  }

  /// Big numbers move out, so that they do not take their space twice.
  Rational take_exact(const Entry& entry) {
    if (entry.exponent == kLarge)
      return std::move(large_[static_cast<std::size_t>(entry.mantissa)]);
    return dyadic(entry.mantissa, entry.exponent);
  }

  std::vector<Entry> entries_;
  std::vector<Rational> large_;
  std::optional<int> finest_;
  int top_ = 0;
  bool any_ = false;
};

enum class Key {
  kFormat,
  kVersion,
  kVertices,
  kQuads,
  kFaces,
  kCells,
  kInputVertices,
  kConstructionNames,
  kConstruction,
  kLevel,
  kUnknown,
};

/// What stands under a key: `depth` is that of its innermost values; the text is for messages.
struct KeyShape {
  Key key;
  const char* name;
  std::size_t depth;
  const char* shape;
};

constexpr std::array<KeyShape, 10> kShapes{{
    {Key::kFormat, "format", 1, "the text \"quadbound-mesh\""},
    {Key::kVersion, "version", 1, "the number 1"},
    {Key::kVertices, "vertices", 3, "a list of pairs of rationals in quotation marks"},
    {Key::kQuads, "quads", 3, "a list of lists of four vertex numbers"},
    {Key::kFaces, "faces", 3, "a list of lists of three, five or more vertex numbers"},
    {Key::kCells, "cells", 1, "a whole number"},
    {Key::kInputVertices, "input_vertices", 1, "a whole number"},
    {Key::kConstructionNames, "construction_names", 2, "a list of texts"},
    {Key::kConstruction, "construction", 2, "a list of numbers of construction names"},
    {Key::kLevel, "level", 2, "a list of whole numbers up to 255"},
}};
constexpr KeyShape kUnknownShape{Key::kUnknown, "", 0, ""};

class MeshEvents final : public JsonEvents {
 public:
  using JsonEvents::JsonEvents;

  bool null() override { return other_value(); }
  bool boolean(bool) override { return other_value(); }
  bool number_integer(number_integer_t) override { return other_value(); }
  bool number_float(number_float_t, const std::string&) override { return other_value(); }

  bool number_unsigned(number_unsigned_t value) override {
    if (!at_value()) return true;
    switch (key_.key) {
      case Key::kVersion:
        if (value != 1) refuse(fmt::format("version {} of the mesh format; 1 is read", value));
        break;
      case Key::kQuads:
      case Key::kFaces:
        corners_.push_back(vertex_number(value));
        break;
      case Key::kCells:
        mesh_.cells = value;
        break;
      case Key::kInputVertices:
        mesh_.input_vertices = value;
        break;
      case Key::kConstruction:
        mesh_.construction.push_back(byte(value));
        break;
      case Key::kLevel:
        mesh_.level.push_back(byte(value));
        break;
      default:
        wrong_shape();
    }
    return true;
  }

  bool string(std::string& value) override {
    if (!at_value()) return true;
    switch (key_.key) {
      case Key::kFormat:
        if (value != "quadbound-mesh") wrong_shape();
        break;
      case Key::kVertices:
        if (!coordinates_.add(value))
          throw InputError({file(), {}, entry_},
                           fmt::format("{} is not a rational number", excerpt(value)));
        break;
      case Key::kConstructionNames:
        mesh_.construction_names.push_back(value);
        break;
      default:
        wrong_shape();
    }
    return true;
  }

  Mesh take() {
    require_keys();
    if (coordinates_.size() / 2 >= kNoVertex) refuse("too many vertices");
    require_corners_exist();
    require_entry_per_quad(mesh_.construction.size(), Key::kConstruction);
    require_entry_per_quad(mesh_.level.size(), Key::kLevel);
    for (const std::uint8_t name : mesh_.construction)
      if (name >= mesh_.construction_names.size())
        refuse(fmt::format("\"construction\" has {}, but there are {} construction names", name,
                           mesh_.construction_names.size()));
    mesh_.vertices = coordinates_.take_vertices();
    return std::move(mesh_);
  }

 private:
  void on_object() override {
    if (depth() == 1) return;
    if (key_.key != Key::kUnknown) wrong_shape();
  }
  void on_key(const std::string& name) override {
    if (depth() != 1) return;
    const auto found = std::find_if(kShapes.begin(), kShapes.end(),
                                    [&](const KeyShape& shape) { return name == shape.name; });
    key_ = found == kShapes.end() ? kUnknownShape : *found;
    seen_[static_cast<std::size_t>(key_.key)] = true;
    entry_ = 0;
  }
  void on_object_end() override {}

  void on_array() override {
    if (depth() == 1) refuse("a mesh must be a JSON object");
    if (key_.key != Key::kUnknown && depth() > key_.depth) wrong_shape();
  }

  void on_array_end() override {
    if (key_.key == Key::kUnknown || depth() != 3) return;
    if (key_.key == Key::kVertices) {
      if (coordinates_.size() != 2 * (entry_ + 1)) wrong_shape();
    } else {
      add_face();
    }
    ++entry_;
  }

  void add_face() {
    const bool quad = corners_.size() == 4;
    if (quad != (key_.key == Key::kQuads) || corners_.size() < 3) wrong_shape();
    quadbound::add_face(mesh_, std::exchange(corners_, {}));
  }

  /// Whether the value that was just met counts; false inside unknown keys.
  bool at_value() {
    if (depth() == 0) refuse("a mesh must be a JSON object");
    if (key_.key == Key::kUnknown) return false;
    if (depth() != key_.depth) wrong_shape();
    return true;
  }

  bool other_value() {
    if (at_value()) wrong_shape();
    return true;
  }

  VertexId vertex_number(std::uint64_t value) {
    if (value >= kNoVertex)
      refuse(fmt::format("\"{}\" has vertex {}, which cannot be", key_.name, value));
    largest_corner_ = std::max(largest_corner_, value);
    return static_cast<VertexId>(value);
  }

  std::uint8_t byte(std::uint64_t value) {
    if (value > std::numeric_limits<std::uint8_t>::max()) wrong_shape();
    return static_cast<std::uint8_t>(value);
  }

  void require_keys() {
    for (const Key key : {Key::kFormat, Key::kVersion, Key::kVertices, Key::kQuads})
      if (!seen_[static_cast<std::size_t>(key)])
        refuse(fmt::format("the key \"{}\" is missing", shape_of(key).name));
  }

  void require_corners_exist() {
    const std::size_t count = coordinates_.size() / 2;
    if (largest_corner_ < count || (mesh_.quads.empty() && mesh_.other_faces.empty())) return;
    const auto missing = [&](VertexId v) { return v >= count; };
    for (std::size_t q = 0; q < mesh_.quads.size(); ++q)
      if (std::any_of(mesh_.quads[q].begin(), mesh_.quads[q].end(), missing))
        refuse(fmt::format("quad {} names a vertex that is not among the {}", q, count));
    for (std::size_t f = 0; f < mesh_.other_faces.size(); ++f)
      if (std::any_of(mesh_.other_faces[f].begin(), mesh_.other_faces[f].end(), missing))
        refuse(fmt::format("face {} names a vertex that is not among the {}", f, count));
  }

  void require_entry_per_quad(std::size_t entries, Key key) {
    if (seen_[static_cast<std::size_t>(key)] && entries != mesh_.quads.size())
      refuse(fmt::format("\"{}\" has {} entries for {} quads", shape_of(key).name, entries,
                         mesh_.quads.size()));
  }

  static const KeyShape& shape_of(Key key) { return kShapes[static_cast<std::size_t>(key)]; }

  [[noreturn]] void wrong_shape() {
    const std::string where = key_.depth == 3 ? fmt::format(", at entry {}", entry_) : "";
    refuse(fmt::format("\"{}\" must be {}{}", key_.name, key_.shape, where));
  }

  [[noreturn]] void refuse(const std::string& message) {
    throw InputError({file(), {}, {}}, message);
  }

  Mesh mesh_;
  CoordinateStore coordinates_;
  KeyShape key_ = kUnknownShape;  ///< the key of the outer object whose value is being read
  std::array<bool, kShapes.size() + 1> seen_{};
  std::size_t entry_ = 0;  ///< in the list under that key
  std::vector<VertexId> corners_;
  std::uint64_t largest_corner_ = 0;
};

}  // namespace

Mesh parse_mesh_json(std::string_view text, const std::string& file) {
  MeshEvents events(text, file);
  events.run();
  return events.take();
}

}  // namespace quadbound
