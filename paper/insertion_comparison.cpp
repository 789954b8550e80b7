// SPDX-License-Identifier: Apache-2.0
#include "paper/insertion_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <variant>

#include "algo/mesh_polygon.hpp"
#include "generators/polygons.hpp"
#include "paper/experiment.hpp"
#include "verify/verify.hpp"

namespace quadbound {
namespace {

/// Far more than polygons of these sizes take but for the sharpest.
constexpr Budget kBudget{2'000'000, 600};

template <class Counts>
std::uint64_t sum(const Counts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

void add_counters(LemmaCounters& to, const LemmaCounters& from) {
  const auto add_all = [](auto& sums, const auto& counts) {
    for (std::size_t i = 0; i < counts.size(); ++i) sums[i] += counts[i];
  };
  add_all(to.strips, from.strips);
  add_all(to.corners, from.corners);
  to.replaced_chains += from.replaced_chains;
  to.moved_feet += from.moved_feet;
  to.strips_without_case += from.strips_without_case;
  to.corners_without_case += from.corners_without_case;
  to.strips_outside += from.strips_outside;
  to.corners_outside += from.corners_outside;
  to.kites_outside += from.kites_outside;
}

/// What became of a mesh of the paper's mode.
void judge(InsertionTally& tally, const Polygon& polygon, const PolygonMesh& made) {
  add_counters(tally.pieces, *made.counters.lemmas);
  tally.kites += made.counters.kites;
  const Report report = verify_polygon(polygon, made.mesh);
  if (report.holds()) {
    ++tally.paper_proved;
    return;
  }
  for (const std::string& claim : broken_claims(report))
    if (claim != "min-angle" && claim != "max-angle") {
      ++tally.no_case[claim];
      return;
    }
  ++tally.paper_outside;
}

void add_polygon(InsertionComparison& comparison, InsertionTally& tally, const Polygon& polygon) {
  ++tally.polygons;
  const PolygonMeshResult ours = mesh_polygon(polygon, {kBudget, {}});
  const auto* mesh = std::get_if<PolygonMesh>(&ours);
  if (mesh == nullptr) {
    ++tally.ours_refused;
    return;
  }
  if (!verify_polygon(polygon, mesh->mesh).holds())
    throw std::logic_error(polygon.file + ": thm-13 fails");
  ++tally.ours_proved;
  const std::uint64_t before = tally.paper_proved;
  std::string why = "angles outside the bounds";
  const LemmaMeshResult theirs = mesh_polygon_by_lemmas(polygon, {kBudget, {}});
  if (const auto* made = std::get_if<PolygonMesh>(&theirs)) {
    judge(tally, polygon, *made);
  } else if (const auto* no_case = std::get_if<NoCase>(&theirs)) {
    ++tally.no_case[no_case->claim];
    add_counters(tally.pieces, no_case->counters);
    why = no_case->message;
  } else {
    ++tally.no_case["budget"];
    why = std::get<Refusal>(theirs).message;
  }
  if (tally.paper_proved > before) return;
  const std::uint64_t size =
      std::accumulate(polygon.rings.begin(), polygon.rings.end(), std::uint64_t{0},
                      [](std::uint64_t n, const Ring& ring) { return n + ring.size(); });
  if (!comparison.smallest.empty() && comparison.smallest_size <= size) return;
  comparison.smallest = polygon.file + ": " + why;
  comparison.smallest_size = size;
}

std::vector<std::string> cells_of(const std::string& name, const InsertionTally& t) {
  std::string no_case;
  for (const auto& [claim, count] : t.no_case)
    no_case += fmt::format("{}{} {}", no_case.empty() ? "" : ", ", claim, count);
  const auto share = [](std::uint64_t outside, std::uint64_t without_case, std::uint64_t made) {
    return fmt::format("{} + {} of {}", outside, without_case, made + without_case);
  };
  const LemmaCounters& p = t.pieces;
  return {name,
          std::to_string(t.polygons),
          std::to_string(t.ours_proved),
          std::to_string(t.paper_proved),
          std::to_string(t.paper_outside),
          no_case,
          share(p.strips_outside, p.strips_without_case, sum(p.strips)),
          share(p.corners_outside, p.corners_without_case, sum(p.corners)),
          fmt::format("{} of {}", p.kites_outside, t.kites)};
}

constexpr const char* kColumns = R"(
Each mesh is judged. *a bound broken*: min-angle or max-angle fails, and nothing else. *no case*: there is no mesh; the first
place that the paper says nothing of, by the lemma, or the claim that fails. *A_i*, *P_v*: polygons of Lemmas 11 and 12 that
no piece of theirs keeps within the bounds + those without a case, of all, also in polygons that were not meshed. *kites*:
those of Section 4 with an angle outside, of all in meshes.
)";

std::string line_of(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

}  // namespace

void InsertionTally::add(const InsertionTally& other) {
  polygons += other.polygons;
  ours_proved += other.ours_proved;
  ours_refused += other.ours_refused;
  paper_proved += other.paper_proved;
  paper_outside += other.paper_outside;
  for (const auto& [claim, count] : other.no_case) no_case[claim] += count;
  kites += other.kites;
  add_counters(pieces, other.pieces);
}

InsertionTally InsertionComparison::total() const {
  InsertionTally all;
  for (const NamedTally& row : rows) all.add(row.tally);
  return all;
}

InsertionComparison compare_insertions(std::uint64_t seeds, Watcher& watcher) {
  constexpr std::array<std::uint64_t, 2> kSizes{12, 40};
  const auto families = polygon_families();
  InsertionComparison comparison;
  watcher.stage("the paper's constructions");
  for (const FamilyDescription& family : families) {
    NamedTally row{std::string(family.name), {}};
    for (const std::uint64_t wanted : kSizes) {
      for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Recipe recipe{row.name, fitting(family.sizes, wanted), seed, {}};
        try {
          add_polygon(comparison, row.tally, generate_polygon(recipe));
        } catch (const RecipeError&) {
          continue;  // this seed has no such polygon; the number of polygons says so
        }
      }
    }
    comparison.rows.push_back(std::move(row));
    watcher.steps(comparison.rows.size(), families.size());
  }
  return comparison;
}

InsertionComparison compare_insertions(const std::vector<Polygon>& polygons, Watcher& watcher) {
  InsertionComparison comparison;
  watcher.stage("the paper's constructions");
  for (const Polygon& polygon : polygons) {
    NamedTally row{polygon.file, {}};
    add_polygon(comparison, row.tally, polygon);
    comparison.rows.push_back(std::move(row));
    watcher.steps(comparison.rows.size(), polygons.size());
  }
  return comparison;
}

std::string to_text(const InsertionComparison& comparison) {
  std::string text = line_of({"polygons", "number", "ours: proved", "paper's: proved",
                              "a bound broken", "no case", "A_i", "P_v", "kites"}) +
                     "| --- | ---: | ---: | ---: | ---: | --- | ---: | ---: | ---: |\n";
  for (const NamedTally& row : comparison.rows) text += line_of(cells_of(row.name, row.tally));
  text += line_of(cells_of("all", comparison.total()));
  if (!comparison.smallest.empty())
    text += fmt::format("\nThe smallest that the paper's constructions do not mesh: {}\n",
                        comparison.smallest);
  return text + kColumns;
}

}  // namespace quadbound
