// SPDX-License-Identifier: Apache-2.0
#pragma once
// The checks of lemma_audit.hpp on one tree and on one line.

#include <functional>
#include <string>

#include "paper/edge_chains.hpp"
#include "paper/lemma_audit.hpp"

namespace quadbound {

/// Counts, and keeps the smallest counterexample of each check.
class CheckLedger {
 public:
  CheckLedger(const CutTree& tree, TwoTwoVariant two_two, LemmaAudit& audit)
      : tree_(tree), two_two_(two_two), audit_(audit) {}

  /// From now on on this line.
  void set_line(const CutLine& line);
  /// `where` are vertices to name, should it fail.
  void count(Check check, bool holds, std::initializer_list<VertexId> where);

  [[nodiscard]] LemmaAudit& audit() { return audit_; }

 private:
  const CutTree& tree_;
  TwoTwoVariant two_two_;
  LemmaAudit& audit_;
  CutLine line_;
  std::optional<bool> general_;  ///< position of the line, once asked for
};

/// Observations 1 and 2, Lemma 2: each vertex and edge of Q but for its outer boundary.
void check_quadrangulation(const CutTree& tree, CheckLedger& ledger);

/// All else, on the part of a line in the middle 3/8 of the root.
void check_line(const CutTree& tree, const CutLine& line, CheckLedger& ledger);

}  // namespace quadbound
