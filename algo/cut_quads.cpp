// SPDX-License-Identifier: Apache-2.0
#include "algo/cut_quads.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace quadbound {
namespace {

/// By a key below `count`, then by edge, each once. A key comes with a few edges, perhaps more than
/// once with the same one.
template <class Pair, class Key>
std::vector<Pair> sorted_once(const std::vector<Pair>& pairs, std::size_t count, const Key& key) {
  std::vector<std::uint32_t> first(count + 1);
  for (const Pair& pair : pairs) ++first[key(pair)];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Pair> sorted(pairs.size());
  for (std::size_t i = pairs.size(); i-- > 0;) sorted[--first[key(pairs[i])]] = pairs[i];
  const auto by_edge = [](const Pair& a, const Pair& b) { return a.edge < b.edge; };
  const auto same = [](const Pair& a, const Pair& b) { return a.edge == b.edge; };
  auto end = sorted.begin();
  for (std::size_t k = 0; k < count; ++k) {
    const auto from = sorted.begin() + first[k];
    const auto to = sorted.begin() + first[k + 1];
    if (to - from > 1) std::sort(from, to, by_edge);
    end = std::move(from, std::unique(from, to, same), end);
  }
  sorted.erase(end, sorted.end());
  return sorted;
}

}  // namespace

CutQuads::CutQuads(const Domain& domain, const TreeMesh& tree_mesh, const EdgeCells& edge_cells)
    : domain_(domain),
      tree_mesh_(tree_mesh),
      is_cut_(tree_mesh.mesh().quads.size()),
      where_(tree_mesh.mesh().vertices.size(), Where::kUnknown),
      last_edges_(is_cut_.size(), 0xFFFF'FFFFU) {
  mark_leaves(edge_cells);
  look_at_met_leaves(edge_cells);
  for (EdgeId site = 0; site < domain_.size(); ++site)
    if (tree_mesh_.vertex_of(site) != kNoVertex)
      where_[tree_mesh_.vertex_of(site)] = Where::kBoundary;
  std::vector<EdgeId>().swap(last_edges_);
  cuts_ = sorted_once(cuts_, is_cut_.size(), [](const Cut& cut) { return cut.quad; });
  // judge lists all that are above the edge, also those beyond another edge.
  std::erase_if(above_, [this](const Above& a) { return where_[a.vertex] != Where::kInside; });
  above_ = sorted_once(above_, where_.size(), [](const Above& above) { return above.vertex; });
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
  std::vector<VertexId> vertices;
  edge_cells.for_met([&](Cell leaf, std::span<const EdgeId> edges) {
    vertices.clear();
    tree_mesh_.append_vertices_of(leaf, vertices);
    for (const VertexId v : vertices)
      where_[v] = edge_cells.where_at(leaf, edges, tree_mesh_.at(v));
    judge_quads_at(vertices, edges);
  });
}

/// Lemma 2: edges of Q lie in the cells of their two ends, so every quad that an edge cuts has a
/// vertex in a leaf that the edge meets.
void CutQuads::judge_quads_at(std::span<const VertexId> vertices, std::span<const EdgeId> edges) {
  for (const EdgeId edge : edges) {
    for (const VertexId v : vertices) {
      for (const QuadId quad : tree_mesh_.quads_at(v)) {
        if (last_edges_[quad] == edge) continue;
        last_edges_[quad] = edge;
        judge({quad, edge});
      }
    }
  }
}

/// A pair that is judged at more than one leaf may get in twice.
void CutQuads::judge(const Cut& cut) {
  const Sides sides = sides_of(cut);
  if (!find_passage(cut, sides)) return;
  is_cut_[cut.quad] = true;
  cuts_.push_back(cut);
  const Quad& q = tree_mesh_.mesh().quads[cut.quad];
  for (unsigned k = 0; k < 4; ++k)
    if (sides.above[k]) above_.push_back({q[k], cut.edge});
}

CutQuads::Sides CutQuads::sides_of(const Cut& cut) const {
  const EdgeId edge = cut.edge;
  const Quad& q = tree_mesh_.mesh().quads[cut.quad];
  const FinePoint& start = domain_.at(edge);
  const Vector d = domain_.direction(edge);
  Sides sides;
  for (unsigned k = 0; k < 4; ++k) {
    const bool is_site = tree_mesh_.is_site(q[k]);
    const EdgeId site = tree_mesh_.site_near(q[k]);
    const LatticePoint at = tree_mesh_.at(q[k]);
    const Vector arm = (is_site ? domain_.at(site) : on_lattice(at)) - start;
    double height = cross(d, arm);
    if (!Domain::is_certain(height, d, arm)) {
      const int side = is_site ? domain_.side(edge, site) : domain_.side(edge, at);
      if (side == 0) height = 0;
      sides.above[k] = side > 0;
    } else {
      sides.above[k] = height > 0;
    }
    sides.arm[k] = arm;
    sides.height[k] = height;
  }
  return sides;
}

std::optional<Passage> CutQuads::find_passage(const Cut& cut, const Sides& sides) const {
  const auto& [above, arm, h] = sides;
  if (above[0] == above[1] && above[1] == above[2] && above[2] == above[3]) return std::nullopt;
  const Vector d = domain_.direction(cut.edge);
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

std::span<const Above> CutQuads::above(VertexId vertex) const {
  const auto first = std::lower_bound(above_.begin(), above_.end(), Above{vertex, 0});
  auto last = first;
  while (last != above_.end() && last->vertex == vertex) ++last;
  return {first, last};
}

}  // namespace quadbound
