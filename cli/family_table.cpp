// SPDX-License-Identifier: Apache-2.0
#include "cli/family_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "generators/polygons.hpp"

namespace quadbound::cli {
namespace {

FamilyRow row_of(const FamilyTableRequest& request, const FamilyDescription& family) {
  FamilyRow row{std::string(family.name), 0, {}};
  PolygonRecipe recipe;
  recipe.family = row.name;
  recipe.n = fitting(family.sizes, request.n);
  const Parameter& holes = family.parameters.front();
  if (request.holes)
    recipe.parameters["holes"] = std::clamp(*request.holes, holes.smallest, holes.largest);
  for (std::uint64_t i = 0; i < request.count; ++i) {
    recipe.seed = request.seed + i;
    try {
      row.statistics.add(generate_polygon(recipe));
    } catch (const RecipeError&) {
      ++row.refused;
    }
  }
  return row;
}

std::string command(const FamilyTableRequest& request, const char* file) {
  std::string text = "quadbound generate";
  if (request.families.size() == 1) text += ' ' + request.families.front();
  text += fmt::format(" --statistics {} --n {} --count {} --seed {}", file, request.n,
                      request.count, request.seed);
  if (request.holes) text += fmt::format(" --holes {}", *request.holes);
  return text;
}

std::string angle_class_name(std::size_t i) {
  return fmt::format("{}-{}", kAngleEnds[i], kAngleEnds[i + 1]);
}

std::string decade_name(std::size_t i) {
  if (i + 1 == kDecades) return fmt::format("<1e-{}", i);
  return fmt::format("1e-{}", i + 1);
}

std::string percent(std::uint64_t part, std::uint64_t whole) {
  if (part == 0) return "-";
  return fmt::format("{:.2f}", 100 * static_cast<double>(part) / static_cast<double>(whole));
}

std::string header(const std::vector<std::string>& columns) {
  std::string text = "|";
  for (const std::string& c : columns) text += fmt::format(" {} |", c);
  text += "\n| ---";
  for (std::size_t i = 1; i < columns.size(); ++i) text += " | --:";
  return text + " |\n";
}

std::string extremes_row(const FamilyRow& row) {
  const FamilyStatistics& s = row.statistics;
  return fmt::format(
      "| {} | {} | {} | {} | {} | {:.4g} | {:.6g} | {:.1f} | {:.1f} | {:.1f} | {:.2g} | {:.2g} | "
      "{:.2g} | {:.2g} |\n",
      row.name, s.polygons, row.refused, s.vertices, s.holes, s.smallest_angle, s.largest_angle,
      100 * s.acute_share(), 100 * s.reflex_share(),
      100 * static_cast<double>(s.straight) / static_cast<double>(s.vertices), s.smallest_feature,
      s.largest_feature, s.smallest_edge_ratio, s.largest_edge_ratio);
}

std::string extremes(const std::vector<FamilyRow>& rows) {
  std::string text = header({"family", "polygons", "refused", "vertices", "holes", "smallest angle",
                             "largest angle", "acute %", "reflex %", "straight %",
                             "feature size min", "max", "edge ratio min", "max"});
  for (const FamilyRow& row : rows) {
    if (row.statistics.polygons > 0)
      text += extremes_row(row);
    else
      text += fmt::format("| {} | 0 | {} |\n", row.name, row.refused);
  }
  return text;
}

template <class Counts>
std::string shares(const Counts& counts, std::uint64_t whole) {
  std::string text;
  for (const std::uint64_t count : counts) text += fmt::format(" {} |", percent(count, whole));
  return text;
}

std::string angle_table(const std::vector<FamilyRow>& rows) {
  std::vector<std::string> columns{"family"};
  for (std::size_t i = 0; i < kAngleClasses; ++i) columns.push_back(angle_class_name(i));
  columns.emplace_back("straight");
  std::string text = header(columns);
  for (const FamilyRow& row : rows)
    text += fmt::format("| {} |{} {} |\n", row.name,
                        shares(row.statistics.angles, row.statistics.vertices),
                        percent(row.statistics.straight, row.statistics.vertices));
  return text;
}

std::string decade_table(const std::vector<FamilyRow>& rows,
                         std::array<std::uint64_t, kDecades> FamilyStatistics::*counts) {
  std::vector<std::string> columns{"family"};
  for (std::size_t i = 0; i < kDecades; ++i) columns.push_back(decade_name(i));
  std::string text = header(columns);
  for (const FamilyRow& row : rows)
    text += fmt::format("| {} |{}\n", row.name,
                        shares(row.statistics.*counts, row.statistics.polygons));
  return text;
}

/// The classes in which the last row, that of all families, has nothing.
std::string not_covered(const FamilyStatistics& all) {
  std::string text;
  const auto add = [&text](const std::string& what) { text += (text.empty() ? "" : "; ") + what; };
  for (std::size_t i = 0; i < kAngleClasses; ++i)
    if (all.angles[i] == 0) add("angles of " + angle_class_name(i) + " degrees");
  if (all.straight == 0) add("straight angles");
  for (std::size_t i = 0; i < kDecades; ++i)
    if (all.features[i] == 0) add("feature sizes of " + decade_name(i));
  for (std::size_t i = 0; i < kDecades; ++i)
    if (all.edges[i] == 0) add("edge ratios of " + decade_name(i));
  return text.empty() ? "nothing" : text;
}

nlohmann::ordered_json to_json(const FamilyRow& row) {
  const FamilyStatistics& s = row.statistics;
  nlohmann::ordered_json json{{"name", row.name},       {"polygons", s.polygons},
                              {"refused", row.refused}, {"vertices", s.vertices},
                              {"holes", s.holes},       {"angles", s.angles},
                              {"straight", s.straight}};
  if (s.polygons == 0) return json;
  json["smallest_angle"] = s.smallest_angle;
  json["largest_angle"] = s.largest_angle;
  json["acute_share"] = s.acute_share();
  json["reflex_share"] = s.reflex_share();
  json["feature_size"] = {
      {"smallest", s.smallest_feature}, {"largest", s.largest_feature}, {"decades", s.features}};
  json["edge_ratio"] = {
      {"smallest", s.smallest_edge_ratio}, {"largest", s.largest_edge_ratio}, {"decades", s.edges}};
  return json;
}

}  // namespace

std::vector<FamilyRow> family_rows(const FamilyTableRequest& request) {
  std::vector<FamilyRow> rows;
  FamilyRow all{"all", 0, {}};
  for (const std::string& name : request.families) {
    rows.push_back(row_of(request, find_family(polygon_families(), name)));
    all.refused += rows.back().refused;
    all.statistics.merge(rows.back().statistics);
  }
  rows.push_back(std::move(all));
  return rows;
}

std::string to_markdown(const FamilyTableRequest& request, const std::vector<FamilyRow>& rows) {
  return fmt::format(
      "# What the families of polygons are like\n\n```\n{}\n```\n\n"
      "Interior angles in degrees, straight ones apart. The feature size is the smallest local "
      "feature size of a polygon (the\nleast distance of a vertex from an edge that does not end "
      "there) over the longer side of its bounding box; the edge\nratio is that of its shortest "
      "to its longest edge.\n\n{}\n"
      "Not covered by any of them: {}.\n\n"
      "## Angles, percent of all\n\n{}\n"
      "## Feature size, percent of the polygons, by the power of ten below it\n\n{}\n"
      "## Edge ratio, percent of the polygons, by the power of ten below it\n\n{}",
      command(request, "results/families.md"), extremes(rows), not_covered(rows.back().statistics),
      angle_table(rows), decade_table(rows, &FamilyStatistics::features),
      decade_table(rows, &FamilyStatistics::edges));
}

std::string to_json(const FamilyTableRequest& request, const std::vector<FamilyRow>& rows) {
  nlohmann::ordered_json json{{"format", "quadbound-families"},
                              {"version", 1},
                              {"command", command(request, "FILE.json")},
                              {"angle_ends", kAngleEnds}};
  for (const FamilyRow& row : rows) json["families"].push_back(to_json(row));
  return json.dump(1) + '\n';
}

}  // namespace quadbound::cli
