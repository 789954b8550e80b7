// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sections 3 and 4 as a whole: a quadrilateral mesh of a polygon with holes (thm-13).

#include <variant>
#include <vector>

#include "algo/counters.hpp"
#include "algo/domain_mesh.hpp"
#include "algo/edge_insertion.hpp"
#include "algo/mesh_points.hpp"
#include "model/mesh.hpp"
#include "model/polygon.hpp"

namespace quadbound {

struct PolygonMeshOptions {
  Budget budget;
};

/// What Section 3 and 4 did, beyond the counters of Section 2.
struct PolygonCounters {
  Counters quadtree;                    ///< of the last round
  std::uint64_t cells_before = 0;       ///< leaves before edge separation
  std::uint64_t rounds = 0;             ///< of edge separation, the last included
  std::uint64_t separation_splits = 0;  ///< leaves that edge separation asked to split
  std::uint64_t dead_end_splits = 0;    ///< leaves split where no piece led on
  std::uint64_t restarts = 0;           ///< to cut kites
  std::uint64_t kites = 0;
  std::uint64_t kept_quads = 0;
  InsertionCounters insertion;
};

struct PolygonMesh {
  Mesh mesh;
  RootSquare root;
  PolygonCounters counters;
};

using PolygonMeshResult = std::variant<PolygonMesh, Refusal>;

/// Meshes the inside of a polygon.
///
/// Guarantees (thm-13): 1. the mesh covers exactly the inside: its boundary is the polygon, edges
/// subdivided by points exactly on them. 2. all angles but whole input angles are in [arctan(1/3),
/// 180 - arctan(1/7)] degrees. 3. the same input gives the same mesh on every machine. 4. no budget
/// exceeded, or a Refusal that says which.
/// The search for pieces is in floating point; verify_polygon proves 1 and 2 of every mesh.
/// Requires: validate(polygon) passes.
PolygonMeshResult mesh_polygon(const Polygon& polygon, const PolygonMeshOptions& options = {});

}  // namespace quadbound
