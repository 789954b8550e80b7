// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lemma 11: the polygon A_i between two centres of the chain beta and their feet, meshed by the
// paper's cases.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algo/domain.hpp"
#include "algo/edge_insertion.hpp"
#include "algo/strip_pieces.hpp"
#include "algo/tree_mesh.hpp"

namespace quadbound {

/// A part of a strip. Steiner points are numbered within it.
struct StripPart {
  double slack = 1;  ///< the smallest of its quads; at most kSmallestSlack if one is out of bounds
  std::vector<StripQuad> quads;
  std::vector<LatticePoint> steiner;

  [[nodiscard]] bool is_within_bounds() const { return slack > kSmallestSlack; }
  void append(const StripPart& other);
  StripVertex add_steiner(LatticePoint point);
  void add_quad(const std::array<StripVertex, 4>& corners, const std::array<FinePoint, 4>& at,
                StripConstruction construction);
};

/// The chain alpha_i from c_i to c_(i+1) along an edge, and the feet of its ends.
struct StripPolygon {
  EdgeId edge;
  std::span<const VertexId> alpha;
  std::int64_t first_foot;
  std::int64_t last_foot;
};

/// Meshes A_i by the pieces of Lemma 11: one edge of alpha between two feet (case 1); two edges and
/// a Steiner point with its foot (case 2); three edges, of which a fourth makes a quad (case 3);
/// four edges around a Steiner point on c_i c_(i+1) (case 4); and these one after the other where
/// an inner vertex has a foot of its own, perpendicular or vertical.
///
/// Guarantees: 1. of all ways to put these together the one with the largest slack, which may be
/// outside the bounds. 2. nullopt where there is none: more than four edges, or feet that are not
/// on the edge in their order.
std::optional<StripPart> mesh_by_lemma_11(const Domain& domain, const TreeMesh& tree_mesh,
                                          const StripPolygon& polygon);

}  // namespace quadbound
