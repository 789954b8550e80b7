// SPDX-License-Identifier: Apache-2.0
#include "algo/edge_separation.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "algo/edge_cells.hpp"

namespace quadbound {
namespace {

using EdgePair = std::pair<EdgeId, EdgeId>;

class FaultFinder {
 public:
  FaultFinder(const Domain& domain, const TreeMesh& tree_mesh, const CutQuads& cut_quads)
      : domain_(domain), tree_mesh_(tree_mesh), cut_quads_(cut_quads), leaves_(tree_mesh.tree()) {}

  std::vector<SeparationFault> run() {
    check_quads();
    check_vertices();
    return std::move(faults_);
  }

 private:
  // --- (i): quads that two edges cut -------------------------------------------------------------

  void check_quads() {
    const std::vector<Cut>& cuts = cut_quads_.cuts();
    for (std::size_t first = 0; first < cuts.size();) {
      std::size_t end = first + 1;
      while (end < cuts.size() && cuts[end].quad == cuts[first].quad) ++end;
      if (end - first > 1 && in_core(cuts[first].quad))
        check_quad({cuts.data() + first, end - first});
      first = end;
    }
  }

  void check_quad(std::span<const Cut> cuts) {
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (near_common_vertex(cuts[i], cuts[j]) || !interior_between(cuts[i], cuts[j])) continue;
        return blame_quad(cuts[i].quad, cuts[i].edge, cuts[j].edge);
      }
    }
  }

  [[nodiscard]] bool near_common_vertex(const Cut& a, const Cut& b) {
    const Quad& quad = tree_mesh_.mesh().quads[a.quad];
    const auto all_in_grid = [&](EdgeId site) {
      return std::all_of(quad.begin(), quad.end(),
                         [&](VertexId v) { return in_grid(leaf_of(v), site); });
    };
    if (domain_.next(a.edge) == b.edge && all_in_grid(b.edge)) return true;
    return domain_.next(b.edge) == a.edge && all_in_grid(a.edge);
  }

  /// The middle of either chord, as far as it belongs to its edge, lies on the left of the other.
  [[nodiscard]] bool interior_between(const Cut& a, const Cut& b) const {
    return on_left(a.edge, b) && on_left(b.edge, a);
  }
  [[nodiscard]] bool on_left(EdgeId edge, const Cut& of) const {
    const auto [begin, end] = cut_quads_.passage(of);
    const double middle = (std::max(0.0, begin) + std::min(1.0, end)) / 2;
    const Vector from_start = domain_.at(of.edge) - domain_.at(edge);
    return cross(domain_.direction(edge), from_start + middle * domain_.direction(of.edge)) > 0;
  }

  // --- (ii): vertices below which several edges run ----------------------------------------------

  void check_vertices() {
    const std::vector<Above>& all = cut_quads_.all_above();
    for (std::size_t first = 0; first < all.size();) {
      std::size_t end = first + 1;
      while (end < all.size() && all[end].vertex == all[first].vertex) ++end;
      if (tree_mesh_.window().is_whole() || in_core(leaf_of(all[first].vertex)))
        check_vertex({all.data() + first, end - first});
      first = end;
    }
  }

  void check_vertex(std::span<const Above> edges) {
    const VertexId vertex = edges.front().vertex;
    const std::optional<EdgePair> pair = too_close_at(edges);
    if (!pair) return;
    for (const QuadId quad : tree_mesh_.quads_at(vertex))
      if (cut_quads_.is_cut(quad)) blame_quad(quad, pair->first, pair->second);
  }

  /// An edge that must not run below this vertex, and one that it is too close to.
  [[nodiscard]] std::optional<EdgePair> too_close_at(std::span<const Above> edges) {
    const VertexId vertex = edges.front().vertex;
    bool in_some_grid = false;
    std::optional<EdgePair> pair;
    const auto look = [&](EdgeId site) {
      in_some_grid = true;
      for (const Above& above : edges)
        if (above.edge != site && above.edge != domain_.previous(site)) pair = {above.edge, site};
    };
    if (tree_mesh_.is_centre(vertex)) {
      tree_mesh_.for_grids_at(vertex, look);
    } else {
      tree_mesh_.for_grids_with(leaf_of(vertex), look);
    }
    if (!in_some_grid && edges.size() > 1) pair = {edges.front().edge, edges.back().edge};
    return pair;
  }

  // --- the window --------------------------------------------------------------------------------

  /// Quads and vertices are looked at in the order of their numbers, which is depth first.
  [[nodiscard]] Cell leaf_of(VertexId vertex) { return leaves_.leaf_at(tree_mesh_.at(vertex)); }
  [[nodiscard]] bool in_core(Cell leaf) const { return tree_mesh_.window().is_core(leaf); }
  [[nodiscard]] bool in_core(QuadId quad) {
    if (tree_mesh_.window().is_whole()) return true;
    const Quad& q = tree_mesh_.mesh().quads[quad];
    return std::any_of(q.begin(), q.end(), [this](VertexId v) { return in_core(leaf_of(v)); });
  }

  // --- 5x5 grids ---------------------------------------------------------------------------------

  [[nodiscard]] bool in_grid(Cell leaf, EdgeId site) const {
    bool found = false;
    tree_mesh_.for_grids_with(leaf, [&](EdgeId there) { found = found || there == site; });
    return found;
  }

  // --- what to split -----------------------------------------------------------------------------

