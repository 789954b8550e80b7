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
/// allow; the others are rationals in a side table, or fractions of small numbers in another:
/// points where edges between lattice points meet lines of the lattice.
///
/// Guarantees: 1. exact(v) is the value that was put in, whichever way it is kept. 2. A vertex
/// added with add_exact or add_double is on the lattice exactly when its coordinates are integer
/// multiples of 2^exponent() within kMaxLatticeCoordinate.
/// Complexity: 16 bytes for a vertex on the lattice, 64 for one kept as fractions, 80 and four long
/// integers for one kept as rationals.
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
  /// Requires: not on the lattice (guarantee 2); remainders below their denominators, which are
  /// below 2^62; floors within kMaxLatticeCoordinate.
  VertexId add_fraction(const FractionPoint& point);

  /// Requires: vertex < size().
  void move_to(VertexId vertex, LatticePoint point) { entries_[vertex] = point; }
  void move_to_exact(VertexId vertex, const RationalPoint& point);

  [[nodiscard]] bool on_lattice(VertexId vertex) const { return entries_[vertex].x != kElsewhere; }
  /// Requires: on_lattice(vertex).
  [[nodiscard]] LatticePoint lattice(VertexId vertex) const { return entries_[vertex]; }
  /// nullptr where it is not kept as fractions.
  [[nodiscard]] const FractionPoint* fraction(VertexId vertex) const {
    const LatticePoint entry = entries_[vertex];
    return entry.x == kElsewhere && entry.y < 0 ? &fractions_[index_of(entry)] : nullptr;
  }
  [[nodiscard]] RationalPoint exact(VertexId vertex) const;
  /// Each coordinate rounded to the nearest double, ties to even.
  [[nodiscard]] Point rounded(VertexId vertex) const;

  /// Number of vertices that are not on the lattice.
  [[nodiscard]] std::size_t off_lattice_count() const;

 private:
  static constexpr std::int64_t kElsewhere = std::numeric_limits<std::int64_t>::min();
  [[nodiscard]] LatticePoint encode(const RationalPoint& point);
  /// Into the table of an entry that is elsewhere.
  static std::size_t index_of(LatticePoint entry) {
    return static_cast<std::size_t>(entry.y < 0 ? -1 - entry.y : entry.y);
  }

  int exponent_;
  /// For the others {kElsewhere, index into rationals_, or -1 - index into fractions_}.
  std::vector<LatticePoint> entries_;
  std::vector<RationalPoint> rationals_;
  std::vector<FractionPoint> fractions_;
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
