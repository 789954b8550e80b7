// SPDX-License-Identifier: Apache-2.0
#pragma once
// A second judge for the tests: slow, short, and written with CGAL's exact kernel instead of our
// own arithmetic; the claims are checked by definition, not by proof.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "verify/verify.hpp"

namespace quadbound::test {

struct NaiveReport {
  /// no-overlap is decided for all meshes of strictly convex quads, and not-decided for others.
  std::map<std::string, Verdict> exact;
  std::map<std::string, StoredVerdict> stored;
  using Corner = std::pair<std::uint64_t, int>;  ///< quad and corner
  std::optional<Corner> smallest;                ///< of those that the bounds judge
  std::optional<Corner> largest;
  std::set<Corner> whole;  ///< whole input angles of a polygon
};

/// Requires: all rounded coordinates are finite. Complexity: quadratic.
NaiveReport naive_judge(const PointSet& points, const Mesh& mesh);
NaiveReport naive_judge(const Polygon& polygon, const Mesh& mesh);

}  // namespace quadbound::test
