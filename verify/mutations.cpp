// SPDX-License-Identifier: Apache-2.0
#include "verify/mutations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace quadbound::test {
namespace {

Quad& any_quad(Mesh& mesh, Random& random) { return mesh.quads[pick(random, mesh.quads.size())]; }
VertexId any_vertex(const Mesh& mesh, Random& random) {
  return mesh.quads[pick(random, mesh.quads.size())][pick(random, 4)];
}

void move_by(Mesh& mesh, VertexId v, const Rational& dx, const Rational& dy) {
  const RationalPoint p = mesh.vertices.exact(v);
  mesh.vertices.move_to_exact(v, {p.x + dx, p.y + dy});
}

/// From -size to size, in hundredths of it.
Rational random_step(Random& random, const Rational& size) {
  return size * Rational(static_cast<int>(pick(random, 201)) - 100, 100);
}

/// The length of the first edge of some quad, in the 1-norm.
Rational edge_size(const Mesh& mesh) {
  const RationalPoint a = mesh.vertices.exact(mesh.quads[0][0]);
  const RationalPoint b = mesh.vertices.exact(mesh.quads[0][1]);
  return Rational(abs(Rational(a.x - b.x))) + Rational(abs(Rational(a.y - b.y)));
}

VertexId add_between(Mesh& mesh, VertexId a, VertexId b, const Rational& t) {
  const RationalPoint p = mesh.vertices.exact(a);
  const RationalPoint q = mesh.vertices.exact(b);
  return mesh.vertices.add_exact({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
}

void move_tiny(Case& c, Random& random) {
  const int exponent = static_cast<int>(pick(random, 2)) * 40;
  const Rational step = dyadic(1, c.mesh.vertices.exponent() - exponent);
  const auto sign = [&] { return static_cast<int>(pick(random, 3)) - 1; };
  move_by(c.mesh, any_vertex(c.mesh, random), sign() * step, sign() * step);
}
void move_some(Case& c, Random& random) {
  const Rational size = edge_size(c.mesh);
  move_by(c.mesh, any_vertex(c.mesh, random), random_step(random, size), random_step(random, size));
}
void move_far(Case& c, Random& random) {
  const Rational size = 8 * edge_size(c.mesh);
  move_by(c.mesh, any_vertex(c.mesh, random), random_step(random, size), random_step(random, size));
}
void move_onto_vertex(Case& c, Random& random) {
  const VertexId to = any_vertex(c.mesh, random);
  c.mesh.vertices.move_to_exact(any_vertex(c.mesh, random), c.mesh.vertices.exact(to));
}
void move_onto_edge(Case& c, Random& random) {
  const Quad q = any_quad(c.mesh, random);
  const std::size_t i = pick(random, 4);
  const RationalPoint a = c.mesh.vertices.exact(q[i]);
  const RationalPoint b = c.mesh.vertices.exact(q[(i + 1) % 4]);
  const Rational t(static_cast<int>(1 + pick(random, 3)), 4);
  c.mesh.vertices.move_to_exact(any_vertex(c.mesh, random),
                                {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
}
void straighten_corner(Case& c, Random& random) {
  const Quad q = any_quad(c.mesh, random);
  const std::size_t i = pick(random, 4);
  const RationalPoint a = c.mesh.vertices.exact(q[(i + 3) % 4]);
  const RationalPoint b = c.mesh.vertices.exact(q[(i + 1) % 4]);
  c.mesh.vertices.move_to_exact(q[i], {(a.x + b.x) / 2, (a.y + b.y) / 2});
}
void flip_quad(Case& c, Random& random) {
  Quad& q = any_quad(c.mesh, random);
  std::reverse(q.begin(), q.end());
}
void drop_quad(Case& c, Random& random) {
  c.mesh.quads.erase(c.mesh.quads.begin() +
                     static_cast<std::ptrdiff_t>(pick(random, c.mesh.quads.size())));
}
void double_quad(Case& c, Random& random) {
  Quad q = any_quad(c.mesh, random);
  std::rotate(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(pick(random, 4)), q.end());
  if (pick(random, 3) == 0) std::reverse(q.begin(), q.end());
  c.mesh.quads.push_back(q);
}
void split_into_triangles(Case& c, Random& random) {
  const std::size_t i = pick(random, c.mesh.quads.size());
  const Quad q = c.mesh.quads[i];
  c.mesh.quads.erase(c.mesh.quads.begin() + static_cast<std::ptrdiff_t>(i));
  c.mesh.other_faces.push_back({q[0], q[1], q[2]});
  c.mesh.other_faces.push_back({q[0], q[2], q[3]});
}
void add_other_face(Case& c, Random& random) {
  c.mesh.other_faces.push_back({any_vertex(c.mesh, random), 0, 1});
}
void hang_nodes(Case& c, Random& random) {
  const std::size_t i = pick(random, c.mesh.quads.size());
  Quad q = c.mesh.quads[i];
  std::rotate(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(pick(random, 2)), q.end());
  const Rational t(static_cast<int>(2 + pick(random, 3)), 6);
  const VertexId m = add_between(c.mesh, q[0], q[1], t);
  const VertexId n = add_between(c.mesh, q[3], q[2], t);
  c.mesh.quads[i] = {q[0], m, n, q[3]};
  c.mesh.quads.push_back({m, q[1], q[2], n});
}
/// One corner of one quad gets a vertex of its own at the same place.
void tear_corner(Case& c, Random& random) {
  VertexId& v = any_quad(c.mesh, random)[pick(random, 4)];
  v = c.mesh.vertices.add_exact(c.mesh.vertices.exact(v));
}
/// All quads after some one get a vertex of their own: slits, and cuts right through.
void tear_vertex(Case& c, Random& random) {
  const VertexId v = any_vertex(c.mesh, random);
  const VertexId twin = c.mesh.vertices.add_exact(c.mesh.vertices.exact(v));
  for (std::size_t i = pick(random, c.mesh.quads.size()); i < c.mesh.quads.size(); ++i)
    std::replace(c.mesh.quads[i].begin(), c.mesh.quads[i].end(), v, twin);
}
/// A quad on some edge, on either side of it and of any size: mostly a second sheet.
void glue_quad(Case& c, Random& random) {
  const Quad q = any_quad(c.mesh, random);
  const std::size_t i = pick(random, 4);
  const VertexId a = q[i];
  const VertexId b = q[(i + 1) % 4];
  const RationalPoint p = c.mesh.vertices.exact(a);
  const RationalPoint r = c.mesh.vertices.exact(b);
  Rational side(static_cast<int>(pick(random, 4)) + 1, 2);
  if (pick(random, 2) == 0) side = -side;
  const Rational dx = side * (r.y - p.y);
  const Rational dy = -side * (r.x - p.x);
  const VertexId far_b = c.mesh.vertices.add_exact({r.x + dx, r.y + dy});
  const VertexId far_a = c.mesh.vertices.add_exact({p.x + dx, p.y + dy});
  if (side > 0) {
    c.mesh.quads.push_back({b, a, far_a, far_b});
  } else {
    c.mesh.quads.push_back({a, b, far_b, far_a});
  }
}
/// A copy of the whole mesh that shares a vertex, or nothing, with it.
void add_copy(Case& c, Random& random) {
  const std::size_t count = c.mesh.quads.size();
  const auto vertices = static_cast<VertexId>(c.mesh.vertices.size());
  const Rational size = edge_size(c.mesh);
  const Rational reach = pick(random, 4) == 0 ? Rational(8 * size) : size;
  const Rational dx = random_step(random, reach);
  const Rational dy = random_step(random, reach);
  for (VertexId v = 0; v < vertices; ++v) {
    const RationalPoint p = c.mesh.vertices.exact(v);
    c.mesh.vertices.add_exact({p.x + dx, p.y + dy});
  }
  for (std::size_t i = 0; i < count; ++i) {
    Quad q = c.mesh.quads[i];
    for (VertexId& v : q) v += vertices;
    c.mesh.quads.push_back(q);
  }
}
void merge_vertices(Case& c, Random& random) {
  const VertexId from = any_vertex(c.mesh, random);
  const VertexId to = any_vertex(c.mesh, random);
  for (Quad& q : c.mesh.quads) std::replace(q.begin(), q.end(), from, to);
}
void swap_within_quad(Case& c, Random& random) {
  Quad& q = any_quad(c.mesh, random);
  const std::size_t i = pick(random, 4);
  std::swap(q[i], q[(i + 1 + pick(random, 3)) % 4]);
}
void swap_between_quads(Case& c, Random& random) {
  std::swap(any_quad(c.mesh, random)[pick(random, 4)], any_quad(c.mesh, random)[pick(random, 4)]);
}
void change_id(Case& c, Random& random) {
  any_quad(c.mesh, random)[pick(random, 4)] =
      static_cast<VertexId>(pick(random, c.mesh.vertices.size() + 1));
}
void exchange_positions(Case& c, Random& random) {
  const VertexId v = any_vertex(c.mesh, random);
  const VertexId w = any_vertex(c.mesh, random);
  const RationalPoint p = c.mesh.vertices.exact(v);
  c.mesh.vertices.move_to_exact(v, c.mesh.vertices.exact(w));
  c.mesh.vertices.move_to_exact(w, p);
}
void mirror(Case& c, Random&) {
  for (VertexId v = 0; v < c.mesh.vertices.size(); ++v) {
    const RationalPoint p = c.mesh.vertices.exact(v);
    c.mesh.vertices.move_to_exact(v, {-p.x, p.y});
  }
}
void squeeze(Case& c, Random& random) {
  const Rational factor(static_cast<int>(1 + pick(random, 12)), 8);
  for (VertexId v = 0; v < c.mesh.vertices.size(); ++v) {
    const RationalPoint p = c.mesh.vertices.exact(v);
    c.mesh.vertices.move_to_exact(v, {factor * p.x, p.y});
  }
}
void nudge_point(Case& c, Random& random) {
  if (c.points.points.empty()) return;
  Point& p = c.points.points[pick(random, c.points.points.size())];
  double& value = pick(random, 2) == 0 ? p.x : p.y;
  value = std::nextafter(value, pick(random, 2) == 0 ? -INFINITY : INFINITY);
}
void add_point(Case& c, Random& random) {
  const auto coordinate = [&] { return static_cast<double>(pick(random, 8)) / 2; };
  c.points.points.push_back({coordinate(), coordinate()});
}
void change_cells(Case& c, Random& random) {
  c.mesh.cells = (c.mesh.quads.size() - 1) / 3 + pick(random, 2);
}

// Damage that is none.
void rotate_corners(Case& c, Random& random) {
  for (Quad& q : c.mesh.quads)
    std::rotate(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(pick(random, 4)), q.end());
}
void reorder_quads(Case& c, Random& random) {
  std::shuffle(c.mesh.quads.begin(), c.mesh.quads.end(), random);
}
void renumber_vertices(Case& c, Random& random) {
  std::vector<VertexId> order(c.mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), random);
  const Vertices old = c.mesh.vertices;
  for (VertexId v = 0; v < order.size(); ++v) c.mesh.vertices.move_to_exact(order[v], old.exact(v));
  for (Quad& q : c.mesh.quads)
    for (VertexId& v : q) v = order[v];
}

// Damage to polygons and their boundaries.

/// An unpaired edge; the mesh has one.
std::pair<VertexId, VertexId> any_boundary_edge(const Mesh& mesh, Random& random) {
  std::set<std::pair<VertexId, VertexId>> edges;
  for (const Quad& q : mesh.quads)
    for (std::size_t i = 0; i < 4; ++i) edges.insert({q[i], q[(i + 1) % 4]});
  std::vector<std::pair<VertexId, VertexId>> unpaired;
  for (const auto& [from, to] : edges)
    if (edges.count({to, from}) == 0) unpaired.emplace_back(from, to);
  return unpaired.empty() ? std::pair(any_vertex(mesh, random), any_vertex(mesh, random))
                          : unpaired[pick(random, unpaired.size())];
}
/// Along the line to the vertex after it: by a little, onto it, past it, or backwards.
void slide_along_boundary(Case& c, Random& random) {
  const auto [v, after] = any_boundary_edge(c.mesh, random);
  const RationalPoint p = c.mesh.vertices.exact(v);
  const RationalPoint q = c.mesh.vertices.exact(after);
  const Rational t(static_cast<int>(pick(random, 14)) - 4, 6);
  c.mesh.vertices.move_to_exact(v, {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
}
void push_off_boundary(Case& c, Random& random) {
  const auto [v, after] = any_boundary_edge(c.mesh, random);
  const RationalPoint p = c.mesh.vertices.exact(v);
  const RationalPoint q = c.mesh.vertices.exact(after);
  Rational t = dyadic(1, -5 * static_cast<int>(pick(random, 20)) - 3) / 3;
  if (pick(random, 2) == 0) t = -t;
  c.mesh.vertices.move_to_exact(v, {p.x + t * (p.y - q.y), p.y + t * (q.x - p.x)});
}
Ring& any_ring(Case& c, Random& random) {
  return c.polygon.rings[pick(random, c.polygon.rings.size())];
}
/// A vertex at the middle of an edge, where there may be a Steiner point.
void add_ring_vertex(Case& c, Random& random) {
  Ring& ring = any_ring(c, random);
  const std::size_t i = pick(random, ring.size());
  const Point a = ring[i];
  const Point b = ring[(i + 1) % ring.size()];
  const Point middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
}
void drop_ring_vertex(Case& c, Random& random) {
  Ring& ring = any_ring(c, random);
  if (ring.size() > 3)
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(pick(random, ring.size())));
}
void nudge_ring_vertex(Case& c, Random& random) {
  Ring& ring = any_ring(c, random);
  Point& p = ring[pick(random, ring.size())];
  double& value = p.x == 0 || (p.y != 0 && pick(random, 2) == 0) ? p.y : p.x;
  if (value != 0) value = std::nextafter(value, pick(random, 2) == 0 ? -INFINITY : INFINITY);
}
void drop_hole(Case& c, Random&) {
  if (c.polygon.rings.size() > 1) c.polygon.rings.pop_back();
}
void change_cells_of_polygon(Case& c, Random& random) {
  c.mesh.cells = (c.mesh.quads.size() - 1) / 5 + pick(random, 8) / 7;
}
void start_rings_elsewhere(Case& c, Random& random) {
  for (Ring& ring : c.polygon.rings)
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(pick(random, ring.size())),
                ring.end());
}

constexpr Mutation kOfMeshes[] = {
    {"vertex moved by a unit", move_tiny, 5},
    {"vertex moved within its surroundings", move_some, 50},
    {"vertex moved far", move_far, 80},
    {"vertex moved onto another", move_onto_vertex, 50},
    {"vertex moved onto an edge", move_onto_edge, 80},
    {"corner straightened", straighten_corner, 80},
    {"quad flipped", flip_quad, 95},
    {"quad dropped", drop_quad, 30},
    {"quad doubled", double_quad, 95},
    {"quad split into triangles", split_into_triangles, 95},
    {"other face added", add_other_face, 95},
    {"hanging nodes", hang_nodes, 50},
    {"corner torn off", tear_corner, 60},
    {"vertex torn in two", tear_vertex, 10},
    {"quad glued on", glue_quad, 70},
    {"whole mesh copied", add_copy, 95},
    {"vertices merged", merge_vertices, 50},
    {"corners of a quad exchanged", swap_within_quad, 95},
    {"corners of two quads exchanged", swap_between_quads, 80},
    {"corner given to any vertex", change_id, 80},
    {"positions exchanged", exchange_positions, 50},
    {"mesh mirrored", mirror, 95},
    {"mesh squeezed", squeeze, 30},
};
constexpr Mutation kHarmless[] = {
    {"corners of all quads rotated", rotate_corners, 0},
    {"quads reordered", reorder_quads, 0},
    {"vertices renumbered", renumber_vertices, 0},
};
constexpr Mutation kOfPoints[] = {
    {"input point moved by one ulp", nudge_point, 70},
    {"input point added", add_point, 30},
    {"cells counted wrongly", change_cells, 30},
};
constexpr Mutation kOfPolygons[] = {
    {"boundary vertex slid along the boundary", slide_along_boundary, 40},
    {"boundary vertex pushed off the boundary", push_off_boundary, 60},
    {"vertex added to a ring", add_ring_vertex, 30},
    {"vertex dropped from a ring", drop_ring_vertex, 40},
    {"ring vertex moved by one ulp", nudge_ring_vertex, 50},
    {"hole dropped", drop_hole, 30},
    {"cells counted wrongly", change_cells_of_polygon, 30},
    {"rings started elsewhere", start_rings_elsewhere, 0},
};

std::vector<Mutation> with_common(std::span<const Mutation> own) {
  std::vector<Mutation> all(std::begin(kOfMeshes), std::end(kOfMeshes));
  all.insert(all.end(), own.begin(), own.end());
  all.insert(all.end(), std::begin(kHarmless), std::end(kHarmless));
  return all;
}

}  // namespace

std::vector<Mutation> mutations_for_points() { return with_common(kOfPoints); }
std::vector<Mutation> mutations_for_polygons() { return with_common(kOfPolygons); }

}  // namespace quadbound::test
