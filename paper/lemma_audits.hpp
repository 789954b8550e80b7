// SPDX-License-Identifier: Apache-2.0
#pragma once
// All audits of Section 3 together.

#include <cstdint>
#include <vector>

#include "paper/corner_audit.hpp"
#include "paper/lemma_audit.hpp"
#include "paper/polygon_trees.hpp"
#include "paper/watcher.hpp"

namespace quadbound {

struct LemmaAudits {
  LemmaAudit audit;                 ///< with two extra points in the case 2,2, as we do
  LemmaAudit moved_centres;         ///< with the centre that the paper moves there (Fig. 8a)
  PolygonTreesAudit polygon_trees;  ///< as `audit`
  CornerAudit corners;
};

/// `trees` random trees, a quarter as many with moved centres, ten times as many random corners,
/// the counterexamples that are kept, and trees of `polygons` and of one generated polygon for each
/// 150 of `trees`. Guarantees: 1. the same arguments give the same counts.
/// Complexity: about 2 ms for each of `trees`.
LemmaAudits audit_paper_lemmas(std::uint64_t trees, const std::vector<Polygon>& polygons,
                               Watcher& watcher);

}  // namespace quadbound
