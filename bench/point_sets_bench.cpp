// SPDX-License-Identifier: Apache-2.0
// What meshing a point set and proving the mesh cost, stage by stage and as a whole.
//
// Before anything of a point set is timed, its mesh is made and all of thm-1 proved; a stage whose
// counters differ from those of the proved mesh is not timed either.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "algo/mesh_points.hpp"
#include "algo/quadrangulation.hpp"
#include "algo/template_tree.hpp"
#include "bench/staged.hpp"
#include "generators/points.hpp"
#include "verify/verify.hpp"

namespace quadbound {
namespace {

// ---- The point sets and their proved meshes

/// What stays of the mesh once it is proved; the mesh itself would be counted as memory of the
/// stages.
struct Answer {
  bool proved = false;
  Counters counters;
  std::uint64_t quads = 0;
  std::uint64_t cells = 0;
  std::uint64_t vertices = 0;
  std::uint64_t off_lattice = 0;
};

struct PointCase {
  std::string family;
  std::uint64_t n = 0;
  PointSet points;
  Answer answer;
};

Answer proved_answer(const PointSet& points) {
  const PointMeshResult result = mesh_points(points);
  const auto* made = std::get_if<PointMesh>(&result);
  if (made == nullptr) return {};
  const Mesh& mesh = made->mesh;
  return {verify_points(points, mesh).holds(),
          made->counters,
          mesh.quads.size(),
          mesh.cells,
          mesh.vertices.size(),
          mesh.vertices.off_lattice_count()};
}

/// Only the case in use is kept, so that a filtered run does no more than it must.
const PointCase& case_of(const std::string& family, std::uint64_t n) {
  static PointCase current;
  if (current.family == family && current.n == n) return current;
  current = {family, n, generate_points(parse_point_recipe(fmt::format("{}:n={}", family, n))), {}};
  current.answer = proved_answer(current.points);
  return current;
}

// ---- Stages: `prepare` is not timed; `run` is, and so is letting go of what it returns

SeparatedTree tree_of(const PointCase& c) {
  return separate_points(place_root(c.points.points), GridRefinement::kSixBySix, {});
}

struct TreeStage {
  static constexpr std::string_view kName = "tree";
  explicit TreeStage(const PointCase& the_case) : c(the_case) {}
  void prepare() {}
  [[nodiscard]] SeparatedTree run() const { return tree_of(c); }
  [[nodiscard]] bool is_right(const SeparatedTree& made) const {
    return made.tree.blocks().size() == c.answer.counters.splits &&
           made.refinement_splits == c.answer.counters.refinement_splits;
  }
  const PointCase& c;
};

struct Quadrangulation {
  TemplateTree tree;
  Counters counters;
  Mesh mesh;
};

Quadrangulation quadrangulation_of(const SeparatedTree& separated) {
  Quadrangulation made{TemplateTree(separated.tree), {}, Mesh()};
  made.mesh = quadrangulate(made.tree, separated.tree.root(), TwoTwoVariant::kExact, made.counters);
  return made;
}

struct TemplatesStage {
  static constexpr std::string_view kName = "templates";
  explicit TemplatesStage(const PointCase& the_case) : c(the_case), separated(tree_of(the_case)) {}
  void prepare() {}
  [[nodiscard]] Quadrangulation run() const { return quadrangulation_of(separated); }
  [[nodiscard]] bool is_right(const Quadrangulation& made) const {
    const Counters& proved = c.answer.counters;
    return made.mesh.quads.size() == c.answer.quads &&
           made.mesh.vertices.size() == c.answer.vertices && made.counters.quads == proved.quads &&
           made.counters.stitch_cases == proved.stitch_cases;
  }
  const PointCase& c;
  SeparatedTree separated;
};

struct WarpingStage {
  static constexpr std::string_view kName = "warping";
  explicit WarpingStage(const PointCase& the_case)
      : c(the_case), separated(tree_of(the_case)), unwarped(quadrangulation_of(separated)) {}
  void prepare() { warped.vertices = unwarped.mesh.vertices; }
  [[nodiscard]] Counters run() {
    Counters counters;
    const std::vector<WarpSite> sites = warp_sites(site_cells(separated), unwarped.tree);
    warp(warped, c.points.points, sites, Warping::kAligned, counters);
    return counters;
  }
  [[nodiscard]] bool is_right(const Counters& made) const {
    return made.centres_aligned == c.answer.counters.centres_aligned &&
           warped.vertices.off_lattice_count() == c.answer.off_lattice;
  }
  const PointCase& c;
  SeparatedTree separated;
  Quadrangulation unwarped;
  Mesh warped;
};

struct VerificationStage {
  static constexpr std::string_view kName = "verification";
  explicit VerificationStage(const PointCase& the_case)
      : c(the_case), made(mesh_points(the_case.points)) {}
  void prepare() {}
  [[nodiscard]] Report run() const {
    return verify_points(c.points, std::get<PointMesh>(made).mesh);
  }
  [[nodiscard]] static bool is_right(const Report& report) { return report.holds(); }
  const PointCase& c;
  PointMeshResult made;
};

struct WholeStage {
  static constexpr std::string_view kName = "whole";
  explicit WholeStage(const PointCase& the_case) : c(the_case) {}
  void prepare() {}
  [[nodiscard]] std::pair<PointMeshResult, Report> run() const {
    PointMeshResult made = mesh_points(c.points);
    Report report = verify_points(c.points, std::get<PointMesh>(made).mesh);
    return {std::move(made), std::move(report)};
  }
  [[nodiscard]] bool is_right(const std::pair<PointMeshResult, Report>& made) const {
    return made.second.holds() && std::get<PointMesh>(made.first).counters == c.answer.counters;
  }
  const PointCase& c;
};

// ---- Timing

void count(benchmark::State& state, const Answer& answer) {
  set_counter(state, "quads", answer.quads);
  set_counter(state, "cells", answer.cells);
  set_counter(state, "vertices", answer.vertices);
  set_counter(state, "off_lattice", answer.off_lattice);
  set_counter(state, "splits", answer.counters.splits);
  set_counter(state, "refinement_splits", answer.counters.refinement_splits);
  set_counter(state, "extras_made", answer.counters.extras_made);
  set_counter(state, "extras_moved", answer.counters.extras_moved);
  set_counter(state, "extras_dropped", answer.counters.extras_dropped);
  set_counter(state, "centres_aligned", answer.counters.centres_aligned);
}

template <class Stage>
void time_case(benchmark::State& state, const std::string& family, std::uint64_t n) {
  const PointCase& c = case_of(family, n);
  if (!c.answer.proved) return refuse(state, "the mesh is not proved");
  Stage stage(c);
  time_stage(state, stage, c.answer.quads);
  count(state, c.answer);
}

template <class Stage>
void add_stage(const std::string& family, std::uint64_t n) {
  const std::string name = fmt::format("{}/{}/{}", Stage::kName, family, n);
  const auto time = [family, n](benchmark::State& state) { time_case<Stage>(state, family, n); };
  benchmark::RegisterBenchmark(name.c_str(), time)->Unit(benchmark::kMillisecond);
}

void add_case(const std::string& family, std::uint64_t n) {
  add_stage<TreeStage>(family, n);
  add_stage<TemplatesStage>(family, n);
  add_stage<WarpingStage>(family, n);
  add_stage<VerificationStage>(family, n);
  add_stage<WholeStage>(family, n);
}

void add_all(bool large) {
  for (const std::uint64_t n : {100U, 1'000U, 10'000U, 100'000U}) add_case("uniform", n);
  add_case("clustered", 10'000);
  if (large) add_case("uniform", 1'000'000);
}

}  // namespace
}  // namespace quadbound

int main(int argc, char** argv) {
  return quadbound::run_benchmarks(argc, argv, quadbound::add_all);
}
