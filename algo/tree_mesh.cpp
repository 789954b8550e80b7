// SPDX-License-Identifier: Apache-2.0
#include "algo/tree_mesh.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "algo/quadrangulation.hpp"

namespace quadbound {
namespace {

/// An empty list in braces would leave a vector its memory.
template <class Value>
void release(std::vector<Value>& values) {
  std::vector<Value>().swap(values);
}

}  // namespace

TreeMesh::TreeMesh(const Domain& domain, const Separation& separation, const EdgeCells& edge_cells,
                   Counters& counters, Window window)
    : tree_(separation.tree()),
      window_(std::move(window)),
      template_tree_(tree_, window_),
      cell_of_(separation.cell_of_point()) {
  leave_out_leaves(edge_cells);
  mesh_ = quadrangulate(template_tree_, tree_.root(), TwoTwoVariant::kExact, counters);
  place_sites(domain);
  link_quads();
}

void TreeMesh::leave_out_leaves(const EdgeCells& edge_cells) {
  for (BlockId block = 0; block < tree_.blocks().size(); ++block) {
    if (!window_.has(block)) continue;
    for (const Quadrant q : kQuadrants)
      if (tree_.is_leaf({block, q}) &&
          (edge_cells.where({block, q}) == Where::kOutside || !window_.is_core({block, q})))
        template_tree_.leave_out(template_tree_.node_of(block), q);
  }
}

void TreeMesh::place_sites(const Domain& domain) {
  site_near_.assign(mesh_.vertices.size(), kNoSite);
  grid_of_.assign(mesh_.vertices.size(), kNoSite);
  vertex_of_.assign(domain.size(), kNoVertex);
  for (EdgeId site = 0; site < domain.size(); ++site) {
    const Cell cell = cell_of_[site];
    if (!is_near_window(cell)) continue;
    tree_.for_extended_neighbours(cell, [this, site](int, int, Cell there) {
      if (has(there)) site_near_[centre(there)] = site;
    });
    mark_grid(site);
    if (!has(cell)) continue;
    vertex_of_[site] = centre(cell);
    site_near_[vertex_of_[site]] = site;
    mesh_.vertices.move_to(vertex_of_[site], domain.floor(site));
  }
  std::sort(other_grids_.begin(), other_grids_.end());
}

/// Whether some of the 5x5 grid of a cell may lie in the window: it is within the node of the cell
/// and the eight around that one.
bool TreeMesh::is_near_window(Cell cell) const {
  if (window_.has(cell.block)) return true;
  const Quadtree::Block& block = tree_.blocks()[cell.block];
  bool near = false;
  tree_.for_extended_neighbours({block.parent, block.quadrant}, [&](int, int, Cell there) {
    near = near || (!tree_.is_leaf(there) && window_.has(tree_.content(there)));
  });
  return near;
}

/// Requires: the 24 cells around the site's cell exist and are leaves.
void TreeMesh::mark_grid(EdgeId site) {
  const auto mark = [this, site](Cell leaf) {
    if (!has(leaf)) return;
    const VertexId vertex = centre(leaf);
    if (grid_of_[vertex] == kNoSite) {
      grid_of_[vertex] = site;
    } else {
      other_grids_.emplace_back(vertex, site);
    }
  };
  const Cell cell = cell_of_[site];
  Cell row = *tree_.neighbour(*tree_.neighbour(cell, kSouth), kSouth);
  for (int y = -2; y <= 2; ++y) {
    Cell at = *tree_.neighbour(*tree_.neighbour(row, kWest), kWest);
    for (int x = -2; x <= 2; ++x) {
      mark(at);
      if (x < 2) at = *tree_.neighbour(at, kEast);
    }
    if (y < 2) row = *tree_.neighbour(row, kNorth);
  }
}

void TreeMesh::link_quads() {
  first_quad_.assign(mesh_.vertices.size() + 1, 0);
  for (const Quad& quad : mesh_.quads)
    for (const VertexId v : quad) ++first_quad_[v];
  std::partial_sum(first_quad_.begin(), first_quad_.end(), first_quad_.begin());
  // From the ends of the lists backwards, so that first_quad_ ends as what it is called.
  quads_at_.resize(4 * mesh_.quads.size());
  for (QuadId quad = static_cast<QuadId>(mesh_.quads.size()); quad-- > 0;)
    for (const VertexId v : mesh_.quads[quad]) quads_at_[--first_quad_[v]] = quad;
}

void TreeMesh::forget_links() {
  release(first_quad_);
  release(quads_at_);
  release(grid_of_);
  release(other_grids_);
  template_tree_.forget();
}

void TreeMesh::forget_sites() { release(site_near_); }

/// Those that VertexNumbering gave it: its centre and the extra points that are kept.
VertexId TreeMesh::vertices_of_leaf(NodeId node, Quadrant q) const {
  const Template which = which_template(template_tree_.children(node));
  if (which == Template::kT4) return 1;
  const VertexId outer = template_tree_.fate(node, q) == ExtraFate::kDropped ? 0 : 1;
  const VertexId inner = which == Template::kT1 || which == Template::kT2b ? 1 : 0;
  return 1 + outer + inner;
}

void TreeMesh::append_vertices_of(Cell leaf, std::vector<VertexId>& vertices) const {
  const NodeId node = template_tree_.node_of(leaf.block);
  const VertexId first = template_tree_.centre(node, leaf.quadrant);
  const VertexId count = vertices_of_leaf(node, leaf.quadrant);
  for (VertexId v = first; v < first + count; ++v) vertices.push_back(v);
  const auto& halves = halves_extras();
  auto extra = std::lower_bound(halves.begin(), halves.end(), std::pair{first, VertexId{0}});
  for (; extra != halves.end() && extra->first == first; ++extra) vertices.push_back(extra->second);
}

}  // namespace quadbound
