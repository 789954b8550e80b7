// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 3.1: which quads of Q the edges of the domain cut, and which vertices lie inside.

#include <cstdint>
#include <span>
#include <vector>

#include "algo/domain.hpp"
#include "algo/side_sets.hpp"
#include "algo/tree_mesh.hpp"

namespace quadbound {

/// Edge `edge` runs through the inside of a quad, or touches it in one vertex, between the
/// parameters `from` <= `to` of its line (0 at its start, 1 at its end).
struct Cut {
  QuadId quad;
  EdgeId edge;
  double from;
  double to;
};

enum class Where : std::uint8_t { kUnknown, kOutside, kInside, kBoundary };

/// A vertex strictly on the left of the line of an edge that cuts one of its quads.
struct Above {
  VertexId vertex;
  EdgeId edge;
  friend auto operator<=>(const Above&, const Above&) = default;
};

/// Whether the centres of leaves lie inside, as far as that was found out, by 4 * block + quadrant.
using KnownCentres = std::vector<Where>;

/// Guarantees: 1. cuts are sorted by quad, then edge. 2. where(v) is exact: kInside strictly inside
/// the domain, kBoundary on an edge or a vertex of it. 3. above(v) are the edges of the paper's
/// F(v), ascending, for vertices inside.
/// Complexity: linear in the leaves that edges meet and in the quads; n for each part of the mesh
/// that edges through mesh vertices, or holes, cut off from the rest and in which nothing is known.
class CutQuads {
 public:
  /// `known` saves work in a window, and is brought up to date.
  CutQuads(const Domain& domain, const TreeMesh& tree_mesh, KnownCentres& known);

  [[nodiscard]] const std::vector<Cut>& cuts() const { return cuts_; }
  [[nodiscard]] bool is_cut(QuadId quad) const { return is_cut_[quad]; }
  [[nodiscard]] Where where(VertexId vertex) const { return where_[vertex]; }
  [[nodiscard]] std::span<const Above> above(VertexId vertex) const;
  /// All of it, sorted by vertex.
  [[nodiscard]] const std::vector<Above>& all_above() const { return above_; }

 private:
  void find_candidates();
  void add_candidates(Cell leaf, std::span<const EdgeId> edges);
  void judge(QuadId quad, EdgeId edge);
  void find_sides(const KnownCentres& known);
  void settle_known(const KnownCentres& known, SideSets& sets, std::vector<Where>& of_set) const;
  void update(KnownCentres& known) const;
  [[nodiscard]] bool is_inside(LatticePoint point) const;
  void collect_above();

  const Domain& domain_;
  const TreeMesh& tree_mesh_;
  std::vector<Cut> cuts_;
  std::vector<bool> is_cut_;
  std::vector<Where> where_;
  std::vector<std::uint8_t> odd_sides_;  ///< bit k: an odd number of edges crosses side k of a quad
  std::vector<Above> above_;

  // scratch
  std::vector<EdgeId> last_edge_;          ///< by quad: the edge it was last paired with
  std::vector<std::uint64_t> candidates_;  ///< quad << 32 | edge
  std::vector<VertexId> vertices_;
};

}  // namespace quadbound
