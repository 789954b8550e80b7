// SPDX-License-Identifier: Apache-2.0
#include "cli/fuzzers/readers.hpp"

#include <functional>
#include <sstream>
#include <string>
#include <string_view>

#include "cli/fuzzers/fuzzer.hpp"
#include "model/errors.hpp"
#include "model/read_mesh.hpp"
#include "model/read_points.hpp"
#include "model/read_polygon.hpp"
#include "model/validate.hpp"
#include "model/write_json.hpp"
#include "model/write_msh.hpp"
#include "model/write_obj.hpp"
#include "model/write_points.hpp"
#include "model/write_polygon.hpp"

namespace quadbound::fuzzer {
namespace {

/// Whether an action was done; if not, it was refused as it should be.
bool done(const std::function<void()>& action) {
  try {
    action();
    return true;
  } catch (const InputError& error) {
    require_one_line(error.what());
    require(std::string_view(error.what()).starts_with("input: "), "the file is not named");
    return false;
  }
}

// --- polygons ------------------------------------------------------------------------------------

void try_polygon(std::string_view text, PolygonFormat format) {
  Polygon polygon;
  if (!done([&] { polygon = parse_polygon(text, format, "input"); })) return;
  const bool valid = done([&] { validate(polygon); });
  // .poly does not say which ring is the outer one, and asks for a point in each hole.
  if (format == PolygonFormat::kPoly && !valid) return;
  std::ostringstream copy;
  if (!done([&] { write_polygon(copy, polygon, format); })) return;
  require(parse_polygon(copy.str(), format, "copy").rings == polygon.rings,
          "another polygon comes back");
}

// --- point sets ----------------------------------------------------------------------------------

void try_points(std::string_view text, PointFormat format) {
  PointSet points;
  if (!done([&] { points = parse_points(text, format, "input"); })) return;
  (void)done([&] { validate(points); });
  if (points.points.empty() && format != PointFormat::kNode) return;  // an empty file is refused
  std::ostringstream copy;
  write_points(copy, points, format);
  require(parse_points(copy.str(), format, "copy").points == points.points,
          "other points come back");
}

// --- meshes --------------------------------------------------------------------------------------

bool same_place(const Mesh& a, VertexId i, const Mesh& b, VertexId j, bool rounded) {
  return rounded ? a.vertices.rounded(i) == b.vertices.rounded(j)
                 : a.vertices.exact(i) == b.vertices.exact(j);
}

void require_same(const Mesh& mesh, const Mesh& copy, bool rounded) {
  require(copy.quads.size() == mesh.quads.size(), "another number of quads comes back");
  for (std::size_t quad = 0; quad < mesh.quads.size(); ++quad)
    for (std::size_t k = 0; k < 4; ++k)
      require(same_place(mesh, mesh.quads[quad][k], copy, copy.quads[quad][k], rounded),
              "a corner comes back elsewhere");
}

}  // namespace

void geojson(std::string_view text) { try_polygon(text, PolygonFormat::kGeoJson); }
void poly(std::string_view text) { try_polygon(text, PolygonFormat::kPoly); }
void wkt(std::string_view text) { try_polygon(text, PolygonFormat::kWkt); }
void csv(std::string_view text) { try_points(text, PointFormat::kCsv); }
void node(std::string_view text) { try_points(text, PointFormat::kNode); }
void xyz(std::string_view text) { try_points(text, PointFormat::kXyz); }

void mesh_json(std::string_view text) {
  Mesh mesh;
  if (!done([&] { mesh = parse_mesh(text, MeshFormat::kJson, "input"); })) return;
  std::ostringstream copy;
  write_json(copy, mesh);
  const Mesh back = parse_mesh(copy.str(), MeshFormat::kJson, "copy");
  require_same(mesh, back, false);
  require(back.other_faces == mesh.other_faces && back.level == mesh.level &&
              back.construction == mesh.construction && back.cells == mesh.cells,
          "another mesh comes back");
}

void obj(std::string_view text) {
  Mesh mesh;
  if (!done([&] { mesh = parse_mesh(text, MeshFormat::kObj, "input"); })) return;
  std::ostringstream copy;
  write_obj(copy, mesh);
  require_same(mesh, parse_mesh(copy.str(), MeshFormat::kObj, "copy"), true);
}

void msh(std::string_view text) {
  Mesh mesh;
  if (!done([&] { mesh = parse_mesh(text, MeshFormat::kGmsh, "input"); })) return;
  if (!can_be_msh(mesh)) return;
  std::ostringstream copy;
  write_msh(copy, mesh);
  require_same(mesh, parse_mesh(copy.str(), MeshFormat::kGmsh, "copy"), true);
}

}  // namespace quadbound::fuzzer
