// SPDX-License-Identifier: Apache-2.0
#include "model/write_polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "model/errors.hpp"
#include "model/predicates.hpp"

namespace quadbound {
namespace {

void append_ring(std::string& text, const Ring& ring) {
  text += "[\n";
  for (const Point& p : ring) text += fmt::format("[{},{}],\n", p.x, p.y);
  text += fmt::format("[{},{}]]", ring.front().x, ring.front().y);
}

/// Halves first, so that the sum stays within the doubles.
Point middle(const Point& a, const Point& b) { return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2}; }

/// Whether q is inside a triangle or on its border, seen from v: not on a-v or v-b.
bool behind(const Point& q, const Point& a, const Point& v, const Point& b, int turn) {
  return orientation(a, v, q) == turn && orientation(v, b, q) == turn &&
         orientation(b, a, q) != -turn;
}

/// A place near the corner v between a and b that is inside the ring where v is convex: halfway to
/// the vertex that looks deepest into the corner, or to the middle of a-b where none does.
Point place_in_corner(const Ring& ring, const Point& a, const Point& v, const Point& b) {
  const int turn = orientation(a, v, b);
  std::optional<Point> deepest;  // the line through it parallel to a-b is the nearest to v
  for (const Point& q : ring) {
    if (!behind(q, a, v, b, turn)) continue;
    const auto depth = [&](const Point& p) {
      return std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
    };
    if (!deepest || depth(q) > depth(*deepest)) deepest = q;
  }
  return middle(v, deepest.value_or(middle(a, b)));
}

/// Vertices are numbered through all rings.
std::string poly_segments(const Polygon& polygon) {
  std::string text;
  std::size_t first = 0;
  for (const Ring& ring : polygon.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      text += fmt::format("{} {} {}\n", first + i, first + i, first + (i + 1) % ring.size());
    first += ring.size();
  }
  return fmt::format("{} 0\n", first) + text;
}

std::string poly_vertices(const Polygon& polygon) {
  std::string text;
  std::size_t number = 0;
  for (const Ring& ring : polygon.rings)
    for (const Point& p : ring) text += fmt::format("{} {} {}\n", number++, p.x, p.y);
  return fmt::format("{} 2 0 0\n", number) + text;
}

std::string poly_holes(const Polygon& polygon) {
  std::string text = fmt::format("{}\n", polygon.rings.size() - 1);
  for (std::size_t i = 1; i < polygon.rings.size(); ++i) {
    const std::optional<Point> inside = point_inside(polygon.rings[i]);
    if (!inside)
      throw InputError({polygon.file, i, {}},
                       "no double was found inside this hole, which .poly asks for");
    text += fmt::format("{} {} {}\n", i - 1, inside->x, inside->y);
  }
  return text;
}

}  // namespace

std::optional<Point> point_inside(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& before = ring[(i + ring.size() - 1) % ring.size()];
    const Point& after = ring[(i + 1) % ring.size()];
    if (orientation(before, ring[i], after) == 0) continue;
    const Point place = place_in_corner(ring, before, ring[i], after);
    if (strictly_inside(place, ring)) return place;
  }
  return std::nullopt;
}

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

void write_wkt(std::ostream& stream, const Polygon& polygon) {
  std::string text = "POLYGON (";
  for (std::size_t i = 0; i < polygon.rings.size(); ++i) {
    const Ring& ring = polygon.rings[i];
    text += i == 0 ? "(" : ", (";
    for (const Point& p : ring) text += fmt::format("{} {}, ", p.x, p.y);
    text += fmt::format("{} {})", ring.front().x, ring.front().y);
  }
  stream << text << ")\n";
}

void write_poly(std::ostream& stream, const Polygon& polygon) {
  std::string name = polygon.file;
  std::ranges::replace_if(
      name, [](unsigned char c) { return c < ' '; }, ' ');
  stream << "# " << name << '\n'
         << poly_vertices(polygon) << poly_segments(polygon) << poly_holes(polygon);
}

void write_polygon(std::ostream& stream, const Polygon& polygon, PolygonFormat format) {
  switch (format) {
    case PolygonFormat::kGeoJson:
      return write_geojson(stream, polygon);
    case PolygonFormat::kPoly:
      return write_poly(stream, polygon);
    case PolygonFormat::kWkt:
      return write_wkt(stream, polygon);
  }
}

}  // namespace quadbound
