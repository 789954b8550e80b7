// SPDX-License-Identifier: Apache-2.0
#pragma once
// Who is where: vertices at one place, and input points that are no vertex.

#include <cstdint>
#include <optional>
#include <vector>

#include "verify/chunks.hpp"
#include "verify/links.hpp"
#include "verify/plane.hpp"

namespace quadbound::judge {

struct CoincidentVertices {
  VertexId first;
  VertexId second;
};

/// The used vertex of smallest number that is where an earlier one is, and the first such one.
/// Complexity: expected linear time, 8 to 16 bytes per vertex.
std::optional<CoincidentVertices> find_coincident(const ExactPlane& plane,
                                                  const CornersByVertex& corners);

/// Index of the first input point that no used vertex has as its position (a point that is not
/// finite has none), and how many there are.
struct LostPoints {
  std::uint64_t count = 0;
  std::size_t first = 0;
};

/// Complexity: expected linear in points and vertices; about 25 bytes per point.
LostPoints find_lost_points(const ExactPlane& plane, int exponent, const CornersByVertex& corners,
                            const std::vector<Point>& points, const Threads& threads);

/// A used vertex that is where an input point is; the point by its index.
struct PlacedVertex {
  VertexId vertex;
  std::uint32_t point;
};

/// All of them, ascending by vertex. Requires: points finite and all different.
/// Complexity: that of find_lost_points.
std::vector<PlacedVertex> find_placed_vertices(const ExactPlane& plane, int exponent,
                                               const CornersByVertex& corners,
                                               const std::vector<Point>& points,
                                               const Threads& threads);

/// Used vertices whose position changes when it is rounded to doubles.
struct MovedVertices {
  std::vector<std::uint8_t> is_moved;  ///< by vertex
  bool any = false;
  std::optional<VertexId> infinite;  ///< the first whose rounded position is infinite
};
MovedVertices find_moved(const StoredPlane& plane, const CornersByVertex& corners,
                         const Threads& threads);

}  // namespace quadbound::judge
