// SPDX-License-Identifier: Apache-2.0
#pragma once
// One mesh of a point set, measured and judged.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algo/mesh_points.hpp"
#include "model/angle.hpp"
#include "verify/verify.hpp"

namespace quadbound {

/// What is meshed and how.
struct Trial {
  /// Family of random points, with a space and NAME=VALUE for a parameter; or a real set's name.
  std::string set;
  std::optional<std::uint64_t> seed;  ///< empty for real sets
  GridRefinement refinement = GridRefinement::kSixBySix;
  Warping warping = Warping::kAligned;
  TwoTwoVariant two_two = TwoTwoVariant::kExact;
};

struct Measurement {
  Trial trial;
  std::uint64_t points = 0;  ///< n
  std::uint64_t cells = 0;   ///< N
  std::uint64_t vertices = 0;
  std::uint64_t quads = 0;
  Corner<Rational> smallest;  ///< extreme corners of the mesh
  Corner<Rational> largest;
  Corner<Rational>
      smallest_at_points;  ///< with Warping::kPaper only: of the quads that have an input point
  Corner<Rational> largest_at_points;
  std::uint64_t corners_beyond = 0;  ///< outside thm-1's interval
  std::vector<std::string> broken;   ///< ids of the claims that do not hold; empty: thm-1 proved

  [[nodiscard]] bool proved() const { return broken.empty(); }
  [[nodiscard]] double cells_per_point() const;  ///< N / n
  [[nodiscard]] double quads_per_cell() const;
};

struct JudgedMesh {
  Measurement measurement;
  Mesh mesh;
  Report report;
};

/// The random points of a trial. Requires: trial.seed; the family is one of point_families().
PointSet points_of(const Trial& trial, std::uint64_t n);

/// Meshes and judges.
/// Guarantees: 1. the same points and trial give the same result, whatever the threads.
/// Errors: std::runtime_error with the mesher's refusal.
JudgedMesh run_trial(const Trial& trial, const PointSet& points, unsigned threads);

/// The extreme corner of an angle claim. Errors: std::runtime_error where the report has none.
Corner<Rational> worst_corner(const Report& report, std::string_view id);

/// Ids of the claims that do not hold, but for the theorem, their conjunction.
std::vector<std::string> broken_claims(const Report& report);

}  // namespace quadbound
