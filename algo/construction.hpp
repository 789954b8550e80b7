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

/// Sections 3 and 4: which construction a quad between the quadtree's mesh and the boundary comes
/// from. Numbered after those of Section 2 in a mesh of a polygon.
enum class StripConstruction : std::uint8_t {
  kQuad,           ///< one edge of alpha and two feet
  kPentagon,       ///< two edges of alpha and two feet: three quads around a Steiner point
  kBump,           ///< three edges of alpha closed by a fourth
  kFan,            ///< two edges of alpha and a vertex of the polygon
  kCorner,         ///< a vertex of alpha, its feet on two edges of the polygon and their corner
  kCornerHexagon,  ///< two edges of alpha, two feet and a corner of the polygon: three quads
  kKiteWhole,      ///< a kite as one quad
  kKiteTip,        ///< the quad at the acute vertex of a kite
  kKiteWing,       ///< the two quads between the tip and the kite's inner vertex
  kKiteSide,       ///< quads along the two sides that a kite shares with the rest
};
inline constexpr std::size_t kStripConstructionCount = 10;
inline constexpr std::array<std::string_view, kStripConstructionCount> kStripConstructionNames{
    "strip quad",     "strip pentagon", "strip bump", "strip fan", "corner quad",
    "corner hexagon", "kite whole",     "kite tip",   "kite wing", "kite side"};
/// The number of a strip construction in Mesh::construction.
inline constexpr std::uint8_t number_of(StripConstruction construction) {
  return static_cast<std::uint8_t>(kConstructionCount + static_cast<std::size_t>(construction));
}

}  // namespace quadbound
