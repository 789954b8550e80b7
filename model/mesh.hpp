// SPDX-License-Identifier: Apache-2.0
#pragma once
// A quadrilateral mesh with exact coordinates, ours or anyone's.

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "model/exact.hpp"

namespace quadbound {

using VertexId = std::uint32_t;
inline constexpr VertexId kNoVertex = std::numeric_limits<VertexId>::max();

/// The vertices of a mesh. A vertex is on the lattice (two integers) wherever its coordinates
/// allow; the few others are rationals in a side table.
///
/// Guarantees: 1. exact(v) is the value that was put in, whichever way it is kept. 2. A vertex
/// added with add_exact or add_double is on the lattice exactly when its coordinates are integer
/// multiples of 2^exponent() within kMaxLatticeCoordinate.
/// Complexity: 16 bytes for a vertex on the lattice.
class Vertices {
 public:
  explicit Vertices(int exponent = 0) : exponent_(exponent) {}

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] int exponent() const { return exponent_; }
  void reserve(std::size_t count) { entries_.reserve(count); }

  VertexId add(LatticePoint point) {
    entries_.push_back(point);
    return static_cast<VertexId>(entries_.size() - 1);
  }
  VertexId add_exact(const RationalPoint& point);
  VertexId add_double(const Point& point);
  /// Requires: not on the lattice (guarantee 2).
  VertexId add_off_lattice(RationalPoint point);

  /// Requires: vertex < size().
  void move_to(VertexId vertex, LatticePoint point) { entries_[vertex] = point; }
  void move_to_exact(VertexId vertex, const RationalPoint& point);

  [[nodiscard]] bool on_lattice(VertexId vertex) const { return entries_[vertex].x != kElsewhere; }
  /// Requires: on_lattice(vertex).
  [[nodiscard]] LatticePoint lattice(VertexId vertex) const { return entries_[vertex]; }
  [[nodiscard]] RationalPoint exact(VertexId vertex) const;
  /// Each coordinate rounded to the nearest double, ties to even.
  [[nodiscard]] Point rounded(VertexId vertex) const;

  /// Number of vertices that are kept as rationals.
  [[nodiscard]] std::size_t off_lattice_count() const;

 private:
  static constexpr std::int64_t kElsewhere = std::numeric_limits<std::int64_t>::min();
  [[nodiscard]] LatticePoint encode(const RationalPoint& point);

  int exponent_;
  std::vector<LatticePoint> entries_;  ///< {kElsewhere, index into off_lattice_} for the others
  std::vector<RationalPoint> off_lattice_;
};

/// The smallest exponent of a lattice that holds as many of these doubles as one lattice can: the
/// exponent of the finest of them, or, where that is out of reach of the largest, the finest that
/// the largest allows.
int common_exponent(const std::vector<Point>& points);

using Quad = std::array<VertexId, 4>;

struct Mesh {
  Vertices vertices;
  std::vector<Quad> quads;  ///< counter-clockwise where the mesh is valid
  /// Faces with another number of sides; only foreign files have them.
  std::vector<std::vector<VertexId>> other_faces;

  std::uint64_t cells = 0;           ///< N, the leaves of the quadtree; 0 where unknown
  std::uint64_t input_vertices = 0;  ///< n, the number of input points or polygon vertices

  /// Names of constructions, and one index into them per quad; both empty where unknown.
  std::vector<std::string> construction_names;
  std::vector<std::uint8_t> construction;
  /// Level of the smallest cell that a quad has a vertex in, per quad; empty where unknown.
  std::vector<std::uint8_t> level;
};

}  // namespace quadbound
