// SPDX-License-Identifier: Apache-2.0
#include "algo/cut_quads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace quadbound {
namespace {

/// In lattice units; where a rise is far from certain its rounding makes 3 to 5 of them. The number
/// of a foot is rounded to the lattice, by 1 / sqrt(2) along the edge at most: from 3 units above
/// it, which is what is left of these after rounding, that turns what should be the perpendicular
/// by 13.3 degrees at most.
constexpr double kLeastHeight = 4;

}  // namespace

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
    if (!tree_mesh_.has(leaf)) return;
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

/// Whether the perpendicular from a point has its foot on the edge.
bool CutQuads::is_over(EdgeId edge, Vector arm) const {
  const Vector d = domain_.direction(edge);
  const double along = dot(d, arm);
  return 0 <= along && along <= dot(d, d);
}

/// The rise where its rounded value is in doubt.
double CutQuads::exact_rise(EdgeId edge, VertexId vertex, double rounded) const {
  const bool is_site = tree_mesh_.is_site(vertex);
  const LatticePoint at = tree_mesh_.at(vertex);
  const int side =
      is_site ? domain_.side(edge, tree_mesh_.site_near(vertex)) : domain_.side(edge, at);
  if (side == 0 || (side > 0 && !is_site && domain_.height(edge, at) < kLeastHeight)) return 0;
  return side * std::max(std::abs(rounded), std::numeric_limits<double>::min());
}

/// Inline: a tenth of the instructions of CutQuads would go into the calls.
[[gnu::always_inline]] inline CutQuads::Sight CutQuads::sight(EdgeId edge, VertexId vertex) const {
  const bool is_site = tree_mesh_.is_site(vertex);
  const Vector d = domain_.direction(edge);
  const Vector arm =
      (is_site ? domain_.at(tree_mesh_.site_near(vertex)) : on_lattice(tree_mesh_.at(vertex))) -
      domain_.at(edge);
  const double rise = cross(d, arm);
  if (!Domain::is_certain(rise, d, arm)) return {arm, exact_rise(edge, vertex, rise)};
  // The 1-norm is no less than the length, which costs a root.
  const bool may_be_on_it = 0 < rise && rise < kLeastHeight * (std::abs(d.x) + std::abs(d.y));
  return {arm, may_be_on_it && rise < kLeastHeight * length(d) && !is_site ? 0 : rise};
}

std::optional<Passage> CutQuads::find_passage(const Cut& cut) const {
  const Quad& q = tree_mesh_.mesh().quads[cut.quad];
  const Vector d = domain_.direction(cut.edge);
  std::array<bool, 4> above{};
  std::array<Vector, 4> arm{};
  std::array<double, 4> h{};
  for (unsigned k = 0; k < 4; ++k) {
    const Sight seen = sight(cut.edge, q[k]);
    arm[k] = seen.arm;
    h[k] = seen.rise;
    above[k] = h[k] > 0;
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
      const Sight seen = sight(cut.edge, v);
      if (seen.rise > 0) {
        above_.push_back({v, cut.edge});
      } else if (seen.rise == 0 && is_over(cut.edge, seen.arm)) {
        where_[v] = Where::kBoundary;
      }
    }
  }
  const auto key = [](const Above& above) {
    return std::uint64_t{above.vertex} << 32 | above.edge;
  };
  std::sort(above_.begin(), above_.end(),
            [&](const Above& a, const Above& b) { return key(a) < key(b); });
  above_.erase(std::unique(above_.begin(), above_.end()), above_.end());
  std::erase_if(above_, [this](const Above& a) { return where_[a.vertex] != Where::kInside; });
}

std::span<const Above> CutQuads::above(VertexId vertex) const {
  const auto first = std::lower_bound(above_.begin(), above_.end(), Above{vertex, 0});
  auto last = first;
  while (last != above_.end() && last->vertex == vertex) ++last;
  return {first, last};
}

}  // namespace quadbound
