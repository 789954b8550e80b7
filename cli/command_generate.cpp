// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/family_table.hpp"
#include "generators/gallery.hpp"
#include "generators/points.hpp"
#include "generators/polygons.hpp"
#include "model/files.hpp"
#include "model/write_points.hpp"
#include "model/write_polygon.hpp"

namespace quadbound::cli {
namespace {

struct GenerateCommand {
  std::string family;
  std::uint64_t n = 100;
  std::uint64_t seed = 1;
  std::uint64_t count = 1;
  std::optional<std::int64_t> holes;
  std::vector<std::string> parameters;
  std::string output = "-";
  std::string gallery;
  std::string statistics;
};

/// The recipe that the options spell, in its one-line form.
std::string recipe_text(const GenerateCommand& options) {
  if (options.family.find(':') != std::string::npos) return options.family;
  std::string text = fmt::format("{}:n={},seed={}", options.family, options.n, options.seed);
  if (options.holes) text += fmt::format(",holes={}", *options.holes);
  for (const std::string& parameter : options.parameters) text += "," + parameter;
  return text;
}

/// What n may be; nothing where it may be anything.
std::string sizes_text(const Sizes& sizes) {
  if (sizes.smallest == sizes.largest) return fmt::format("; n is {}", sizes.smallest);
  std::string text;
  if (sizes.smallest > 1 || sizes.largest < kMaxRecipeSize)
    text += fmt::format("; n from {} to {}", sizes.smallest, sizes.largest);
  if (sizes.step > 1) text += fmt::format(" in steps of {}", sizes.step);
  return text;
}

void append_families(std::string& text, std::span<const FamilyDescription> families) {
  for (const FamilyDescription& family : families) {
    text += fmt::format("  {:<18} {}{}\n", family.name, family.meaning, sizes_text(family.sizes));
    for (const Parameter& p : family.parameters)
      text +=
          fmt::format("  {:<18}   {} (default {}): {}\n", "", p.name, p.default_value, p.meaning);
  }
}

std::string family_list() {
  std::string text =
      "Point sets (.csv, .node, .xyz, .txt; CSV on standard output), and their parameters for "
      "--set NAME=VALUE:\n";
  append_families(text, point_families());
  text += "\nPolygons (.geojson, .json, .poly, .wkt; GeoJSON on standard output):\n";
  append_families(text, polygon_families());
  return text + R"(
Examples:
  quadbound generate uniform --n 1000 --seed 7 -o points.csv
  quadbound generate clustered --n 500 --set clusters=5 -o points.csv
  quadbound generate star --n 40 --holes 3 -o polygon.geojson
  quadbound generate koch --n 48 -o snowflake.poly
  quadbound generate growth --n 200 --seed 1 --count 10 -o polygon.geojson
  quadbound generate grid:n=100,seed=1
  quadbound generate --gallery families.svg
  quadbound generate --statistics families.md --n 60 --count 100)";
}

bool is_polygon(const std::string& recipe) {
  const std::string family = recipe.substr(0, recipe.find(':'));
  const auto families = polygon_families();
  return std::any_of(families.begin(), families.end(),
                     [&](const auto& f) { return f.name == family; });
}

void write_polygon(const std::string& path, const PolygonRecipe& recipe) {
  const PolygonFormat format = path == "-" ? PolygonFormat::kGeoJson : polygon_format(path);
  const Polygon polygon = generate_polygon(recipe);
  write_file(path,
             [&](std::ostream& stream) { quadbound::write_polygon(stream, polygon, format); });
}

void write_points(const std::string& path, const PointRecipe& recipe) {
  const PointFormat format = path == "-" ? PointFormat::kCsv : point_format(path);
  const PointSet points = generate_points(recipe);
  write_file(path, [&](std::ostream& stream) { quadbound::write_points(stream, points, format); });
}

/// Where the result of a seed goes: with several seeds, FILE.csv becomes FILE-SEED.csv.
std::string output_for(const GenerateCommand& options, std::uint64_t seed) {
  if (options.count == 1) return options.output;
  const std::filesystem::path path(options.output);
  return (path.parent_path() /
          fmt::format("{}-{}{}", path.stem().string(), seed, path.extension().string()))
      .string();
}

/// The canvas that goes by the extension of a picture.
using DrawPicture = void (*)(std::ostream&, double, double, const Drawing&);
DrawPicture picture_writer(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".svg") return draw_svg;
  if (extension == ".pdf") return draw_pdf;
  if (extension == ".png") return draw_png;
  throw CLI::ValidationError("--gallery",
                             fmt::format("{} is no picture: .svg, .pdf or .png", path));
}

