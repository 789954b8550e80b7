// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 3.2: the pieces that the strip between alpha and the edges is put together from.
//
// The strip lies on the right of alpha and on the left of the edges; both run in the same
// direction. `a`, `b`, `c` are vertices of alpha in its order, x before y feet or vertices of the
// domain on one edge. Quads are counter-clockwise.

#include <array>
#include <optional>

#include "algo/domain.hpp"
#include "algo/fine_point.hpp"

namespace quadbound {

/// Below this slack a quad counts as outside the bounds. Rounding in corner_slack is below 2^-48;
/// a corner exactly on a bound would not survive the rounding of its coordinates to doubles.
inline constexpr double kSmallestSlack = 1e-9;

/// sin 3 degrees: more slack than this is not asked for.
inline constexpr double kEnoughSlack = 0.0523;

/// The Steiner point and the foot inside a strip pentagon.
struct Pentagon {
  double slack;
  LatticePoint steiner;
  std::int64_t foot;
};

/// Meshes the pentagon x, y, c, b, a with the quads (x, z, s, a), (z, y, c, s) and (a, s, c, b): a
/// Steiner point s and a foot z between x and y. The first of a fixed list of candidates that has
/// enough slack, or else the best, if it has more than `least`.
std::optional<Pentagon> mesh_pentagon(const Domain& domain, EdgeId edge, const FinePoint& x,
                                      const FinePoint& y, LatticePoint a, LatticePoint b,
                                      LatticePoint c, double least);

/// The Steiner point inside a corner hexagon.
struct Hexagon {
  double slack;
  LatticePoint steiner;
};

/// Meshes the hexagon x, v, y, c, b, a around the corner v of the domain with the quads (x, v, s,
/// a), (v, y, c, s) and (s, c, b, a). Pattern search from points between v and b.
std::optional<Hexagon> mesh_hexagon(const FinePoint& x, const FinePoint& v, const FinePoint& y,
                                    LatticePoint a, LatticePoint b, LatticePoint c);

}  // namespace quadbound
