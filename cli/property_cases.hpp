// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the properties share: random inputs from recipes, how they shrink, and which constructions a
// property has reached. Tests only.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algo/mesh_points.hpp"
#include "algo/mesh_polygon.hpp"
#include "generators/points.hpp"
#include "generators/polygons.hpp"
#include "verify/report.hpp"

namespace quadbound::cli {

// --- inputs --------------------------------------------------------------------------------------

/// A polygon of a recipe, or what shrinking left of one; valid and normalised.
struct PolygonSample {
  std::optional<PolygonRecipe> recipe;
  Polygon polygon;
};

/// A point set of a recipe, or what shrinking left of one; valid.
struct PointSample {
  std::optional<PointRecipe> recipe;
  PointSet points;
};

/// All families alike; outer rings of up to 36 vertices, more for larger sizes, a few holes.
/// Guarantees: 1. depends on the random bits and the size alone. 2. A sample shrinks to smaller
/// recipes of its family first, and then to polygons without one of its holes or vertices (sets
/// without some of their points), all of them valid.
rc::Gen<PolygonSample> any_polygon();
/// The same for points; up to 60 of them.
rc::Gen<PointSample> any_point_set();

/// The recipe; where there is none any more, the polygon as WKT and the points as CSV.
void showValue(const PolygonSample& sample, std::ostream& stream);
void showValue(const PointSample& sample, std::ostream& stream);

// --- what is done with them ----------------------------------------------------------------------

/// Few enough cells for a test; larger meshes are no cases of a property.
inline constexpr std::uint64_t kMostCells = 15'000;

/// Nothing where the mesh would be larger than kMostCells; any other refusal fails the property,
/// and so does one of several lines.
std::optional<PolygonMesh> meshed(const Polygon& polygon);
/// Nothing, too, where points are too close for exact coordinates: some families put them a unit in
/// the last place apart.
std::optional<PointMesh> meshed(const PointSet& points,
                                GridRefinement refinement = GridRefinement::kSixBySix);

/// The claims that do not hold; empty where all do.
std::string broken_claims(const Report& report);

std::string json_text(const Mesh& mesh);

bool is_one_line(const std::string& text);

template <class Map>
Polygon mapped(Polygon polygon, Map map) {
  for (Ring& ring : polygon.rings)
    for (Point& p : ring) p = map(p);
  return polygon;
}

template <class Map>
PointSet mapped(PointSet points, Map map) {
  for (Point& p : points.points) p = map(p);
  return points;
}

// --- what was reached ----------------------------------------------------------------------------

/// Counts the cases of a property that reached each construction of the paper.
class Reached {
 public:
  enum class Of { kPoints, kPolygons };
  /// Zero for every template, stitching case and quad of Section 2 and, for polygons, of Sections 3
  /// and 4. A kite as one quad is left out: one polygon in some thousand has it.
  explicit Reached(Of input);

  void add(const PolygonMesh& made);
  void add(const PointMesh& made);
  /// Counts a case by any other name, which is expected from now on.
  void expect(const std::string& name) { cases_.try_emplace(name, 0); }
  void add(const std::string& name) { ++cases_[name]; }

  /// The names without a case.
  [[nodiscard]] std::vector<std::string> never() const;
  /// The rarest ones, for a person who weighs how many cases a property needs.
  [[nodiscard]] std::string rarest() const;

 private:
  void add(const Counters& counters, const Mesh& mesh);
  std::map<std::string, std::uint64_t> cases_;
};

/// Checks a property as RC_GTEST_PROP does, with `percent` of RC_PARAMS' max_success (100) as the
/// number of cases, and that all of `reached` was reached.
template <class Property>
void check_property(int percent, const Reached& reached, Property&& property) {
  const auto* const info = testing::UnitTest::GetInstance()->current_test_info();
  rc::detail::TestMetadata metadata;
  metadata.id = std::string(info->test_suite_name()) + '/' + info->name();
  metadata.description = info->name();
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  params.maxSuccess = params.maxSuccess * percent / 100;
  const auto result = rc::detail::checkTestable(std::forward<Property>(property), metadata, params);
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  ASSERT_TRUE(result.template is<rc::detail::SuccessResult>()) << text.str();
  EXPECT_EQ(reached.never(), std::vector<std::string>{});
  testing::Test::RecordProperty("rarest", reached.rarest());
}

}  // namespace quadbound::cli

template <>
struct rc::Arbitrary<quadbound::cli::PolygonSample> {
  static Gen<quadbound::cli::PolygonSample> arbitrary() { return quadbound::cli::any_polygon(); }
};

template <>
struct rc::Arbitrary<quadbound::cli::PointSample> {
  static Gen<quadbound::cli::PointSample> arbitrary() { return quadbound::cli::any_point_set(); }
};
