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
#include "bench/resident_memory.hpp"
#include "generators/points.hpp"
#include "verify/verify.hpp"

namespace quadbound {
namespace {

#if defined(__clang__)
constexpr const char* kCompiler = __VERSION__;  // names itself
#else
constexpr const char* kCompiler = "GCC " __VERSION__;
#endif

bool all_right = true;

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
  const auto set = [&state](const char* name, std::uint64_t value) {
    state.counters[name] = benchmark::Counter(static_cast<double>(value));
  };
  set("quads", answer.quads);
  set("cells", answer.cells);
  set("vertices", answer.vertices);
  set("off_lattice", answer.off_lattice);
  set("splits", answer.counters.splits);
  set("refinement_splits", answer.counters.refinement_splits);
  set("extras_made", answer.counters.extras_made);
  set("extras_moved", answer.counters.extras_moved);
  set("extras_dropped", answer.counters.extras_dropped);
  set("centres_aligned", answer.counters.centres_aligned);
  using Flags = benchmark::Counter;
  const auto quads = static_cast<double>(answer.quads);
  state.counters["quads_per_second"] = Flags(quads, Flags::kIsIterationInvariantRate);
  state.counters["time_per_quad"] = Flags(quads, Flags::kIsIterationInvariantRate | Flags::kInvert);
}

/// Below this many quads the peak is lost in what the process holds anyway.
constexpr std::uint64_t kFewQuads = 100'000;

/// Runs the stage once outside the timing: its answer must be right, and its peak of memory is
/// taken.
template <class Stage>
bool passes_trial(benchmark::State& state, Stage& stage, const Answer& answer) {
  stage.prepare();
  const ResidentPeak peak;
  const auto made = stage.run();
  const auto bytes = peak.beyond_start();
  if (bytes && answer.quads >= kFewQuads)
    state.counters["peak_bytes_per_quad"] =
        static_cast<double>(*bytes) / static_cast<double>(answer.quads);
  return stage.is_right(made);
}

void refuse(benchmark::State& state, const char* why) {
  all_right = false;
  state.SkipWithError(why);
}

template <class Stage>
void time_stage(benchmark::State& state, const std::string& family, std::uint64_t n) {
  const PointCase& c = case_of(family, n);
  if (!c.answer.proved) return refuse(state, "the mesh is not proved");
  Stage stage(c);
  if (!passes_trial(state, stage, c.answer)) return refuse(state, "the stage differs");
  for (auto _ : state) {
    state.PauseTiming();
    stage.prepare();
    state.ResumeTiming();
    auto made = stage.run();
    benchmark::DoNotOptimize(made);
  }
  count(state, c.answer);
}

template <class Stage>
void add_stage(const std::string& family, std::uint64_t n) {
  const std::string name = fmt::format("{}/{}/{}", Stage::kName, family, n);
  const auto time = [family, n](benchmark::State& state) { time_stage<Stage>(state, family, n); };
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

/// Takes `--large` off the arguments.
bool wants_large(int& argc, char** argv) {
  int kept = 1;
  bool found = false;
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--large") {
      found = true;
    } else {
      argv[kept++] = argv[i];
    }
  }
  argc = kept;
  return found;
}

}  // namespace
}  // namespace quadbound

int main(int argc, char** argv) {
  const bool large = quadbound::wants_large(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::AddCustomContext("compiler", quadbound::kCompiler);
  quadbound::add_all(large);
  // A filter that matches nothing would time nothing for ever.
  if (benchmark::RunSpecifiedBenchmarks() == 0) return 2;
  benchmark::Shutdown();
  return quadbound::all_right ? 0 : 1;
}
