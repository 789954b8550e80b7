// SPDX-License-Identifier: Apache-2.0
#include "paper/experiment.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <utility>
#include <variant>

#include "generators/points.hpp"

namespace quadbound {
namespace {

double ratio(std::uint64_t a, std::uint64_t b) {
  return static_cast<double>(a) / static_cast<double>(b);
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

/// Only asked of meshes that broke a bound, so rationals are fast enough.
std::uint64_t count_corners_beyond(const Mesh& mesh) {
  std::uint64_t count = 0;
  for (const Quad& quad : mesh.quads) {
    std::array<RationalPoint, 4> at;
    for (std::size_t i = 0; i < 4; ++i) at[i] = mesh.vertices.exact(quad[i]);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto corner = corner_at<Rational>(at[i], at[(i + 1) % 4], at[(i + 3) % 4]);
      if (!within(corner, kTheorem1)) ++count;
    }
  }
  return count;
}

}  // namespace

double Measurement::cells_per_point() const { return ratio(cells, points); }
double Measurement::quads_per_cell() const { return ratio(quads, cells); }

PointSet points_of(const Trial& trial, std::uint64_t n) {
  return generate_points(
      parse_point_recipe(fmt::format("{}:n={},seed={}", trial.set, n, trial.seed.value())));
}

JudgedMesh run_trial(const Trial& trial, const PointSet& points, unsigned threads) {
  PointMeshOptions options;
  options.refinement = trial.refinement;
  options.warping = trial.warping;
  PointMeshResult result = mesh_points(points, options);
  if (const auto* refusal = std::get_if<Refusal>(&result))
    throw std::runtime_error(points.file + ": " + refusal->message);
  JudgedMesh judged;
  judged.mesh = std::move(std::get<PointMesh>(result).mesh);
  VerifyOptions verify;
  verify.threads = threads;
  judged.report = verify_points(points, judged.mesh, verify);
  Measurement& m = judged.measurement;
  m.trial = trial;
  m.points = points.points.size();
  m.cells = judged.mesh.cells;
  m.vertices = judged.mesh.vertices.size();
  m.quads = judged.mesh.quads.size();
  m.smallest = worst_corner(judged.report, "min-angle");
  m.largest = worst_corner(judged.report, "max-angle");
  m.broken = broken_claims(judged.report);
  if (!m.proved()) m.corners_beyond = count_corners_beyond(judged.mesh);
  return judged;
}

}  // namespace quadbound