  void blame_quad(QuadId quad, EdgeId edge, EdgeId other) {
    std::vector<Cell> leaves;
    int largest = 0;
    for (const VertexId v : tree_mesh_.mesh().quads[quad]) {
      leaves.push_back(leaf_of(v));
      largest = std::max(largest, tree_mesh_.tree().side_bits(leaves.back()));
    }
    for (const Cell leaf : leaves)
      if (tree_mesh_.tree().side_bits(leaf) == largest) add({leaf, edge, other});
  }

  /// A leaf is at fault for all quads and vertices around it, mostly because of the same edges.
  void add(const SeparationFault& fault) {
    if (last_fault_.empty()) last_fault_.resize(tree_mesh_.tree().blocks().size());
    std::uint32_t& last = last_fault_[fault.split.block][fault.split.quadrant];
    if (last != 0 && faults_[last - 1].edge == fault.edge && faults_[last - 1].other == fault.other)
      return;
    faults_.push_back(fault);
    last = static_cast<std::uint32_t>(faults_.size());
  }

  const Domain& domain_;
  const TreeMesh& tree_mesh_;
  const CutQuads& cut_quads_;
  LeafFinder leaves_;
  std::vector<SeparationFault> faults_;
  /// By leaf the number of its last fault, from 1; 0 where it has none.
  std::vector<std::array<std::uint32_t, 4>> last_fault_;
};

// --- gaps ----------------------------------------------------------------------------------------

double distance_to_edge(const Domain& domain, EdgeId edge, const FinePoint& point) {
  const Vector d = domain.direction(edge);
  const Vector to = point - domain.at(edge);
  const double t = std::clamp(dot(d, to) / dot(d, d), 0.0, 1.0);
  return length(to - t * d);
}

/// Two edges with too large leaves between them.
struct Gap {
  EdgeId edge;
  EdgeId other;
  int side_bits;  ///< of the smallest leaf at fault
  double width;   ///< where it is widest at such a leaf
};

double width_at(const Domain& domain, const Quadtree& tree, Cell leaf, EdgeId edge, EdgeId other) {
  const std::int64_t half = std::int64_t{1} << (tree.side_bits(leaf) - 1);
  const LatticePoint corner = tree.corner(leaf);
  const FinePoint centre = on_lattice({corner.x + half, corner.y + half});
  return distance_to_edge(domain, edge, centre) + distance_to_edge(domain, other, centre);
}

/// Of two for the same pair of edges.
bool is_finer(const Gap& a, const Gap& b) {
  return a.side_bits != b.side_bits ? a.side_bits < b.side_bits : a.width > b.width;
}

/// Sorted by edge, each gap listed for both of its edges.
std::vector<Gap> gaps_of(const Domain& domain, const Quadtree& tree,
                         const std::vector<SeparationFault>& faults) {
  std::vector<Gap> gaps;
  for (const SeparationFault& fault : faults) {
    const auto [e, f] = std::pair{fault.edge, fault.other};
    if (e == f || domain.next(e) == f || domain.next(f) == e) continue;
    const int side_bits = tree.side_bits(fault.split);
    const double width = width_at(domain, tree, fault.split, e, f);
    // Most faults are of the same gap as the one before.
    const bool same = !gaps.empty() && gaps.back().edge == f && gaps.back().other == e;
    const std::array<Gap, 2> gap{{{e, f, side_bits, width}, {f, e, side_bits, width}}};
    if (!same) {
      gaps.insert(gaps.end(), gap.begin(), gap.end());
    } else if (is_finer(gap[1], gaps.back())) {
      std::copy(gap.begin(), gap.end(), gaps.end() - 2);
    }
  }
  std::sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) {
    if (a.edge != b.edge || a.other != b.other)
      return std::tie(a.edge, a.other) < std::tie(b.edge, b.other);
    return is_finer(a, b);
  });
  const auto same = [](const Gap& a, const Gap& b) {
    return a.edge == b.edge && a.other == b.other;
  };
  gaps.erase(std::unique(gaps.begin(), gaps.end(), same), gaps.end());
  return gaps;
}

bool is_in_gap(const Domain& domain, const Quadtree& tree, const std::vector<Gap>& gaps, Cell leaf,
               std::span<const EdgeId> edges) {
  for (const EdgeId edge : edges) {
    const auto before = [](const Gap& gap, EdgeId e) { return gap.edge < e; };
    auto gap = std::lower_bound(gaps.begin(), gaps.end(), edge, before);
    for (; gap != gaps.end() && gap->edge == edge; ++gap)
      if (tree.side_bits(leaf) >= gap->side_bits &&
          width_at(domain, tree, leaf, gap->edge, gap->other) <= gap->width)
        return true;
  }
  return false;
}

}  // namespace

std::vector<SeparationFault> separation_faults(const Domain& domain, const TreeMesh& tree_mesh,
                                               const CutQuads& cut_quads) {
  return FaultFinder(domain, tree_mesh, cut_quads).run();
}

std::vector<Cell> leaves_along_gaps(const Domain& domain, const Quadtree& tree,
                                    const std::vector<SeparationFault>& faults) {
  const std::vector<Gap> gaps = gaps_of(domain, tree, faults);
  std::vector<EdgeId> edges;
  for (const Gap& gap : gaps)
    if (edges.empty() || edges.back() != gap.edge) edges.push_back(gap.edge);
  std::vector<Cell> leaves;
  for_leaves_with_edges(domain, tree, edges, [&](Cell leaf, std::span<const EdgeId> met) {
    if (is_in_gap(domain, tree, gaps, leaf, met)) leaves.push_back(leaf);
  });
  return leaves;
}

}  // namespace quadbound
