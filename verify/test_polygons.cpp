// SPDX-License-Identifier: Apache-2.0
#include "verify/test_polygons.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "model/angle.hpp"

namespace quadbound::test {
namespace {

/// The vertex after each boundary vertex.
std::map<VertexId, VertexId> boundary_of(const Mesh& mesh) {
  std::set<std::pair<VertexId, VertexId>> edges;
  for (const Quad& q : mesh.quads)
    for (std::size_t i = 0; i < 4; ++i) edges.insert({q[i], q[(i + 1) % 4]});
  std::map<VertexId, VertexId> next;
  for (const auto& [from, to] : edges)
    if (edges.count({to, from}) == 0) next[from] = to;
  return next;
}

Ring ring_of(const Mesh& mesh, const std::vector<VertexId>& loop, unsigned kept_straight) {
  Ring ring;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const VertexId v = loop[i];
    const VertexId after = loop[(i + 1) % loop.size()];
    const VertexId before = loop[(i + loop.size() - 1) % loop.size()];
    const auto corner = corner_at<Rational>(mesh.vertices.exact(v), mesh.vertices.exact(after),
                                            mesh.vertices.exact(before));
    if (corner.cross != 0 || (kept_straight != 0 && v % kept_straight == 0))
      ring.push_back(mesh.vertices.rounded(v));
  }
  return ring;
}

bool is_clockwise(const Ring& ring) {
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    area += (a.x - ring[0].x) * (b.y - ring[0].y) - (a.y - ring[0].y) * (b.x - ring[0].x);
  }
  return area < 0;
}

std::vector<Rational> lines(unsigned count) {
  std::vector<Rational> result;
  for (unsigned i = 0; i <= count; ++i) result.emplace_back(i);
  return result;
}

}  // namespace

Case with_polygon(Case made, unsigned kept_straight) {
  made.polygon.rings.clear();
  auto next = boundary_of(made.mesh);
  while (!next.empty()) {
    std::vector<VertexId> loop;
    for (auto at = next.begin(); at != next.end();) {
      loop.push_back(at->first);
      const VertexId to = at->second;
      next.erase(at);
      at = next.find(to);
    }
    made.polygon.rings.push_back(ring_of(made.mesh, loop, kept_straight));
  }
  std::stable_partition(made.polygon.rings.begin(), made.polygon.rings.end(),
                        [](const Ring& ring) { return !is_clockwise(ring); });
  return made;
}

Case rectangles(std::string name, const std::vector<Rational>& xs, const std::vector<Rational>& ys,
                const Cells& removed, const Rational& slope, unsigned kept_straight) {
  Positions positions;
  for (const Rational& y : ys)
    for (const Rational& x : xs) positions.push_back({x + slope * y, y});
  std::vector<Quad> quads;
  const auto columns = static_cast<unsigned>(xs.size());
  for (unsigned j = 0; j + 1 < ys.size(); ++j) {
    for (unsigned i = 0; i + 1 < columns; ++i) {
      if (std::count(removed.begin(), removed.end(), std::pair(i, j)) != 0) continue;
      const VertexId v = j * columns + i;
      quads.push_back({v, v + 1, v + columns + 1, v + columns});
    }
  }
  return with_polygon(make_case(std::move(name), positions, quads), kept_straight);
}

Case square() { return rectangles("square", lines(3), lines(3), {}); }
Case l_shape() { return rectangles("L", lines(4), lines(4), {{2, 2}, {3, 2}, {2, 3}, {3, 3}}); }
Case square_with_hole() { return rectangles("square with a hole", lines(4), lines(4), {{1, 1}}); }

Case hole_with_thirds(const Rational& slope) {
  const std::vector<Rational> ys{0, 1, Rational(4, 3), 2, 3};
  return rectangles("hole with thirds", {0, Rational(1, 3), 1, 2, 3}, ys, {{2, 1}, {2, 2}}, slope);
}

std::vector<Case> valid_polygon_cases() {
  std::vector<Case> all{square(), l_shape(), square_with_hole()};
  for (const Rational& slope : {Rational(0), Rational(1), Rational(-3, 2), Rational(3)})
    all.push_back(hole_with_thirds(slope));
  all.push_back(rectangles("straight vertices", lines(4), lines(3), {{1, 1}}, 0, 3));
  all.push_back(rectangles("two holes", lines(5), lines(3), {{1, 1}, {3, 1}}, Rational(1, 2), 2));
  all.push_back(rectangles("one cell", lines(1), lines(1), {}, 5));
  // Two quads that split the angle at the origin, exactly at the lower and at the upper bound.
  const Positions lower{{0, 0}, {6, 0}, {8, 1}, {6, 2}, {4, 8}, {-2, 6}};
  const Positions upper{{0, 0}, {1, 0}, {-3, 4}, {-7, 1}, {-10, -3}, {-3, -4}};
  for (const Positions& p : {lower, upper})
    all.push_back(with_polygon(make_case("split angle", p, {{0, 1, 2, 3}, {0, 3, 4, 5}})));
  std::mt19937_64 random(5);
  all.push_back(with_polygon(perturbed_grid(4, 3, random)));
  all.push_back(with_polygon(mapped(square_with_hole(), "far away", dyadic(1, 40), 12345, 0)));
  all.push_back(with_polygon(mapped(l_shape(), "partly on the lattice", Rational(1, 2), 0, 0)));
  all.push_back(with_polygon(mapped(square_with_hole(), "fine", dyadic(1, -900), 0, -930), 3));
  return all;
}

}  // namespace quadbound::test
