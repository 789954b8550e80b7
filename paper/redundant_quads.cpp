// SPDX-License-Identifier: Apache-2.0
#include "paper/redundant_quads.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <variant>
#include <vector>

#include "algo/construction.hpp"
#include "algo/mesh_polygon.hpp"
#include "paper/experiment.hpp"
#include "verify/verify.hpp"

namespace quadbound {
namespace {

class Thinner {
 public:
  Thinner(const Mesh& mesh, const RootSquare& root)
      : mesh_(mesh), root_(root), edges_(mesh.vertices.size()), merged_(mesh.vertices.size()) {
    std::vector<bool> beside_strip(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
      for (const VertexId v : mesh.quads[i]) {
        ++edges_[v];  // as many as quads, inside
        if (mesh.construction[i] >= kConstructionCount) beside_strip[v] = true;
      }
    }
    for (VertexId v = 0; v < merged_.size(); ++v) {
      merged_[v] = v;
      if (!mesh.vertices.on_lattice(v)) continue;
      const LatticePoint p = mesh.vertices.lattice(v);
      places_.emplace_back(p.x, p.y);
      if (beside_strip[v]) edges_[v] += kMany;
    }
    std::sort(places_.begin(), places_.end());
  }

  ThinnedMesh run() {
    ThinnedMesh result;
    std::vector<bool> is_removed(mesh_.quads.size());
    for (std::size_t i = 0; i < mesh_.quads.size(); ++i) {
      if (mesh_.construction[i] != static_cast<std::uint8_t>(Construction::kMiddle)) continue;
      const Quad& q = mesh_.quads[i];
      is_removed[i] = shrink(q[0], q[1], q[2], q[3]) || shrink(q[1], q[2], q[3], q[0]);
      result.removed += is_removed[i] ? 1U : 0U;
    }
    result.mesh = rebuilt(is_removed);
    return result;
  }

 private:
  static constexpr std::uint32_t kMany = 1U << 16U;

  /// a and c become one.
  bool shrink(VertexId a, VertexId b, VertexId c, VertexId d) {
    if (edges_[a] != 3 || edges_[c] != 3) return false;
    if (edges_[b] % kMany < 4 || edges_[d] % kMany < 4) return false;
    if (!are_inner_extras(a, c)) return false;
    merged_[c] = a;
    edges_[a] = 4;
    --edges_[b];
    --edges_[d];
    return true;
  }

  /// Of the two leaves of a template T2b: their centres are as far beyond them as the middle of the
  /// node, and that middle is an odd number of the leaves' sides from the root's corner.
  [[nodiscard]] bool are_inner_extras(VertexId a, VertexId c) const {
    if (!mesh_.vertices.on_lattice(a) || !mesh_.vertices.on_lattice(c)) return false;
    const LatticePoint p = mesh_.vertices.lattice(a);
    const LatticePoint q = mesh_.vertices.lattice(c);
    const std::int64_t dx = (q.x - p.x) / 2;
    const std::int64_t dy = (q.y - p.y) / 2;
    if (dx == 0 || std::abs(dx) != std::abs(dy)) return false;
    if (!is_vertex({p.x - dx, p.y - dy}) || !is_vertex({q.x + dx, q.y + dy})) return false;
    const std::int64_t side = 4 * std::abs(dx);
    const auto is_odd = [side](std::int64_t distance) {
      return distance % side == 0 && distance / side % 2 != 0;
    };
    return is_odd(p.x + dx - root_.corner.x) && is_odd(p.y + dy - root_.corner.y);
  }

  [[nodiscard]] bool is_vertex(LatticePoint p) const {
    return std::binary_search(places_.begin(), places_.end(), std::pair{p.x, p.y});
  }

  [[nodiscard]] Mesh rebuilt(const std::vector<bool>& is_removed) const {
    Mesh made = mesh_;
    made.quads.clear();
    made.construction.clear();
    made.level.clear();
    made.vertices = Vertices(mesh_.vertices.exponent());
    const std::vector<VertexId> number = numbered(made.vertices);
    for (std::size_t i = 0; i < mesh_.quads.size(); ++i) {
      if (is_removed[i]) continue;
      Quad quad = mesh_.quads[i];
      for (VertexId& v : quad) v = number[merged_[v]];
      made.quads.push_back(quad);
      made.construction.push_back(mesh_.construction[i]);
      if (!mesh_.level.empty()) made.level.push_back(mesh_.level[i]);
    }
    return made;
  }

  /// Adds all vertices but those that became another; their new numbers.
  std::vector<VertexId> numbered(Vertices& vertices) const {
    std::vector<VertexId> number(merged_.size(), kNoVertex);
    for (VertexId v = 0; v < merged_.size(); ++v)
      if (merged_[v] == v) number[v] = vertices.add_exact(mesh_.vertices.exact(v));
    for (VertexId v = 0; v < merged_.size(); ++v) {
      if (merged_[v] == v) continue;
      const LatticePoint p = mesh_.vertices.lattice(merged_[v]);
      const LatticePoint q = mesh_.vertices.lattice(v);
      vertices.move_to(number[merged_[v]], {(p.x + q.x) / 2, (p.y + q.y) / 2});
    }
    return number;
  }

  const Mesh& mesh_;
  RootSquare root_;
  std::vector<std::uint32_t> edges_;  ///< more than kMany beside strips
  std::vector<VertexId> merged_;      ///< the vertex itself where it stays
  std::vector<std::pair<std::int64_t, std::int64_t>> places_;
};

}  // namespace

ThinnedMesh without_redundant_quads(const Mesh& mesh, const RootSquare& root) {
  return Thinner(mesh, root).run();
}

ThinnedFigure thinned_figure(const Polygon& polygon) {
  const auto made = std::get<PolygonMesh>(mesh_polygon(polygon));
  const ThinnedMesh thinned = without_redundant_quads(made.mesh, made.root);
  return {thinned.removed, mesh_shape(thinned.mesh),
          broken_claims(verify_polygon(polygon, thinned.mesh))};
}

}  // namespace quadbound
