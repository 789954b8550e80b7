// SPDX-License-Identifier: Apache-2.0
#include "algo/kept_quads.hpp"

#include <algorithm>
#include <utility>

namespace quadbound {
namespace {

/// The quad with the edge from b to a, where there is one in K.
bool kept_across(const TreeMesh& tree_mesh, const std::vector<bool>& is_kept, VertexId a,
                 VertexId b) {
  for (const QuadId quad : tree_mesh.quads_at(a)) {
    if (!is_kept[quad]) continue;
    const Quad& q = tree_mesh.mesh().quads[quad];
    for (unsigned k = 0; k < 4; ++k)
      if (q[k] == b && q[(k + 1) & 3U] == a) return true;
  }
  return false;
}

}  // namespace

KeptQuads keep_quads(const TreeMesh& tree_mesh, const CutQuads& cut_quads) {
  const std::vector<Quad>& quads = tree_mesh.mesh().quads;
  KeptQuads result;
  result.is_kept.resize(quads.size());
  const auto inside = [&](VertexId v) { return cut_quads.where(v) == Where::kInside; };
  for (QuadId quad = 0; quad < quads.size(); ++quad)
    result.is_kept[quad] =
        !cut_quads.is_cut(quad) && std::all_of(quads[quad].begin(), quads[quad].end(), inside);

  // Only quads at vertices of quads that are not kept can have an edge on the boundary of K.
  std::vector<bool> beside(tree_mesh.mesh().vertices.size());
  for (QuadId quad = 0; quad < quads.size(); ++quad)
    if (!result.is_kept[quad])
      for (const VertexId v : quads[quad]) beside[v] = true;
  std::vector<std::pair<VertexId, VertexId>> edges;
  for (QuadId quad = 0; quad < quads.size(); ++quad) {
    if (!result.is_kept[quad]) continue;
    for (unsigned k = 0; k < 4; ++k) {
      const VertexId a = quads[quad][k];
      const VertexId b = quads[quad][(k + 1) & 3U];
      if (beside[a] && beside[b] && !kept_across(tree_mesh, result.is_kept, a, b))
        edges.emplace_back(a, b);
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].first == edges[i - 1].first &&
        tree_mesh.window().is_core(tree_mesh.leaf_of(edges[i].first)))
      result.pinched.push_back(edges[i].first);
  if (!result.pinched.empty() || !tree_mesh.window().is_whole()) return result;

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
