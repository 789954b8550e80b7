// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "model/errors.hpp"
#include "model/files.hpp"
#include "model/polygon_formats.hpp"
#include "model/predicates.hpp"
#include "model/text_scanner.hpp"
#include "model/triangle_vertices.hpp"

namespace quadbound {
namespace {

/// The vertices of a file and, for each, the other ends of its two segments.
struct Chains {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 2>> neighbours;
};

/// The vertex section is empty: the vertices are in the .node file of the same name.
TriangleVertices read_sibling(const std::string& file) {
  const std::string path = std::filesystem::path(file).replace_extension(".node").string();
  if (!std::filesystem::exists(path))
    throw InputError({file, {}, {}},
                     fmt::format("no vertices here, and there is no file {}", path));
  const std::string text = read_file(path);
  TextScanner scanner(text, path, TextScanner::Comments::kHash);
  TriangleVertices vertices = read_triangle_vertices(scanner);
  if (scanner.next_line()) scanner.fail("text after the last vertex");
  return vertices;
}

/// The count at the head of a section, which up to `extras` more numbers may follow.
std::uint64_t section_count(TextScanner& scanner, const char* what, std::size_t extras) {
  scanner.require_line(what);
  const auto& fields = scanner.fields();
  if (fields.size() > 1 + extras) scanner.fail(fmt::format("too many fields before {}", what));
  for (const std::string_view field : fields) (void)scanner.count(field);
  return scanner.count(fields[0]);
}

/// The next line of a section, with its number and between `least` and `most` fields.
const std::vector<std::string_view>& section_line(TextScanner& scanner, const char* what,
                                                  std::size_t least, std::size_t most) {
  scanner.require_line(what);
  const auto& fields = scanner.fields();
  if (fields.size() < least || fields.size() > most)
    scanner.fail(fmt::format("{} fields in the line of {}", fields.size(), what));
  (void)scanner.count(fields[0]);
  return fields;
}

using Ends = std::vector<std::vector<std::size_t>>;

Ends read_segments(TextScanner& scanner, const TriangleVertices& vertices) {
  Ends ends(vertices.points.size());
  const auto vertex = [&](std::string_view field) {
    const std::uint64_t number = scanner.count(field);
    if (number < vertices.first_number || number - vertices.first_number >= ends.size())
      scanner.fail(fmt::format("there is no vertex number {}", number));
    return number - vertices.first_number;
  };
  const std::uint64_t count = section_count(scanner, "the segments", 1);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto& fields = section_line(scanner, "a segment", 3, 4);
    const std::size_t a = vertex(fields[1]);
    const std::size_t b = vertex(fields[2]);
    if (fields.size() == 4) (void)scanner.number(fields[3]);
    if (a == b) scanner.fail("a segment from a vertex to itself", a);
    ends[a].push_back(b);
    ends[b].push_back(a);
  }
  return ends;
}

std::vector<std::array<std::size_t, 2>> require_rings(const Ends& ends, const std::string& file) {
  std::vector<std::array<std::size_t, 2>> neighbours;
  for (std::size_t v = 0; v < ends.size(); ++v) {
    if (ends[v].size() != 2)
      throw InputError(
          {file, {}, v},
          fmt::format("{} segments end here, not 2: the segments must form closed rings",
                      ends[v].size()));
    neighbours.push_back({ends[v][0], ends[v][1]});
  }
  return neighbours;
}

std::vector<Point> read_holes(TextScanner& scanner) {
  std::vector<Point> holes;
  const std::uint64_t count = section_count(scanner, "the holes", 0);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto& fields = section_line(scanner, "a hole", 3, 3);
    holes.push_back({scanner.number(fields[1]), scanner.number(fields[2])});
  }
  return holes;
}

void skip_regions(TextScanner& scanner) {
  if (!scanner.next_line()) return;
  if (scanner.fields().size() != 1) scanner.fail("text after the holes");
  const std::uint64_t count = scanner.count(scanner.fields()[0]);
  for (std::uint64_t i = 0; i < count; ++i) (void)section_line(scanner, "a region", 4, 5);
  if (scanner.next_line()) scanner.fail("text after the regions");
}

/// Walks around the ring of `first`, towards its neighbour of the lower number.
Ring walk(const Chains& chains, std::size_t first, std::vector<bool>& visited) {
  Ring ring;
  std::size_t previous = std::max(chains.neighbours[first][0], chains.neighbours[first][1]);
  std::size_t at = first;
  do {
    visited[at] = true;
    ring.push_back(chains.points[at]);
    const auto& ends = chains.neighbours[at];
    const std::size_t next = ends[0] == previous ? ends[1] : ends[0];
    previous = at;
    at = next;
  } while (at != first);
  return ring;
}

/// The rings by their first vertices, but the ring with the leftmost vertex in front.
std::vector<Ring> assemble(const Chains& chains) {
  std::vector<Ring> rings;
  std::vector<bool> visited(chains.points.size(), false);
  const auto leftmost =
      std::min_element(chains.points.begin(), chains.points.end(), lexicographically_before);
  std::size_t outer = 0;
  for (std::size_t v = 0; v < chains.points.size(); ++v) {
    if (visited[v]) continue;
    const bool before = visited[static_cast<std::size_t>(leftmost - chains.points.begin())];
    rings.push_back(walk(chains, v, visited));
    const bool after = visited[static_cast<std::size_t>(leftmost - chains.points.begin())];
    if (after && !before) outer = rings.size() - 1;
  }
  const auto at = rings.begin() + static_cast<std::ptrdiff_t>(outer);
  std::rotate(rings.begin(), at, at + 1);
  return rings;
}

/// The smallest box around a ring.
struct Box {
  explicit Box(const Ring& ring) : low(ring.front()), high(ring.front()) {
    for (const Point& p : ring) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  [[nodiscard]] bool holds(const Point& p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
  }
  Point low;
  Point high;
};

void require_hole_points_inside(const std::vector<Point>& holes, const Polygon& polygon) {
  const std::vector<Box> boxes(polygon.rings.begin(), polygon.rings.end());
  for (std::size_t h = 0; h < holes.size(); ++h) {
    std::size_t r = 1;
    while (r < boxes.size() &&
           !(boxes[r].holds(holes[h]) && strictly_inside(holes[h], polygon.rings[r])))
      ++r;
    if (r == boxes.size())
      throw InputError({polygon.file, {}, {}},
                       fmt::format("hole point {} lies inside no inner ring", h));
  }
}

}  // namespace

Polygon parse_poly(std::string_view text, const std::string& file) {
  TextScanner scanner(text, file, TextScanner::Comments::kHash);
  TriangleVertices vertices = read_triangle_vertices(scanner);
  if (vertices.points.empty()) vertices = read_sibling(file);
  const Ends ends = read_segments(scanner, vertices);
  const std::vector<Point> holes = read_holes(scanner);
  skip_regions(scanner);
  if (vertices.points.empty()) throw InputError({file, {}, {}}, "the polygon is empty");
  const Chains chains{std::move(vertices.points), require_rings(ends, file)};
  Polygon polygon{file, assemble(chains)};
  require_hole_points_inside(holes, polygon);
  return polygon;
}

}  // namespace quadbound
