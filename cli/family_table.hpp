// SPDX-License-Identifier: Apache-2.0
#pragma once
// Statistics of the families of polygons, for `quadbound generate --statistics`.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generators/family_statistics.hpp"

namespace quadbound::cli {

struct FamilyTableRequest {
  std::vector<std::string> families;
  std::uint64_t n = 100;  ///< or the next smaller one that a family has
  std::uint64_t count = 1;
  std::uint64_t seed = 1;
  std::optional<std::int64_t> holes;  ///< or the nearest number that a family allows
};

struct FamilyRow {
  std::string name;
  std::uint64_t refused = 0;  ///< recipes that the family cannot carry out
  FamilyStatistics statistics;
};

/// A row for each family, of `count` polygons with this seed and those after it, and a last row of
/// all. Errors: RecipeError for a family that does not exist.
std::vector<FamilyRow> family_rows(const FamilyTableRequest& request);

/// Two tables and a list of what no polygon has, as Markdown, under the command that makes it.
std::string to_markdown(const FamilyTableRequest& request, const std::vector<FamilyRow>& rows);

/// {"format": "quadbound-families", "version": 1, "command", "angle_ends", "families": [...]}; each
/// family has "name", "polygons", "refused", "vertices", "holes", "angles" (corners by class),
/// "straight", "smallest_angle", "largest_angle", "acute_share", "reflex_share", and "feature_size"
/// and "edge_ratio" with "smallest", "largest" and "decades" (polygons).
std::string to_json(const FamilyTableRequest& request, const std::vector<FamilyRow>& rows);

}  // namespace quadbound::cli
