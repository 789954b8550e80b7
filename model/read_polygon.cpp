// SPDX-License-Identifier: Apache-2.0
#include "model/read_polygon.hpp"

#include "model/errors.hpp"
#include "model/files.hpp"
#include "model/polygon_formats.hpp"
#include "model/text_scanner.hpp"

namespace quadbound {

PolygonFormat polygon_format(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".geojson" || extension == ".json") return PolygonFormat::kGeoJson;
  if (extension == ".poly") return PolygonFormat::kPoly;
  if (extension == ".wkt") return PolygonFormat::kWkt;
  throw InputError(
      {file_name_of(path), {}, {}},
      path == "-" ? "the format of the polygon must be given"
                  : "not a polygon file: the extension must be .geojson, .json, .poly or .wkt");
}

void drop_closing_vertex(Ring& ring, const std::string& file, std::size_t ring_number) {
  if (ring.empty()) throw InputError({file, ring_number, {}}, "the ring is empty");
  if (ring.front() != ring.back())
    throw InputError({file, ring_number, ring.size() - 1},
                     "the ring is not closed: its last vertex differs from its first");
  if (ring.size() == 1) throw InputError({file, ring_number, 0}, "the ring has no other vertex");
  ring.pop_back();
}

Polygon parse_polygon(std::string_view text, PolygonFormat format, const std::string& file) {
  if (trimmed(without_byte_order_mark(text)).empty())
    throw InputError({file, {}, {}}, "the file is empty");
  switch (format) {
    case PolygonFormat::kGeoJson:
      return parse_geojson(text, file);
    case PolygonFormat::kPoly:
      return parse_poly(text, file);
    case PolygonFormat::kWkt:
      break;
  }
  return parse_wkt(text, file);
}

Polygon read_polygon(const std::string& path, std::optional<PolygonFormat> format) {
  const PolygonFormat known = format ? *format : polygon_format(path);
  return parse_polygon(read_file(path), known, file_name_of(path));
}

}  // namespace quadbound
