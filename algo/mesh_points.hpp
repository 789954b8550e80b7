// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 2 as a whole: a quadrilateral mesh around a set of points (thm-1).

#include <string>
#include <variant>
#include <vector>

#include "algo/apply_template.hpp"
#include "algo/counters.hpp"
#include "algo/point_separation.hpp"
#include "algo/warping.hpp"
#include "model/mesh.hpp"
#include "model/polygon.hpp"

namespace quadbound {

struct PointMeshOptions {
  GridRefinement refinement = GridRefinement::kSixBySix;
  TwoTwoVariant two_two = TwoTwoVariant::kExact;
  Warping warping = Warping::kAligned;
  Budget budget;
};

struct PointMesh {
  Mesh mesh;
  RootSquare root;
  std::vector<VertexId> vertex_of_point;
  Counters counters;
};

/// Why there is no mesh: a budget ran out.
struct Refusal {
  RefusalKind kind;
  Point where;          ///< a place in the input that asks for the refinement
  int level;            ///< of the cell there
  std::string message;  ///< one line: what, where, how to go on
};

using PointMeshResult = std::variant<PointMesh, Refusal>;

/// Meshes a square around the points.
///
/// Guarantees (thm-1), for the default options: 1. every point is exactly a vertex. 2. every angle
/// is in [arctan(1/2), 180 - arctan(1/2)] degrees. 3. at most 3 N quads, N = mesh.cells. 4. the
/// same input gives the same mesh on every machine; so does any order of the points, up to
/// vertex_of_point. 5. no budget exceeded, or a Refusal that says which.
/// Requires: validate(points) passes. Complexity: O(n log n + N); some 57 bytes per quad.
PointMeshResult mesh_points(const PointSet& points, const PointMeshOptions& options = {});

}  // namespace quadbound
