// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether the unpaired edges of a mesh are the rings of a polygon, subdivided.

#include <optional>
#include <span>
#include <vector>

#include "model/polygon.hpp"
#include "verify/boundary.hpp"
#include "verify/places.hpp"
#include "verify/report.hpp"

namespace quadbound::judge {

/// The vertices of a polygon in one list. Ring r has those from starts[r] to before starts[r + 1].
struct RingVertices {
  explicit RingVertices(const Polygon& polygon);
  [[nodiscard]] std::size_t rings() const { return starts.size() - 1; }
  [[nodiscard]] std::size_t size(std::size_t ring) const { return starts[ring + 1] - starts[ring]; }

  std::vector<Point> points;
  std::vector<std::size_t> starts;
};

/// Where the unpaired edges leave the rings.
struct Departure {
  enum class Kind {
    branching,    ///< a vertex has not exactly one unpaired edge in and one out
    ring_lost,    ///< no vertex of the ring has an unpaired edge; of a hole: it is filled
    vertex_lost,  ///< a vertex of the ring has no unpaired edge, or is no vertex of the mesh
    off_edge,     ///< a vertex is not on the line of the edge that it should subdivide
    passed,       ///< a vertex is on that line, but not between the one before it and the end
    stray_loop,   ///< a loop belongs to no ring
  };
  Kind kind;
  std::size_t ring = 0;  ///< not for branching and stray_loop
  /// Index in the ring of the vertex that is lost, or that starts the edge.
  std::size_t ring_vertex = 0;
  VertexId vertex = kNoVertex;  ///< not for ring_lost and vertex_lost
};

struct RingWalk {
  std::optional<Departure> departure;  ///< none exactly where the boundary is kept
  PolygonFacts::Steiner steiner;       ///< of all edges, where there is no departure
};

/// Walks from each ring's first vertex along the unpaired edges.
///
/// Guarantees: 1. there is no departure exactly where every unpaired edge lies on one edge of the
/// polygon and has its direction, every edge of the polygon is covered by such edges one after the
/// other, from vertex to vertex, and no vertex has two unpaired edges in or out. 2. The departure
/// is the first by kind in this order: branching; the first ring or vertex that is lost; the first
/// by ring, edge and place on it that is off or passed; the stray loop of the smallest vertex.
/// Requires: unpaired edges as link_corners gives them; placed vertices as find_placed_vertices
/// does for the points of the rings; the polygon is valid (model/validate.hpp) for 1. Complexity:
/// O(n log n) for n unpaired edges and ring vertices; in 128-bit integers while edges of the
/// polygon have their ends on the lattice and subdivide it at its lines.
RingWalk walk_rings(const ExactPlane& plane, const std::vector<DirectedEdge>& unpaired,
                    const RingVertices& rings, std::span<const PlacedVertex> placed);

}  // namespace quadbound::judge
