// SPDX-License-Identifier: Apache-2.0
#include "paper/lemma_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <nlohmann/json.hpp>

#include "paper/claims.hpp"
#include "paper/lemma_counterexamples.hpp"

namespace quadbound {
namespace {

using Json = nlohmann::ordered_json;

TextTable checks_table(const LemmaAudits& audits) {
  TextTable table{{"claim", "statement", "looked at", "fail", "in general position",
                   "fail with moved centres", "fail on trees of polygons"},
                  {}};
  const auto of = [](const CheckTally& t) {
    return fmt::format("{} of {}", with_commas(t.failed), with_commas(t.looked_at));
  };
  for (std::size_t i = 0; i < kCheckCount; ++i) {
    const CheckDescription& d = describe(static_cast<Check>(i));
    const CheckTally& t = audits.audit.checks[i];
    table.rows.push_back({std::string(d.id), std::string(d.what), with_commas(t.looked_at),
                          with_commas(t.failed), with_commas(t.failed_in_general_position),
                          of(audits.moved_centres.checks[i]),
                          of(audits.polygon_trees.audit.checks[i])});
  }
  return table;
}

TextTable slopes_table(const LemmaAudit& audit) {
  TextTable table{{"theta", "-90", "-71.57", "-45", "-18.43", "0", "18.43", "45", "71.57", "90"},
                  {}};
  constexpr std::array<const char*, 5> kRows{"18.43 to 45", "above 0, below 18.43", "0",
                                             "above -18.43, below 0", "-45 to -18.43"};
  for (std::size_t row = 0; row < kRows.size(); ++row) {
    table.rows.push_back({kRows[row]});
    for (const std::uint64_t count : audit.slopes[row])
      table.rows.back().push_back(with_commas(count));
  }
  return table;
}

TextTable strips_table(const LemmaAudit& audit) {
  TextTable table{{"inner vertices", "A_i", "with perpendicular feet", "a foot moved",
                   "no way found", "quads most"},
                  {}};
  for (const auto& [turns, s] : audit.strips)
    table.rows.push_back({turns.empty() ? "none" : turns, with_commas(s.looked_at),
                          with_commas(s.as_written), with_commas(s.moved_feet),
                          with_commas(s.looked_at - s.as_written - s.moved_feet),
                          std::to_string(s.most_quads)});
  return table;
}

TextTable counterexamples_table() {
  TextTable table{{"statement", "smallest counterexample"}, {}};
  for (const LemmaCounterexample& c : lemma_counterexamples()) {
    const bool moved = c.cut_case.two_two == TwoTwoVariant::kPaper;
    table.rows.push_back({std::string(describe(c.check).what) + (moved ? ", moved centres" : ""),
                          to_text(c.cut_case)});
  }
  return table;
}

TextTable corners_table(const CornerAudit& audit) {
  TextTable table{{"Lemma 12", "looked at", "fail", "smallest counterexample"}, {}};
  for (std::size_t i = 0; i < kCornerCheckCount; ++i) {
    const CornerTally& t = audit.checks[i];
    table.rows.push_back({std::string(describe(static_cast<CornerCheck>(i))),
                          with_commas(t.looked_at), with_commas(t.failed),
                          t.smallest ? to_text(*t.smallest) : ""});
  }
  return table;
}

Json json_of(const LemmaAudit& audit) {
  Json json{{"trees", audit.trees}, {"lines", audit.lines}, {"checks", Json::array()}};
  for (std::size_t i = 0; i < kCheckCount; ++i) {
    const CheckDescription& d = describe(static_cast<Check>(i));
    const CheckTally& t = audit.checks[i];
    json["checks"].push_back({{"claim", d.id},
                              {"statement", d.what},
                              {"looked_at", t.looked_at},
                              {"failed", t.failed},
                              {"failed_in_general_position", t.failed_in_general_position}});
  }
  json["table_1"] = audit.slopes;
  for (const auto& [turns, s] : audit.strips)
    json["strips"][turns] = {{"looked_at", s.looked_at},
                             {"as_written", s.as_written},
                             {"moved_feet", s.moved_feet},
                             {"most_quads", s.most_quads}};
  return json;
}

Json json_of(const PolygonTreesAudit& trees) {
  Json json = json_of(trees.audit);
  json["polygons"] = trees.polygons;
  json["refused"] = trees.refused;
  return json;
}

Json json_of(const CornerAudit& audit) {
  Json json{{"corners", audit.corners}, {"by_edges", audit.by_edges}, {"checks", Json::array()}};
  for (std::size_t i = 0; i < kCornerCheckCount; ++i) {
    const CornerTally& t = audit.checks[i];
    json["checks"].push_back({{"statement", describe(static_cast<CornerCheck>(i))},
                              {"looked_at", t.looked_at},
                              {"failed", t.failed}});
  }
  return json;
}

}  // namespace

std::string lemma_json(const LemmaAudits& audits) {
  return Json{{"audit", json_of(audits.audit)},
              {"moved_centres", json_of(audits.moved_centres)},
              {"polygon_trees", json_of(audits.polygon_trees)},
              {"corners", json_of(audits.corners)}}
      .dump();
}

std::string to_text(const LemmaAudits& audits) {
  return to_text(audits.audit) + "\nWith the centres that Fig. 8a moves:\n" +
         to_text(audits.moved_centres) +
         fmt::format(
             "\nOn trees of polygons, {} of them without a tree: {} polygons, turned four "
             "times, ",
             audits.polygon_trees.refused, audits.polygon_trees.polygons) +
         to_text(audits.polygon_trees.audit) + "\nLemma 12:\n" + to_text(audits.corners);
}

std::vector<Block> lemma_section(const LemmaAudits& audits) {
  const LemmaAudit& audit = audits.audit;
  std::vector<Block> blocks;
  blocks.emplace_back(
      Heading{2,
              "The lemmas of Section 3, audited (lemma-2 to lemma-12)",
              "lemmas",
              {"observation-1", "observation-2", "alpha", "beta", "rule-2", "lemma-2", "lemma-3",
               "lemma-4", "lemma-5", "lemma-6", "lemma-7", "table-1", "lemma-8", "lemma-9",
               "lemma-10", "lemma-11", "lemma-12"}});
  blocks.emplace_back(Paragraph{fmt::format(
      "Each statement is decided in integers on {} balanced trees cut by {} lines: random ones, "
      "and "
      "slopes of 0, 1/7, 1/3, 1/2, 3/4 and 1 or next to them, through or beside centres, corners "
      "and "
      "extra points. A statement that holds was not broken on these; that is no proof. In general "
      "position no vertex of Q and no corner of a cell is on the line. Moved centres: {} trees "
      "with "
      "the paper's own case 2,2 (Fig. 8a). Also: `quadbound prove lemmas`.",
      with_commas(audit.trees), with_commas(audit.lines),
      with_commas(audits.moved_centres.trees))});
  const PolygonTreesAudit& of_polygons = audits.polygon_trees;
  blocks.emplace_back(Paragraph{fmt::format(
      "Trees of polygons: {} polygons of 24 families and Lake Superior, each turned by all right "
      "angles, in the tree that their vertices and edges ask for, cut by the lines of their own "
      "edges: {} trees and {} lines. {} polygons more were too fine for the integers of the audit.",
      of_polygons.polygons - of_polygons.refused, with_commas(of_polygons.audit.trees),
      with_commas(of_polygons.audit.lines), of_polygons.refused)});
  blocks.emplace_back(checks_table(audits));
  blocks.emplace_back(Paragraph{"Table 1: how often each delta_i was met."});
  blocks.emplace_back(slopes_table(audit));
  blocks.emplace_back(Paragraph{fmt::format(
      "Lemma 11: polygons A_i by the inner vertices of alpha_i (C convex, R reflex, S straight), "
      "meshed by the paper's pieces. {} chains alpha_i had a vertex below c_i c_(i+1) and were "
      "replaced by the chain above. That no way was found is no proof that there is none.",
      with_commas(audit.under))});
  blocks.emplace_back(strips_table(audit));
  blocks.emplace_back(Paragraph{"Counterexamples, made small by dropping cells:"});
  blocks.emplace_back(counterexamples_table());
  blocks.emplace_back(Paragraph{
      fmt::format("Lemma 12 on {} corners in a grid of equal cells: all with v on the odd "
                  "sixteenths of its cell and "
                  "edges of slopes of numbers up to 3 or of 8 and 1, and random ones. By the edges "
                  "of E, from -1 (u beyond "
                  "w), 0 (u = w) to 7: {}.",
                  with_commas(audits.corners.corners), fmt::join(audits.corners.by_edges, ", "))});
  blocks.emplace_back(corners_table(audits.corners));
  return blocks;
}

}  // namespace quadbound
