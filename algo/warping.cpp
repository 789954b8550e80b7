// SPDX-License-Identifier: Apache-2.0
#include "algo/warping.hpp"

namespace quadbound {
namespace {

/// Replaces one coordinate of a vertex; integers where they do.
void set_coordinate(Vertices& vertices, VertexId vertex, bool is_x, double value) {
  const auto on = lattice_floor(value, vertices.exponent());
  if (vertices.on_lattice(vertex) && on && on->exact) {
    LatticePoint at = vertices.lattice(vertex);
    (is_x ? at.x : at.y) = on->floor;
    vertices.move_to(vertex, at);
    return;
  }
  RationalPoint at = vertices.exact(vertex);
  (is_x ? at.x : at.y) = exact_value(value);
  vertices.move_to_exact(vertex, at);
}

}  // namespace

std::vector<SiteCells> site_cells(const SeparatedTree& separated) {
  std::vector<SiteCells> sites;
  sites.reserve(separated.cell_of_point.size());
  for (const Cell cell : separated.cell_of_point) {
    SiteCells site{cell, {}};
    for (const Direction d : kDirections) site.neighbour[d] = *separated.tree.neighbour(cell, d);
    sites.push_back(site);
  }
  return sites;
}

std::vector<WarpSite> warp_sites(const std::vector<SiteCells>& sites, const TemplateTree& tree) {
  const auto centre = [&tree](Cell cell) {
    return tree.centre(tree.node_of(cell.block), cell.quadrant);
  };
  std::vector<WarpSite> result;
  result.reserve(sites.size());
  for (const SiteCells& site : sites) {
    WarpSite warp{centre(site.centre), {}};
    for (const Direction d : kDirections) warp.neighbour[d] = centre(site.neighbour[d]);
    result.push_back(warp);
  }
  return result;
}

void warp(Mesh& mesh, const std::vector<Point>& points, const std::vector<WarpSite>& sites,
          Warping warping, Counters& counters) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    set_coordinate(mesh.vertices, sites[i].centre, true, points[i].x);
    set_coordinate(mesh.vertices, sites[i].centre, false, points[i].y);
    if (warping == Warping::kPaper) continue;
    for (const Direction d : kDirections) {
      const bool beside = d == kEast || d == kWest;
      set_coordinate(mesh.vertices, sites[i].neighbour[d], !beside,
                     beside ? points[i].y : points[i].x);
      ++counters.centres_aligned;
    }
  }
}

}  // namespace quadbound
