// SPDX-License-Identifier: Apache-2.0
#include "algo/corner_alignment.hpp"

#include <array>

#include "model/angle.hpp"

namespace quadbound {
namespace {

/// The angle at a corner between its edge and the line to a point is arctan(1/3) at least, or the
/// point lies on the other side.
bool leaves_angle(const Domain& domain, EdgeId site, EdgeId edge, Vector to) {
  const Vector along = edge == site ? domain.direction(edge) : -1.0 * domain.direction(edge);
  const double inwards = edge == site ? cross(along, to) : cross(to, along);
  const double d = dot(along, to);
  return d <= 0 || 3 * std::abs(inwards) >= d;
}

bool within_bounds(const TreeMesh& tree_mesh, QuadId quad) {
  const Quad& q = tree_mesh.mesh().quads[quad];
  for (unsigned k = 0; k < 4; ++k) {
    const auto corner = corner_at<Int128>(tree_mesh.at(q[k]), tree_mesh.at(q[(k + 1) & 3U]),
                                          tree_mesh.at(q[(k + 3) & 3U]));
    if (!within(corner, kTheorem13)) return false;
  }
  return true;
}

}  // namespace

std::vector<AlignedCentre> align_with_corners(const Domain& domain, TreeMesh& tree_mesh,
                                              const CutQuads& cut_quads, const KeptQuads& kept,
                                              InsertionCounters& counters) {
  std::vector<AlignedCentre> aligned;
  for (EdgeId site = 0; site < domain.size(); ++site) {
    for (const Direction direction : kDirections) {
      const auto beside = tree_mesh.tree().neighbour(tree_mesh.cell_of(site), direction);
      const VertexId centre = tree_mesh.centre(*beside);  // exists: the 5x5 grid
      const LatticePoint before = tree_mesh.at(centre);
      if (cut_quads.where(centre) != Where::kInside || !in_wedge(domain, site, before)) continue;
      LatticePoint after = before;
      if (is_horizontal(direction)) {
        after.y = domain.floor(site).y;
      } else {
        after.x = domain.floor(site).x;
      }
      const Vector to = on_lattice(after) - domain.at(site);
      if (!in_wedge(domain, site, after) || !leaves_angle(domain, site, site, to) ||
          !leaves_angle(domain, site, domain.previous(site), to))
        continue;
      tree_mesh.move_to(centre, after);
      bool fits = true;
      for (const QuadId quad : tree_mesh.quads_at(centre))
        if (kept.is_kept[quad]) fits = fits && within_bounds(tree_mesh, quad);
      ++(fits ? counters.moves : counters.moves_refused);
      if (fits) {
        aligned.push_back({site, centre, before});
      } else {
        tree_mesh.move_to(centre, before);
      }
    }
  }
  return aligned;
}

}  // namespace quadbound
