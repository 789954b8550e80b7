// SPDX-License-Identifier: Apache-2.0
#pragma once
// Recipes: a generated input as one line of text, such as "clustered:n=100,seed=7,clusters=5".

#include <cstdint>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace quadbound {

/// A recipe that cannot be read or carried out; what() is one line that starts with the recipe.
class RecipeError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

struct Recipe {
  std::string family;
  std::uint64_t n = 0;
  std::uint64_t seed = 1;
  /// The family's own parameters; those left out take their default.
  std::map<std::string, std::int64_t> parameters;
  friend bool operator==(const Recipe&, const Recipe&) = default;
};

/// A parameter of a family: what it may be and what it does.
struct Parameter {
  std::string_view name;
  std::int64_t default_value = 0;
  std::int64_t smallest = 0;
  std::int64_t largest = 0;
  std::string_view meaning;
};

/// The most points or vertices a recipe may ask for.
inline constexpr std::uint64_t kMaxRecipeSize = 100'000'000;

/// What n may be: smallest, smallest + step, smallest + 2 step, ... but no more than largest.
struct Sizes {
  std::uint64_t smallest = 1;
  std::uint64_t largest = kMaxRecipeSize;
  std::uint64_t step = 1;
};

struct FamilyDescription {
  std::string_view name;
  std::string_view meaning;
  std::vector<Parameter> parameters;
  Sizes sizes = {};
};

/// The largest n of these sizes that is at most `wanted`; the smallest where there is none.
std::uint64_t fitting(const Sizes& sizes, std::uint64_t wanted);

/// "FAMILY:n=N,seed=SEED[,NAME=VALUE...]" with the parameters the recipe holds, in alphabetical
/// order.
std::string to_text(const Recipe& recipe);

/// The family's entry in a table. Errors: RecipeError that lists the families there are.
const FamilyDescription& find_family(std::span<const FamilyDescription> families,
                                     std::string_view name);

/// The recipe with the defaults of its family written out.
///
/// Guarantees: 1. every parameter of the family is there, within its limits; nothing else is.
/// 2. n is one of the family's sizes. 3. completed(completed(r)) == completed(r).
/// Errors: RecipeError for an unknown family or parameter, and for a value outside its limits.
Recipe completed(Recipe recipe, std::span<const FamilyDescription> families);

/// Reads what to_text writes, in any order of the names; the seed may be left out.
///
/// Guarantees: 1. the result is completed. 2. parse_recipe(to_text(r)) == r for a completed r.
/// Errors: RecipeError for anything else: white space, a name given twice, n left out, a number
/// that is not a decimal integer, and all that `completed` refuses.
Recipe parse_recipe(std::string_view text, std::span<const FamilyDescription> families);

}  // namespace quadbound
