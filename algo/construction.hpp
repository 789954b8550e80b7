// SPDX-License-Identifier: Apache-2.0
#pragma once
// Names of the paper's templates (Figures 1 and 2), stitching cases (Figures 5 and 6) and of the
// quads that they make. `1`, `2`, `4` count chain points that face each other: `1` a leaf with an
// extra point, `L` the same as one half of a longer side, `2` two leaves without extra points, `4`
// two leaves with extra points.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace quadbound {

enum class Template : std::uint8_t { kT0, kT1, kT2a, kT2b, kT3, kT4 };
inline constexpr std::size_t kTemplateCount = 6;
inline constexpr std::array<std::string_view, kTemplateCount> kTemplateNames{"T0",  "T1", "T2a",
                                                                             "T2b", "T3", "T4"};

enum class StitchCase : std::uint8_t {
  kOneOne,    ///< Fig. 5: leaf and leaf, an extra each
  kOneTwo,    ///< Fig. 5: leaf with its extra, and two leaves without
  kOneFour,   ///< Fig. 5(5): leaf with its extra, and two leaves with extras
  kTwoTwo,    ///< Fig. 5: two leaves and two leaves, no extras
  kLeafLeaf,  ///< the two-leaf cases: two leaves against A | B, see two_leaf_case
  kLeafTwo,
  kTwoTwoHalves,
  kLeafFour,
  kFourTwo,
  kFourFour,
  kHalved,  ///< the recursive step of stitchChains
};
inline constexpr std::size_t kStitchCaseCount = 11;
inline constexpr std::array<std::string_view, kStitchCaseCount> kStitchCaseNames{
    "1|1",          "1|2",          "1|4",          "2|2",          "two-leaf L,L", "two-leaf L,2",
    "two-leaf 2,2", "two-leaf L,4", "two-leaf 4,2", "two-leaf 4,4", "halved"};

/// Which construction a quad comes from; its shape up to similarity is listed by theorem-1.
enum class Construction : std::uint8_t {
  kT4,
  kT3Two,
  kT3Four,
  kMiddle,
  kOneOne,
  kOneTwo,
  kOneFour,
  kTwoTwo,
  kLeafLeaf,
  kLeafTwo,
  kTwoTwoHalves,
  kLeafFour,
  kFourTwo,
  kFourFour,
};
inline constexpr std::size_t kConstructionCount = 14;
inline constexpr std::array<std::string_view, kConstructionCount> kConstructionNames{
    "template T4",  "template T3 (2,2)", "template T3 (4,4)", "middle quad",  "stitch 1|1",
    "stitch 1|2",   "stitch 1|4",        "stitch 2|2",        "two-leaf L,L", "two-leaf L,2",
    "two-leaf 2,2", "two-leaf L,4",      "two-leaf 4,2",      "two-leaf 4,4"};

}  // namespace quadbound
