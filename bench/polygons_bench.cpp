// SPDX-License-Identifier: Apache-2.0
// What meshing a polygon with holes and proving the mesh cost: as a whole, and stage by stage where
// the first round leads to it. There the times of the stages add up to that of meshing.
//
// Before anything of a polygon is timed, its mesh is made and all of thm-13 proved; a stage whose
// outcome differs from that of the proved mesh is not timed either.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "algo/corner_alignment.hpp"
#include "algo/cut_quads.hpp"
#include "algo/domain.hpp"
#include "algo/edge_cells.hpp"
#include "algo/edge_insertion.hpp"
#include "algo/edge_separation.hpp"
#include "algo/kept_quads.hpp"
#include "algo/kite_filling.hpp"
#include "algo/kites.hpp"
#include "algo/mesh_polygon.hpp"
#include "algo/strip_assembly.hpp"
#include "algo/tree_mesh.hpp"
#include "bench/staged.hpp"
#include "generators/polygons.hpp"
#include "model/mesh_shape.hpp"
#include "model/read_polygon.hpp"
#include "model/validate.hpp"
#include "verify/verify.hpp"

namespace quadbound {
namespace {

// ---- The polygons and their proved meshes

constexpr std::string_view kLake = "lake";

/// What stays of the mesh once it is proved; the mesh itself would be counted as memory of the
/// stages.
struct Answer {
  bool proved = false;
  RootSquare root;
  PolygonCounters counters;
  std::uint64_t quads = 0;
  std::uint64_t cells = 0;
  std::uint64_t vertices = 0;
  std::uint64_t off_lattice = 0;
  Report report;
  double mean_scaled_jacobian = 0;
};

struct PolygonCase {
  std::string family;
  std::uint64_t n = 0;
  Polygon polygon;
  Answer answer;
};

Answer proved_answer(const Polygon& polygon) {
  const PolygonMeshResult result = mesh_polygon(polygon);
  const auto* made = std::get_if<PolygonMesh>(&result);
  if (made == nullptr) return {};
  const Mesh& mesh = made->mesh;
  Report report = verify_polygon(polygon, mesh);
  return {report.holds(),
          made->root,
          made->counters,
          mesh.quads.size(),
          mesh.cells,
          mesh.vertices.size(),
          mesh.vertices.off_lattice_count(),
          std::move(report),
          mesh_shape(mesh).scaled_jacobian.mean()};
}

Polygon polygon_of(const std::string& family, std::uint64_t n) {
  if (family == kLake)
    return normalised(read_polygon(QUADBOUND_PAPER_DATA "/superior-303.geojson"));
  return generate_polygon(parse_polygon_recipe(fmt::format("{}:n={}", family, n)));
}

/// Only the case in use is kept, so that a filtered run does no more than it must.
const PolygonCase& case_of(const std::string& family, std::uint64_t n) {
  static PolygonCase current;
  if (current.family == family && current.n == n) return current;
  current = {family, n, polygon_of(family, n), {}};
  current.answer = proved_answer(current.polygon);
  return current;
}

// ---- The road of one round, as DomainMesher goes it

Domain domain_of(const PolygonCase& c) {
  const auto size =
      std::accumulate(c.polygon.rings.begin(), c.polygon.rings.end(), std::size_t{0},
                      [](std::size_t sum, const Ring& ring) { return sum + ring.size(); });
  return cut_kites(c.polygon, c.answer.root, std::vector<bool>(size));
}

Separation separated(const Domain& domain) {
  Separation separation(placed_vertices(domain), {});
  separation.apply_conditions();
  separation.refine_five_by_five();
  return separation;
}

/// Edge separation as far as the tree alone tells; where the edges are then.
EdgeCells separate_cells(const Domain& domain, Separation& separation) {
  for (;;) {
    EdgeCells edge_cells(domain, separation.tree());
    const std::vector<Cell> large = leaves_too_large(domain, separation.tree(), edge_cells);
    if (large.empty()) return edge_cells;
    separation.refine(large);
  }
}

/// What each step leaves to the next ones.
struct AfterTree {
  explicit AfterTree(const PolygonCase& the_case)
      : c(the_case),
        domain(domain_of(the_case)),
        separation(separated(domain)),
        edge_cells(separate_cells(domain, separation)) {}
  const PolygonCase& c;
  Domain domain;
  Separation separation;
  EdgeCells edge_cells;
};

struct AfterQuadrangulation : AfterTree {
  explicit AfterQuadrangulation(const PolygonCase& the_case)
      : AfterTree(the_case), tree_mesh(domain, separation, edge_cells, counters) {}
  Counters counters;
  TreeMesh tree_mesh;
};

struct AfterCutting : AfterQuadrangulation {
  explicit AfterCutting(const PolygonCase& the_case)
      : AfterQuadrangulation(the_case), cut_quads(domain, tree_mesh, edge_cells) {}
  CutQuads cut_quads;
};

struct AfterKeeping : AfterCutting {
  explicit AfterKeeping(const PolygonCase& the_case)
      : AfterCutting(the_case), kept(keep_quads(tree_mesh, cut_quads)) {}
  KeptQuads kept;
};

struct Insertion {
  InsertionCounters counters;
  std::vector<AlignedCentre> aligned;
  std::vector<Strip> strips;
};

Insertion insertion_of(AfterKeeping& before) {
  Insertion made;
  made.aligned = align_with_corners(before.domain, before.tree_mesh, before.cut_quads, before.kept,
                                    made.counters);
  for (const auto& alpha : before.kept.alphas) {
    auto strip =
        insert_edges(before.domain, before.tree_mesh, before.cut_quads, alpha, made.counters);
    if (auto* whole = std::get_if<Strip>(&strip)) made.strips.push_back(std::move(*whole));
  }
  return made;
}

struct AfterInsertion : AfterKeeping {
  explicit AfterInsertion(const PolygonCase& the_case)
      : AfterKeeping(the_case), insertion(insertion_of(*this)) {}
  Insertion insertion;
};

// ---- Stages: `prepare` is not timed; `run` is, and so is letting go of what it returns

struct TreeStage {
  static constexpr std::string_view kName = "tree";
  explicit TreeStage(const PolygonCase& the_case) : c(the_case) {}
  void prepare() {}
  [[nodiscard]] AfterTree run() const { return AfterTree(c); }
  [[nodiscard]] bool is_right(const AfterTree& made) const {
    return made.separation.tree().leaf_count() == c.answer.cells;
  }
  const PolygonCase& c;
};

struct Quadrangulation {
  explicit Quadrangulation(const AfterTree& before)
      : tree_mesh(before.domain, before.separation, before.edge_cells, counters) {}
  Counters counters;
  TreeMesh tree_mesh;
};

struct QuadrangulationStage : AfterTree {
  static constexpr std::string_view kName = "quadrangulation";
  using AfterTree::AfterTree;
  void prepare() {}
  [[nodiscard]] Quadrangulation run() const { return Quadrangulation(*this); }
  [[nodiscard]] bool is_right(const Quadrangulation& made) const {
    return made.counters == c.answer.counters.quadtree;
  }
};

/// Includes the last look for faults of edge separation.
struct CuttingStage : AfterQuadrangulation {
  static constexpr std::string_view kName = "cutting";
  using AfterQuadrangulation::AfterQuadrangulation;
  void prepare() {}
  [[nodiscard]] std::pair<CutQuads, std::size_t> run() const {
    CutQuads made(domain, tree_mesh, edge_cells);
    const std::size_t faults = separation_faults(domain, tree_mesh, made).size();
    return {std::move(made), faults};
  }
  [[nodiscard]] static bool is_right(const std::pair<CutQuads, std::size_t>& made) {
    return made.second == 0;
  }
};

struct KeepingStage : AfterCutting {
  static constexpr std::string_view kName = "keeping";
  using AfterCutting::AfterCutting;
  void prepare() {}
  [[nodiscard]] KeptQuads run() const { return keep_quads(tree_mesh, cut_quads); }
  [[nodiscard]] bool is_right(const KeptQuads& made) const {
    const auto count = std::count(made.is_kept.begin(), made.is_kept.end(), true);
    return made.pinched.empty() &&
           static_cast<std::uint64_t>(count) == c.answer.counters.kept_quads;
  }
};

struct InsertionStage : AfterKeeping {
  static constexpr std::string_view kName = "insertion";
  using AfterKeeping::AfterKeeping;
  /// The centres that the last run aligned go back.
  void prepare() {
    for (const auto& [centre, before] : before_run) tree_mesh.move_to(centre, before);
  }
  [[nodiscard]] Insertion run() {
    Insertion made = insertion_of(*this);
    if (before_run.empty())
      for (const AlignedCentre& a : made.aligned) before_run.emplace_back(a.centre, a.before);
    return made;
  }
  [[nodiscard]] bool is_right(const Insertion& made) const {
    return made.strips.size() == kept.alphas.size() &&
           made.counters.moves == c.answer.counters.insertion.moves &&
           made.counters.alpha_vertices_by_level ==
               c.answer.counters.insertion.alpha_vertices_by_level;
  }
  std::vector<std::pair<VertexId, LatticePoint>> before_run;
};

/// There are no kites to be filled. What becomes of Q is a copy.
struct AssemblyStage : AfterInsertion {
  static constexpr std::string_view kName = "assembly";
  using AfterInsertion::AfterInsertion;
  void prepare() { q = tree_mesh.mesh(); }
  [[nodiscard]] DomainMesh run() {
    return assemble(domain, separation.tree(), std::move(q), kept, insertion.strips);
  }
  [[nodiscard]] bool is_right(const DomainMesh& made) const {
    return made.mesh.quads.size() == c.answer.quads &&
           made.mesh.vertices.size() == c.answer.vertices;
  }
  Mesh q;
};

struct MeshingStage {
  static constexpr std::string_view kName = "meshing";
  explicit MeshingStage(const PolygonCase& the_case) : c(the_case) {}
  void prepare() {}
  [[nodiscard]] PolygonMeshResult run() const { return mesh_polygon(c.polygon); }
  [[nodiscard]] bool is_right(const PolygonMeshResult& made) const {
    return std::get<PolygonMesh>(made).mesh.quads.size() == c.answer.quads;
  }
  const PolygonCase& c;
};

struct VerificationStage {
  static constexpr std::string_view kName = "verification";
  explicit VerificationStage(const PolygonCase& the_case)
      : c(the_case), made(mesh_polygon(the_case.polygon)) {}
  void prepare() {}
  [[nodiscard]] Report run() const {
    return verify_polygon(c.polygon, std::get<PolygonMesh>(made).mesh);
  }
  [[nodiscard]] static bool is_right(const Report& report) { return report.holds(); }
  const PolygonCase& c;
  PolygonMeshResult made;
};

struct WholeStage {
  static constexpr std::string_view kName = "whole";
  explicit WholeStage(const PolygonCase& the_case) : c(the_case) {}
  void prepare() {}
  [[nodiscard]] std::pair<PolygonMeshResult, Report> run() const {
    PolygonMeshResult made = mesh_polygon(c.polygon);
    Report report = verify_polygon(c.polygon, std::get<PolygonMesh>(made).mesh);
    return {std::move(made), std::move(report)};
  }
  [[nodiscard]] bool is_right(const std::pair<PolygonMeshResult, Report>& made) const {
    return made.second.holds() && made.second.quads == c.answer.quads;
  }
  const PolygonCase& c;
};

// ---- Timing

void count(benchmark::State& state, const Answer& answer) {
  const PolygonCounters& counters = answer.counters;
  set_counter(state, "quads", answer.quads);
  set_counter(state, "cells", answer.cells);
  set_counter(state, "vertices", answer.vertices);
  set_counter(state, "off_lattice", answer.off_lattice);
  set_counter(state, "splits", counters.quadtree.splits);
  set_counter(state, "cells_before", counters.cells_before);
  set_counter(state, "rounds", counters.rounds);
  set_counter(state, "separation_splits", counters.separation_splits);
  set_counter(state, "dead_end_splits", counters.dead_end_splits);
  set_counter(state, "kite_splits", counters.kite_splits);
  set_counter(state, "restarts", counters.restarts);
  set_counter(state, "kites", counters.kites);
  set_counter(state, "kept_quads", counters.kept_quads);
  set_counter(state, "centres_aligned", counters.insertion.moves);
  set_angles(state, answer.report);
  state.counters["mean_scaled_jacobian"] = benchmark::Counter(answer.mean_scaled_jacobian);
}

template <class Stage>
void time_case(benchmark::State& state, const std::string& family, std::uint64_t n) {
  const PolygonCase& c = case_of(family, n);
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

/// For all polygons.
void add_whole(const std::string& family, std::uint64_t n) {
  add_stage<MeshingStage>(family, n);
  add_stage<VerificationStage>(family, n);
  add_stage<WholeStage>(family, n);
}

/// For polygons that are meshed in one round and without kites.
void add_stages(const std::string& family, std::uint64_t n) {
  add_stage<TreeStage>(family, n);
  add_stage<QuadrangulationStage>(family, n);
  add_stage<CuttingStage>(family, n);
  add_stage<KeepingStage>(family, n);
  add_stage<InsertionStage>(family, n);
  add_stage<AssemblyStage>(family, n);
  add_whole(family, n);
}

void add_all(bool large) {
  for (const char* family : {"regular", "blob"})
    for (const std::uint64_t n : {100U, 1'000U, 10'000U, 100'000U}) add_stages(family, n);
  for (const std::uint64_t n : {1'000U, 10'000U}) add_whole("comb", n);
  add_whole(std::string(kLake), 303);
  add_whole("coast", 10'000);
  if (!large) return;
  add_whole("coast", 100'000);
  add_whole("regular", 1'000'000);
}

}  // namespace
}  // namespace quadbound

int main(int argc, char** argv) {
  return quadbound::run_benchmarks(argc, argv, quadbound::add_all);
}
