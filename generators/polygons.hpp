// SPDX-License-Identifier: Apache-2.0
#pragma once
// Polygons with holes from recipes: families that are hard for a mesher in different ways.
//
// two-opt, space-partition and growth are 2-opt Moves, Space Partitioning and Steady Growth of
// T. Auer and M. Held, Heuristics for the Generation of Random Polygons, CCCG 1996; CGAL's
// random_polygon_2 is two-opt too. Here growth takes the points in the order of their distance from
// the centre, which is one of the orders that Steady Growth allows. coast displaces midpoints after
// A. Fournier, D. Fussell and L. Carpenter, Computer Rendering of Stochastic Models, CACM 25
// (1982). koch is the curve of H. von Koch, Sur une courbe continue sans tangente, Arkiv for
// Matematik 1 (1904). obtuse-spiral is made like Figure 49 of the paper that this project
// implements. The others are our own.
//
// glyph is the outline of a character of the fonts DejaVu 2.37, read with FreeType from the folder
// of the CMake option QUADBOUND_FONT_FOLDER (/usr/share/fonts/truetype/dejavu, Debian's
// fonts-dejavu-core): DejaVuSans.ttf, DejaVuSans-Bold.ttf, DejaVuSansMono.ttf,
// DejaVuSansMono-Bold.ttf, DejaVuSerif.ttf and DejaVuSerif-Bold.ttf. Each must have the checksum of
// version 2.37 in its head table, so that a recipe gives the same bytes or none: a file that is
// missing or another one is a RecipeError that names it. Curves are divided in integers. Characters
// of several pieces, or with outlines that meet, are refused.

#include <span>
#include <string_view>

#include "generators/recipe.hpp"
#include "model/polygon.hpp"

namespace quadbound {

using PolygonRecipe = Recipe;

/// The families that generate_polygon knows, with their parameters. All take "holes". No name is
/// that of a family of point sets.
std::span<const FamilyDescription> polygon_families();

/// parse_recipe with the families of polygons.
PolygonRecipe parse_polygon_recipe(std::string_view text);

/// The polygon of a recipe; `file` of the result is the completed recipe as text.
///
/// Guarantees: 1. the outer ring has exactly n vertices, counter-clockwise; each hole has as many
/// as the family's parameters (or the font) say, clockwise. 2. the polygon passes validate(). 3.
/// The same recipe gives the same bytes on every machine: integers, and single operations on
/// doubles in a fixed order. 4. coordinates are multiples of 2^-20, of magnitude 5 at most; comb,
/// spiral-band, grid-aligned and near-grid take more room where n needs it. Errors: RecipeError
/// where the recipe is not valid, or its family cannot have that many vertices or holes or resolve
/// them in multiples of 2^-20. Complexity: O(n log n) time, expected for the random families;
/// two-opt, which is limited to 20,000 vertices, about O(n^2).
Polygon generate_polygon(const PolygonRecipe& recipe);

}  // namespace quadbound
