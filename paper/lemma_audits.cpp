// SPDX-License-Identifier: Apache-2.0
#include "paper/lemma_audits.hpp"

#include "paper/lemma_counterexamples.hpp"

namespace quadbound {
namespace {

/// The trees of a polygon take about as long as so many random ones.
constexpr std::uint64_t kTreesPerPolygon = 150;

}  // namespace

LemmaAudits audit_paper_lemmas(std::uint64_t trees, const std::vector<Polygon>& polygons,
                               Watcher& watcher) {
  LemmaAudits audits;
  watcher.stage("lemmas 2 to 11");
  LemmaAuditOptions options{trees};
  audits.audit = audit_lemmas(options, watcher);
  watcher.stage("lemmas 2 to 11, moved centres");
  options.trees = (trees + 3) / 4;
  options.two_two = TwoTwoVariant::kPaper;
  audits.moved_centres = audit_lemmas(options, watcher);
  for (const LemmaCounterexample& c : lemma_counterexamples())
    audit_case(c.cut_case,
               c.cut_case.two_two == TwoTwoVariant::kPaper ? audits.moved_centres : audits.audit);
  watcher.stage("lemmas 2 to 11, trees of polygons");
  audits.polygon_trees = audit_polygon_trees(trees / kTreesPerPolygon, polygons, watcher);
  watcher.stage("lemma 12");
  audits.corners = audit_corners(10 * trees);
  return audits;
}

}  // namespace quadbound
