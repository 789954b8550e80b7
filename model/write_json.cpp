// SPDX-License-Identifier: Apache-2.0
#include "model/write_json.hpp"

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/write_text.hpp"

namespace quadbound {
namespace {

/// Writes k * 2^exponent in lowest terms without rational arithmetic: the common factors are the
/// trailing zeros of k, and all denominators there can be are kept as text.
class LatticeText {
 public:
  explicit LatticeText(int exponent) : exponent_(exponent) {
    for (int i = 0; i <= -exponent; ++i) powers_.push_back(to_text(dyadic(1, i)));
  }

  void write(TextOut& out, std::int64_t k) const {
    if (k == 0) {
      out << '0';
    } else if (exponent_ < 0) {
      write_fraction(out, k);
    } else if (exponent_ <= 62 - kLatticeBits) {
      out << (k * (std::int64_t{1} << exponent_));
    } else {
      out << to_text(dyadic(k, exponent_));
    }
  }

 private:
  void write_fraction(TextOut& out, std::int64_t k) const {
    const int common = std::min(std::countr_zero(static_cast<std::uint64_t>(k)), -exponent_);
    out << (k >> common);  // exact: only zeros are shifted out
    const int left = -exponent_ - common;
    if (left > 0) out << '/' << powers_[static_cast<std::size_t>(left)];
  }

  int exponent_;
  std::vector<std::string> powers_;  ///< of two, as decimal digits
};

/// "key": [ and the items, one on a line.
template <class Items, class Write>
void write_lines(TextOut& out, std::string_view key, const Items& items, const Write& write) {
  out << ",\n\"" << key << "\":[";
  bool first = true;
  for (const auto& item : items) {
    out << (first ? "\n" : ",\n");
    first = false;
    write(item);
  }
  out << "\n]";
}

void write_vertices(TextOut& out, const Vertices& vertices) {
  const LatticeText lattice(vertices.exponent());
  out << ",\n\"vertices\":[";
  for (VertexId v = 0; v < vertices.size(); ++v) {
    out << (v == 0 ? "\n[\"" : ",\n[\"");
    if (vertices.on_lattice(v)) {
      const LatticePoint point = vertices.lattice(v);
      lattice.write(out, point.x);
      out << "\",\"";
      lattice.write(out, point.y);
    } else {
      const RationalPoint point = vertices.exact(v);
      out << to_text(point.x) << "\",\"" << to_text(point.y);
    }
    out << "\"]";
  }
  out << "\n]";
}

template <class Face>
void write_face(TextOut& out, const Face& face) {
  char separator = '[';
  for (const VertexId vertex : face) {
    out << separator << vertex;
    separator = ',';
  }
  out << ']';
}

/// Small numbers, many on a line.
void write_bytes(TextOut& out, std::string_view key, const std::vector<std::uint8_t>& values) {
  constexpr std::size_t kPerLine = 64;
  out << ",\n\"" << key << "\":[";
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) out << ',';
    if (i % kPerLine == 0) out << '\n';
    out << values[i];
  }
  out << "\n]";
}

void write_names(TextOut& out, const std::vector<std::string>& names) {
  using nlohmann::json;
  // A name that is no UTF-8 is written with replacement characters rather than refused.
  write_lines(out, "construction_names", names, [&](const std::string& name) {
    out << json(name).dump(-1, ' ', false, json::error_handler_t::replace);
  });
}

}  // namespace

void write_json(std::ostream& stream, const Mesh& mesh) {
  TextOut out(stream);
  out << "{\"format\":\"quadbound-mesh\",\n\"version\":1,\n\"cells\":" << mesh.cells
      << ",\n\"input_vertices\":" << mesh.input_vertices;
  if (!mesh.construction_names.empty()) write_names(out, mesh.construction_names);
  if (!mesh.construction.empty()) write_bytes(out, "construction", mesh.construction);
  if (!mesh.level.empty()) write_bytes(out, "level", mesh.level);
  write_vertices(out, mesh.vertices);
  write_lines(out, "quads", mesh.quads, [&](const Quad& quad) { write_face(out, quad); });
  if (!mesh.other_faces.empty())
    write_lines(out, "faces", mesh.other_faces, [&](const auto& face) { write_face(out, face); });
  out << "\n}\n";
}

}  // namespace quadbound