void write_gallery(const std::string& path) {
  const DrawPicture draw = picture_writer(path);
  const Gallery gallery = gallery_of_polygons();
  write_file(path, [&](std::ostream& stream) {
    draw(stream, gallery.width, gallery.height, gallery.drawing);
  });
}

void write_statistics(const GenerateCommand& options) {
  const std::string extension = std::filesystem::path(options.statistics).extension().string();
  const bool is_json = extension == ".json";
  if (options.statistics != "-" && !is_json && extension != ".md")
    throw CLI::ValidationError("--statistics",
                               fmt::format("{} is no table: .md, .json or -", options.statistics));
  FamilyTableRequest request{{}, options.n, options.count, options.seed, options.holes};
  if (!options.family.empty()) request.families.push_back(options.family);
  for (const FamilyDescription& family : polygon_families())
    if (options.family.empty()) request.families.emplace_back(family.name);
  const std::vector<FamilyRow> rows = family_rows(request);
  write_file(options.statistics, [&](std::ostream& stream) {
    stream << (is_json ? to_json(request, rows) : to_markdown(request, rows));
  });
}

ExitStatus generate(const GenerateCommand& options) {
  if (!options.gallery.empty()) {
    write_gallery(options.gallery);
    return kGood;
  }
  if (!options.statistics.empty()) {
    write_statistics(options);
    return kGood;
  }
  if (options.family.empty()) throw CLI::RequiredError("FAMILY, --gallery or --statistics");
  if (options.count > 1 && options.output == "-")
    throw CLI::ValidationError("--count", "several results need -o FILE");
  const std::string text = recipe_text(options);
  const bool polygons = is_polygon(text);
  Recipe recipe = polygons ? parse_polygon_recipe(text) : parse_point_recipe(text);
  for (std::uint64_t i = 0; i < options.count; ++i, ++recipe.seed)
    (polygons ? write_polygon : write_points)(output_for(options, recipe.seed), recipe);
  return kGood;
}

}  // namespace

void add_generate_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<GenerateCommand>();
  CLI::App* command = app.add_subcommand("generate", "make a point set or a polygon from a recipe");
  command->footer(family_list());
  CLI::Option* family = command->add_option("FAMILY", options->family,
                                            "a family, or a whole recipe FAMILY:n=N,seed=S,...");
  CLI::Option* parameters =
      command->add_option("--set", options->parameters, "a parameter of the family, NAME=VALUE");
  parameters->allow_extra_args(false);
  command->add_option("--n", options->n, "number of points, or of vertices of the outer ring")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "the same seed gives the same bytes")
      ->capture_default_str();
  command
      ->add_option("--count", options->count,
                   "so many results, of this seed and those after it, as FILE-SEED")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000}));
  command->add_option("--holes", options->holes, "holes of a polygon, like --set holes=NUMBER");
  CLI::Option* output =
      command
          ->add_option("-o,--output", options->output,
                       "where to write; the extension is the format, - is standard output")
          ->capture_default_str();
  CLI::Option* gallery =
      command
          ->add_option("--gallery", options->gallery,
                       "a sheet with a polygon of each family instead; .svg, .pdf or .png")
          ->excludes(family);
  command
      ->add_option("--statistics", options->statistics,
                   "instead: angles, features and edges of --count polygons of each family, or of "
                   "FAMILY; .md, .json, or - for standard output")
      ->excludes(gallery)
      ->excludes(output)
      ->excludes(parameters);
  command->callback([options, &outcome] { outcome.status = generate(*options); });
}

}  // namespace quadbound::cli
