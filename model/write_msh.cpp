// SPDX-License-Identifier: Apache-2.0
#include "model/write_msh.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "model/mesh_edges.hpp"
#include "model/write_text.hpp"

namespace quadbound {
namespace {

using Rings = std::vector<std::vector<VertexId>>;

// Element types of the format.
constexpr int kLine = 1;
constexpr int kTriangle = 2;
constexpr int kQuadrilateral = 3;
// Entities have a dimension and a tag; ours: curve i + 1 is ring i, and the one surface.
constexpr int kSurface = 1;

std::uint64_t tag(VertexId vertex) { return std::uint64_t{vertex} + 1; }

struct Box {
  Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  void include(const Point& point) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }
};

void write_box(TextOut& out, const Box& box) {
  out << ' ' << box.low.x << ' ' << box.low.y << " 0 " << box.high.x << ' ' << box.high.y << " 0";
}

void write_physical_names(TextOut& out, const Rings& rings) {
  out << "$PhysicalNames\n" << rings.size() + 1 << '\n';
  for (std::size_t i = 0; i < rings.size(); ++i) out << "1 " << i + 1 << " \"ring " << i << "\"\n";
  out << "2 " << rings.size() + 1 << " \"domain\"\n$EndPhysicalNames\n";
}

void write_entities(TextOut& out, const Mesh& mesh, const Rings& rings) {
  out << "$Entities\n0 " << rings.size() << " 1 0\n";
  Box all;
  for (VertexId v = 0; v < mesh.vertices.size(); ++v) all.include(mesh.vertices.rounded(v));
  for (std::size_t i = 0; i < rings.size(); ++i) {
    Box box;
    for (const VertexId v : rings[i]) box.include(mesh.vertices.rounded(v));
    out << i + 1;
    write_box(out, box);
    out << " 1 " << i + 1 << " 0\n";  // its physical group; no end points: the curve is closed
  }
  out << kSurface;
  write_box(out, mesh.vertices.size() == 0 ? Box{{0, 0}, {0, 0}} : all);
  out << " 1 " << rings.size() + 1 << ' ' << rings.size();
  for (std::size_t i = 0; i < rings.size(); ++i) out << ' ' << i + 1;
  out << "\n$EndEntities\n";
}

void write_node_block(TextOut& out, const Vertices& vertices, int dimension, std::size_t entity,
                      std::span<const VertexId> nodes) {
  out << dimension << ' ' << entity << " 0 " << nodes.size() << '\n';
  for (const VertexId v : nodes) out << tag(v) << '\n';
  for (const VertexId v : nodes) {
    const Point point = vertices.rounded(v);
    out << point.x << ' ' << point.y << " 0\n";
  }
}

void write_nodes(TextOut& out, const Mesh& mesh, const Rings& rings) {
  const std::size_t count = mesh.vertices.size();
  out << "$Nodes\n" << rings.size() + 1 << ' ' << count << " 1 " << count << '\n';
  std::vector<bool> placed(count, false);
  std::vector<VertexId> nodes;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    nodes.clear();
    for (const VertexId v : rings[i]) {
      if (!placed[v]) nodes.push_back(v);
      placed[v] = true;
    }
    write_node_block(out, mesh.vertices, 1, i + 1, nodes);
  }
  nodes.clear();
  for (VertexId v = 0; v < count; ++v)
    if (!placed[v]) nodes.push_back(v);
  write_node_block(out, mesh.vertices, 2, kSurface, nodes);
  out << "$EndNodes\n";
}

/// Elements are numbered from 1 in the order in which they are written.
class Elements {
 public:
  explicit Elements(TextOut& out) : out_(out) {}

  void begin_block(int dimension, std::size_t entity, int type, std::size_t count) {
    out_ << dimension << ' ' << entity << ' ' << type << ' ' << count << '\n';
  }
  template <class Face>
  void write(const Face& corners) {
    out_ << ++last_;
    for (const VertexId corner : corners) out_ << ' ' << tag(corner);
    out_ << '\n';
  }

 private:
  TextOut& out_;
  std::uint64_t last_ = 0;
};

void write_ring(Elements& elements, const std::vector<VertexId>& ring, std::size_t entity) {
  elements.begin_block(1, entity, kLine, ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i)
    elements.write(std::array{ring[i], ring[(i + 1) % ring.size()]});
}

void write_elements(TextOut& out, const Mesh& mesh, const Rings& rings) {
  std::size_t count = mesh.quads.size() + mesh.other_faces.size();
  for (const auto& ring : rings) count += ring.size();
  const std::size_t blocks =
      rings.size() + (mesh.quads.empty() ? 0 : 1) + (mesh.other_faces.empty() ? 0 : 1);
  out << "$Elements\n" << blocks << ' ' << count << " 1 " << count << '\n';
  Elements elements(out);
  for (std::size_t i = 0; i < rings.size(); ++i) write_ring(elements, rings[i], i + 1);
  if (!mesh.quads.empty()) elements.begin_block(2, kSurface, kQuadrilateral, mesh.quads.size());
  for (const Quad& quad : mesh.quads) elements.write(quad);
  if (!mesh.other_faces.empty())
    elements.begin_block(2, kSurface, kTriangle, mesh.other_faces.size());
  for (const auto& face : mesh.other_faces) elements.write(face);
  out << "$EndElements\n";
}

}  // namespace

bool can_be_msh(const Mesh& mesh) {
  return std::all_of(mesh.other_faces.begin(), mesh.other_faces.end(),
                     [](const auto& face) { return face.size() == 3; });
}

void write_msh(std::ostream& stream, const Mesh& mesh) {
  const Rings rings = boundary_rings(mesh);
  TextOut out(stream);
  out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  write_physical_names(out, rings);
  write_entities(out, mesh, rings);
  write_nodes(out, mesh, rings);
  write_elements(out, mesh, rings);
}

}  // namespace quadbound
