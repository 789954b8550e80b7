// SPDX-License-Identifier: Apache-2.0
#include "algo/mesh_polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "algo/corner_alignment.hpp"
#include "algo/edge_separation.hpp"
#include "algo/kept_quads.hpp"
#include "algo/kites.hpp"
#include "algo/strip_assembly.hpp"

namespace quadbound {
namespace {

PlacedPoints placed_vertices(const Domain& domain) {
  PlacedPoints placed;
  placed.root = domain.root();
  for (EdgeId v = 0; v < domain.size(); ++v) {
    placed.floors.push_back(domain.floor(v));
    placed.rounded.push_back(domain.rounded(v));
  }
  return placed;
}

/// How often the cells at an acute vertex are split before it is given a kite: refinement there
/// only scales what is seen from the vertex.
constexpr int kPatience = 3;

/// The vertex that two edges share, if it is acute.
std::optional<EdgeId> acute_between(const Domain& domain, EdgeId e, EdgeId f) {
  if (domain.next(e) == f && domain.is_acute(f)) return f;
  if (domain.next(f) == e && domain.is_acute(e)) return e;
  return std::nullopt;
}

/// One attempt at a domain: rounds of separation and insertion on one growing tree.
class DomainMesher {
 public:
  DomainMesher(const Domain& domain, const PolygonMeshOptions& options, PolygonCounters& counters)
      : domain_(domain),
        separation_(placed_vertices(domain), options.budget),
        counters_(counters) {}

  /// The mesh, or the acute vertices that need a kite.
  std::variant<DomainMesh, std::vector<EdgeId>> run() {
    separation_.apply_conditions();
    separation_.refine_five_by_five();
    counters_.cells_before = separation_.tree().leaf_count();
    for (;;) {
      ++counters_.rounds;
      counters_.quadtree = {};
      counters_.insertion = {};
      std::optional<DomainMesh> made = round();
      if (made) return std::move(*made);
      std::vector<EdgeId> hopeless = lose_patience();
      if (!hopeless.empty()) return hopeless;
      separation_.refine(to_split_);
    }
  }

 private:
  std::optional<DomainMesh> round() {
    to_split_.clear();
    TreeMesh tree_mesh(domain_, separation_, counters_.quadtree);
    const CutQuads cut_quads(domain_, tree_mesh);
    const std::vector<SeparationFault> faults = separation_faults(domain_, tree_mesh, cut_quads);
    for (const SeparationFault& fault : faults) {
      to_split_.push_back(fault.split);
      const auto acute = acute_between(domain_, fault.edge, fault.other);
      if (acute) troubled_.push_back(*acute);
    }
    counters_.separation_splits += faults.size();
    if (!faults.empty()) {
      const std::vector<Cell> gaps = leaves_along_gaps(domain_, tree_mesh, cut_quads, faults);
      to_split_.insert(to_split_.end(), gaps.begin(), gaps.end());
      return std::nullopt;
    }
    const KeptQuads kept = keep_quads(tree_mesh, cut_quads);
    if (!kept.pinched.empty()) {
      split_around(tree_mesh, kept.pinched);
      return std::nullopt;
    }
    if (!one_alpha_for_each_ring(tree_mesh, cut_quads, kept)) return std::nullopt;
    align_with_corners(domain_, tree_mesh, cut_quads, kept, counters_.insertion);
    std::vector<Strip> strips;
    for (const std::vector<VertexId>& alpha : kept.alphas) {
      auto made = insert_edges(domain_, tree_mesh, cut_quads, alpha, counters_.insertion);
      if (const auto* dead = std::get_if<DeadEnd>(&made)) {
        split_around(tree_mesh, dead->near);
        for (const VertexId v : dead->near) blame_acute(tree_mesh, cut_quads, v);
      } else {
        strips.push_back(std::get<Strip>(std::move(made)));
      }
    }
    if (!to_split_.empty()) return std::nullopt;
    counters_.kept_quads =
        static_cast<std::uint64_t>(std::count(kept.is_kept.begin(), kept.is_kept.end(), true));
    return assemble(domain_, tree_mesh, kept, strips);
  }

