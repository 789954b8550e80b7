// SPDX-License-Identifier: Apache-2.0
#pragma once
// The polygon that Section 3 meshes: the input P, or P less the kites at its acute vertices (the
// paper's B, Section 4), on the lattice of the root square.

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "algo/fine_point.hpp"
#include "algo/point_separation.hpp"
#include "algo/quadtree.hpp"
#include "model/mesh.hpp"
#include "model/polygon.hpp"

namespace quadbound {

/// A vertex of the domain, and the edge that starts there.
using EdgeId = std::uint32_t;

/// Section 4: the kite a-p-v-q at an acute vertex a. Its sides q-v and v-p are edges of the domain.
struct Kite {
  RationalPoint a;  ///< the acute vertex of P, as in the input
  EdgeId p = 0;     ///< on the edge of P that leaves a
  EdgeId v = 0;     ///< inside P
  EdgeId q = 0;     ///< on the edge of P that ends in a
};

/// Guarantees: 1. vertices.exact(i) is the place of vertex i, exactly. 2. the interior is on the
/// left of every edge. 3. side, holds, turn, moved_off, moved_turn, foot are exact.
class Domain {
 public:
  Domain(const RootSquare& root, const Polygon& polygon);
  /// Vertices in the coordinates of the input; rings as in Polygon.
  Domain(const RootSquare& root, const std::vector<std::vector<RationalPoint>>& rings);

  [[nodiscard]] EdgeId size() const { return static_cast<EdgeId>(fine_.size()); }
  [[nodiscard]] std::size_t ring_count() const { return ring_count_; }
  [[nodiscard]] const RootSquare& root() const { return root_; }
  [[nodiscard]] const Vertices& vertices() const { return vertices_; }

  [[nodiscard]] std::uint32_t ring(EdgeId i) const { return ring_[i]; }
  [[nodiscard]] EdgeId next(EdgeId i) const { return next_[i]; }
  [[nodiscard]] EdgeId previous(EdgeId i) const { return previous_[i]; }
  [[nodiscard]] const FinePoint& at(EdgeId i) const { return fine_[i]; }
  /// Rounded down to the lattice, and whether that cut something off.
  [[nodiscard]] LatticePoint floor(EdgeId i) const { return fine_[i].floor; }
  [[nodiscard]] bool rounded(EdgeId i) const { return !vertices_.on_lattice(i); }
  /// From the start of an edge to its end.
  [[nodiscard]] Vector direction(EdgeId e) const { return fine_[next_[e]] - fine_[e]; }

  /// Whether the sign of the cross product of an edge's direction and a vector from its start is
  /// right: that of side() for the point where the vector ends.
  static bool is_certain(double cross_product, Vector direction, Vector to) {
    // Difference and product errors of cross() on FinePoints stay below 2^-48 of the products.
    constexpr double kFilter = 0x1p-46;
    return std::abs(cross_product) >
           kFilter * (std::abs(direction.x * to.y) + std::abs(direction.y * to.x)) +
               0x1p-40 * (std::abs(direction.x) + std::abs(direction.y));
  }
  /// +1 where a point is on the left of the line of an edge (inside), 0 on it, -1 on the right.
  [[nodiscard]] int side(EdgeId e, LatticePoint point) const;
  /// The same for a vertex of the domain.
  [[nodiscard]] int side(EdgeId e, EdgeId vertex) const;
  /// Whether a point on the line of an edge is on the edge, its ends included.
  [[nodiscard]] bool holds(EdgeId e, LatticePoint point) const;
  /// +1 where a vertex is on the left of the line between two points, 0 on it, -1 on the right.
  [[nodiscard]] int turn(LatticePoint from, LatticePoint to, EdgeId vertex) const;
  /// Where points are moved by (e, e^2), e > 0 being smaller than any distance that is not 0, none
  /// is on a line any more. The side of an edge to which those on its line come.
  [[nodiscard]] int moved_off(EdgeId e) const;
  /// turn() for two such points, which differ: never 0.
  [[nodiscard]] int moved_turn(LatticePoint from, LatticePoint to, EdgeId vertex) const;
  /// Height of a lattice point above the line of an edge, in lattice units, with an error of a few
  /// units of the last place of the height, or of a lattice unit where that is more.
  [[nodiscard]] double height(EdgeId e, LatticePoint point) const;

  /// The interior angle at a vertex is below 90 degrees, exactly.
  [[nodiscard]] bool is_acute(EdgeId vertex) const;

  // --- Steiner points on an edge, numbered by the coordinate that changes faster along it

  /// Whether edge e runs more in x than in y: then its Steiner points have an integer x.
  [[nodiscard]] bool runs_in_x(EdgeId e) const { return runs_in_x_[e]; }
  /// Number of the Steiner point nearest to a lattice point's perpendicular foot moved along the
  /// edge by `offset` lattice units.
  [[nodiscard]] std::int64_t foot(EdgeId e, LatticePoint point, double offset = 0) const;
  /// Whether a number is strictly between the ends of its edge.
  [[nodiscard]] bool on_edge(EdgeId e, std::int64_t foot) const;
  /// The same, increasing along the edge.
  [[nodiscard]] std::int64_t along(EdgeId e, std::int64_t foot) const {
    return backwards_[e] ? -foot : foot;
  }
  /// Requires: on_edge(e, foot). With an error of a few units of the last place of a lattice unit.
  [[nodiscard]] FinePoint foot_point(EdgeId e, std::int64_t foot) const;
  /// In the coordinates of the input.
  [[nodiscard]] RationalPoint foot_exact(EdgeId e, std::int64_t foot) const;
  /// Appends it to vertices, which lie on the lattice of the domain.
  VertexId add_foot(Vertices& vertices, EdgeId e, std::int64_t foot) const;

  std::vector<Kite> kites;  ///< ascending by p
  /// Whether a vertex is the p or q of a kite. Complexity: logarithmic in the kites.
  [[nodiscard]] bool is_kite_foot(EdgeId vertex) const;

 private:
  template <class Rings>
  void add_rings(const Rings& rings);
  [[nodiscard]] FinePoint fine_point(EdgeId vertex) const;
  [[nodiscard]] RationalPoint in_units(EdgeId vertex) const;
  [[nodiscard]] int side_exact(EdgeId e, const RationalPoint& point) const;
  [[nodiscard]] bool on_lattice_edge(EdgeId e) const { return !rounded(e) && !rounded(next_[e]); }

  RootSquare root_;
  Vertices vertices_;
  std::size_t ring_count_;
  std::vector<FinePoint> fine_;
  std::vector<std::uint32_t> ring_;
  std::vector<EdgeId> next_;
  std::vector<EdgeId> previous_;
  std::vector<bool> runs_in_x_;
  std::vector<bool> backwards_;  ///< the number of the Steiner points falls along the edge
};

/// The vertices of a domain as Separation takes them.
PlacedPoints placed_vertices(const Domain& domain);

}  // namespace quadbound
