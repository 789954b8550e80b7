// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which corners meet at which vertex, and which edges are paired. All of it is decided vertex by
// vertex: the edge v -> w is paired exactly when w precedes v in some corner at v.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "model/mesh.hpp"
#include "verify/chunks.hpp"

namespace quadbound::judge {

/// 4 * quad + corner; also stands for the edge that leaves the corner.
using CornerIndex = std::uint32_t;

struct DirectedEdge {
  VertexId from;
  VertexId to;
  CornerIndex corner;
};

/// The corners at each vertex, in ascending order.
/// Complexity: 16 bytes per quad and 4 per vertex.
class CornersByVertex {
 public:
  /// Requires: well-formed quads, fewer than 2^30.
  CornersByVertex(const std::vector<Quad>& quads, std::size_t vertices, const Threads& threads);

  [[nodiscard]] std::size_t vertices() const { return starts_.size() - 1; }
  [[nodiscard]] std::span<const CornerIndex> at(VertexId v) const {
    return {corners_.data() + starts_[v], starts_[v + 1] - starts_[v]};
  }
  [[nodiscard]] bool is_used(VertexId v) const { return starts_[v] != starts_[v + 1]; }
  [[nodiscard]] VertexId next(CornerIndex c) const { return quads_[c / 4][(c + 1) % 4]; }
  [[nodiscard]] VertexId previous(CornerIndex c) const { return quads_[c / 4][(c + 3) % 4]; }

 private:
  const std::vector<Quad>& quads_;
  std::vector<std::uint32_t> starts_;
  std::vector<CornerIndex> corners_;
};

struct Links {
  std::uint64_t used_vertices = 0;
  std::uint64_t directed_edges = 0;    ///< different ones
  std::vector<DirectedEdge> unpaired;  ///< different ones, ascending by from, then by to

  /// Directed edges that belong to more quads than their reverses do: each as often as that is so,
  /// less one where it is unpaired and listed there. With the unpaired edges they are what is left
  /// of all edges of quads where opposite ones cancel each other. Empty where no edge is doubled.
  std::vector<DirectedEdge> surplus;

  struct DoubledEdge {
    DirectedEdge edge;
    CornerIndex other;
  };
  std::optional<DoubledEdge> doubled;  ///< the first by from, then by to

  /// The first vertex without unpaired edges whose corners make another number of turns than one.
  /// Means nothing where quads are not strictly convex or edges are doubled.
  struct Winding {
    VertexId vertex;
    unsigned turns;
  };
  std::optional<Winding> winding;
  /// The first vertex with one fan of corners between two unpaired edges and other corners besides.
  std::optional<VertexId> second_fan;
};

/// Requires: passes as survey_quads fills them.
Links link_corners(const CornersByVertex& corners, const std::vector<std::uint8_t>& passes,
                   const Threads& threads);

}  // namespace quadbound::judge
