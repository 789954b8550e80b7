// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "generators/points.hpp"
#include "generators/polygons.hpp"
#include "model/files.hpp"
#include "model/write_polygon.hpp"

namespace quadbound::cli {
namespace {

struct GenerateCommand {
  std::string family;
  std::uint64_t n = 100;
  std::uint64_t seed = 1;
  std::vector<std::string> parameters;
  std::string output = "-";
};

/// The recipe that the options spell, in its one-line form.
std::string recipe_text(const GenerateCommand& options) {
  if (options.family.find(':') != std::string::npos) return options.family;
  std::string text = fmt::format("{}:n={},seed={}", options.family, options.n, options.seed);
  for (const std::string& parameter : options.parameters) text += "," + parameter;
  return text;
}

void append_families(std::string& text, std::span<const FamilyDescription> families) {
  for (const FamilyDescription& family : families) {
    text += fmt::format("  {:<18} {}\n", family.name, family.meaning);
    for (const Parameter& p : family.parameters)
      text +=
          fmt::format("  {:<18}   {} (default {}): {}\n", "", p.name, p.default_value, p.meaning);
  }
}

std::string family_list() {
  std::string text = "Point sets (as CSV), and their parameters for --set NAME=VALUE:\n";
  append_families(text, point_families());
  text += "\nPolygons (as GeoJSON):\n";
  append_families(text, polygon_families());
  return text + R"(
Examples:
  quadbound generate uniform --n 1000 --seed 7 -o points.csv
  quadbound generate clustered --n 500 --set clusters=5 -o points.csv
  quadbound generate star --n 40 --set holes=3 -o polygon.geojson
  quadbound generate grid:n=100,seed=1)";
}

bool is_polygon(const std::string& recipe) {
  const std::string family = recipe.substr(0, recipe.find(':'));
  const auto families = polygon_families();
  return std::any_of(families.begin(), families.end(),
                     [&](const auto& f) { return f.name == family; });
}

ExitStatus generate(const GenerateCommand& options) {
  const std::string recipe = recipe_text(options);
  if (is_polygon(recipe)) {
    const Polygon polygon = generate_polygon(parse_polygon_recipe(recipe));
    write_file(options.output,
               [&polygon](std::ostream& stream) { write_geojson(stream, polygon); });
    return kGood;
  }
  const PointSet points = generate_points(parse_point_recipe(recipe));
  write_file(options.output, [&points](std::ostream& stream) {
    stream << "x,y\n";
    for (const Point& p : points.points) stream << fmt::format("{},{}\n", p.x, p.y);
  });
  return kGood;
}

}  // namespace

void add_generate_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<GenerateCommand>();
  CLI::App* command = app.add_subcommand("generate", "make a point set or a polygon from a recipe");
  command->footer(family_list());
  command
      ->add_option("FAMILY", options->family, "a family, or a whole recipe FAMILY:n=N,seed=S,...")
      ->required();
  command->add_option("--n", options->n, "number of points, or of vertices of the outer ring")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "the same seed gives the same bytes")
      ->capture_default_str();
  command->add_option("--set", options->parameters, "a parameter of the family, NAME=VALUE")
      ->allow_extra_args(false);
  command->add_option("-o,--output", options->output, "where to write; - is standard output")
      ->capture_default_str();
  command->callback([options, &outcome] { outcome.status = generate(*options); });
}

}  // namespace quadbound::cli
