// SPDX-License-Identifier: Apache-2.0
#pragma once
// The judge: says of anyone's mesh, claim by claim, whether it is what the theorem promises.

#include <optional>

#include "model/angle.hpp"
#include "model/mesh.hpp"
#include "model/polygon.hpp"
#include "verify/report.hpp"

namespace quadbound {

struct VerifyOptions {
  std::optional<AngleInterval> angles;          ///< empty: those of the theorem
  std::optional<std::uint64_t> quads_per_cell;  ///< empty: that of the theorem
  unsigned threads = 1;                         ///< 0: as many as there are cores
  /// Compare the positions of vertices even where the tiling proof has shown them to differ.
  bool always_compare_positions = false;
};

/// Judges a mesh of a point set: thm-1 and all the claims it consists of.
///
/// Guarantees:
/// 1. Every verdict is exact: floating point only filters in front of integers and rationals.
/// 2. all-quad: there are quads and no other faces; the vertex numbers of a quad exist and differ.
///    Where quads are malformed the other claims are not decided, save size-3N. Other faces are
///    left out of all other claims.
/// 3. distinct-vertices: no two vertices of quads are at one place.
/// 4. conforming: no directed edge belongs to two quads, and no end of an unpaired edge lies inside
///    another unpaired edge (hanging node). Unpaired: no quad has the edge the other way round.
/// 5. strictly-convex: every corner turns left.
/// 6. one-boundary: the unpaired edges form one closed loop that neither meets nor crosses itself.
/// 7. no-overlap: no two quads share an inner point. Holds by the proof in verify/tiling.md; fails
///    where quads cover the surroundings of a vertex or of a crossing of two unpaired edges twice;
///    is not decided where the conditions of the proof are broken otherwise.
/// 8. euler: vertices - edges + quads = 1.
/// 9. area: the signed areas of the quads add up to the area within the outermost boundary loop.
///    Not decided where the unpaired edges are no union of disjoint closed loops. The sum is exact;
///    edges with an end off the lattice enter it only where they are not cancelled by their reverse
///    (verify/tiling.md, Areas).
/// 10. points-kept: every input point is the place of a vertex of a quad.
/// 11. min-angle, max-angle: all corners are within options.angles (kTheorem1). Angles are taken in
/// [0, 360)
///    degrees, so that a reflex corner breaks max-angle only. Both come with the extreme corner; of
///    equal ones it is that of the smallest quad and corner number.
/// 12. size-3N: at most options.quads_per_cell (3) quads per cell. Not decided where mesh.cells is
/// 0.
/// 13. strictly-convex, min-angle and max-angle are judged a second time with the coordinates
///    rounded to doubles. A bound is broken within_rounding where no corner is beyond it by more
///    than 4 sqrt(2) 2^-53 M / l radians: M the largest coordinate at the corner, l its shorter
///    edge.
/// 14. The report is the same whatever the number of threads.
/// Requires: fewer than 2^30 quads. Errors: std::length_error otherwise.
/// Complexity: time linear in vertices and quads while quads are sound; about 25 bytes per quad
/// beyond the mesh, and where vertices are off the lattice 4 per vertex and 116 for each of those.
Report verify_points(const PointSet& points, const Mesh& mesh, const VerifyOptions& options = {});

/// Judges a mesh of a polygon with holes: thm-13 and all the claims it consists of.
///
/// Guarantees: 1 to 5, 7, 13 and 14 as for points, and:
/// 15. boundary-kept: the unpaired edges are exactly the rings, subdivided, each ring once and in
///    its direction: every vertex of the polygon is a boundary vertex, and every other boundary
///    vertex lies exactly on its edge, after the one before it. A failure names ring, edge and
///    vertex.
/// 16. With boundary-kept, no-overlap holds by the same proof (verify/tiling.md).
/// 17. euler: vertices - edges + quads = 2 - rings.
/// 18. area: the signed areas of the quads add up to the area of the polygon, as for points.
/// 19. min-angle, max-angle: as for points with kTheorem13, for all corners but the whole input
///    angles. A whole input angle is the corner of a quad at the place of a vertex of the polygon
///    where the mesh vertex has no other corner; those are counted and listed in report.polygon,
///    and judged by strictly-convex only. Where no other corner is left, both claims hold.
/// 20. size-5N: at most options.quads_per_cell (5) quads per cell. Not decided where mesh.cells is
///    0.
/// 21. report.polygon has the Steiner points per edge where boundary-kept holds.
/// Requires: fewer than 2^30 quads; a polygon that is valid and normalised (model/validate.hpp).
/// Errors: std::length_error for the former.
/// Complexity: as for points, and O(b log b) for b boundary edges and input vertices.
Report verify_polygon(const Polygon& polygon, const Mesh& mesh, const VerifyOptions& options = {});

}  // namespace quadbound
