// SPDX-License-Identifier: Apache-2.0
#pragma once
// Polygons with holes from GeoJSON, WKT and Triangle's .poly.

#include <optional>
#include <string>
#include <string_view>

#include "model/polygon.hpp"

namespace quadbound {

enum class PolygonFormat {
  kGeoJson,  ///< .geojson, .json: a Polygon, bare, in a Feature or in a FeatureCollection of one
  kPoly,     ///< .poly: Triangle's vertices, segments and holes, numbered from 0 or 1
  kWkt,      ///< .wkt: POLYGON ((x y, ...), ...)
};

/// The format that a file name tells. Errors: InputError, on one line that names the extensions
/// there are.
PolygonFormat polygon_format(const std::string& path);

/// Reads a polygon; the format goes by the extension unless it is given. "-" is standard input and
/// needs a format.
///
/// Guarantees: 1. every coordinate is the double nearest to the decimal number in the file; a third
/// one is ignored in GeoJSON and refused elsewhere. 2. GeoJSON and WKT: rings in the order of the
/// file, first ring first, each without its closing vertex. 3. .poly: each ring starts at its
/// vertex of the lowest number and goes on to the neighbour of the lower number; the ring with the
/// leftmost vertex comes first, since it is the outer one in every valid file; the others follow in
/// the order of their first vertices. Every vertex belongs to exactly two segments, and every hole
/// point lies inside an inner ring. Attributes, markers and regions are dropped. 4. Orientation is
/// left as it is (see normalised). 5. A byte-order mark and carriage returns are skipped.
/// Not checked here: that the rings bound a region (see validate).
/// Errors: InputError with ring, vertex and line where they are known.
Polygon read_polygon(const std::string& path, std::optional<PolygonFormat> format = {});

/// The same for a text in memory; `file` is the name in messages. A .poly text without vertices
/// reads the .node file beside `file`.
Polygon parse_polygon(std::string_view text, PolygonFormat format, const std::string& file);

}  // namespace quadbound
