// SPDX-License-Identifier: Apache-2.0
#include "paper/lemma_audit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "paper/lemma_checks.hpp"

namespace quadbound {
namespace {

constexpr std::array<CheckDescription, kCheckCount> kDescriptions{{
    {"distinct-vertices", "thm-1", "no two vertices of Q are at one place"},
    {"extra-degree", "observation-1", "an extra point has degree three"},
    {"extra-own-centre", "observation-1", "one of its edges goes to the centre of its own cell"},
    {"extra-on-line", "observation-1",
     "the other two end on the line through the nearest corner, perpendicular to the first"},
    {"extra-neighbours", "observation-1", "they end in edge neighbours of its cell"},
    {"extra-two-sides", "observation-1", "they cross two distinct sides of its cell"},
    {"extra-quadrant", "observation-1", "within its cell, its edges stay in its quadrant"},
    {"facing-halves", "observation-2",
     "an edge between edge neighbours lies in the halves that face each other"},
    {"two-cells", "lemma-2", "an edge of Q lies in the cells of its two ends"},
    {"alpha-edges", "alpha", "each E_i has 0, 1 or 2 edges"},
    {"alpha-connected", "alpha", "E_1 E_2 ... E_k is one chain"},
    {"north-above", "rule-2", "the centres in N(c) lie above the edge"},
    {"beta-on-alpha", "lemma-3", "every centre of beta above the edge is on alpha"},
    {"order-as-written", "beta", "sorted by x, then y, c_(i+1) comes after c_i on alpha"},
    {"order", "beta", "the same with y falling where theta < 0"},
    {"neighbours", "lemma-4", "c_i and c_(i+1) are edge or corner neighbours"},
    {"vertical", "lemma-5",
     "c_i v_i does not meet alpha, but where alpha itself goes straight down"},
    {"vertical-crossed", "lemma-5", "alpha does not cross c_i v_i, but may touch it"},
    {"four-edges-of-alpha", "lemma-6", "alpha_i has at most four edges"},
    {"four-edges-without-spikes", "lemma-6", "the same without edges that are run along twice"},
    {"chain-above", "lemma-6", "where alpha_i runs below c_i c_(i+1), there is a chain above it"},
    {"four-edges", "lemma-6", "alpha_i, or the chain above instead, has at most four edges"},
    {"slopes", "lemma-7", "the slope of c_i c_(i+1) is 0, 18.43, 45, 71.57 or 90 degrees"},
    {"table-1", "table-1", "delta_i is in its row"},
    {"table-1-repaired", "table-1", "the same with -90 in the last row"},
    {"outside-triangle", "lemma-8", "c_(i+1) is strictly outside the triangle p_i c_i v_i"},
    {"feet-in-order", "lemma-8", "p_(i+1) comes after p_i"},
    {"simple-polygon", "lemma-8", "A_i with perpendicular projections is simple"},
    {"angles-at-centres", "lemma-9", "phi_1 and kappa_1 are within 18.43 and 161.57 degrees"},
    {"two-edges-strict", "lemma-10", "(i) phi_1, kappa_1 > 18.43 where alpha_i has two edges"},
    {"two-edges-double", "lemma-10", "(ii) phi_1 + phi_2, kappa_1 + kappa_2 >= 2 x 18.43"},
    {"two-edges-small", "lemma-10", "phi_2, kappa_2 < 18.43 are 12.53 or 14.04"},
    {"five-quads", "lemma-11", "A_i is meshed by the pieces as written, at most five quads"},
    {"five-quads-moved", "lemma-11", "the same with p_i or p_(i+1) moved where nothing else helps"},
}};

std::string place_text(const CutTree& tree, std::initializer_list<VertexId> where) {
  std::string text;
  for (const VertexId v : where)
    text += fmt::format("{}({}, {})", text.empty() ? "" : ", ", tree.at(v).x, tree.at(v).y);
  return text;
}

constexpr std::array<std::string_view, 9> kDegrees{"-90",   "-71.57", "-45",   "-18.43", "0",
                                                   "18.43", "45",     "71.57", "90"};
constexpr std::array<std::string_view, 5> kRows{"18.43 <= theta <= 45", "0 < theta < 18.43",
                                                "theta = 0", "-18.43 < theta < 0",
                                                "-45 <= theta <= -18.43"};

}  // namespace

const CheckDescription& describe(Check check) {
  return kDescriptions[static_cast<std::size_t>(check)];
}

void CheckLedger::set_line(const CutLine& line) {
  line_ = line;
  general_.reset();
}

void CheckLedger::count(Check check, bool holds, std::initializer_list<VertexId> where) {
  CheckTally& tally = audit_.checks[static_cast<std::size_t>(check)];
  ++tally.looked_at;
  if (holds) return;
  ++tally.failed;
  if (!general_) general_ = in_general_position(tree_, line_);
  const bool first_in_general = *general_ && tally.failed_in_general_position++ == 0;
  if (!first_in_general && tally.smallest &&
      (tally.smallest_leaves <= tree_.leaves().size() ||
       (tally.failed_in_general_position > 0 && !*general_)))
    return;
  tally.smallest = CutTreeCase{nodes_of(tree_.tree()), line_, two_two_};
  tally.smallest_leaves = tree_.leaves().size();
  tally.where = place_text(tree_, where);
}

/// What fails without a line is noted with the first one.
void audit_tree(const CutTree& tree, TwoTwoVariant two_two, std::span<const CutLine> lines,
                LemmaAudit& audit) {
  ++audit.trees;
  CheckLedger ledger(tree, two_two, audit);
  if (!lines.empty()) ledger.set_line(lines.front());
  check_quadrangulation(tree, ledger);
  for (const CutLine& line : lines) {
    ledger.set_line(line);
    check_line(tree, line, ledger);
    ++audit.lines;
  }
}

LemmaAudit audit_lemmas(const LemmaAuditOptions& options, Watcher& watcher) {
  LemmaAudit audit;
  while (audit.trees < options.trees) {
    watcher.steps(audit.trees, options.trees);
    RandomIntegers random(audit.trees);
    const CutTree tree(random_cut_tree(random), options.two_two);
    std::vector<CutLine> lines;
    for (std::uint64_t i = 0; i < options.lines_per_tree; ++i)
      lines.push_back(random_cut_line(tree, random));
    audit_tree(tree, options.two_two, lines, audit);
  }
  return audit;
}

void audit_case(const CutTreeCase& cut_case, LemmaAudit& audit) {
  const CutTree tree(tree_with(cut_case.split), cut_case.two_two);
  audit_tree(tree, cut_case.two_two, {&cut_case.line, 1}, audit);
}

LemmaAudit audit_case(const CutTreeCase& cut_case) {
  LemmaAudit audit;
  audit_case(cut_case, audit);
  return audit;
}

namespace {

/// In general position, if that is asked for.
bool fails(const CutTreeCase& cut_case, Check check, bool in_general) {
  const LemmaAudit audit = audit_case(cut_case);
  return (in_general ? audit.of(check).failed_in_general_position : audit.of(check).failed) > 0;
}

/// Without one node and all inside it.
std::vector<TreeNode> without(const std::vector<TreeNode>& nodes, const TreeNode& dropped) {
  std::vector<TreeNode> left;
  for (const TreeNode& n : nodes) {
    const int levels = n.level - dropped.level;
    const bool inside = levels >= 0 && n.i >> levels == dropped.i && n.j >> levels == dropped.j;
    if (!inside) left.push_back(n);
  }
  return left;
}

void drop_nodes(CutTreeCase& cut_case, Check check, bool in_general) {
  for (std::size_t k = 0; k < cut_case.split.size();) {
    CutTreeCase smaller = cut_case;
    smaller.split = nodes_of(tree_with(without(cut_case.split, cut_case.split[k])));
    if (smaller.split.size() < cut_case.split.size() && fails(smaller, check, in_general)) {
      cut_case = std::move(smaller);
      k = 0;
    } else {
      ++k;
    }
  }
}

/// Lines of small slopes through points of a coarse lattice near the middle of a line, the simplest
/// first.
std::vector<CutLine> simpler_lines(const CutLine& line, std::int64_t unit) {
  const std::int64_t x = kCutTreeSide / 2;
  const std::int64_t y = line.point.y + (x - line.point.x) * line.dy / line.dx;
  std::vector<CutLine> lines;
  constexpr std::int64_t kLargest = 12;
  constexpr std::int64_t kSteps = 8;
  for (std::int64_t dx = 1; dx <= kLargest; ++dx)
    for (std::int64_t dy = -dx; dy <= dx; ++dy)
      for (std::int64_t steps = -kSteps; steps <= kSteps; ++steps)
        lines.push_back({{x, (y / unit + steps) * unit}, dx, dy});
  return lines;
}

void simplify_line(CutTreeCase& cut_case, Check check, bool in_general) {
  int deepest = 0;
  for (const TreeNode& n : cut_case.split) deepest = std::max(deepest, n.level);
  for (int level = deepest + 1; level <= deepest + 4; ++level) {
    for (const CutLine& line : simpler_lines(cut_case.line, kCutTreeSide >> level)) {
      CutTreeCase simpler = cut_case;
      simpler.line = line;
      if (!fails(simpler, check, in_general)) continue;
      cut_case = simpler;
      return;
    }
  }
}

}  // namespace

CutTreeCase smaller_case(CutTreeCase cut_case, Check check) {
  const bool in_general = fails(cut_case, check, true);
  drop_nodes(cut_case, check, in_general);
  simplify_line(cut_case, check, in_general);
  drop_nodes(cut_case, check, in_general);
  return cut_case;
}

std::string to_text(const LemmaAudit& audit) {
  std::string text = fmt::format("{} trees, {} lines\n\n", audit.trees, audit.lines);
  constexpr const char* kRow = "{:<14} {:<76} {:>9} {:>8} {:>8}\n";
  text += fmt::format(kRow, "claim", "what", "looked at", "fail", "general");
  for (std::size_t i = 0; i < kCheckCount; ++i) {
    const CheckTally& t = audit.checks[i];
    text += fmt::format(kRow, kDescriptions[i].id, kDescriptions[i].what, t.looked_at, t.failed,
                        t.failed_in_general_position);
  }
  text += fmt::format("\nalpha_i with a vertex under c_i c_(i+1): {}; with a spike: {}\n\n",
                      audit.under, audit.spikes);
  text += fmt::format("{:<24}", "delta");
  for (const std::string_view d : kDegrees) text += fmt::format("{:>8}", d);
  text += "\n";
  for (std::size_t row = 0; row < audit.slopes.size(); ++row) {
    text += fmt::format("{:<24}", kRows[row]);
    for (const std::uint64_t count : audit.slopes[row]) text += fmt::format("{:>8}", count);
    text += "\n";
  }
  text += fmt::format("\n{:<8} {:>9} {:>11} {:>11} {:>6}\n", "alpha_i", "looked at", "as written",
                      "moved feet", "quads");
  for (const auto& [turns, s] : audit.strips)
    text += fmt::format("{:<8} {:>9} {:>11} {:>11} {:>6}\n", turns.empty() ? "-" : turns,
                        s.looked_at, s.as_written, s.moved_feet, s.most_quads);
  return text;
}

}  // namespace quadbound
