// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 2.4.3: warping the centre of every point's cell to the point.

#include <array>
#include <vector>

#include "algo/counters.hpp"
#include "algo/point_separation.hpp"
#include "algo/template_tree.hpp"
#include "model/mesh.hpp"
#include "model/polygon.hpp"

namespace quadbound {

enum class Warping : std::uint8_t {
  /// Ours: the centres of the four edge neighbours are aligned with the point as well, E and W with
  /// its
  /// y, N and S with its x. The quads at the point become rectangles.
  kAligned,
  /// The paper's: nothing else moves. Breaks thm-1 near the corners of a cell
  /// (paper/departures.md).
  kPaper,
};

/// A point's cell and its edge neighbours, while the quadtree stands.
struct SiteCells {
  Cell centre;
  std::array<Cell, 4> neighbour;  ///< by Direction
};
std::vector<SiteCells> site_cells(const SeparatedTree& separated);

/// The vertices at the centres of those cells.
struct WarpSite {
  VertexId centre;
  std::array<VertexId, 4> neighbour;  ///< by Direction
};

/// Requires: `tree` was made of the quadtree of the cells, and its leaves are numbered.
std::vector<WarpSite> warp_sites(const std::vector<SiteCells>& sites, const TemplateTree& tree);

/// Guarantees: 1. site i's centre is exactly at point i. 2. with kAligned and the tree of
/// separate_points all angles stay within thm-1's interval (theorem-1 checks every case).
/// Complexity: constant time per point.
void warp(Mesh& mesh, const std::vector<Point>& points, const std::vector<WarpSite>& sites,
          Warping warping, Counters& counters);

}  // namespace quadbound
