// SPDX-License-Identifier: Apache-2.0
#pragma once
// The paper's numbers, measured: Fig. 10, N against n (80n), Theorem 1 case by case, the paper's
// own warping, and the polygons of Figures 46 to 53. Nothing is written here; paper/reproduce.hpp
// does.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "paper/experiment.hpp"
#include "paper/lemma_audits.hpp"
#include "paper/polygon_experiment.hpp"
#include "paper/theorem_1_table.hpp"
#include "paper/watcher.hpp"

namespace quadbound {

struct StepTime {
  std::string step;
  double seconds = 0;
};

/// Measurements that differ in the seed only.
struct Group {
  std::string set;
  std::uint64_t points = 0;
  GridRefinement refinement = GridRefinement::kSixBySix;
  std::vector<Measurement> runs;

  [[nodiscard]] double smallest_ratio() const;  ///< of N / n
  [[nodiscard]] double mean_ratio() const;
  [[nodiscard]] double largest_ratio() const;
  [[nodiscard]] double largest_quads_per_cell() const;
  [[nodiscard]] Corner<Rational> smallest() const;
  [[nodiscard]] Corner<Rational> largest() const;
  [[nodiscard]] bool proved() const;
};

/// A mesh of Sections 3 and 4.
struct PolygonFigure {
  std::string id;   ///< fig-46, ...; or plate, the picture of README.md
  std::string how;  ///< the command that makes the polygon, or its file
  JudgedPolygonMesh judged;
};

struct Reproduction {
  std::optional<JudgedMesh> lake;  ///< Fig. 10; always there once measured
  PointSet lake_points;
  /// The same points with the paper's own case 2,2 (Fig. 8a).
  Measurement lake_with_their_case;
  std::vector<Group> groups;        ///< in the order of the tables
  std::vector<Measurement> warped;  ///< the paper's warping on random sets
  Theorem1Table theorem_1;
  std::vector<PolygonFigure> polygons;  ///< fig-46, fig-49, fig-50, plate
  std::optional<JudgedMesh> fig_47;     ///< of fig-46's vertices; always there once measured
  LemmaAudits lemmas;
  std::vector<StepTime> times;

  /// thm-1: every mesh with our warping is proved, and every configuration. thm-13: every mesh of a
  /// polygon is proved. The lemmas' audit found what it is said to find.
  [[nodiscard]] bool holds() const;
  /// Requires: an id of `polygons`.
  [[nodiscard]] const JudgedPolygonMesh& polygon(std::string_view id) const;
  /// The group of that name, size and grid; nullptr where it was not measured.
  [[nodiscard]] const Group* find(const std::string& set, std::uint64_t points,
                                  GridRefinement refinement) const;
};

struct MeasureOptions {
  std::string data;  ///< folder with superior-303.csv, .geojson; coast-*.csv are welcome
  std::uint64_t max_n = 100'000;  ///< of the random sets
  std::uint64_t trees = 500;      ///< of the census
  std::uint64_t audits = 8000;    ///< trees of the lemmas' audit
  unsigned threads = 1;           ///< of the judge
};

/// The sizes of a run that takes long: `quadbound reproduce --full`.
MeasureOptions full_measure_options();

/// Guarantees: 1. all but `times` depends on the options alone, and not on the threads.
/// Errors: InputError where a file of Lake Superior is missing, or a file is not what it should be.
/// Complexity: some 40 s on one core at max_n = 100,000, growing linearly; 0.5 GB.
Reproduction measure(const MeasureOptions& options, Watcher& watcher);

}  // namespace quadbound
