// SPDX-License-Identifier: Apache-2.0
#include "algo/kept_quads.hpp"

#include <algorithm>
#include <utility>

namespace quadbound {
namespace {

/// Whether one of the quads that are not kept has the edge from a to b.
bool dropped_along(const TreeMesh& tree_mesh, const std::vector<bool>& is_kept, VertexId a,
                   VertexId b) {
  for (const QuadId quad : tree_mesh.quads_at(a)) {
    if (is_kept[quad]) continue;
    const Quad& q = tree_mesh.mesh().quads[quad];
    for (unsigned k = 0; k < 4; ++k)
      if (q[k] == a && q[(k + 1) & 3U] == b) return true;
  }
  return false;
}

/// Edges with K on their left and a quad that is not kept on their right, ascending. They are
/// looked for among the latter, of which few have two vertices inside: each edge of Q between such
/// vertices has a quad on either side.
std::vector<std::pair<VertexId, VertexId>> boundary_of(const TreeMesh& tree_mesh,
                                                       const CutQuads& cut_quads,
                                                       const std::vector<bool>& is_kept) {
  std::vector<std::pair<VertexId, VertexId>> edges;
  for (QuadId quad = 0; quad < is_kept.size(); ++quad) {
    if (is_kept[quad]) continue;
    const Quad& q = tree_mesh.mesh().quads[quad];
    for (unsigned k = 0; k < 4; ++k) {
      const VertexId b = q[k];
      const VertexId a = q[(k + 1) & 3U];
      if (cut_quads.where(a) == Where::kInside && cut_quads.where(b) == Where::kInside &&
          !dropped_along(tree_mesh, is_kept, a, b))
        edges.emplace_back(a, b);
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<bool> kept_of(const TreeMesh& tree_mesh, const CutQuads& cut_quads) {
  const std::vector<Quad>& quads = tree_mesh.mesh().quads;
  std::vector<bool> is_kept(quads.size());
  const auto inside = [&](VertexId v) { return cut_quads.where(v) == Where::kInside; };
  for (QuadId quad = 0; quad < quads.size(); ++quad)
    is_kept[quad] =
        !cut_quads.is_cut(quad) && std::all_of(quads[quad].begin(), quads[quad].end(), inside);
  return is_kept;
}

/// Where two edges of the boundary begin.
std::vector<VertexId> pinched_of(const TreeMesh& tree_mesh,
                                 const std::vector<std::pair<VertexId, VertexId>>& boundary) {
  std::vector<VertexId> pinched;
  for (std::size_t i = 1; i < boundary.size(); ++i)
    if (boundary[i].first == boundary[i - 1].first &&
        tree_mesh.window().is_core(tree_mesh.leaf_of(boundary[i].first)))
      pinched.push_back(boundary[i].first);
  return pinched;
}

}  // namespace

std::vector<VertexId> pinched_vertices(const TreeMesh& tree_mesh, const CutQuads& cut_quads) {
  return pinched_of(tree_mesh, boundary_of(tree_mesh, cut_quads, kept_of(tree_mesh, cut_quads)));
}

KeptQuads keep_quads(const TreeMesh& tree_mesh, const CutQuads& cut_quads) {
  KeptQuads result;
  result.is_kept = kept_of(tree_mesh, cut_quads);
  const auto edges = boundary_of(tree_mesh, cut_quads, result.is_kept);
  result.pinched = pinched_of(tree_mesh, edges);
  if (!result.pinched.empty()) return result;

  std::vector<bool> done(edges.size());
  for (std::size_t first = 0; first < edges.size(); ++first) {
    if (done[first]) continue;
    std::vector<VertexId> alpha;
    for (std::size_t at = first; !done[at];) {
      done[at] = true;
      alpha.push_back(edges[at].first);
      at = static_cast<std::size_t>(
          std::lower_bound(edges.begin(), edges.end(), std::pair{edges[at].second, VertexId{0}}) -
          edges.begin());
    }
    result.alphas.push_back(std::move(alpha));
  }
  return result;
}

}  // namespace quadbound
