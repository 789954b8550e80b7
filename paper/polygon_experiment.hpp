// SPDX-License-Identifier: Apache-2.0
#pragma once
// One mesh of a polygon (Sections 3 and 4), measured and judged.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/angle.hpp"
#include "model/mesh.hpp"
#include "model/mesh_shape.hpp"
#include "model/polygon.hpp"
#include "verify/verify.hpp"

namespace quadbound {

struct PolygonMeasurement {
  std::string polygon;      ///< its recipe, or the file's name
  std::uint64_t edges = 0;  ///< n, of all rings
  std::uint64_t cells = 0;  ///< N
  std::uint64_t vertices = 0;
  std::uint64_t quads = 0;
  Corner<Rational> smallest;  ///< extreme corners of the mesh but for whole input angles
  Corner<Rational> largest;
  std::uint64_t whole_corners = 0;  ///< input angles that are the corner of one quad
  std::uint64_t kites = 0;
  std::uint64_t cells_before = 0;  ///< before edge separation
  std::uint64_t rounds = 0;
  std::uint64_t kept_quads = 0;
  MeshShape shape;
  std::vector<std::string> broken;  ///< ids of the claims that do not hold; empty: thm-13 proved

  [[nodiscard]] bool proved() const { return broken.empty(); }
  [[nodiscard]] double quads_per_cell() const;
};

struct JudgedPolygonMesh {
  Polygon polygon;  ///< normalised
  PolygonMeasurement measurement;
  Mesh mesh;
  Report report;
};

/// Meshes and judges. `file` of the polygon names it.
/// Guarantees: 1. the same polygon gives the same result, whatever the threads.
/// Errors: std::runtime_error with the mesher's refusal.
JudgedPolygonMesh judge_polygon_mesh(const Polygon& polygon, unsigned threads);

/// Quads of the mesh that a construction made, by its name (algo/construction.hpp).
std::uint64_t quads_made_by(const Mesh& mesh, std::string_view construction);

/// The quads of the mesh that stem from the quadtree: the paper's mesh of the inside before edges
/// and corners are inserted (Fig. 48).
Mesh without_strips(const Mesh& mesh);

}  // namespace quadbound
