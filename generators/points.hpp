// SPDX-License-Identifier: Apache-2.0
#pragma once
// Point sets from recipes: ten families, chosen to be hard for a quadtree in different ways.

#include <span>
#include <string_view>

#include "generators/recipe.hpp"
#include "model/polygon.hpp"

namespace quadbound {

using PointRecipe = Recipe;

/// The families that generate_points knows, with their parameters.
std::span<const FamilyDescription> point_families();

/// parse_recipe with the families of point sets.
PointRecipe parse_point_recipe(std::string_view text);

/// The points of a recipe; `file` of the result is the completed recipe as text.
///
/// Guarantees: 1. exactly n points. 2. No two are equal; no coordinate is -0, infinite or not a
/// number. 3. The same recipe gives the same bytes on every machine with IEEE doubles: integer
/// arithmetic, exact scaling by powers of two, and single correctly rounded operations only. 4. A
/// parameter left out and the same parameter at its default give the same points.
/// Errors: RecipeError where the recipe is not valid, or its family has too few distinct points.
/// Complexity: O(n) expected time and memory.
PointSet generate_points(const PointRecipe& recipe);

}  // namespace quadbound
