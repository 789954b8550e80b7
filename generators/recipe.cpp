// SPDX-License-Identifier: Apache-2.0
#include "generators/recipe.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

namespace quadbound {
namespace {

template <class Integer>
Integer parse_integer(std::string_view recipe, std::string_view name, std::string_view digits) {
  Integer value{};
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc{} || stop != end)
    throw RecipeError(
        fmt::format("{}: {} is \"{}\", not an integer in range", recipe, name, digits));
  return value;
}

/// "NAME=VALUE" put into the recipe.
void read_assignment(std::string_view text, std::string_view assignment,
                     std::set<std::string>& names, Recipe& recipe) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw RecipeError(fmt::format("{}: \"{}\" should be NAME=VALUE", text, assignment));
  const std::string name(assignment.substr(0, equals));
  const std::string_view value = assignment.substr(equals + 1);
  if (!names.insert(name).second)
    throw RecipeError(fmt::format("{}: {} is given twice", text, name));
  if (name == "n")
    recipe.n = parse_integer<std::uint64_t>(text, name, value);
  else if (name == "seed")
    recipe.seed = parse_integer<std::uint64_t>(text, name, value);
  else
    recipe.parameters[name] = parse_integer<std::int64_t>(text, name, value);
}

void check_limits(const Recipe& recipe, const Parameter& parameter) {
  const std::int64_t value = recipe.parameters.at(std::string(parameter.name));
  if (value < parameter.smallest || value > parameter.largest)
    throw RecipeError(fmt::format("{}: {} must be from {} to {}", to_text(recipe), parameter.name,
                                  parameter.smallest, parameter.largest));
}

void check_size(const Recipe& recipe, const Sizes& sizes) {
  if (recipe.n < sizes.smallest || recipe.n > sizes.largest)
    throw RecipeError(
        fmt::format("{}: n must be from {} to {}", to_text(recipe), sizes.smallest, sizes.largest));
  if ((recipe.n - sizes.smallest) % sizes.step != 0)
    throw RecipeError(fmt::format("{}: n must be {} more than a multiple of {}", to_text(recipe),
                                  sizes.smallest % sizes.step, sizes.step));
}

}  // namespace

std::uint64_t fitting(const Sizes& sizes, std::uint64_t wanted) {
  const std::uint64_t n = std::clamp(wanted, sizes.smallest, sizes.largest);
  return n - (n - sizes.smallest) % sizes.step;
}

std::string to_text(const Recipe& recipe) {
  std::string text = fmt::format("{}:n={},seed={}", recipe.family, recipe.n, recipe.seed);
  for (const auto& [name, value] : recipe.parameters) text += fmt::format(",{}={}", name, value);
  return text;
}

const FamilyDescription& find_family(std::span<const FamilyDescription> families,
                                     std::string_view name) {
  const auto found = std::ranges::find(families, name, &FamilyDescription::name);
  if (found != families.end()) return *found;
  std::string known;
  for (const FamilyDescription& family : families)
    known += fmt::format("{}{}", known.empty() ? "" : ", ", family.name);
  throw RecipeError(fmt::format("{}: no such family; there are {}", name, known));
}

Recipe completed(Recipe recipe, std::span<const FamilyDescription> families) {
  const FamilyDescription& family = find_family(families, recipe.family);
  check_size(recipe, family.sizes);
  for (const auto& [name, value] : recipe.parameters)
    if (std::ranges::find(family.parameters, name, &Parameter::name) == family.parameters.end())
      throw RecipeError(
          fmt::format("{}: {} has no parameter {}", to_text(recipe), family.name, name));
  for (const Parameter& parameter : family.parameters) {
    recipe.parameters.emplace(parameter.name, parameter.default_value);
    check_limits(recipe, parameter);
  }
  return recipe;
}

Recipe parse_recipe(std::string_view text, std::span<const FamilyDescription> families) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos)
    throw RecipeError(fmt::format("{}: a recipe is FAMILY:n=N[,NAME=VALUE...]", text));
  Recipe recipe;
  recipe.family = text.substr(0, colon);
  std::set<std::string> names;
  for (std::size_t begin = colon + 1; begin <= text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    read_assignment(text, text.substr(begin, comma - begin), names, recipe);
    begin = comma + 1;
  }
  if (!names.contains("n")) throw RecipeError(fmt::format("{}: n is missing", text));
  return completed(std::move(recipe), families);
}

}  // namespace quadbound
