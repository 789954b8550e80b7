// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 3.1: which quads of Q the edges of the domain cut, and which vertices lie inside.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algo/domain.hpp"
#include "algo/edge_cells.hpp"
#include "algo/tree_mesh.hpp"

namespace quadbound {

/// Edge `edge` runs through the inside of a quad, or touches it in one vertex.
struct Cut {
  QuadId quad;
  EdgeId edge;
};

/// Where it does: between the parameters `from` <= `to` of its line (0 at its start, 1 at its end).
struct Passage {
  double from;
  double to;
};

/// A vertex strictly on the left of the line of an edge that cuts one of its quads.
struct Above {
  VertexId vertex;
  EdgeId edge;
  friend auto operator<=>(const Above&, const Above&) = default;
};

/// A vertex of Q less than four lattice units above an edge, where no foot could be perpendicular
/// below it, counts as on the edge; on edges so long that rounding tells, three to five units.
///
/// Guarantees: 1. cuts are sorted by quad, then edge. 2. where(v) is exact but for that: kInside
/// strictly inside the domain, kBoundary on an edge or a vertex of it. 3. above(v) are the edges of
/// the paper's F(v), ascending, for vertices inside.
/// Complexity: linear in the leaves that edges meet and in the vertices, and sorting.
class CutQuads {
 public:
  /// Requires: edge_cells of the tree and window of tree_mesh.
  CutQuads(const Domain& domain, const TreeMesh& tree_mesh, const EdgeCells& edge_cells);

  [[nodiscard]] const std::vector<Cut>& cuts() const { return cuts_; }
  /// Requires: one of cuts(), and the vertices where they were. Not kept: few cuts are asked for
  /// it.
  [[nodiscard]] Passage passage(const Cut& cut) const { return *find_passage(cut); }
  /// Gives back the memory of cuts and is_cut, which must not be asked any more.
  void forget_cuts();
  [[nodiscard]] bool is_cut(QuadId quad) const { return is_cut_[quad]; }
  [[nodiscard]] Where where(VertexId vertex) const { return where_[vertex]; }
  [[nodiscard]] std::span<const Above> above(VertexId vertex) const;
  /// All of it, sorted by vertex.
  [[nodiscard]] const std::vector<Above>& all_above() const { return above_; }

 private:
  void mark_leaves(const EdgeCells& edge_cells);
  void look_at_met_leaves(const EdgeCells& edge_cells);
  void judge_quads_at(std::span<const VertexId> vertices, std::span<const EdgeId> edges,
                      std::vector<EdgeId>& last_edges);
  /// A vertex of Q from the start of an edge, and its cross product with the direction of the edge:
  /// the sign is right, and 0 on the line or so near to it that this counts as on it.
  struct Sight {
    Vector arm;
    double rise;
  };
  [[nodiscard]] Sight sight(EdgeId edge, VertexId vertex) const;
  [[nodiscard]] double exact_rise(EdgeId edge, VertexId vertex, double rounded) const;
  [[nodiscard]] bool is_over(EdgeId edge, Vector arm) const;
  [[nodiscard]] std::optional<Passage> find_passage(const Cut& cut) const;
  void sort_cuts();
  void collect_above();

  const Domain& domain_;
  const TreeMesh& tree_mesh_;
  std::vector<Cut> cuts_;
  std::vector<bool> is_cut_;
  std::vector<Where> where_;
  std::vector<Above> above_;
};

}  // namespace quadbound
