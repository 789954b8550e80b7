// SPDX-License-Identifier: Apache-2.0
#pragma once
// All audits of Section 3 together.

#include <cstdint>

#include "paper/corner_audit.hpp"
#include "paper/lemma_audit.hpp"
#include "paper/watcher.hpp"

namespace quadbound {

struct LemmaAudits {
  LemmaAudit audit;          ///< with two extra points in the case 2,2, as we do
  LemmaAudit moved_centres;  ///< with the centre that the paper moves there (Fig. 8a)
  CornerAudit corners;
};

/// `trees` random trees, a quarter as many with moved centres, ten times as many random corners,
/// and the counterexamples that are kept. Guarantees: 1. the same number gives the same counts.
/// Complexity: about 1 ms for each of `trees`.
LemmaAudits audit_paper_lemmas(std::uint64_t trees, Watcher& watcher);

}  // namespace quadbound
