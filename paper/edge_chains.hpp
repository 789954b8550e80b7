// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 3.1: the quadrangulation chain alpha and the quadtree chain beta of an edge, by the
// paper's own rules.
//
// A point is above the line if it is strictly on its left. A quad is cut by the line if some of its
// vertices are above and some are not, and so is a cell by its corners: it meets the line and has a
// part above it.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "model/exact.hpp"
#include "paper/cut_tree.hpp"

namespace quadbound {

/// Coordinates along and above a line, times the length of its direction. Below 2^38 for points of
/// the root, so that cross and dot products stay far inside 128 bits.
struct Framed {
  Int128 t = 0;
  Int128 h = 0;
  friend bool operator==(const Framed&, const Framed&) = default;
};
inline Framed operator-(const Framed& a, const Framed& b) { return {a.t - b.t, a.h - b.h}; }
inline Framed operator+(const Framed& a, const Framed& b) { return {a.t + b.t, a.h + b.h}; }
inline Framed operator*(Int128 s, const Framed& a) { return {s * a.t, s * a.h}; }
inline Int128 cross(const Framed& a, const Framed& b) { return a.t * b.h - a.h * b.t; }
inline Int128 dot(const Framed& a, const Framed& b) { return a.t * b.t + a.h * b.h; }

inline Framed framed(const CutLine& line, LatticePoint point) {
  const std::int64_t x = point.x - line.point.x;
  const std::int64_t y = point.y - line.point.y;
  return {Int128{x} * line.dx + Int128{y} * line.dy, Int128{y} * line.dx - Int128{x} * line.dy};
}
inline bool is_above(const CutLine& line, LatticePoint point) { return framed(line, point).h > 0; }

/// Guarantees: 1. alpha is E_1 E_2 ... E_k: the vertices in order, spikes included. Where it is not
/// connected (broken) the next part simply follows. 2. beta is what rules 1 to 3 name and lies
/// above the line; what rule 2 names and lies not above is in not_above. 3. beta is sorted as the
/// paper says, by x and then y.
struct EdgeChains {
  std::vector<VertexId> alpha;
  std::vector<std::pair<VertexId, VertexId>> broken;  ///< end of a part and start of the next
  std::size_t most_edges = 0;                         ///< of an E_i
  std::vector<Cell> beta;
  std::vector<Cell> crossed;                    ///< C
  std::vector<std::pair<Cell, Cell>> north_of;  ///< rule 2: c and each cell of N(c)
};

EdgeChains edge_chains(const CutTree& tree, const CutLine& line);

/// alpha_i: the shortest part of alpha from an occurrence of one vertex to a later one of another.
std::optional<std::vector<VertexId>> part_of(const std::vector<VertexId>& alpha, VertexId from,
                                             VertexId to);

/// "We choose instead a chain of edges in Q lying above c_i c_(i+1)", read as: the upper boundary
/// of the quads that the segment cuts. nullopt where that is no chain from one end to the other.
std::optional<std::vector<VertexId>> chain_above(const CutTree& tree, VertexId from, VertexId to);

/// Whether no vertex of the tree's cells and of Q is on the line.
bool in_general_position(const CutTree& tree, const CutLine& line);

}  // namespace quadbound
