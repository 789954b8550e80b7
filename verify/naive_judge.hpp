// SPDX-License-Identifier: Apache-2.0
#pragma once
// A second judge for the tests: slow, short, and written with CGAL's exact kernel instead of our
// own arithmetic; the claims are checked by definition, not by proof.

#include <map>
#include <string>
#include <utility>

#include "verify/verify.hpp"

namespace quadbound::test {

struct NaiveReport {
  /// no-overlap is decided for all meshes of strictly convex quads, and not-decided for others.
  std::map<std::string, Verdict> exact;
  std::map<std::string, StoredVerdict> stored;
  std::pair<std::uint64_t, int> smallest;  ///< quad and corner
  std::pair<std::uint64_t, int> largest;
};

/// Requires: all rounded coordinates are finite. Complexity: quadratic.
NaiveReport naive_judge(const PointSet& points, const Mesh& mesh);

}  // namespace quadbound::test
