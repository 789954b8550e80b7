// SPDX-License-Identifier: Apache-2.0
#include "algo/cut_quads.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace quadbound {
namespace {

/// Whether an edge may meet a cell grown by a quarter of its side, which is how far outside a
/// mirrored extra point lies. Lemma 2: edges of Q lie in the cells of their two ends, so every quad
/// that an edge cuts has a vertex in one of these cells.
bool may_meet(const Domain& domain, EdgeId edge, LatticePoint corner, int side_bits) {
  const LatticePoint a = domain.floor(edge);
  const LatticePoint b = domain.floor(domain.next(edge));
  const std::int64_t side = std::int64_t{1} << side_bits;
  const std::int64_t grown = side / 4 + 1;
  if (std::max(a.x, b.x) < corner.x - grown || std::min(a.x, b.x) > corner.x + side + grown)
    return false;
  if (std::max(a.y, b.y) < corner.y - grown || std::min(a.y, b.y) > corner.y + side + grown)
    return false;
  const Vector d = domain.direction(edge);
  const Vector to_centre = on_lattice({corner.x + side / 2, corner.y + side / 2}) - domain.at(edge);
  const double reach = 0.75 * static_cast<double>(side) + 2;
  const double size = std::abs(d.x) + std::abs(d.y);
  // 2^-48 is more than the rounding of the cross product.
  return std::abs(cross(d, to_centre)) <=
         size * (reach + 0x1p-48 * (std::abs(to_centre.x) + std::abs(to_centre.y)));
}

}  // namespace

CutQuads::CutQuads(const Domain& domain, const TreeMesh& tree_mesh)
    : domain_(domain),
      tree_mesh_(tree_mesh),
      is_cut_(tree_mesh.mesh().quads.size()),
      where_(tree_mesh.mesh().vertices.size(), Where::kUnknown),
      odd_sides_(tree_mesh.mesh().quads.size()) {
  find_candidates();
  for (EdgeId site = 0; site < domain_.size(); ++site)
    where_[tree_mesh_.vertex_of(site)] = Where::kBoundary;
  for (const std::uint64_t pair : candidates_)
    judge(static_cast<QuadId>(pair >> 32), static_cast<EdgeId>(pair));
  candidates_ = {};
  flood();
  collect_above();
}

void CutQuads::find_candidates() {
  last_edge_.assign(is_cut_.size(), 0xFFFF'FFFFU);
  edges_.resize(domain_.size());
  std::iota(edges_.begin(), edges_.end(), EdgeId{0});
  descend(0, 0);
  last_edge_ = {};
  std::sort(candidates_.begin(), candidates_.end());
  candidates_.erase(std::unique(candidates_.begin(), candidates_.end()), candidates_.end());
}

/// The edges that may meet the block are those from `first` to the top of the stack.
void CutQuads::descend(BlockId block, std::size_t first) {
  const Quadtree& tree = tree_mesh_.tree();
  const std::size_t end = edges_.size();
  for (const Quadrant q : kQuadrants) {
    const Cell cell{block, q};
    const LatticePoint corner = tree.corner(cell);
    for (std::size_t i = first; i < end; ++i)
      if (may_meet(domain_, edges_[i], corner, tree.side_bits(cell))) edges_.push_back(edges_[i]);
    if (edges_.size() > end) {
      if (tree.is_leaf(cell)) {
        add_candidates(cell, end);
      } else {
        descend(tree.content(cell), end);
      }
    }
    edges_.resize(end);
  }
}

void CutQuads::add_candidates(Cell leaf, std::size_t first) {
  vertices_.clear();
  tree_mesh_.append_vertices_of(leaf, vertices_);
  for (std::size_t i = first; i < edges_.size(); ++i) {
    for (const VertexId v : vertices_) {
      for (const QuadId quad : tree_mesh_.quads_at(v)) {
        if (last_edge_[quad] == edges_[i]) continue;
        last_edge_[quad] = edges_[i];
        candidates_.push_back(std::uint64_t{quad} << 32 | edges_[i]);
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

void CutQuads::flood() {
  // The lower left leaf of the tree lies outside the domain by place_root.
  const Quadtree& tree = tree_mesh_.tree();
  const VertexId outermost = tree_mesh_.centre(tree.leaf_at(tree.root().corner));
  where_[outermost] = Where::kOutside;
  flood_from(outermost);
  // Edges that run through vertices all along cut the rest off.
  for (VertexId v = 0; v < where_.size(); ++v) {
    if (where_[v] != Where::kUnknown) continue;
    where_[v] = is_inside(tree_mesh_.at(v)) ? Where::kInside : Where::kOutside;
    flood_from(v);
  }
}

void CutQuads::flood_from(VertexId vertex) {
  std::vector<VertexId> pending{vertex};
  const auto reach = [&](VertexId there, bool inside) {
    if (where_[there] != Where::kUnknown) return;
    where_[there] = inside ? Where::kInside : Where::kOutside;
    pending.push_back(there);
  };
  while (!pending.empty()) {
    const VertexId at = pending.back();
    pending.pop_back();
    const bool inside = where_[at] == Where::kInside;
    for (const QuadId quad : tree_mesh_.quads_at(at)) {
      const Quad& q = tree_mesh_.mesh().quads[quad];
      const auto k = static_cast<unsigned>(std::find(q.begin(), q.end(), at) - q.begin());
      const unsigned before = (k + 3) & 3U;
      reach(q[(k + 1) & 3U], inside != ((odd_sides_[quad] >> k & 1U) != 0));
      reach(q[before], inside != ((odd_sides_[quad] >> before & 1U) != 0));
    }
  }
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
