// SPDX-License-Identifier: Apache-2.0
#include "paper/lemma_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace quadbound {
namespace {

using Checks = std::vector<Check>;
using Verdict = PaperVerdict;

/// What the paper says, as checks, and what is left of it after the repair.
struct LemmaClaim {
  std::string_view id;
  std::string_view what;
  Checks as_written;
  Checks repaired;
  Verdict expected;
  std::string_view why;
};

constexpr std::string_view kMovedCentre =
    "not where Fig. 8a moves a centre; two extra points instead";

const std::vector<LemmaClaim>& lemma_table() {
  static const std::vector<LemmaClaim> table{
      {"observation-1",
       "an extra point has degree three, one edge to the centre of its own cell",
       {Check::kExtraDegree, Check::kExtraOwnCentre},
       {},
       Verdict::kHolds,
       {}},
      {"observation-1",
       "its other edges end beside its cell, on a line through the nearest corner",
       {Check::kExtraOnLine, Check::kExtraNeighbours, Check::kExtraTwoSides, Check::kExtraQuadrant},
       {},
       Verdict::kHolds,
       {}},
      {"observation-2",
       "an edge between points of two edge neighbours joins the halves that face each other",
       {Check::kFacingHalves},
       {},
       Verdict::kHolds,
       {}},
      {"thm-1",
       "no two vertices of Q are at one place",
       {Check::kDistinctVertices},
       {Check::kDistinctVertices},
       Verdict::kHoldsAfterRepair,
       "Fig. 8a may move two centres to one place; two extra points instead"},
      {"lemma-2",
       "an edge of Q lies in the cells of its two ends",
       {Check::kTwoCells},
       {},
       Verdict::kHolds,
       {}},
      {"alpha",
       "E_1 E_2 ... E_k is one chain, each E_i of 0, 1 or 2 edges",
       {Check::kAlphaEdges, Check::kAlphaConnected},
       {},
       Verdict::kHolds,
       {}},
      {"rule-2",
       "the centres in N(c) lie above the edge",
       {Check::kNorthAbove},
       {},
       Verdict::kRefuted,
       "a half-size cell north of c may be below: departures.md"},
      {"lemma-3",
       "every centre of the chain beta is on alpha",
       {Check::kNorthAbove, Check::kBetaOnAlpha},
       {Check::kBetaOnAlpha},
       Verdict::kHoldsAfterRepair,
       "of the centres that rule 2 names, those above the edge"},
      {"beta",
       "sorted by x and then y, c_(i+1) comes after c_i on alpha",
       {Check::kOrderAsWritten},
       {Check::kOrder},
       Verdict::kHoldsAfterRepair,
       "y falls where theta < 0"},
      {"lemma-4",
       "consecutive centres of beta are edge or corner neighbours",
       {Check::kNeighbours},
       {Check::kNeighbours},
       Verdict::kHoldsAfterRepair,
       kMovedCentre},
      {"lemma-5",
       "vertical projections do not meet alpha",
       {Check::kVertical},
       {},
       Verdict::kRefuted,
       "alpha may touch c_i v_i at an extra point: departures.md"},
      {"lemma-5",
       "alpha does not cross vertical projections",
       {Check::kVerticalCrossed},
       {Check::kVerticalCrossed},
       Verdict::kHoldsAfterRepair,
       kMovedCentre},
      {"lemma-6",
       "alpha_i has at most four edges",
       {Check::kFourEdgesOfAlpha},
       {Check::kChainAbove, Check::kFourEdges},
       Verdict::kHoldsAfterRepair,
       "below c_i c_(i+1), the chain above is the upper boundary of the quads that c_i c_(i+1) "
       "cuts"},
      {"lemma-7",
       "the slopes of c_i c_(i+1) are 0, 18.43, 45, 71.57 or 90 degrees",
       {Check::kSlopes},
       {Check::kSlopes},
       Verdict::kHoldsAfterRepair,
       kMovedCentre},
      {"table-1",
       "delta_i for each range of theta",
       {Check::kTable1},
       {Check::kTable1Repaired},
       Verdict::kHoldsAfterRepair,
       "-90 belongs to the last row"},
      {"lemma-8",
       "c_(i+1) is strictly outside the triangle p_i c_i v_i",
       {Check::kOutsideTriangle},
       {},
       Verdict::kRefuted,
       "it may be on c_i v_i, straight below c_i: departures.md"},
      {"lemma-8",
       "perpendicular projections are in order and A_i is simple",
       {Check::kFeetInOrder, Check::kSimplePolygon},
       {Check::kFeetInOrder, Check::kSimplePolygon},
       Verdict::kHoldsAfterRepair,
       kMovedCentre},
      {"lemma-9",
       "angles of A_i at c_i and c_(i+1) are within 18.43 and 161.57",
       {Check::kAnglesAtCentres},
       {Check::kAnglesAtCentres},
       Verdict::kHoldsAfterRepair,
       kMovedCentre},
      {"lemma-10",
       "(i) phi_1 and kappa_1 are above 18.43 where alpha_i has two edges",
       {Check::kTwoEdgesStrict},
       {Check::kTwoEdgesStrict},
       Verdict::kHoldsAfterRepair,
       kMovedCentre},
      {"lemma-10",
       "(ii) phi_1 + phi_2 and kappa_1 + kappa_2 are at least 2 x 18.43",
       {Check::kTwoEdgesDouble},
       {},
       Verdict::kRefuted,
       "from 30.97 up where delta_i = -71.57 and phi_2 = 12.53: departures.md"},
      {"lemma-10",
       "phi_2 or kappa_2 below 18.43 is 12.53 or 14.04",
       {Check::kTwoEdgesSmall},
       {Check::kTwoEdgesSmall},
       Verdict::kHoldsAfterRepair,
       kMovedCentre},
      {"lemma-11",
       "A_i has at most five quads within 18.43 and 171.86",
       {Check::kAtMostFiveQuads},
       {Check::kAtMostFiveQuadsMoved},
       Verdict::kHoldsAfterRepair,
       "a foot is moved where Lemma 10 (ii) fails"},
  };
  return table;
}

struct Counted {
  std::uint64_t looked_at = 0;
  std::uint64_t failed = 0;
  std::uint64_t in_general_position = 0;
};

Counted counted(const LemmaAudit& audit, const Checks& checks) {
  Counted sum;
  for (const Check check : checks) {
    sum.looked_at += audit.of(check).looked_at;
    sum.failed += audit.of(check).failed;
    sum.in_general_position += audit.of(check).failed_in_general_position;
  }
  return sum;
}

template <class Tally>
std::string text_of(const Tally& c) {
  return fmt::format("{} of {} fail", with_commas(c.failed), with_commas(c.looked_at));
}

/// With moved centres only where nothing fails without.
Counted as_written(const LemmaAudits& audits, const LemmaClaim& claim) {
  const Counted ours = counted(audits.audit, claim.as_written);
  return ours.failed > 0 ? ours : counted(audits.moved_centres, claim.as_written);
}

PaperClaim judged(const LemmaAudits& audits, const LemmaClaim& claim) {
  PaperClaim result{std::string(claim.id), std::string(claim.what), "always", "",
                    claim.expected,        std::string(claim.why)};
  const Counted written = as_written(audits, claim);
  const Counted repaired = counted(audits.audit, claim.repaired);
  const Counted on_polygons = counted(audits.polygon_trees.audit,
                                      claim.repaired.empty() ? claim.as_written : claim.repaired);
  bool as_expected = written.failed > 0;
  if (claim.expected == Verdict::kHolds) {
    as_expected = written.failed + on_polygons.failed == 0;
    result.ours = text_of(counted(audits.audit, claim.as_written));
  } else if (claim.expected == Verdict::kHoldsAfterRepair) {
    as_expected = as_expected && repaired.failed + on_polygons.failed == 0;
    result.ours = text_of(written) + "; repaired, " + text_of(repaired);
  } else {
    result.ours = fmt::format("{}, {} of them in general position", text_of(written),
                              with_commas(written.in_general_position));
  }
  result.ours += "; on trees of polygons, " + text_of(on_polygons);
  if (!as_expected) result.verdict = Verdict::kFails;
  return result;
}

// --- corners -------------------------------------------------------------------------------------

struct CornerClaim {
  std::string_view what;
  CornerCheck as_written;
  CornerCheck repaired;
  Verdict expected;
  std::string_view why;
};

constexpr std::array<CornerClaim, 7> kCornerTable{{
    {"both chains beta end in the 3x3 cells around v", CornerCheck::kEndsInGrid,
     CornerCheck::kEndsInGrid, Verdict::kHolds, ""},
    {"E has one to seven edges", CornerCheck::kOneToSevenEdges, CornerCheck::kOneToSevenEdges,
     Verdict::kRefuted, "u = w, and u beyond w, happen: departures.md"},
    {"u and w have their feet on e and f", CornerCheck::kFeetOnEdges, CornerCheck::kFeetOnEdges,
     Verdict::kRefuted, "a foot may lie beyond v: departures.md"},
    {"case 1: four quads", CornerCheck::kCase1, CornerCheck::kCase1, Verdict::kHolds, ""},
    {"case 2: two quads, feet moved", CornerCheck::kCase2, CornerCheck::kCase2, Verdict::kRefuted,
     "not where v t goes on in line with e or f: departures.md"},
    {"case 3: v may be joined to the centres in line with it", CornerCheck::kCase3Angles,
     CornerCheck::kCase3Angles, Verdict::kRefuted,
     "not where e or f goes on in that line: departures.md"},
    {"case 3: quads and pentagons as drawn", CornerCheck::kCase3AsWritten, CornerCheck::kCase3,
     Verdict::kHoldsAfterRepair, "where the angles at v allow it, with the foot of s moved"},
}};

PaperClaim judged(const CornerAudit& audit, const CornerClaim& claim) {
  const CornerTally& written = audit.of(claim.as_written);
  const CornerTally& repaired = audit.of(claim.repaired);
  PaperClaim result{"lemma-12",       std::string(claim.what), "always",
                    text_of(written), claim.expected,          std::string(claim.why)};
  const bool differ = claim.as_written != claim.repaired;
  if (differ) result.ours += ", " + text_of(repaired);
  const bool as_expected = claim.expected == Verdict::kHolds
                               ? written.failed + repaired.failed == 0
                               : written.failed > 0 && (!differ || repaired.failed == 0);
  if (!as_expected) result.verdict = Verdict::kFails;
  return result;
}

}  // namespace

std::vector<PaperClaim> lemma_claims(const LemmaAudits& audits) {
  std::vector<PaperClaim> claims;
  claims.reserve(lemma_table().size() + kCornerTable.size());
  for (const LemmaClaim& claim : lemma_table()) claims.push_back(judged(audits, claim));
  for (const CornerClaim& claim : kCornerTable) claims.push_back(judged(audits.corners, claim));
  return claims;
}

bool lemmas_hold(const LemmaAudits& audits) {
  const std::vector<PaperClaim> claims = lemma_claims(audits);
  return std::none_of(claims.begin(), claims.end(),
                      [](const PaperClaim& c) { return c.verdict == PaperVerdict::kFails; });
}

}  // namespace quadbound
