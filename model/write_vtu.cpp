// SPDX-License-Identifier: Apache-2.0
#include "model/write_vtu.hpp"

#include <array>
#include <bit>
#include <limits>
#include <string_view>
#include <vector>

#include "model/quad_shape.hpp"
#include "model/write_text.hpp"

namespace quadbound {
namespace {

class Base64 {
 public:
  explicit Base64(TextOut& out) : out_(out) {}

  void put_byte(std::uint8_t byte) {
    group_ = (group_ << 8) | byte;
    if (++filled_ == 3) put_group(4);
  }

  /// The end of the array: the last group is filled up with zeros.
  void finish() {
    if (filled_ == 0) return;
    const int digits = filled_ + 1;
    group_ <<= 8 * (3 - filled_);
    put_group(digits);
  }

 private:
  void put_group(int digits) {
    static constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<char, 4> text;
    for (int i = 0; i < 4; ++i)
      text[static_cast<std::size_t>(i)] =
          i < digits ? kDigits[(group_ >> (18 - 6 * i)) & 63U] : '=';
    out_ << std::string_view(text.data(), text.size());
    group_ = 0;
    filled_ = 0;
  }

  TextOut& out_;
  std::uint32_t group_ = 0;
  int filled_ = 0;
};

struct ArrayType {
  std::string_view name;
  int bytes;
};
constexpr ArrayType kFloat64{"Float64", 8};
constexpr ArrayType kInt64{"Int64", 8};
constexpr ArrayType kUInt8{"UInt8", 1};

/// One array: a header that counts the bytes, then the values, all of it in one base64 text.
class DataArray {
 public:
  DataArray(TextOut& out, ArrayType type, std::string_view name, std::size_t values,
            int components = 1)
      : out_(out), base64_(out), bytes_(type.bytes) {
    out_ << "<DataArray type=\"" << type.name << "\" Name=\"" << name << '"';
    if (components > 1) out_ << " NumberOfComponents=\"" << components << '"';
    out_ << " format=\"binary\">\n";
    put_bytes(values * static_cast<std::size_t>(type.bytes), 8);
  }
  DataArray(const DataArray&) = delete;
  DataArray& operator=(const DataArray&) = delete;
  ~DataArray() {
    base64_.finish();
    out_ << "\n</DataArray>\n";
  }

  void put(double value) { put_bytes(std::bit_cast<std::uint64_t>(value), bytes_); }
  void put(std::uint64_t value) { put_bytes(value, bytes_); }

 private:
  void put_bytes(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i, value >>= 8) base64_.put_byte(value & 255U);
  }

  TextOut& out_;
  Base64 base64_;
  int bytes_;
};

void write_points(TextOut& out, const Vertices& vertices) {
  out << "<Points>\n";
  {
    DataArray points(out, kFloat64, "Points", 3 * vertices.size(), 3);
    for (VertexId v = 0; v < vertices.size(); ++v) {
      const Point point = vertices.rounded(v);
      points.put(point.x);
      points.put(point.y);
      points.put(0.0);
    }
  }
  out << "</Points>\n";
}

std::size_t corner_count(const Mesh& mesh) {
  std::size_t corners = 4 * mesh.quads.size();
  for (const auto& face : mesh.other_faces) corners += face.size();
  return corners;
}

void write_connectivity(TextOut& out, const Mesh& mesh) {
  DataArray connectivity(out, kInt64, "connectivity", corner_count(mesh));
  for (const Quad& quad : mesh.quads)
    for (const VertexId vertex : quad) connectivity.put(std::uint64_t{vertex});
  for (const auto& face : mesh.other_faces)
    for (const VertexId vertex : face) connectivity.put(std::uint64_t{vertex});
}

void write_offsets(TextOut& out, const Mesh& mesh, std::size_t cells) {
  DataArray offsets(out, kInt64, "offsets", cells);
  std::uint64_t end = 0;
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) offsets.put(end += 4);
  for (const auto& face : mesh.other_faces) offsets.put(end += face.size());
}

void write_cells(TextOut& out, const Mesh& mesh, std::size_t cells) {
  constexpr std::uint64_t kVtkPolygon = 7;
  constexpr std::uint64_t kVtkQuad = 9;
  out << "<Cells>\n";
  write_connectivity(out, mesh);
  write_offsets(out, mesh, cells);
  {
    DataArray types(out, kUInt8, "types", cells);
    for (std::size_t i = 0; i < cells; ++i)
      types.put(i < mesh.quads.size() ? kVtkQuad : kVtkPolygon);
  }
  out << "</Cells>\n";
}

void write_measure(TextOut& out, const std::vector<QuadShape>& shapes, std::size_t cells,
                   std::string_view name, double QuadShape::*measure) {
  DataArray values(out, kFloat64, name, cells);
  for (const QuadShape& shape : shapes) values.put(shape.*measure);
  for (std::size_t i = shapes.size(); i < cells; ++i)
    values.put(std::numeric_limits<double>::quiet_NaN());
}

void write_shapes(TextOut& out, const Mesh& mesh, std::size_t cells) {
  std::vector<QuadShape> shapes;
  shapes.reserve(mesh.quads.size());
  for (const Quad& quad : mesh.quads) shapes.push_back(quad_shape(mesh.vertices, quad));
  write_measure(out, shapes, cells, "min_angle", &QuadShape::min_angle);
  write_measure(out, shapes, cells, "max_angle", &QuadShape::max_angle);
  write_measure(out, shapes, cells, "scaled_jacobian", &QuadShape::scaled_jacobian);
  write_measure(out, shapes, cells, "aspect_ratio", &QuadShape::aspect_ratio);
}

void write_numbers(TextOut& out, std::string_view name, const std::vector<std::uint8_t>& numbers,
                   std::size_t cells) {
  if (numbers.empty()) return;
  DataArray values(out, kUInt8, name, cells);
  for (std::size_t i = 0; i < cells; ++i)
    values.put(std::uint64_t{i < numbers.size() ? numbers[i] : std::uint8_t{255}});
}

void write_cell_data(TextOut& out, const Mesh& mesh, std::size_t cells) {
  out << "<CellData>\n";
  write_shapes(out, mesh, cells);
  write_numbers(out, "construction", mesh.construction, cells);
  write_numbers(out, "level", mesh.level, cells);
  out << "</CellData>\n";
}

}  // namespace

void write_vtu(std::ostream& stream, const Mesh& mesh) {
  const std::size_t cells = mesh.quads.size() + mesh.other_faces.size();
  TextOut out(stream);
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
      << mesh.vertices.size() << "\" NumberOfCells=\"" << cells << "\">\n";
  write_points(out, mesh.vertices);
  write_cells(out, mesh, cells);
  write_cell_data(out, mesh, cells);
  out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace quadbound
