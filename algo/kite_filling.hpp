// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 4, the rest: the kites that algo/kites.hpp cut off are meshed in agreement with the mesh
// of B, whatever Steiner points that has on their sides.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "algo/domain_mesh.hpp"

namespace quadbound {

/// How often what was needed.
struct KiteCounters {
  std::uint64_t whole = 0;          ///< kites that are one quad
  std::uint64_t plain_sides = 0;    ///< sides without Steiner points, of the other kites
  std::uint64_t stepped_sides = 0;  ///< sides with Steiner points
  /// Of the stepped sides: v_k moved along an edge of B, as in the paper;
  std::uint64_t moved_along_edge = 0;
  /// v_k moved in the plane, and p along the polygon.
  std::uint64_t moved_in_plane = 0;
  /// both, and vertices of B's inside around them.
  std::uint64_t moved_with_neighbours = 0;
};

/// The tip, and where v_k may go: as we do it, or as Section 4 has it (paper/departures.md).
enum class KiteShape : std::uint8_t { kOurs, kPaper };

struct KiteFilling {
  std::vector<std::size_t> failed;  ///< indices into Domain::kites, ascending
  std::size_t outside = 0;          ///< kites with angles outside thm-13's interval (kPaper)
  KiteCounters counters;
};

/// Adds the quads of all kites to a mesh of B (Figure 43).
///
/// Guarantees: 1. The mesh covers the kites as well, those in `failed` excepted; it is conforming
/// where it was. New vertices on the polygon are exactly on its edges, all others on the lattice.
/// 2. The angles of every quad that is new or changed are within thm-13's interval by exact
/// arithmetic, the input angle at a kite's tip excepted; with kPaper no kite is in `failed`, and
/// those that break this are counted. 3. Vertices of B move only at kites that
/// are not in `failed`: p and q along their edges of the polygon, the Steiner points next to them
/// on the kite's sides, and, where that is not enough, vertices of the inside next to those.
/// 4. construction and level, where known, are kept in step.
/// Requires: `made` is a mesh of the domain with angles in thm-13's interval. For v_k and p to find
/// a place, edges of B at p should leave arctan(1/2) or more to its two neighbours on the boundary;
/// a kite where the search finds none fails.
/// Complexity: linear in the mesh, and in the Steiner points on the kites' sides.
KiteFilling fill_kites(const Domain& domain, DomainMesh& made, KiteShape shape = KiteShape::kOurs);

}  // namespace quadbound
