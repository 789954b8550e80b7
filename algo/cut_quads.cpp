// SPDX-License-Identifier: Apache-2.0
#include "algo/cut_quads.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace quadbound {

CutQuads::CutQuads(const Domain& domain, const TreeMesh& tree_mesh, const EdgeCells& edge_cells)
    : domain_(domain),
      tree_mesh_(tree_mesh),
      is_cut_(tree_mesh.mesh().quads.size()),
      where_(tree_mesh.mesh().vertices.size(), Where::kUnknown) {
  mark_leaves(edge_cells);
  look_at_met_leaves(edge_cells);
  for (EdgeId site = 0; site < domain_.size(); ++site)
    if (tree_mesh_.vertex_of(site) != kNoVertex)
      where_[tree_mesh_.vertex_of(site)] = Where::kBoundary;
  sort_cuts();
  collect_above();
}

/// Those of leaves that are met are left as they come: look_at_met_leaves knows better.
void CutQuads::mark_leaves(const EdgeCells& edge_cells) {
  tree_mesh_.for_centres(
      [&](Cell leaf, VertexId centre) { where_[centre] = edge_cells.where(leaf); });
  // The extra points of a leaf follow its centre.
  for (VertexId v = 1; v < tree_mesh_.vertices_of_leaves(); ++v)
    if (where_[v] == Where::kUnknown) where_[v] = where_[v - 1];
  for (const auto& [centre, v] : tree_mesh_.halves_extras()) where_[v] = where_[centre];
}

void CutQuads::look_at_met_leaves(const EdgeCells& edge_cells) {
  std::vector<EdgeId> last_edges(is_cut_.size(), 0xFFFF'FFFFU);
  std::vector<VertexId> vertices;
  edge_cells.for_met([&](Cell leaf, std::span<const EdgeId> edges) {
    vertices.clear();
    tree_mesh_.append_vertices_of(leaf, vertices);
    for (const VertexId v : vertices)
      where_[v] = edge_cells.where_at(leaf, edges, tree_mesh_.at(v));
    judge_quads_at(vertices, edges, last_edges);
  });
}

/// Lemma 2: edges of Q lie in the cells of their two ends, so every quad that an edge cuts has a
/// vertex in a leaf that the edge meets. By quad the edge it was last judged with.
void CutQuads::judge_quads_at(std::span<const VertexId> vertices, std::span<const EdgeId> edges,
                              std::vector<EdgeId>& last_edges) {
  for (const EdgeId edge : edges) {
    for (const VertexId v : vertices) {
      for (const QuadId quad : tree_mesh_.quads_at(v)) {
        if (last_edges[quad] == edge) continue;
        last_edges[quad] = edge;
        if (!find_passage({quad, edge})) continue;
        is_cut_[quad] = true;
        cuts_.push_back({quad, edge});
      }
    }
  }
}

/// A pair that was judged at more than one leaf may be there twice.
void CutQuads::sort_cuts() {
  const auto key = [](const Cut& cut) { return std::uint64_t{cut.quad} << 32 | cut.edge; };
  std::sort(cuts_.begin(), cuts_.end(),
            [&](const Cut& a, const Cut& b) { return key(a) < key(b); });
  const auto same = [&](const Cut& a, const Cut& b) { return key(a) == key(b); };
  cuts_.erase(std::unique(cuts_.begin(), cuts_.end(), same), cuts_.end());
}

std::optional<Passage> CutQuads::find_passage(const Cut& cut) const {
  const EdgeId edge = cut.edge;
  const Quad& q = tree_mesh_.mesh().quads[cut.quad];
  const FinePoint& start = domain_.at(edge);
  const Vector d = domain_.direction(edge);
  std::array<bool, 4> above{};
  std::array<Vector, 4> arm{};
  std::array<double, 4> h{};
  for (unsigned k = 0; k < 4; ++k) {
    const bool is_site = tree_mesh_.is_site(q[k]);
    const EdgeId site = tree_mesh_.site_near(q[k]);
    const LatticePoint at = tree_mesh_.at(q[k]);
    arm[k] = (is_site ? domain_.at(site) : on_lattice(at)) - start;
    h[k] = cross(d, arm[k]);
    if (!Domain::is_certain(h[k], d, arm[k])) {
      const int side = is_site ? domain_.side(edge, site) : domain_.side(edge, at);
      if (side == 0) h[k] = 0;
      above[k] = side > 0;
    } else {
      above[k] = h[k] > 0;
    }
  }
  if (above[0] == above[1] && above[1] == above[2] && above[2] == above[3]) return std::nullopt;
  const double square = dot(d, d);
  std::array<double, 4> t{};
  for (unsigned k = 0; k < 4; ++k) t[k] = dot(d, arm[k]);
  std::array<double, 2> ends{};
  unsigned found = 0;
  for (unsigned k = 0; k < 4; ++k) {
    const unsigned m = (k + 1) & 3U;
    if (above[k] == above[m]) continue;
    // The crossing of the side with the line. An end on the line is the crossing, without rounding.
    const double crossing = h[k] == 0   ? t[k]
                            : h[m] == 0 ? t[m]
                                        : (t[m] * h[k] - t[k] * h[m]) / (h[k] - h[m]);
    if (found < 2) ends[found++] = crossing;
  }
  const auto [from, to] = std::minmax(ends[0], ends[1]);
  const bool touches = from == to && 0 < from && from < square;
  if (!touches && !(from < to && 0 < to && from < square)) return std::nullopt;
  return Passage{from / square, to / square};
}

void CutQuads::forget_cuts() {
  std::vector<Cut>().swap(cuts_);
  std::vector<bool>().swap(is_cut_);
}

void CutQuads::collect_above() {
  for (const Cut& cut : cuts_) {
    for (const VertexId v : tree_mesh_.mesh().quads[cut.quad]) {
      if (where_[v] != Where::kInside) continue;
      if (domain_.side(cut.edge, tree_mesh_.at(v)) > 0) above_.push_back({v, cut.edge});
    }
  }
  const auto key = [](const Above& above) {
    return std::uint64_t{above.vertex} << 32 | above.edge;
  };
  std::sort(above_.begin(), above_.end(),
            [&](const Above& a, const Above& b) { return key(a) < key(b); });
  above_.erase(std::unique(above_.begin(), above_.end()), above_.end());
}

std::span<const Above> CutQuads::above(VertexId vertex) const {
  const auto first = std::lower_bound(above_.begin(), above_.end(), Above{vertex, 0});
  auto last = first;
  while (last != above_.end() && last->vertex == vertex) ++last;
  return {first, last};
}

}  // namespace quadbound
