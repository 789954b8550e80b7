// SPDX-License-Identifier: Apache-2.0
#pragma once
// Damage to meshes and to what they were made for, at random.

#include <random>
#include <span>
#include <vector>

#include "verify/test_meshes.hpp"

namespace quadbound::test {

using Random = std::mt19937_64;

inline std::size_t pick(Random& random, std::size_t count) { return random() % count; }

struct Mutation {
  const char* name;
  /// Requires: a mesh with quads, all of whose vertices exist.
  void (*damage)(Case&, Random&);
  /// Least share of mutants, in percent, that must change a verdict; 0 for no damage: none may.
  int effective_percent;
};

std::vector<Mutation> mutations_for_points();
std::vector<Mutation> mutations_for_polygons();

}  // namespace quadbound::test
