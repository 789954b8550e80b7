// SPDX-License-Identifier: Apache-2.0
#include "paper/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <unordered_set>
#include <utility>
#include <variant>

#include "generators/points.hpp"
#include "paper/theorem_1_table.hpp"

namespace quadbound {
namespace {

double ratio(std::uint64_t a, std::uint64_t b) {
  return static_cast<double>(a) / static_cast<double>(b);
}

/// Corner i of a quad.
Corner<Rational> corner_of(const Mesh& mesh, const Quad& quad, std::size_t i) {
  return corner_at<Rational>(mesh.vertices.exact(quad[i]), mesh.vertices.exact(quad[(i + 1) % 4]),
                             mesh.vertices.exact(quad[(i + 3) % 4]));
}

/// Only asked of meshes that broke a bound, so rationals are fast enough.
std::uint64_t count_corners_beyond(const Mesh& mesh) {
  std::uint64_t count = 0;
  for (const Quad& quad : mesh.quads)
    for (std::size_t i = 0; i < 4; ++i)
      if (!within(corner_of(mesh, quad, i), kTheorem1)) ++count;
  return count;
}

void note_corner(Measurement& m, const Corner<Rational>& corner) {
  if (m.smallest_at_points.cross == 0) m.smallest_at_points = m.largest_at_points = corner;
  if (smaller_angle(corner, m.smallest_at_points)) m.smallest_at_points = corner;
  if (smaller_angle(m.largest_at_points, corner)) m.largest_at_points = corner;
}

/// Requires: no corner is straight or reflex.
void measure_at_points(Measurement& m, const PointMesh& made) {
  const std::unordered_set<VertexId> points(made.vertex_of_point.begin(),
                                            made.vertex_of_point.end());
  for (const Quad& quad : made.mesh.quads) {
    if (std::none_of(quad.begin(), quad.end(), [&](VertexId v) { return points.count(v) != 0; }))
      continue;
    for (std::size_t i = 0; i < 4; ++i) note_corner(m, corner_of(made.mesh, quad, i));
  }
}

}  // namespace

double Measurement::cells_per_point() const { return ratio(cells, points); }
double Measurement::quads_per_cell() const { return ratio(quads, cells); }

PointSet points_of(const Trial& trial, std::uint64_t n) {
  const std::size_t space = trial.set.find(' ');
  std::string recipe =
      fmt::format("{}:n={},seed={}", trial.set.substr(0, space), n, trial.seed.value());
  if (space != std::string::npos) recipe += "," + trial.set.substr(space + 1);
  return generate_points(parse_point_recipe(recipe));
}

JudgedMesh run_trial(const Trial& trial, const PointSet& points, unsigned threads) {
  PointMeshOptions options;
  options.refinement = trial.refinement;
  options.warping = trial.warping;
  options.two_two = trial.two_two;
  PointMeshResult result = mesh_points(points, options);
  if (const auto* refusal = std::get_if<Refusal>(&result))
    throw std::runtime_error(points.file + ": " + refusal->message);
  PointMesh& made = std::get<PointMesh>(result);
  JudgedMesh judged;
  VerifyOptions verify;
  verify.threads = threads;
  judged.report = verify_points(points, made.mesh, verify);
  Measurement& m = judged.measurement;
  m.trial = trial;
  m.points = points.points.size();
  m.cells = made.mesh.cells;
  m.vertices = made.mesh.vertices.size();
  m.quads = made.mesh.quads.size();
  m.smallest = worst_corner(judged.report, "min-angle");
  m.largest = worst_corner(judged.report, "max-angle");
  m.broken = broken_claims(judged.report);
  if (!m.proved()) m.corners_beyond = count_corners_beyond(made.mesh);
  if (trial.warping == Warping::kPaper) measure_at_points(m, made);
  judged.mesh = std::move(made.mesh);
  return judged;
}

Corner<Rational> worst_corner(const Report& report, std::string_view id) {
  const Claim* claim = report.find(id);
  if (claim == nullptr || !claim->worst)
    throw std::runtime_error(fmt::format("the report has no extreme corner for {}", id));
  return {claim->worst->cross, claim->worst->dot};
}

std::vector<std::string> broken_claims(const Report& report) {
  std::vector<std::string> broken;
  for (const Claim& claim : report.claims)
    if (claim.exact != Verdict::holds && claim.id != report.theorem) broken.push_back(claim.id);
  return broken;
}

}  // namespace quadbound
