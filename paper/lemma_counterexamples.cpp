// SPDX-License-Identifier: Apache-2.0
#include "paper/lemma_counterexamples.hpp"

namespace quadbound {
namespace {

/// Points are given in quarters of a 64th of the root.
constexpr std::int64_t kUnit = kCutTreeSide / 256;

using Nodes = std::vector<TreeNode>;

LemmaCounterexample counterexample(Check check, bool general, Nodes split, LatticePoint point,
                                   std::int64_t dx, std::int64_t dy,
                                   TwoTwoVariant two_two = TwoTwoVariant::kExact) {
  return {
      check, general, {std::move(split), {{point.x * kUnit, point.y * kUnit}, dx, dy}, two_two}};
}

}  // namespace

const std::vector<LemmaCounterexample>& lemma_counterexamples() {
  const Nodes nodes_1{{1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 2, 2}};
  const Nodes nodes_2{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 1, 0},
                      {2, 0, 2}, {2, 1, 2}, {2, 1, 3}, {3, 2, 5}};
  const Nodes nodes_3{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 1, 0}, {2, 0, 2}, {2, 3, 3}};
  const Nodes nodes_4{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 1, 0}, {2, 2, 0}, {2, 1, 1},
                      {2, 2, 1}, {2, 3, 1}, {2, 0, 2}, {2, 2, 3}, {3, 3, 2}, {3, 5, 2}};
  const Nodes nodes_5{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 1, 1}, {2, 2, 1},
                      {2, 1, 2}, {2, 2, 2}, {3, 3, 3}, {3, 3, 4}, {3, 4, 4}, {4, 7, 8}};
  const Nodes nodes_6{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 1, 2},
                      {2, 2, 2}, {2, 3, 2}, {2, 2, 3}, {3, 4, 5}, {3, 5, 5}};
  const Nodes nodes_7{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 1, 1}, {2, 2, 1},
                      {2, 1, 2}, {2, 2, 2}, {2, 2, 3}, {3, 4, 3}, {3, 4, 4}, {3, 4, 5}};
  const Nodes nodes_8{{1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 2, 2}, {2, 2, 3}};
  const Nodes nodes_9{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 1, 1},
                      {2, 2, 1}, {2, 3, 1}, {2, 2, 2}, {3, 4, 3}, {3, 5, 3}};
  const Nodes nodes_10{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 2, 1},
                       {2, 1, 2}, {2, 2, 2}, {2, 2, 3}, {3, 4, 4}, {3, 4, 5}};
  static const std::vector<LemmaCounterexample> list{
      counterexample(Check::kNorthAbove, true, nodes_1, {128, 176}, 1, -1),
      counterexample(Check::kOrderAsWritten, true, nodes_1, {128, 144}, 1, -1),
      counterexample(Check::kTable1, true, nodes_1, {128, 144}, 1, -1),
      counterexample(Check::kOutsideTriangle, true, nodes_1, {128, 144}, 1, -1),
      counterexample(Check::kVertical, true, nodes_2, {128, 80}, 3, -2),
      counterexample(Check::kFourEdgesOfAlpha, true, nodes_3, {128, 112}, 3, 1),
      counterexample(Check::kFourEdgesOfAlphaWithoutSpikes, true, nodes_4, {128, 116}, 1, 0),
      counterexample(Check::kTwoEdgesDouble, true, nodes_5, {120, 151}, 14, -1),
      counterexample(Check::kAtMostFiveQuads, true, nodes_5, {120, 151}, 14, -1),
      counterexample(Check::kDistinctVertices, false, nodes_6, {128, 128}, 1, 0,
                     TwoTwoVariant::kPaper),
      counterexample(Check::kNeighbours, true, nodes_7, {128, 104}, 1, 1, TwoTwoVariant::kPaper),
      counterexample(Check::kVerticalCrossed, true, nodes_8, {128, 96}, 5, 4,
                     TwoTwoVariant::kPaper),
      counterexample(Check::kSlopes, true, nodes_9, {128, 80}, 5, 1, TwoTwoVariant::kPaper),
      counterexample(Check::kFeetInOrder, true, nodes_6, {128, 184}, 7, -3, TwoTwoVariant::kPaper),
      counterexample(Check::kSimplePolygon, true, nodes_6, {128, 144}, 7, 6, TwoTwoVariant::kPaper),
      counterexample(Check::kAnglesAtCentres, true, nodes_6, {128, 184}, 5, -1,
                     TwoTwoVariant::kPaper),
      counterexample(Check::kTwoEdgesStrict, true, nodes_10, {128, 154}, 7, -1,
                     TwoTwoVariant::kPaper),
      counterexample(Check::kTwoEdgesSmall, true, nodes_6, {128, 144}, 7, 6, TwoTwoVariant::kPaper),
  };
  return list;
}

}  // namespace quadbound
