// SPDX-License-Identifier: Apache-2.0
#pragma once
// Polygons with holes from recipes: families that are hard for a mesher in different ways.

#include <span>
#include <string_view>

#include "generators/recipe.hpp"
#include "model/polygon.hpp"

namespace quadbound {

using PolygonRecipe = Recipe;

/// The families that generate_polygon knows, with their parameters. All take "holes".
std::span<const FamilyDescription> polygon_families();

/// parse_recipe with the families of polygons.
PolygonRecipe parse_polygon_recipe(std::string_view text);

/// The polygon of a recipe; `file` of the result is the completed recipe as text.
///
/// Guarantees: 1. the outer ring has exactly n vertices, counter-clockwise; each hole has as many
/// as the family's parameters say, clockwise. 2. the polygon passes validate(). 3. The same recipe
/// gives the same bytes on every machine: integers, and sums and products of doubles in a fixed
/// order. 4. coordinates are multiples of 2^-20, the extent is between 1 and 4 (comb and
/// spiral-band: their own). Errors: RecipeError where the recipe is not valid or its family cannot
/// have that many vertices or holes. Complexity: O(n log n), of which the validation is the largest
/// part.
Polygon generate_polygon(const PolygonRecipe& recipe);

}  // namespace quadbound
