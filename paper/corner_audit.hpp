// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lemma 12, decided on one corner at a time: the ends u and w of the chains beta of its two edges,
// the chain E between them, and the polygon P_v meshed by the paper's three cases. All in integers.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "model/exact.hpp"

namespace quadbound {

/// A corner v in the middle of a grid of equal cells. The interior is between `out`, the direction
/// of f, and `back`, towards the start of e, counter-clockwise.
/// Requires: v in [0, kSide) x [0, kSide); components up to 2^16; an interior angle of at least 90
/// and below 360 degrees.
struct CornerCase {
  static constexpr std::int64_t kSide = 1 << 12;  ///< of a cell
  LatticePoint v;
  LatticePoint back;
  LatticePoint out;
};

enum class CornerCheck : std::uint8_t {
  kEndsInGrid,
  kOneToSevenEdges,
  kFeetOnEdges,
  kCase1,
  kCase2AsWritten,
  kCase2,
  kCase3Angles,
  kCase3AsWritten,
  kCase3,
};
inline constexpr std::size_t kCornerCheckCount = 9;
/// What it says.
std::string_view describe(CornerCheck check);

struct CornerTally {
  std::uint64_t looked_at = 0;
  std::uint64_t failed = 0;
  std::optional<CornerCase> smallest;  ///< by the size of its numbers, v off the lines of its cell
};

struct CornerAudit {
  std::uint64_t corners = 0;
  std::array<CornerTally, kCornerCheckCount> checks;
  /// Corners by the edges of E: -1 (u beyond w), 0 (u = w), 1 to 7.
  std::array<std::uint64_t, 9> by_edges{};

  [[nodiscard]] const CornerTally& of(CornerCheck check) const {
    return checks[static_cast<std::size_t>(check)];
  }
};

/// Corners with v on the odd sixteenths of a cell and edges of slopes of numbers up to 3, all of
/// them, and `random` others. Guarantees: 1. the same number gives the same counts.
CornerAudit audit_corners(std::uint64_t random);
CornerAudit audit_corner(const CornerCase& corner);

/// v in parts of the cell, and the two directions.
std::string to_text(const CornerCase& corner);
/// For a terminal.
std::string to_text(const CornerAudit& audit);

}  // namespace quadbound
