// SPDX-License-Identifier: Apache-2.0
#include "model/write_polygon.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>

namespace quadbound {
namespace {

void append_ring(std::string& text, const Ring& ring) {
  text += "[\n";
  for (const Point& p : ring) text += fmt::format("[{},{}],\n", p.x, p.y);
  text += fmt::format("[{},{}]]", ring.front().x, ring.front().y);
}

}  // namespace

void write_geojson(std::ostream& stream, const Polygon& polygon) {
  std::string text = fmt::format(
      "{{\"type\":\"Feature\",\"properties\":{{\"name\":{}}},\n\"geometry\":{{\"type\":\"Polygon\","
      "\"coordinates\":[",
      nlohmann::json(polygon.file).dump());
  for (std::size_t i = 0; i < polygon.rings.size(); ++i) {
    if (i != 0) text += ",\n";
    append_ring(text, polygon.rings[i]);
  }
  stream << text << "]}}\n";
}

}  // namespace quadbound
