// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 5: "the redundant quad in the template [T2b] can easily be removed in a postprocessing
// step, thereby removing all degree 9 vertices".

#include <cstdint>
#include <string>
#include <vector>

#include "algo/quadtree.hpp"
#include "model/mesh.hpp"
#include "model/mesh_shape.hpp"
#include "model/polygon.hpp"

namespace quadbound {

struct ThinnedMesh {
  Mesh mesh;
  std::uint64_t removed = 0;
};

/// The middle quads of template T2b shrunk to one point: the inner extra points of their two leaves
/// become one vertex in the middle, and the two other corners lose an edge.
///
/// Guarantees: 1. a quad stays where another corner would have two edges left, or where strips
/// reach its extra points. 2. nothing else changes but the numbers of vertices and quads.
/// Requires: a mesh of mesh_polygon, and its root square. Complexity: O(n log n).
ThinnedMesh without_redundant_quads(const Mesh& mesh, const RootSquare& root);

struct ThinnedFigure {
  std::uint64_t removed = 0;
  MeshShape shape;
  std::vector<std::string> broken;  ///< ids of the claims that do not hold
};

/// The mesh of a polygon, thinned and judged. Requires: mesh_polygon meshes it.
ThinnedFigure thinned_figure(const Polygon& polygon);

}  // namespace quadbound
