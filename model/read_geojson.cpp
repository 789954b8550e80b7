// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "model/errors.hpp"
#include "model/json_input.hpp"
#include "model/polygon_formats.hpp"
#include "model/text_scanner.hpp"

namespace quadbound {
namespace {

using nlohmann::json;

[[noreturn]] void refuse(const std::string& file, const std::string& message) {
  throw InputError({file, {}, {}}, message);
}

/// The member of an object. Errors: InputError where it is missing or null.
const json& member(const json& object, const char* key, const std::string& file) {
  const auto found = object.find(key);
  if (found == object.end() || found->is_null())
    refuse(file, fmt::format("\"{}\" is missing or null", key));
  return *found;
}

std::string type_of(const json& object, const std::string& file) {
  if (!object.is_object())
    refuse(file, fmt::format("a GeoJSON object is due, not {}", object.type_name()));
  const json& type = member(object, "type", file);
  if (!type.is_string()) refuse(file, "\"type\" is not a string");
  return type.get<std::string>();
}

/// The Polygon object inside a Feature or a FeatureCollection.
const json& polygon_object(const json& root, const std::string& file) {
  const json* object = &root;
  std::string type = type_of(*object, file);
  if (type == "FeatureCollection") {
    const json& features = member(*object, "features", file);
    if (!features.is_array() || features.size() != 1)
      refuse(file, "a FeatureCollection must have exactly one feature");
    object = &features.front();
    type = type_of(*object, file);
    if (type != "Feature") refuse(file, fmt::format("{} where a Feature is due", excerpt(type)));
  }
  if (type == "Feature") {
    object = &member(*object, "geometry", file);
    type = type_of(*object, file);
  }
  if (type != "Polygon") refuse(file, fmt::format("{} where a Polygon is due", excerpt(type)));
  return *object;
}

double coordinate(const json& value, const InputLocation& where) {
  if (!value.is_number())
    throw InputError(where, fmt::format("a coordinate is {}, not a number", value.type_name()));
  const double number = value.get<double>();
  if (!std::isfinite(number))
    throw InputError(where, "a coordinate is out of the range of a double");
  return number;
}

Point position(const json& value, const InputLocation& where) {
  if (!value.is_array() || value.size() < 2 || value.size() > 3)
    throw InputError(where, "a position must be a list of two or three numbers");
  if (value.size() == 3) (void)coordinate(value[2], where);
  return {coordinate(value[0], where), coordinate(value[1], where)};
}

}  // namespace

Polygon parse_geojson(std::string_view text, const std::string& file) {
  const json root = parse_json(text, file);
  const json& rings = member(polygon_object(root, file), "coordinates", file);
  if (!rings.is_array()) refuse(file, "\"coordinates\" is not a list of rings");
  if (rings.empty()) refuse(file, "the polygon is empty");
  Polygon polygon{file, {}};
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (!rings[r].is_array()) throw InputError({file, r, {}}, "a ring must be a list of positions");
    Ring& ring = polygon.rings.emplace_back();
    for (std::size_t v = 0; v < rings[r].size(); ++v)
      ring.push_back(position(rings[r][v], {file, r, v}));
    drop_closing_vertex(ring, file, r);
  }
  return polygon;
}

}  // namespace quadbound
