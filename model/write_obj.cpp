// SPDX-License-Identifier: Apache-2.0
#include "model/write_obj.hpp"

#include "model/write_text.hpp"

namespace quadbound {
namespace {

template <class Face>
void write_face(TextOut& out, const Face& face) {
  out << 'f';
  for (const VertexId vertex : face) out << ' ' << std::uint64_t{vertex} + 1;
  out << '\n';
}

}  // namespace

void write_obj(std::ostream& stream, const Mesh& mesh) {
  TextOut out(stream);
  out << "# " << mesh.vertices.size() << " vertices, "
      << mesh.quads.size() + mesh.other_faces.size() << " faces\n";
  for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
    const Point point = mesh.vertices.rounded(v);
    out << "v " << point.x << ' ' << point.y << " 0\n";
  }
  for (const Quad& quad : mesh.quads) write_face(out, quad);
  for (const std::vector<VertexId>& face : mesh.other_faces) write_face(out, face);
}

}  // namespace quadbound
