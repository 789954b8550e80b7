// SPDX-License-Identifier: Apache-2.0
#pragma once
// Polygons into the formats that read_polygon reads.

#include <iosfwd>
#include <optional>

#include "model/polygon.hpp"
#include "model/read_polygon.hpp"

namespace quadbound {

// Guarantees of all three: 1. reading it back gives the same doubles (shortest digits that do), the
// same rings from the same first vertices; for .poly, which does not say which ring is the outer
// one, where the polygon is valid. 2. Equal polygons give equal bytes. Requires: finite
// coordinates, no empty ring. Errors: show in the stream's state.

/// A Feature with one Polygon; `file` becomes its name. Rings are closed, one vertex a line.
void write_geojson(std::ostream& stream, const Polygon& polygon);

/// POLYGON ((x y, ...), ...) on one line, rings closed.
void write_wkt(std::ostream& stream, const Polygon& polygon);

/// Triangle's .poly, numbered from 0, with a point inside each hole; `file` becomes a comment.
/// Requires: holes are simple. Errors: InputError naming the ring where no double was found inside
/// it. Complexity: O(v) for a hole of v vertices, mostly; O(v^2) where most ears of it are thinner
/// than doubles can tell.
void write_poly(std::ostream& stream, const Polygon& polygon);

void write_polygon(std::ostream& stream, const Polygon& polygon, PolygonFormat format);

/// A place inside a ring, off its edges; empty where none was found.
/// Requires: the ring is simple. Complexity: as for write_poly.
std::optional<Point> point_inside(const Ring& ring);

}  // namespace quadbound
