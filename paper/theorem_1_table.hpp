// SPDX-License-Identifier: Apache-2.0
#pragma once
// thm-1 as a table: the configurations of a quad, each proved, and how often random meshes met it.

#include <cstdint>
#include <string>
#include <string_view>

#include "algo/theorem_1.hpp"
#include "paper/watcher.hpp"

namespace quadbound {

struct Theorem1Table {
  ConfigurationCensus census;
  std::uint64_t trees = 0;  ///< random trees, and as many point sets

  /// Every configuration is proved; none was met that is not listed; and, where there are trees,
  /// each was met.
  [[nodiscard]] bool holds() const;
  /// The extreme corners of all configurations, or of those of one construction, warped or not.
  enum class Of : std::uint8_t { kAll, kStill, kWarped };
  [[nodiscard]] Corner<Rational> smallest(Of which = Of::kAll,
                                          std::string_view construction = {}) const;
  [[nodiscard]] Corner<Rational> largest(Of which = Of::kAll,
                                         std::string_view construction = {}) const;
};

/// Random trees reach the templates and stitching cases, point sets the warped quads.
/// Guarantees: 1. the same number of trees gives the same table. Complexity: about 10 ms per tree.
Theorem1Table make_theorem_1_table(std::uint64_t trees, Watcher& watcher);

/// For a terminal: one line per configuration.
std::string to_text(const Theorem1Table& table);

/// Whether the angle at one corner is smaller. Requires: both lie strictly between 0 and 180
/// degrees.
bool smaller_angle(const Corner<Rational>& a, const Corner<Rational>& b);

/// In degrees, for readers.
double degrees(const Corner<Rational>& corner);

}  // namespace quadbound
