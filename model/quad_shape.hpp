// SPDX-License-Identifier: Apache-2.0
#pragma once
// The shape of one quad in doubles, for exports, pictures and statistics; never for a verdict.

#include <array>

#include "model/mesh.hpp"

namespace quadbound {

struct QuadShape {
  double min_angle = 0;        ///< degrees, in [0, 360)
  double max_angle = 0;        ///< degrees, in [0, 360); above 180 at a reflex corner
  double scaled_jacobian = 0;  ///< in [-1, 1]
  double aspect_ratio = 0;     ///< at least 1; infinite where the signed area is not positive
};

/// The shape of a quad whose corners are given counter-clockwise.
///
/// With corners p0 ... p3, edges e_i = p_(i+1) - p_i, and the two medians
///   X1 = (e0 - e2) / 2  and  X2 = (e1 - e3) / 2,  whose cross product is the signed area:
/// - scaled Jacobian (Knupp 2000; Verdict's quad_scaled_jacobian): the smallest over the corners of
///   (e_i x e_(i+1)) / (|e_i| |e_(i+1)|), that is, of the sine of the corner's angle;
/// - aspect ratio (Robinson 1987, "CRE method of element testing and the Jacobian shape
///   parameters"): with the x axis along one median, max(e2 / f3, f3 / e2), where e2 is half the
///   length of that median and f3 half the extent of the other one across it. Robinson leaves the
///   choice of the median to the numbering of the corners; we take the worse of the two, which is
///   max(|X1|, |X2|)^2 / (X1 x X2).
///
/// Guarantees: 1. rotating the numbering of the corners changes nothing beyond rounding. 2. The
/// edges are differences of the exact coordinates, each rounded once, so that a small quad far from
/// the origin is not judged by the rounding of its coordinates. 3. A side of length zero gives NaN
/// nowhere: its corners count as angle 0.
/// Requires: the ids are vertices of the mesh.
QuadShape quad_shape(const Vertices& vertices, const Quad& quad);

/// The same from edge vectors in any unit; edges[i] leads from corner i to corner i + 1.
QuadShape quad_shape(const std::array<Point, 4>& edges);

}  // namespace quadbound
