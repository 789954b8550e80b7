// SPDX-License-Identifier: Apache-2.0
#pragma once
// The formats behind read_polygon, one function each; contracts as there.

#include <string>
#include <string_view>

#include "model/polygon.hpp"

namespace quadbound {

/// A bare Polygon, a Feature with one, or a FeatureCollection of exactly one such Feature.
Polygon parse_geojson(std::string_view text, const std::string& file);

/// POLYGON ((x y, ...), ...), in any case.
Polygon parse_wkt(std::string_view text, const std::string& file);

/// Triangle's .poly; vertices come from the sibling .node file where the section is empty.
Polygon parse_poly(std::string_view text, const std::string& file);

/// Drops the last vertex of a closed ring; one is left at least. Errors: InputError where it differs
/// from the first or there is no other.
void drop_closing_vertex(Ring& ring, const std::string& file, std::size_t ring_number);

}  // namespace quadbound
