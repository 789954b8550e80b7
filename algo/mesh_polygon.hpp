// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sections 3 and 4 as a whole: a quadrilateral mesh of a polygon with holes (thm-13).

#include <variant>

#include "algo/domain_mesher.hpp"
#include "algo/mesh_points.hpp"
#include "algo/sizing.hpp"
#include "model/mesh.hpp"
#include "model/polygon.hpp"

namespace quadbound {

struct PolygonMeshOptions {
  Budget budget;
  Sizing sizing;
};

struct PolygonMesh {
  Mesh mesh;
  RootSquare root;
  PolygonCounters counters;
};

using PolygonMeshResult = std::variant<PolygonMesh, Refusal>;

/// Where the paper has no case.
struct NoCase {
  std::string claim;  ///< its id
  Point where;
  std::string message;  ///< one line, of the first
  LemmaCounters counters;
};
using LemmaMeshResult = std::variant<PolygonMesh, Refusal, NoCase>;

/// Meshes the inside of a polygon.
///
/// Guarantees (thm-13): 1. the mesh covers exactly the inside: its boundary is the polygon, edges
/// subdivided by points exactly on them. 2. all angles but whole input angles are in [arctan(1/3),
/// 180 - arctan(1/7)] degrees. 3. the same input gives the same mesh on every machine. 4. no
/// quadtree cell with its centre inside is wider than the sizing says. 5. no budget exceeded, or a
/// Refusal that says which, and where.
/// The search for pieces is in floating point with a margin; verify_polygon proves 1 and 2 of each
/// mesh. Why the rounds end: paper/termination.md.
/// Requires: validate(polygon) passes; the polygon is normalised.
/// Complexity: linear in the cells of all rounds and their vertices, O(n log n) in the polygon.
PolygonMeshResult mesh_polygon(const Polygon& polygon, const PolygonMeshOptions& options = {});

/// The same in a root square of the caller's, and no other: for those who look for places of
/// vertices in their cells that the insertion finds no way at.
/// Requires: the square holds all vertices, each a twelfth of its side inside.
PolygonMeshResult mesh_polygon_in(const RootSquare& root, const Polygon& polygon,
                                  const PolygonMeshOptions& options = {});

/// mesh_polygon by the paper's own constructions: kites at all acute vertices, Lemmas 11 and 12 by
/// their cases, Section 4 as written (EdgeInsertion::kLemmas). For comparison.
///
/// Guarantees: 1. as above but for 2.: the judge says which meshes keep the bounds, and
/// counters.lemmas which pieces do not. 2. no cell is split because a case fails.
LemmaMeshResult mesh_polygon_by_lemmas(const Polygon& polygon,
                                       const PolygonMeshOptions& options = {});

}  // namespace quadbound
