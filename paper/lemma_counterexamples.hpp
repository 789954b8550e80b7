// SPDX-License-Identifier: Apache-2.0
#pragma once
// The smallest counterexamples found to statements of lemma_audit.hpp. Every audit looks at them
// too.

#include <vector>

#include "paper/lemma_audit.hpp"

namespace quadbound {

struct LemmaCounterexample {
  Check check;
  bool general;  ///< in general position: no vertex of Q and no corner of a cell on the line
  CutTreeCase cut_case;
};

const std::vector<LemmaCounterexample>& lemma_counterexamples();

}  // namespace quadbound
