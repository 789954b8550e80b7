// SPDX-License-Identifier: Apache-2.0
#include "cli/worst_ever.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "cli/campaign.hpp"
#include "model/errors.hpp"
#include "model/files.hpp"
#include "verify/report.hpp"

namespace quadbound::cli {
namespace {

constexpr const char* kFormat = "quadbound-worst-ever";
constexpr int kVersion = 1;

bool is_polygon(const std::string& input) { return input.starts_with('{'); }

double degrees(const Corner<Rational>& corner) {
  return JudgedCorner{{}, corner.cross, corner.dot}.degrees();
}

Corner<Rational> corner_of(Arctangent tangent, int sign) {
  return {Rational(tangent.numerator), Rational(sign * tangent.denominator)};
}

/// "two-leaf L,2" becomes "two-leaf-l-2".
std::string file_name(std::string_view construction) {
  std::string name;
  for (const char c : construction) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0)
      name += static_cast<char>(std::tolower(byte));
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  while (name.ends_with('-')) name.pop_back();
  return name;
}

}  // namespace

WorstEver::WorstEver(std::string path) : path_(std::move(path)) {
  if (std::filesystem::exists(path_)) read();
}

void WorstEver::read() {
  try {
    const Json json = Json::parse(read_file(path_));
    if (json.at("format") != kFormat || json.at("version") != kVersion)
      throw std::invalid_argument("another format");
    for (std::size_t i = 0; i < worst_.size(); ++i)
      for (const Side& side : kSides) {
        const Json entry = json.at("constructions")
                               .value(std::string(polygon_construction_name(i)), Json::object())
                               .value(std::string(side.name), Json());
        if (entry.is_null()) continue;
        worst_[i].*side.record = {
            Corner<Rational>{parse_rational(entry.at("cross").get<std::string>()).value(),
                             parse_rational(entry.at("dot").get<std::string>()).value()},
            0, entry.at("input").get<std::string>()};
      }
  } catch (const InputError&) {
    throw;
  } catch (const std::exception&) {
    throw InputError({path_, std::nullopt, std::nullopt},
                     fmt::format("no {} of version {}", kFormat, kVersion));
  }
}

void WorstEver::add(const std::array<ConstructionTally, kPolygonConstructionCount>& extremes) {
  for (std::size_t i = 0; i < worst_.size(); ++i) {
    const ConstructionTally& seen = extremes[i];
    // As what is there has index 0, ties do not replace it.
    worst_[i].smallest.keep_smaller(seen.smallest.corner, 0, seen.smallest.recipe);
    worst_[i].largest.keep_larger(seen.largest.corner, 0, seen.largest.recipe);
  }
}

std::string WorstEver::folder() const {
  return std::filesystem::path(path_).replace_extension().string();
}

std::string WorstEver::input_of(std::size_t construction, const Side& side) const {
  const Record& record = worst_[construction].*side.record;
  if (!is_polygon(record.recipe)) return record.recipe;
  return fmt::format("{}/{}-{}.geojson", folder(),
                     file_name(polygon_construction_name(construction)), side.name);
}

std::string WorstEver::json_text() const {
  Json json{{"format", kFormat}, {"version", kVersion}};
  json["bounds"] = {{"smallest", angle_json(corner_of(kTheorem13.smallest, 1))},
                    {"largest", angle_json(corner_of(kTheorem13.from_straight, -1))}};
  json["constructions"] = Json::object();
  for (std::size_t i = 0; i < worst_.size(); ++i)
    for (const Side& side : kSides) {
      const Record& record = worst_[i].*side.record;
      if (!record.corner) continue;
      json["constructions"][std::string(polygon_construction_name(i))][std::string(side.name)] = {
          {"angle", angle_json(record.corner)},
          {"degrees", degrees(*record.corner)},
          {"cross", quadbound::to_text(record.corner->cross)},
          {"dot", quadbound::to_text(record.corner->dot)},
          {"input", input_of(i, side)}};
    }
  return json.dump(1) + "\n";
}

std::string WorstEver::table_text() const {
  const double lower = degrees(corner_of(kTheorem13.smallest, 1));
  const double upper = degrees(corner_of(kTheorem13.from_straight, -1));
  std::string text = fmt::format(
      "# The bound against the worst ever seen\n\n"
      "For each construction the most extreme new angles, in degrees, that campaigns have met, and "
      "how far they are\nfrom the bounds of thm-13: arctan(1/3) = {:.6f} and 180 - arctan(1/7) = "
      "{:.6f}. Campaigns add to this\nwith `quadbound fuzz --worst-ever FILE.json`; `quadbound "
      "fuzz --replay INPUT` tries an input again. The exact angles\nare in the JSON file beside "
      "this one.\n\n"
      "| quads made by | smallest | above the bound | input | largest | below the bound | input |\n"
      "| --- | --: | --: | --- | --: | --: | --- |\n",
      lower, upper);
  for (std::size_t i = 0; i < worst_.size(); ++i) {
    const ConstructionTally& worst = worst_[i];
    if (!worst.smallest.corner || !worst.largest.corner) continue;
    std::string name(polygon_construction_name(i));
    for (std::size_t bar = 0; (bar = name.find('|', bar)) != std::string::npos; bar += 5)
      name.replace(bar, 1, "&#124;");
    const double smallest = degrees(*worst.smallest.corner);
    const double largest = degrees(*worst.largest.corner);
    text += fmt::format("| {} | {:.6f} | {:.6f} | `{}` | {:.6f} | {:.6f} | `{}` |\n", name,
                        smallest, smallest - lower, input_of(i, kSides[0]), largest,
                        upper - largest, input_of(i, kSides[1]));
  }
  return text;
}

void WorstEver::write() const {
  for (std::size_t i = 0; i < worst_.size(); ++i)
    for (const Side& side : kSides) {
      const std::string& input = (worst_[i].*side.record).recipe;
      if (!is_polygon(input)) continue;
      std::error_code error;
      std::filesystem::create_directories(folder(), error);
      if (error)
        throw OutputError(fmt::format("{}: cannot be made: {}", folder(), error.message()));
      write_file(input_of(i, side), [&](std::ostream& stream) { stream << input; });
    }
  write_file(path_, [&](std::ostream& stream) { stream << json_text(); });
  write_file(folder() + ".md", [&](std::ostream& stream) { stream << table_text(); });
}

}  // namespace quadbound::cli
