// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 3.1: the quadrangulation chain alpha of each edge, spikes included.
//
// Used only where a polygon is meshed by the paper's own cases (EdgeInsertion::kLemmas); else alpha
// is the boundary of the kept quads (algo/kept_quads.hpp).

#include <optional>
#include <utility>
#include <vector>

#include "algo/cut_quads.hpp"
#include "algo/domain.hpp"
#include "algo/tree_mesh.hpp"

namespace quadbound {

/// alpha = E_1 E_2 ... E_k of one edge: of each quad that it cuts, in their order along it, the
/// edges of Q with both ends strictly above it.
class QuadrangulationChain {
 public:
  /// Requires: the cuts of one edge as cuts_by_edge gives them.
  QuadrangulationChain(const Domain& domain, const TreeMesh& tree_mesh,
                       const std::vector<Cut>& in_order);

  /// alpha_i: the shortest part from one vertex to another, less what it runs along twice; nullopt
  /// where there is none.
  ///
  /// Guarantees: 1. it leads from one vertex to the other along edges of quads that the edge cuts.
  /// 2. all its vertices are strictly above the edge. 3. it nowhere turns back where it came from.
  [[nodiscard]] std::optional<std::vector<VertexId>> part(VertexId from, VertexId to) const;

 private:
  std::vector<VertexId> vertices_;                        ///< kNoVertex where it is not connected
  std::vector<std::pair<VertexId, std::size_t>> places_;  ///< sorted
};

/// By edge, in the order along it.
/// Guarantees: 1. each cut is there once, with its edge. 2. they come by where they begin, and of
/// those that begin together by where they end.
std::vector<std::vector<Cut>> cuts_by_edge(const Domain& domain, const CutQuads& cut_quads);

/// "We choose instead a chain of edges in Q lying above c_i c_(i+1)", read as: the upper boundary
/// of the quads that the segment cuts. nullopt where that is no chain from one end to the other.
///
/// Guarantees: 1. it leads from one end to the other along edges of Q. 2. no vertex of it is below
/// the segment, exactly. 3. it nowhere turns back where it came from.
std::optional<std::vector<VertexId>> chain_above(const TreeMesh& tree_mesh, VertexId from,
                                                 VertexId to);

/// A chain less what it runs along there and back.
std::vector<VertexId> without_repeated(const std::vector<VertexId>& chain);

/// Whether a vertex of a chain is below the segment between its ends, exactly.
bool runs_under(const TreeMesh& tree_mesh, const std::vector<VertexId>& chain);

}  // namespace quadbound
