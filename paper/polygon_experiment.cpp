// SPDX-License-Identifier: Apache-2.0
#include "paper/polygon_experiment.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "algo/construction.hpp"
#include "algo/mesh_polygon.hpp"
#include "model/validate.hpp"
#include "paper/experiment.hpp"

namespace quadbound {

double PolygonMeasurement::quads_per_cell() const {
  return static_cast<double>(quads) / static_cast<double>(cells);
}

JudgedPolygonMesh judge_polygon_mesh(const Polygon& polygon, unsigned threads) {
  Polygon input = normalised(polygon);
  PolygonMeshResult result = mesh_polygon(input);
  if (const auto* refusal = std::get_if<Refusal>(&result))
    throw std::runtime_error(input.file + ": " + refusal->message);
  PolygonMesh& made = std::get<PolygonMesh>(result);
  VerifyOptions verify;
  verify.threads = threads;
  Report report = verify_polygon(input, made.mesh, verify);
  const PolygonFacts& facts = report.polygon.value();
  PolygonMeasurement m{input.file,
                       made.mesh.input_vertices,
                       made.mesh.cells,
                       made.mesh.vertices.size(),
                       made.mesh.quads.size(),
                       worst_corner(report, "min-angle"),
                       worst_corner(report, "max-angle"),
                       facts.whole_corners,
                       made.counters.kites,
                       made.counters.cells_before,
                       made.counters.rounds,
                       made.counters.kept_quads,
                       mesh_shape(made.mesh),
                       broken_claims(report)};
  return {std::move(input), std::move(m), std::move(made.mesh), std::move(report)};
}

std::uint64_t quads_made_by(const Mesh& mesh, std::string_view construction) {
  const auto found =
      std::find(mesh.construction_names.begin(), mesh.construction_names.end(), construction);
  if (found == mesh.construction_names.end()) return 0;
  const auto number = static_cast<std::uint8_t>(found - mesh.construction_names.begin());
  return static_cast<std::uint64_t>(
      std::count(mesh.construction.begin(), mesh.construction.end(), number));
}

Mesh without_strips(const Mesh& mesh) {
  Mesh kept = mesh;
  kept.quads.clear();
  kept.construction.clear();
  kept.level.clear();
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    if (mesh.construction[i] >= kConstructionCount) continue;
    kept.quads.push_back(mesh.quads[i]);
    kept.construction.push_back(mesh.construction[i]);
    if (!mesh.level.empty()) kept.level.push_back(mesh.level[i]);
  }
  return kept;
}

}  // namespace quadbound
