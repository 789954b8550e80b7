// SPDX-License-Identifier: Apache-2.0
#pragma once
// The quadtree of a domain's vertices and its quadrangulation Q, with the links that Section 3 asks
// for.

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "algo/counters.hpp"
#include "algo/domain.hpp"
#include "algo/edge_cells.hpp"
#include "algo/quadtree.hpp"
#include "algo/separation.hpp"
#include "algo/template_tree.hpp"
#include "algo/window.hpp"
#include "model/mesh.hpp"

namespace quadbound {

using QuadId = std::uint32_t;

/// Guarantees: 1. The centre of the cell of a domain's vertex is moved onto that vertex (rounded
/// down to the lattice); nothing else is moved. 2. quads_at lists every quad of a vertex once,
/// ascending. 3. Of a window all quads at its core are there; cells and sites that have none have no
/// vertices. 4. Quads that lie outside the domain, and no edge near any of their leaves, are left
/// out, and so are leaves that have only such quads; quads and vertices keep the order of Q.
/// Requires: tree and domain outlive it, and stay as they are. Complexity: linear.
class TreeMesh {
 public:
  static constexpr EdgeId kNoSite = 0xFFFF'FFFFU;

  /// Requires: edge_cells of this tree and window. The counters count what is left out, too.
  TreeMesh(const Domain& domain, const Separation& separation, const EdgeCells& edge_cells,
           Counters& counters, Window window = {});

  [[nodiscard]] const Quadtree& tree() const { return tree_; }
  [[nodiscard]] const Window& window() const { return window_; }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  /// Leaves no mesh behind.
  [[nodiscard]] Mesh take_mesh() { return std::exchange(mesh_, Mesh()); }
  [[nodiscard]] LatticePoint at(VertexId vertex) const { return mesh_.vertices.lattice(vertex); }
  void move_to(VertexId vertex, LatticePoint point) { mesh_.vertices.move_to(vertex, point); }
  /// Give back the memory of quads_at, for_grids_with and what is known of leaves, and of site_near
  /// and is_site, which must not be asked any more.
  void forget_links();
  void forget_sites();

  [[nodiscard]] std::span<const QuadId> quads_at(VertexId vertex) const {
    return {quads_at_.data() + first_quad_[vertex], first_quad_[vertex + 1] - first_quad_[vertex]};
  }

  /// Whether a leaf is in the window and not left out.
  [[nodiscard]] bool has(Cell leaf) const {
    return window_.has(leaf.block) &&
           !template_tree_.is_left_out(template_tree_.node_of(leaf.block), leaf.quadrant);
  }
  /// Requires: has(leaf).
  [[nodiscard]] VertexId centre(Cell leaf) const {
    return template_tree_.centre(template_tree_.node_of(leaf.block), leaf.quadrant);
  }
  /// The leaf that a vertex lies in.
  [[nodiscard]] Cell leaf_of(VertexId vertex) const { return tree_.leaf_at(at(vertex)); }
  /// Appends the vertices that the tree gave a leaf that it has: they lie in it, or, if mirrored,
  /// within a quarter of its side outside.
  void append_vertices_of(Cell leaf, std::vector<VertexId>& vertices) const;

  /// Calls visit(leaf, its centre) for all leaves that it has.
  template <class Visit>
  void for_centres(const Visit& visit) const {
    for (BlockId block = 0; block < tree_.blocks().size(); ++block) {
      if (!window_.has(block)) continue;
      const NodeId node = template_tree_.node_of(block);
      for (const Quadrant q : kQuadrants)
        if (tree_.is_leaf({block, q}) && !template_tree_.is_left_out(node, q))
          visit(Cell{block, q}, template_tree_.centre(node, q));
    }
  }
  /// Whether a vertex is the centre of a leaf, moved or not.
  [[nodiscard]] bool is_centre(VertexId vertex) const { return template_tree_.is_centre(vertex); }
  /// The vertices of the leaves, less halves_extras: those of a leaf follow its centre, up to the
  /// next centre or this number.
  [[nodiscard]] VertexId vertices_of_leaves() const { return template_tree_.vertices_of_leaves(); }
  /// Extra points of the case 2,2, which are numbered after all others, with the centre of their
  /// leaf before them; ascending.
  [[nodiscard]] const std::vector<std::pair<VertexId, VertexId>>& halves_extras() const {
    return template_tree_.halves_extras();
  }

  /// The leaf and the mesh vertex of a vertex of the domain.
  [[nodiscard]] Cell cell_of(EdgeId site) const { return cell_of_[site]; }
  /// kNoVertex where its cell has none.
  [[nodiscard]] VertexId vertex_of(EdgeId site) const { return vertex_of_[site]; }
  /// The vertex of the domain whose cell or one of the 8 cells around it has its centre here; or
  /// kNoSite.
  [[nodiscard]] EdgeId site_near(VertexId vertex) const { return site_near_[vertex]; }
  /// Calls visit(site) for each vertex of the domain in whose 5x5 grid a leaf is. Nothing is known
  /// of a leaf outside the window.
  template <class Visit>
  void for_grids_with(Cell leaf, const Visit& visit) const {
    if (has(leaf)) for_grids_at(centre(leaf), visit);
  }
  /// The same, by the centre of the leaf.
  template <class Visit>
  void for_grids_at(VertexId vertex, const Visit& visit) const {
    if (grid_of_[vertex] == kNoSite) return;
    visit(grid_of_[vertex]);
    auto other =
        std::lower_bound(other_grids_.begin(), other_grids_.end(), std::pair{vertex, EdgeId{0}});
    for (; other != other_grids_.end() && other->first == vertex; ++other) visit(other->second);
  }
  [[nodiscard]] bool is_site(VertexId vertex) const {
    return site_near_[vertex] != kNoSite && vertex_of_[site_near_[vertex]] == vertex;
  }

 private:
  [[nodiscard]] VertexId vertices_of_leaf(NodeId node, Quadrant q) const;
  void leave_out_leaves(const EdgeCells& edge_cells);
  void link_quads();
  void place_sites(const Domain& domain);
  void mark_grid(EdgeId site);
  [[nodiscard]] bool is_near_window(Cell cell) const;

  const Quadtree& tree_;
  Window window_;
  TemplateTree template_tree_;
  Mesh mesh_;
  std::vector<Cell> cell_of_;
  std::vector<VertexId> vertex_of_;
  std::vector<EdgeId> site_near_;
  std::vector<EdgeId> grid_of_;  ///< by centre: a site in whose 5x5 grid it is
  std::vector<std::pair<VertexId, EdgeId>> other_grids_;  ///< further ones, sorted
  std::vector<std::uint32_t> first_quad_;
  std::vector<QuadId> quads_at_;
};

}  // namespace quadbound
