// SPDX-License-Identifier: Apache-2.0
#pragma once
// Vertices off the lattice once more as numbers that are quick to calculate with. Meshes of
// polygons have many: a boundary edge meets the lattice's lines at fractions.

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "model/mesh.hpp"
#include "verify/chunks.hpp"

namespace quadbound::judge {

inline bool in_range(LatticePoint p) {
  constexpr auto kBound = static_cast<std::uint64_t>(kMaxLatticeCoordinate);
  return static_cast<std::uint64_t>(p.x) + kBound <= 2 * kBound &&
         static_cast<std::uint64_t>(p.y) + kBound <= 2 * kBound;
}

/// A coordinate in fixed point: from value to less than value + 1, in units of 2^-64 of the
/// lattice's. |value| < 2^124 + 2^64, so that differences fit into 126 bits.
struct Fixed {
  static constexpr int kBits = 64;
  Int128 value = 0;
  bool is_exact = true;  ///< the coordinate is value
};

inline Fixed to_fixed(std::int64_t coordinate) {
  return {static_cast<Int128>(coordinate) << Fixed::kBits, true};
}

struct FixedPoint {
  Fixed x;
  Fixed y;
};

/// The sign of b - a; nullopt where it hides in what was cut off.
inline std::optional<int> sign_of_difference(const Fixed& a, const Fixed& b) {
  if (a.value != b.value) return a.value < b.value ? 1 : -1;  // b < b.value + 1 <= a.value <= a
  if (a.is_exact) return b.is_exact ? 0 : 1;
  if (b.is_exact) return -1;
  return std::nullopt;
}

/// Guarantees: 1. find and fractions are those of the exact position. 2. find is nullptr where the
/// vertex is on the lattice, within its bounds or beyond, and where a coordinate is beyond 2^60
/// units and a fraction.
/// Complexity: one division per coordinate, of long integers where the mesh keeps rationals; 116
/// bytes per vertex off the lattice and 4 per vertex; nothing where all are on the lattice.
class OffLattice {
 public:
  OffLattice(const Vertices& vertices, const Threads& threads);

  [[nodiscard]] const FixedPoint* find(VertexId v) const {
    if (slots_.empty() || slots_[v] == kNone) return nullptr;
    return &points_[slots_[v]];
  }

  /// With denominators below 2^62, and 0 where there is no such denominator.
  /// Requires: find(v) != nullptr.
  [[nodiscard]] const FractionPoint& fractions(VertexId v) const { return fractions_[slots_[v]]; }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::uint32_t> slots_;  ///< by vertex
  std::vector<FixedPoint> points_;
  std::vector<FractionPoint> fractions_;
};

}  // namespace quadbound::judge
