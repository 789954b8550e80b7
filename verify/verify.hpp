// SPDX-License-Identifier: Apache-2.0
#pragma once
// The judge: says of anyone's mesh, claim by claim, whether it is what the theorem promises.

#include "model/angle.hpp"
#include "model/mesh.hpp"
#include "model/polygon.hpp"
#include "verify/report.hpp"

namespace quadbound {

struct VerifyOptions {
  AngleInterval angles = kTheorem1;
  std::uint64_t quads_per_cell = 3;
  unsigned threads = 1;  ///< 0: as many as there are cores
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
///    Not decided where the unpaired edges are no union of disjoint closed loops.
/// 10. points-kept: every input point is the place of a vertex of a quad.
/// 11. min-angle, max-angle: all corners are within options.angles. Angles are taken in [0, 360)
///    degrees, so that a reflex corner breaks max-angle only. Both come with the extreme corner; of
///    equal ones it is that of the smallest quad and corner number.
/// 12. size-3N: at most options.quads_per_cell quads per cell. Not decided where mesh.cells is 0.
/// 13. strictly-convex, min-angle and max-angle are judged a second time with the coordinates
///    rounded to doubles. A bound is broken within_rounding where no corner is beyond it by more
///    than 4 sqrt(2) 2^-53 M / l radians: M the largest coordinate at the corner, l its shorter
///    edge.
/// 14. The report is the same whatever the number of threads.
/// Requires: fewer than 2^30 quads. Errors: std::length_error otherwise.
/// Complexity: time linear in vertices and quads while quads are sound and nearly all vertices are
/// on the lattice; about 25 bytes per quad beyond the mesh.
Report verify_points(const PointSet& points, const Mesh& mesh, const VerifyOptions& options = {});

}  // namespace quadbound
