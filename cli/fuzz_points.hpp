// SPDX-License-Identifier: Apache-2.0
#pragma once
// Random point sets and what the mesher and the judge make of them; behind `quadbound fuzz`. Prints
// nothing.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "algo/mesh_points.hpp"
#include "generators/points.hpp"
#include "model/angle.hpp"

namespace quadbound::cli {

/// What is done to the points of a recipe, in this order. Only the offset rounds.
struct PointTransform {
  Point offset;
  bool swap_axes = false;
  bool negate_x = false;
  bool negate_y = false;
  int exponent = 0;  ///< scaled by 2^exponent
};

/// "offset=(1e6,0) swap=1 negate=(0,1) scale=2^-40"
std::string to_text(const PointTransform& transform);

struct PointCase {
  std::uint64_t index = 0;
  PointRecipe recipe;
  PointTransform transform;
  GridRefinement refinement = GridRefinement::kSixBySix;
  PointSet points;
  std::uint64_t merged = 0;  ///< points left out as the offset rounded them onto others
};

struct PointCampaign {
  std::uint64_t seed = 1;
  std::uint64_t max_n = 300;
  std::vector<std::string> families;  ///< must not be empty
  PointMeshOptions mesh;              ///< but for the refinement, which alternates
};

/// The names of all families.
std::vector<std::string> all_point_families();

/// Guarantees: 1. depends on the campaign and the index alone. 2. Families take turns; each is
/// meshed with both refinements in turn. 3. No two points are equal. Coordinates may be out of the
/// range that validate allows.
/// Errors: RecipeError for a family that does not exist.
PointCase random_point_case(const PointCampaign& campaign, std::uint64_t index);

enum class CaseOutcome {
  kProved,
  kOutOfRange,    ///< refused by validate
  kTooDeep,       ///< refused; the closest points are closer than 2^-50 of the extent
  kTooFarOut,     ///< refused; they are closer than 2^-50 of the largest coordinate only
  kTooManyCells,  ///< refused
  kFinding,
};

struct CaseResult {
  CaseOutcome outcome = CaseOutcome::kProved;
  /// Where it is a finding: the id of the claim, "refusal" or "exception".
  std::string claim;
  std::string detail;  ///< of a finding, a refusal or a set out of range
  // Empty unless a mesh was judged.
  std::uint64_t cells = 0;
  std::uint64_t quads = 0;
  std::optional<Corner<Rational>> smallest;
  std::optional<Corner<Rational>> largest;
  Counters counters;
  bool stored_holds = true;  ///< also with coordinates rounded to doubles, up to rounding
};

/// Validates, meshes and judges. A refusal for depth that is neither kTooDeep nor kTooFarOut is a
/// finding. Guarantees: 1. throws nothing but std::bad_alloc: exceptions of the mesher are
/// findings.
CaseResult try_point_case(const PointCase& made, const PointMeshOptions& options);

/// What came out of a family.
struct FamilyTally {
  std::uint64_t sets = 0;
  std::uint64_t merged = 0;
  std::map<CaseOutcome, std::uint64_t> outcomes;
  std::uint64_t beyond_rounding = 0;  ///< !stored_holds
  std::uint64_t points = 0;           ///< these and all below: of the sets that were meshed
  std::uint64_t meshes = 0;
  std::uint64_t cells = 0;
  double smallest_cells_per_point = 0;
  double largest_cells_per_point = 0;
  std::uint64_t cells_per_point_thousandths = 0;  ///< the sum; an integer, so that order is nothing
  double largest_quads_per_cell = 0;
  std::optional<Corner<Rational>> smallest;
  std::optional<Corner<Rational>> largest;

  [[nodiscard]] std::uint64_t count(CaseOutcome outcome) const;
  [[nodiscard]] double mean_cells_per_point() const;
  void add(const PointCase& made, const CaseResult& result);
  /// Guarantees: 1. neither the order nor the grouping of what is merged matters.
  void merge(const FamilyTally& other);
};

struct Finding {
  PointCase made;
  std::string claim;
  std::string detail;
};

struct CampaignTally {
  std::map<std::string, FamilyTally> families;
  Counters counters;  ///< templates, stitch_cases and quads only
  std::vector<Finding> findings;

  [[nodiscard]] FamilyTally total() const;
  void add(const PointCase& made, const CaseResult& result);
  /// Findings are kept in the order of their index.
  void merge(const CampaignTally& other);
  /// Templates and stitching cases that no mesh has reached.
  [[nodiscard]] std::vector<std::string> never_reached() const;
};

/// The closest two points in the maximum norm, and the length and magnitude to compare it with.
struct Closeness {
  double distance = 0;   ///< infinite for one point
  double extent = 0;     ///< of the bounding box, the longer side
  double magnitude = 0;  ///< of the largest coordinate
};
Closeness closeness(std::span<const Point> points);

}  // namespace quadbound::cli
