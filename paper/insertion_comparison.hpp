// SPDX-License-Identifier: Apache-2.0
#pragma once
// thm-13 as written: how many polygons the paper's own constructions (Lemmas 11 and 12 by their
// cases, Section 4) mesh within the bounds, against ours.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "algo/insertion_by_lemmas.hpp"
#include "model/polygon.hpp"
#include "paper/watcher.hpp"

namespace quadbound {

/// Of one kind of polygons.
struct InsertionTally {
  std::uint64_t polygons = 0;
  std::uint64_t ours_proved = 0;
  std::uint64_t ours_refused = 0;  ///< a budget ran out; the paper's mode was not tried
  std::uint64_t paper_proved = 0;
  std::uint64_t paper_outside = 0;  ///< a mesh that breaks a bound, all other claims hold
  std::map<std::string, std::uint64_t> no_case;  ///< by the id of the claim; or of a broken claim
  std::uint64_t kites = 0;                       ///< of the meshes
  LemmaCounters pieces;  ///< of all polygons, but for kites where there is no mesh

  void add(const InsertionTally& other);
};

struct NamedTally {
  std::string name;
  InsertionTally tally;
};

struct InsertionComparison {
  std::vector<NamedTally> rows;
  /// With the fewest vertices that ours meshes and the paper's mode does not: its recipe or file,
  /// and why.
  std::string smallest;
  std::uint64_t smallest_size = 0;
  [[nodiscard]] InsertionTally total() const;
};

/// All families at about 12 and 40 vertices, `seeds` polygons each.
/// Guarantees: 1. depends on the arguments alone. Errors: std::logic_error where a mesh of ours is
/// not proved. Complexity: some 10 ms a polygon.
InsertionComparison compare_insertions(std::uint64_t seeds, Watcher& watcher);
/// The same for polygons of files, one row each.
InsertionComparison compare_insertions(const std::vector<Polygon>& polygons, Watcher& watcher);

/// Markdown tables.
std::string to_text(const InsertionComparison& comparison);

}  // namespace quadbound
