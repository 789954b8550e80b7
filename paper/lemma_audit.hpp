// SPDX-License-Identifier: Apache-2.0
#pragma once
// Observations 1 and 2, rules 1 to 3 of beta, Lemmas 2 to 11 and Table 1 as statements that a
// program decides, in integers, on a balanced quadtree cut by a line.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "paper/cut_tree.hpp"
#include "paper/watcher.hpp"

namespace quadbound {

enum class Check : std::uint8_t {
  kDistinctVertices,
  kExtraDegree,
  kExtraOwnCentre,
  kExtraOnLine,
  kExtraNeighbours,
  kExtraTwoSides,
  kExtraQuadrant,
  kFacingHalves,
  kTwoCells,
  kAlphaEdges,
  kAlphaConnected,
  kNorthAbove,
  kBetaOnAlpha,
  kOrderAsWritten,
  kOrder,
  kNeighbours,
  kVertical,
  kVerticalCrossed,
  kFourEdgesOfAlpha,
  kFourEdgesOfAlphaWithoutSpikes,
  kChainAbove,
  kFourEdges,
  kSlopes,
  kTable1,
  kTable1Repaired,
  kOutsideTriangle,
  kFeetInOrder,
  kSimplePolygon,
  kAnglesAtCentres,
  kTwoEdgesStrict,
  kTwoEdgesDouble,
  kTwoEdgesSmall,
  kAtMostFiveQuads,
  kAtMostFiveQuadsMoved,
};
inline constexpr std::size_t kCheckCount = 34;

struct CheckDescription {
  std::string_view name;  ///< of the case file of its counterexample
  std::string_view id;    ///< of the claim
  std::string_view what;
};
const CheckDescription& describe(Check check);

struct CheckTally {
  std::uint64_t looked_at = 0;
  std::uint64_t failed = 0;
  /// Of these, with no vertex of Q and no corner of a cell on the line.
  std::uint64_t failed_in_general_position = 0;
  /// Of the fewest leaves met; in general position, if one failed there.
  std::optional<CutTreeCase> smallest;
  std::uint64_t smallest_leaves = 0;
  std::string where;  ///< in it, in units of the lattice
};

/// Polygons A_i with a like chain alpha_i. C is a convex inner vertex of it, R a reflex one, S one
/// with 180 degrees.
struct StripTally {
  std::uint64_t looked_at = 0;
  std::uint64_t as_written = 0;  ///< meshed by the pieces of Lemma 11, with perpendicular feet
  std::uint64_t moved_feet = 0;  ///< only after a foot was moved
  std::uint64_t most_quads = 0;
};

/// Everything that was counted.
struct LemmaAudit {
  std::uint64_t trees = 0;
  std::uint64_t lines = 0;
  std::uint64_t under = 0;   ///< alpha_i with a vertex under c_i c_(i+1)
  std::uint64_t spikes = 0;  ///< alpha_i with an edge that is run along twice
  std::array<CheckTally, kCheckCount> checks;
  /// Table 1: rows of theta as in the paper, columns -90, -71.57, -45, -18.43, 0, ... 90 degrees.
  std::array<std::array<std::uint64_t, 9>, 5> slopes{};
  std::map<std::string, StripTally> strips;  ///< by "CRC" and the like

  [[nodiscard]] const CheckTally& of(Check check) const {
    return checks[static_cast<std::size_t>(check)];
  }
};

struct LemmaAuditOptions {
  std::uint64_t trees = 1000;
  std::uint64_t lines_per_tree = 6;
  TwoTwoVariant two_two = TwoTwoVariant::kExact;
};

/// Guarantees: 1. the same options give the same counts. Complexity: about 1 ms for a tree.
LemmaAudit audit_lemmas(const LemmaAuditOptions& options, Watcher& watcher);

/// A tree and lines through it, counted in addition.
void audit_tree(const CutTree& tree, TwoTwoVariant two_two, std::span<const CutLine> lines,
                LemmaAudit& audit);

/// One input, counted in addition.
void audit_case(const CutTreeCase& cut_case, LemmaAudit& audit);
LemmaAudit audit_case(const CutTreeCase& cut_case);

/// The same counterexample with fewer cells and a simpler line, as far as dropping one node at a
/// time leads. Requires: the case fails the check.
CutTreeCase smaller_case(CutTreeCase cut_case, Check check);

/// For a terminal: one line for each check.
std::string to_text(const LemmaAudit& audit);

}  // namespace quadbound
