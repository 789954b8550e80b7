// SPDX-License-Identifier: Apache-2.0
#include "algo/cut_quads.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "algo/edge_cells.hpp"

namespace quadbound {
namespace {

/// Calls visit(leaf, its place in KnownCentres) for the leaves in the window.
template <class Visit>
void for_leaves(const TreeMesh& tree_mesh, const Visit& visit) {
  const Quadtree& tree = tree_mesh.tree();
  for (BlockId block = 0; block < tree.blocks().size(); ++block) {
    if (!tree_mesh.window().has(block)) continue;
    for (const Quadrant q : kQuadrants)
      if (tree.is_leaf({block, q})) visit(Cell{block, q}, 4 * std::size_t{block} + q);
  }
}

constexpr Where side_of(bool inside) { return inside ? Where::kInside : Where::kOutside; }

}  // namespace

CutQuads::CutQuads(const Domain& domain, const TreeMesh& tree_mesh, KnownCentres& known)
    : domain_(domain),
      tree_mesh_(tree_mesh),
      is_cut_(tree_mesh.mesh().quads.size()),
      where_(tree_mesh.mesh().vertices.size(), Where::kUnknown),
      odd_sides_(tree_mesh.mesh().quads.size()) {
  find_candidates();
  for (EdgeId site = 0; site < domain_.size(); ++site)
    if (tree_mesh_.vertex_of(site) != kNoVertex)
      where_[tree_mesh_.vertex_of(site)] = Where::kBoundary;
  for (const std::uint64_t pair : candidates_)
    judge(static_cast<QuadId>(pair >> 32), static_cast<EdgeId>(pair));
  candidates_ = {};
  find_sides(known);
  update(known);
  collect_above();
}

void CutQuads::update(KnownCentres& known) const {
  known.resize(4 * tree_mesh_.tree().blocks().size(), Where::kUnknown);
  for_leaves(tree_mesh_,
             [&](Cell leaf, std::size_t place) { known[place] = where_[tree_mesh_.centre(leaf)]; });
}

void CutQuads::find_candidates() {
  last_edge_.assign(is_cut_.size(), 0xFFFF'FFFFU);
  for_leaves_with_edges(
      domain_, tree_mesh_.tree(), tree_mesh_.window(), edges_of(domain_),
      [this](Cell leaf, std::span<const EdgeId> edges) { add_candidates(leaf, edges); });
  last_edge_ = {};
  std::sort(candidates_.begin(), candidates_.end());
  candidates_.erase(std::unique(candidates_.begin(), candidates_.end()), candidates_.end());
}

/// Lemma 2: edges of Q lie in the cells of their two ends, so every quad that an edge cuts has a
/// vertex in a leaf that the edge meets.
void CutQuads::add_candidates(Cell leaf, std::span<const EdgeId> edges) {
  vertices_.clear();
  tree_mesh_.append_vertices_of(leaf, vertices_);
  for (const EdgeId edge : edges) {
    for (const VertexId v : vertices_) {
      for (const QuadId quad : tree_mesh_.quads_at(v)) {
        if (last_edge_[quad] == edge) continue;
        last_edge_[quad] = edge;
        candidates_.push_back(std::uint64_t{quad} << 32 | edge);
      }
    }
  }
}

void CutQuads::judge(QuadId quad, EdgeId edge) {
  const Quad& q = tree_mesh_.mesh().quads[quad];
  const Vector d = domain_.direction(edge);
  const double square = dot(d, d);
  std::array<bool, 4> above{};
  std::array<double, 4> h{};
  std::array<double, 4> t{};
  for (unsigned k = 0; k < 4; ++k) {
    int side = 0;
    if (tree_mesh_.is_site(q[k])) {
      const EdgeId site = tree_mesh_.site_near(q[k]);
      side = domain_.side(edge, site);
      h[k] = side == 0 ? 0 : cross(d, domain_.at(site) - domain_.at(edge));
      t[k] = dot(d, domain_.at(site) - domain_.at(edge));
    } else {
      const LatticePoint at = tree_mesh_.at(q[k]);
      side = domain_.side(edge, at);
      h[k] = side == 0 ? 0 : cross(d, on_lattice(at) - domain_.at(edge));
      t[k] = dot(d, on_lattice(at) - domain_.at(edge));
      if (side == 0 && 0 < t[k] && t[k] < square) where_[q[k]] = Where::kBoundary;
    }
    above[k] = side > 0;
  }
  std::array<double, 2> ends{};
  unsigned found = 0;
  for (unsigned k = 0; k < 4; ++k) {
    const unsigned m = (k + 1) & 3U;
    if (above[k] == above[m]) continue;
    // The crossing of the side with the line. An end on the line is the crossing, without rounding.
    const double crossing = h[k] == 0   ? t[k]
                            : h[m] == 0 ? t[m]
                                        : (t[m] * h[k] - t[k] * h[m]) / (h[k] - h[m]);
    if (0 < crossing && crossing < square) odd_sides_[quad] ^= static_cast<std::uint8_t>(1U << k);
    if (found < 2) ends[found++] = crossing;
  }
  if (found == 0) return;
  const auto [from, to] = std::minmax(ends[0], ends[1]);
  const bool touches = from == to && 0 < from && from < square;
  if (!touches && !(from < to && 0 < to && from < square)) return;
  is_cut_[quad] = true;
  cuts_.push_back({quad, edge, from / square, to / square});
}

/// Two ends of a side of a quad lie on the same side of the boundary exactly if an even number of
/// edges crosses it; so one vertex that is known tells all that it is joined to.
void CutQuads::find_sides(const KnownCentres& known) {
  SideSets sets(where_.size());
  const std::vector<Quad>& quads = tree_mesh_.mesh().quads;
  for (QuadId quad = 0; quad < quads.size(); ++quad) {
    const Quad& q = quads[quad];
    for (unsigned k = 0; k < 4; ++k) {
      const VertexId next = q[(k + 1) & 3U];
      if (where_[q[k]] == Where::kUnknown && where_[next] == Where::kUnknown)
        sets.join(q[k], next, (unsigned{odd_sides_[quad]} >> k & 1U) != 0);
    }
  }
  std::vector<Where> of_set(where_.size(), Where::kUnknown);
  settle_known(known, sets, of_set);
  for (VertexId v = 0; v < where_.size(); ++v) {
    if (where_[v] == Where::kBoundary) continue;
    const SideSets::Place place = sets.find(v);
    // Edges that run through vertices all along cut some off.
    if (of_set[place.set] == Where::kUnknown)
      of_set[place.set] = side_of(is_inside(tree_mesh_.at(v)) != place.other_side);
    where_[v] = side_of((of_set[place.set] == Where::kInside) != place.other_side);
  }
}

/// Leaves that were split since have no place in the tree; new ones are not known yet.
void CutQuads::settle_known(const KnownCentres& known, SideSets& sets,
                            std::vector<Where>& of_set) const {
  const auto settle = [&](VertexId centre, Where where) {
    if (where_[centre] != Where::kUnknown) return;
    const SideSets::Place place = sets.find(centre);
    of_set[place.set] = side_of((where == Where::kInside) != place.other_side);
  };
  if (tree_mesh_.window().is_whole()) {
    // The lower left leaf of the tree lies outside the domain by place_root.
    const Quadtree& tree = tree_mesh_.tree();
    return settle(tree_mesh_.centre(tree.leaf_at(tree.root().corner)), Where::kOutside);
  }
  for_leaves(tree_mesh_, [&](Cell leaf, std::size_t place) {
    if (place < known.size() && (known[place] == Where::kInside || known[place] == Where::kOutside))
      settle(tree_mesh_.centre(leaf), known[place]);
  });
}

/// Even-odd rule along the ray to the left. Requires: on no edge.
bool CutQuads::is_inside(LatticePoint point) const {
  bool inside = false;
  for (EdgeId e = 0; e < domain_.size(); ++e) {
    // A rounded vertex lies above the row exactly if its floor does: its fraction is not negative.
    const auto above = [&](EdgeId v) {
      return domain_.floor(v).y > point.y ||
             (domain_.floor(v).y == point.y && domain_.at(v).fraction.y > 0);
    };
    const bool up = above(domain_.next(e));
    if (above(e) == up) continue;
    if ((domain_.side(e, point) > 0) == up) inside = !inside;
  }
  return inside;
}

void CutQuads::collect_above() {
  for (const Cut& cut : cuts_) {
    for (const VertexId v : tree_mesh_.mesh().quads[cut.quad]) {
      if (where_[v] != Where::kInside) continue;
      if (domain_.side(cut.edge, tree_mesh_.at(v)) > 0) above_.push_back({v, cut.edge});
    }
  }
  std::sort(above_.begin(), above_.end());
  above_.erase(std::unique(above_.begin(), above_.end()), above_.end());
}

std::span<const Above> CutQuads::above(VertexId vertex) const {
  const auto first = std::lower_bound(above_.begin(), above_.end(), Above{vertex, 0});
  auto last = first;
  while (last != above_.end() && last->vertex == vertex) ++last;
  return {first, last};
}

}  // namespace quadbound
