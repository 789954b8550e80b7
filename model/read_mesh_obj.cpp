// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <utility>

#include "model/mesh_formats.hpp"
#include "model/text_scanner.hpp"

namespace quadbound {
namespace {

/// A vertex with nothing but x, y and perhaps z = 0, a weight and colours.
Point read_vertex(const TextScanner& scanner, std::size_t vertex) {
  const auto& fields = scanner.fields();
  if (fields.size() < 3) scanner.fail("a vertex needs two coordinates", vertex);
  if (fields.size() > 3 && scanner.number(fields[3], vertex) != 0)
    scanner.fail("the vertex is not in the plane z = 0", vertex);
  for (std::size_t i = 4; i < fields.size(); ++i) (void)scanner.number(fields[i], vertex);
  return {scanner.number(fields[1], vertex), scanner.number(fields[2], vertex)};
}

/// "7", "7/1", "7//3" or "7/1/3"; negative numbers count back from the last vertex so far.
VertexId read_corner(const TextScanner& scanner, std::string_view field, std::size_t vertices) {
  std::string_view digits = field.substr(0, field.find('/'));
  const bool backward = digits.starts_with('-');
  if (backward) digits.remove_prefix(1);
  const auto number = parse_count(digits);
  if (!number || *number == 0)
    scanner.fail(fmt::format("{} is not the number of a vertex", excerpt(field)));
  if (backward ? *number > vertices : *number >= kNoVertex)
    scanner.fail(fmt::format("there is no vertex {}", excerpt(field)));
  return static_cast<VertexId>(backward ? vertices - *number : *number - 1);
}

}  // namespace

Mesh parse_mesh_obj(std::string_view text, const std::string& file) {
  TextScanner scanner(text, file, TextScanner::Comments::kHash);
  std::vector<Point> points;
  Mesh mesh;
  // Faces may name vertices that come later in the file.
  std::size_t largest = 0;
  while (scanner.next_line()) {
    const auto& fields = scanner.fields();
    if (fields[0] == "v") points.push_back(read_vertex(scanner, points.size()));
    if (fields[0] != "f") continue;
    if (fields.size() < 4) scanner.fail("a face needs three corners");
    std::vector<VertexId> corners;
    for (std::size_t i = 1; i < fields.size(); ++i) {
      corners.push_back(read_corner(scanner, fields[i], points.size()));
      largest = std::max(largest, std::size_t{corners.back()});
    }
    add_face(mesh, std::move(corners));
  }
  if (points.empty()) scanner.fail("the file has no vertex");
  if (largest >= points.size())
    scanner.fail(
        fmt::format("a face names vertex {}, but there are {}", largest + 1, points.size()));
  mesh.vertices = lattice_vertices(points, file);
  return mesh;
}

}  // namespace quadbound