  /// Acute vertices whose edges run below a vertex of a dead end.
  void blame_acute(const TreeMesh& tree_mesh, const CutQuads& cut_quads, VertexId vertex) {
    const EdgeId site = tree_mesh.site_near(vertex);
    if (site != TreeMesh::kNoSite && domain_.is_acute(site)) troubled_.push_back(site);
    for (const Above& above : cut_quads.above(vertex)) {
      for (const Above& other : cut_quads.above(vertex)) {
        const auto acute = acute_between(domain_, above.edge, other.edge);
        if (acute) troubled_.push_back(*acute);
      }
    }
  }

  /// Counts the rounds in which each acute vertex made trouble.
  std::vector<EdgeId> lose_patience() {
    std::sort(troubled_.begin(), troubled_.end());
    troubled_.erase(std::unique(troubled_.begin(), troubled_.end()), troubled_.end());
    std::vector<EdgeId> hopeless;
    trouble_.resize(domain_.size());
    for (const EdgeId site : troubled_)
      if (++trouble_[site] >= kPatience) hopeless.push_back(site);
    troubled_.clear();
    return hopeless;
  }

  /// The largest of the leaves of some vertices.
  void split_around(const TreeMesh& tree_mesh, const std::vector<VertexId>& vertices) {
    int largest = 0;
    for (const VertexId v : vertices)
      largest = std::max(largest, tree_mesh.tree().side_bits(tree_mesh.leaf_of(v)));
    for (const VertexId v : vertices) {
      const Cell leaf = tree_mesh.leaf_of(v);
      if (tree_mesh.tree().side_bits(leaf) != largest) continue;
      to_split_.push_back(leaf);
      ++counters_.dead_end_splits;
    }
  }

  bool one_alpha_for_each_ring(const TreeMesh& tree_mesh, const CutQuads& cut_quads,
                               const KeptQuads& kept) {
    std::vector<std::size_t> alphas(domain_.ring_count());
    for (const std::vector<VertexId>& alpha : kept.alphas) {
      for (const VertexId v : alpha) {
        const auto above = cut_quads.above(v);
        if (above.empty()) continue;
        ++alphas[domain_.ring(above.front().edge)];
        break;
      }
    }
    bool fits = true;
    for (EdgeId site = 0; site < domain_.size(); ++site) {
      if (alphas[domain_.ring(site)] == 1) continue;
      fits = false;
      to_split_.push_back(tree_mesh.cell_of(site));
    }
    return fits;
  }

  const Domain& domain_;
  Separation separation_;
  PolygonCounters& counters_;
  std::vector<Cell> to_split_;
  std::vector<EdgeId> troubled_;  ///< acute vertices, this round
  std::vector<int> trouble_;      ///< rounds of it, by vertex of the domain
};

/// By vertex of the domain the vertex of the input, where it is one.
std::vector<std::optional<std::size_t>> inputs_of(const std::vector<bool>& cut) {
  std::vector<std::optional<std::size_t>> result;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    if (cut[i]) {
      result.resize(result.size() + 3);
    } else {
      result.emplace_back(i);
    }
  }
  return result;
}

PolygonMesh mesh_with_kites(const Polygon& polygon, const RootSquare& root, std::size_t size,
                            const PolygonMeshOptions& options) {
  PolygonMesh result;
  result.root = root;
  std::vector<bool> cut(size);
  for (;; ++result.counters.restarts) {
    const Domain domain = cut_kites(polygon, root, cut);
    result.counters.kites = domain.kites.size();
    auto made = DomainMesher(domain, options, result.counters).run();
    if (auto* mesh = std::get_if<DomainMesh>(&made)) {
      result.mesh = std::move(mesh->mesh);
      result.mesh.input_vertices = size;
      return result;
    }
    const auto inputs = inputs_of(cut);
    for (const EdgeId site : std::get<std::vector<EdgeId>>(made)) cut[*inputs[site]] = true;
  }
}

}  // namespace

PolygonMeshResult mesh_polygon(const Polygon& polygon, const PolygonMeshOptions& options) {
  std::vector<Point> points;
  for (const Ring& ring : polygon.rings) points.insert(points.end(), ring.begin(), ring.end());
  const RootSquare root = place_root(points).root;
  try {
    return mesh_with_kites(polygon, root, points.size(), options);
  } catch (const TreeBudgetExceeded& exceeded) {
    const Point where{nearest_double(exceeded.where.x, root.exponent),
                      nearest_double(exceeded.where.y, root.exponent)};
    return Refusal{exceeded.kind, where, exceeded.level,
                   fmt::format("budget near ({}, {}) level {}", where.x, where.y, exceeded.level)};
  }
}

}  // namespace quadbound
