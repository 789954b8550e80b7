// SPDX-License-Identifier: Apache-2.0
#include "model/read_mesh.hpp"

#include <utility>

#include "model/errors.hpp"
#include "model/files.hpp"
#include "model/mesh_formats.hpp"
#include "model/text_scanner.hpp"

namespace quadbound {
namespace {

MeshFormat format_of(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".json") return MeshFormat::kJson;
  if (extension == ".msh") return MeshFormat::kGmsh;
  if (extension == ".obj") return MeshFormat::kObj;
  throw InputError({file_name_of(path), {}, {}},
                   path == "-" ? "the format of the mesh must be given"
                               : "not a mesh file: the extension must be .json, .msh or .obj");
}

}  // namespace

Vertices lattice_vertices(const std::vector<Point>& points, const std::string& file) {
  if (points.size() >= kNoVertex) throw InputError({file, {}, {}}, "too many vertices");
  Vertices vertices(common_exponent(points));
  vertices.reserve(points.size());
  for (const Point& point : points) vertices.add_double(point);
  return vertices;
}

void add_face(Mesh& mesh, std::vector<VertexId> corners) {
  if (corners.size() == 4)
    mesh.quads.push_back({corners[0], corners[1], corners[2], corners[3]});
  else
    mesh.other_faces.push_back(std::move(corners));
}

Mesh parse_mesh(std::string_view text, MeshFormat format, const std::string& file) {
  if (trimmed(without_byte_order_mark(text)).empty())
    throw InputError({file, {}, {}}, "the file is empty");
  switch (format) {
    case MeshFormat::kJson:
      return parse_mesh_json(text, file);
    case MeshFormat::kGmsh:
      return parse_mesh_gmsh(text, file);
    case MeshFormat::kObj:
      break;
  }
  return parse_mesh_obj(text, file);
}

Mesh read_mesh(const std::string& path, std::optional<MeshFormat> format) {
  const MeshFormat known = format ? *format : format_of(path);
  return parse_mesh(read_file(path), known, file_name_of(path));
}

}  // namespace quadbound
