// SPDX-License-Identifier: Apache-2.0
// Properties: what is written and read again is the same, in every format that has a reader.
#include <array>
#include <cmath>
#include <sstream>

#include "cli/property_cases.hpp"
#include "model/errors.hpp"
#include "model/read_mesh.hpp"
#include "model/validate.hpp"
#include "model/write_msh.hpp"
#include "model/write_obj.hpp"
#include "model/write_points.hpp"
#include "model/write_polygon.hpp"
#include "verify/verify.hpp"

namespace quadbound::cli {
namespace {

/// Coordinates with all bits of a double, of any magnitude.
double any_factor() {
  const double mantissa = 1 + std::ldexp(*rc::gen::inRange(0, 1 << 30), -30) / 3;
  return std::ldexp(mantissa, *rc::gen::inRange(-200, 200));
}

bool is_valid(const Polygon& polygon) {
  try {
    validate(polygon);
    return true;
  } catch (const InputError&) {
    return false;  // rounding has brought vertices together
  }
}

TEST(Formats, PolygonsComeBackTheSame) {
  Reached reached(Reached::Of::kPolygons);
  check_property(200, reached, [&](const PolygonSample& sample) {
    const double factor = any_factor();
    const Polygon polygon = mapped(sample.polygon, [factor](Point p) {
      return Point{factor * p.x, factor * p.y};
    });
    RC_PRE(is_valid(polygon));
    for (const PolygonFormat format :
         {PolygonFormat::kGeoJson, PolygonFormat::kPoly, PolygonFormat::kWkt}) {
      std::ostringstream text;
      write_polygon(text, polygon, format);
      RC_ASSERT(parse_polygon(text.str(), format, "copy").rings == polygon.rings);
    }
    if (const auto made = meshed(sample.polygon)) reached.add(*made);
  });
}

TEST(Formats, PointSetsComeBackTheSame) {
  Reached reached(Reached::Of::kPoints);
  check_property(100, reached, [&](const PointSample& sample) {
    const double factor = any_factor();
    const PointSet points = mapped(sample.points, [factor](Point p) {
      return Point{factor * p.x, factor * p.y};
    });
    for (const PointFormat format :
         {PointFormat::kCsv, PointFormat::kNode, PointFormat::kXyz, PointFormat::kText}) {
      std::ostringstream text;
      write_points(text, points, format);
      RC_ASSERT(parse_points(text.str(), format, "copy").points == points.points);
    }
    if (const auto made = meshed(sample.points)) reached.add(*made);
  });
}

/// All of the mesh, coordinates as rationals.
void comes_back_exactly(const Mesh& mesh) {
  const Mesh copy = parse_mesh(json_text(mesh), MeshFormat::kJson, "copy");
  RC_ASSERT(copy.vertices.size() == mesh.vertices.size());
  for (VertexId v = 0; v < mesh.vertices.size(); ++v)
    RC_ASSERT(copy.vertices.exact(v) == mesh.vertices.exact(v));
  RC_ASSERT(copy.quads == mesh.quads);
  RC_ASSERT(copy.cells == mesh.cells);
  RC_ASSERT(copy.input_vertices == mesh.input_vertices);
  RC_ASSERT(copy.construction_names == mesh.construction_names);
  RC_ASSERT(copy.construction == mesh.construction);
  RC_ASSERT(copy.level == mesh.level);
}

/// The places of all corners, rounded to doubles. (MSH has the vertices of the boundary first.)
void comes_back_rounded(const Mesh& mesh, MeshFormat format) {
  std::ostringstream text;
  (format == MeshFormat::kObj ? write_obj : write_msh)(text, mesh);
  const Mesh copy = parse_mesh(text.str(), format, "copy");
  RC_ASSERT(copy.vertices.size() == mesh.vertices.size());
  RC_ASSERT(copy.quads.size() == mesh.quads.size());
  for (std::size_t quad = 0; quad < mesh.quads.size(); ++quad)
    for (std::size_t k = 0; k < 4; ++k)
      RC_ASSERT(copy.vertices.exact(copy.quads[quad][k]) ==
                exact_value(mesh.vertices.rounded(mesh.quads[quad][k])));
}

template <class Made>
void comes_back(const Made& made) {
  comes_back_exactly(made.mesh);
  comes_back_rounded(made.mesh, MeshFormat::kObj);
  comes_back_rounded(made.mesh, MeshFormat::kGmsh);
}

TEST(Formats, MeshesOfPolygonsComeBackTheSame) {
  Reached reached(Reached::Of::kPolygons);
  check_property(100, reached, [&](const PolygonSample& sample) {
    const auto made = meshed(sample.polygon);
    RC_PRE(made.has_value());
    comes_back(*made);
    reached.add(*made);
  });
}

TEST(Formats, MeshesOfPointSetsComeBackTheSame) {
  Reached reached(Reached::Of::kPoints);
  check_property(100, reached, [&](const PointSample& sample) {
    const auto made = meshed(sample.points);
    RC_PRE(made.has_value());
    comes_back(*made);
    reached.add(*made);
  });
}

}  // namespace
}  // namespace quadbound::cli
