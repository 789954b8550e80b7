// SPDX-License-Identifier: Apache-2.0
#include "algo/mesh_polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "algo/corner_alignment.hpp"
#include "algo/edge_separation.hpp"
#include "algo/kept_quads.hpp"
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

Domain whole_domain(const Polygon& polygon, const RootSquare& root) {
  std::vector<std::vector<RationalPoint>> rings;
  for (const Ring& ring : polygon.rings) {
    rings.emplace_back();
    for (const Point& point : ring) rings.back().push_back(exact_value(point));
  }
  return {root, rings};
}

/// One attempt at a domain: rounds of separation and insertion on one growing tree.
class DomainMesher {
 public:
  DomainMesher(const Domain& domain, const PolygonMeshOptions& options, PolygonCounters& counters)
      : domain_(domain),
        separation_(placed_vertices(domain), options.budget),
        counters_(counters) {}

  DomainMesh run() {
    separation_.apply_conditions();
    separation_.refine_five_by_five();
    counters_.cells_before = separation_.tree().leaf_count();
    for (;;) {
      ++counters_.rounds;
      counters_.quadtree = {};
      counters_.insertion = {};
      std::optional<DomainMesh> made = round();
      if (made) return std::move(*made);
      separation_.refine(to_split_);
    }
  }

 private:
  std::optional<DomainMesh> round() {
    to_split_.clear();
    TreeMesh tree_mesh(domain_, separation_, counters_.quadtree);
    const CutQuads cut_quads(domain_, tree_mesh);
    const std::vector<SeparationFault> faults = separation_faults(domain_, tree_mesh, cut_quads);
    for (const SeparationFault& fault : faults) to_split_.push_back(fault.split);
    counters_.separation_splits += faults.size();
    if (!faults.empty()) return std::nullopt;
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
      } else {
        strips.push_back(std::get<Strip>(std::move(made)));
      }
    }
    if (!to_split_.empty()) return std::nullopt;
    counters_.kept_quads =
        static_cast<std::uint64_t>(std::count(kept.is_kept.begin(), kept.is_kept.end(), true));
    return assemble(domain_, tree_mesh, kept, strips);
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
};

}  // namespace

PolygonMeshResult mesh_polygon(const Polygon& polygon, const PolygonMeshOptions& options) {
  std::vector<Point> points;
  for (const Ring& ring : polygon.rings) points.insert(points.end(), ring.begin(), ring.end());
  const RootSquare root = place_root(points).root;
  try {
    PolygonMesh result;
    result.root = root;
    const Domain domain = whole_domain(polygon, root);
    DomainMesh made = DomainMesher(domain, options, result.counters).run();
    result.mesh = std::move(made.mesh);
    result.mesh.input_vertices = points.size();
    return result;
  } catch (const TreeBudgetExceeded& exceeded) {
    const Point where{nearest_double(exceeded.where.x, root.exponent),
                      nearest_double(exceeded.where.y, root.exponent)};
    return Refusal{exceeded.kind, where, exceeded.level,
                   fmt::format("budget near ({}, {}) level {}", where.x, where.y, exceeded.level)};
  }
}

}  // namespace quadbound
