// SPDX-License-Identifier: Apache-2.0
#include "verify/naive_judge.hpp"

#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <initializer_list>
#include <set>

namespace quadbound::test {
namespace {

using Field = CGAL::Gmpq;
using Kernel = CGAL::Simple_cartesian<Field>;
using Location = Kernel::Point_2;
using Direction = Kernel::Direction_2;
using Edge = std::pair<VertexId, VertexId>;
using Locations = std::vector<Location>;

Field field(const Rational& value) { return Field(value.backend().data()); }
Verdict verdict(bool holds) { return holds ? Verdict::holds : Verdict::fails; }

bool is_malformed(const Mesh& mesh) {
  if (mesh.quads.empty()) return true;
  return std::any_of(mesh.quads.begin(), mesh.quads.end(), [&](const Quad& q) {
    return std::set<VertexId>(q.begin(), q.end()).size() != 4 ||
           *std::max_element(q.begin(), q.end()) >= mesh.vertices.size();
  });
}

struct NaiveCorner {
  std::pair<std::uint64_t, int> id;
  Field cross;
  Field dot;
  Location at, next, previous;
  /// From the outgoing edge as the x axis; corners without a direction count as zero degrees.
  [[nodiscard]] Direction direction() const {
    return cross == 0 && dot == 0 ? Direction(1, 0) : Direction(dot, cross);
  }
};

std::vector<NaiveCorner> corners_of(const Mesh& mesh, const Locations& p) {
  std::vector<NaiveCorner> corners;
  for (std::uint64_t q = 0; q < mesh.quads.size(); ++q) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Quad& quad = mesh.quads[q];
      const Location& at = p[quad[i]];
      const Location& next = p[quad[(i + 1) % 4]];
      const Location& previous = p[quad[(i + 3) % 4]];
      const auto u = next - at;
      const auto v = previous - at;
      corners.push_back(
          {{q, static_cast<int>(i)}, CGAL::determinant(u, v), u * v, at, next, previous});
    }
  }
  return corners;
}

/// The directions of the bounds, from the x axis.
struct Bounds {
  Direction low;
  Direction high;
  [[nodiscard]] bool is_too_small(const NaiveCorner& c) const { return c.direction() < low; }
  [[nodiscard]] bool is_too_large(const NaiveCorner& c) const { return c.direction() > high; }
};
const Bounds kOfPoints{{2, 1}, {-2, 1}};    // arctan(1/2), 180 degrees - arctan(1/2)
const Bounds kOfPolygons{{3, 1}, {-7, 1}};  // arctan(1/3), 180 degrees - arctan(1/7)

bool is_convex(const NaiveCorner& c) { return CGAL::left_turn(c.previous, c.at, c.next); }

/// 4 sqrt(2) 2^-53 M / l against the tangent of the excess, both squared.
bool is_within_slack(const NaiveCorner& c, const Direction& bound) {
  const Field x = bound.dx() * c.dot + bound.dy() * c.cross;  // the corner turned back by the bound
  const Field y = bound.dx() * c.cross - bound.dy() * c.dot;
  if (x <= 0) return false;
  Field largest = 0;
  for (const Location& p : {c.at, c.next, c.previous})
    largest = std::max({largest, Field(abs(p.x())), Field(abs(p.y()))});
  const Field shorter =
      std::min(CGAL::squared_distance(c.at, c.next), CGAL::squared_distance(c.at, c.previous));
  const Field unit = field(dyadic(1, -53));
  return y * y * shorter <= 32 * unit * unit * largest * largest * x * x;
}

template <class IsBroken>
StoredVerdict stored_verdict(const std::vector<NaiveCorner>& corners, const IsBroken& is_broken,
                             const Direction& bound, bool moved) {
  auto result = StoredVerdict::holds;
  for (const NaiveCorner& c : corners) {
    if (!is_broken(c)) continue;
    if (!moved || !is_within_slack(c, bound)) return StoredVerdict::fails;
    result = StoredVerdict::within_rounding;
  }
  return result;
}

/// Two convex polygons are disjoint inside exactly when an edge of one has all of the other on its
/// right or on itself.
bool separates(const Locations& p, const Quad& a, const Quad& b) {
  for (std::size_t i = 0; i < 4; ++i)
    if (std::none_of(b.begin(), b.end(),
                     [&](VertexId v) { return CGAL::left_turn(p[a[i]], p[a[(i + 1) % 4]], p[v]); }))
      return true;
  return false;
}

/// Whether a line x = c or y = c separates them; saves time only.
bool separated_by_boxes(const Kernel::Iso_rectangle_2& a, const Kernel::Iso_rectangle_2& b) {
  return a.xmax() <= b.xmin() || b.xmax() <= a.xmin() || a.ymax() <= b.ymin() ||
         b.ymax() <= a.ymin();
}

bool has_overlap(const Mesh& mesh, const Locations& p) {
  std::vector<Kernel::Iso_rectangle_2> boxes;
  for (const Quad& q : mesh.quads) {
    const Locations corners{p[q[0]], p[q[1]], p[q[2]], p[q[3]]};
    boxes.push_back(CGAL::bounding_box(corners.begin(), corners.end()));
  }
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!separated_by_boxes(boxes[i], boxes[j]) && !separates(p, mesh.quads[i], mesh.quads[j]) &&
          !separates(p, mesh.quads[j], mesh.quads[i]))
        return true;
  return false;
}

struct Edges {
  std::multiset<Edge> directed;
  std::set<Edge> unpaired;
  std::set<Edge> undirected;
  std::set<VertexId> vertices;
};

Edges edges_of(const Mesh& mesh) {
  Edges edges;
  for (const Quad& q : mesh.quads) {
    for (std::size_t i = 0; i < 4; ++i) {
      const VertexId a = q[i];
      const VertexId b = q[(i + 1) % 4];
      edges.vertices.insert(a);
      edges.directed.insert({a, b});
      edges.undirected.insert(std::minmax(a, b));
    }
  }
  for (const Edge& e : edges.directed)
    if (edges.directed.count({e.second, e.first}) == 0) edges.unpaired.insert(e);
  return edges;
}

bool is_conforming(const Edges& edges, const Locations& p) {
  for (const Edge& e : edges.directed)
    if (edges.directed.count(e) > 1) return false;
  for (const Edge& e : edges.unpaired)
    for (const Edge& f : edges.unpaired)
      for (const VertexId v : {f.first, f.second})
        if (CGAL::collinear(p[e.first], p[v], p[e.second]) &&
            CGAL::collinear_are_strictly_ordered_along_line(p[e.first], p[v], p[e.second]))
          return false;
  return true;
}

/// The closed loops of the unpaired edges; nothing where they branch.
std::optional<std::vector<CGAL::Polygon_2<Kernel>>> loops_of(const Edges& edges,
                                                             const Locations& p) {
  std::map<VertexId, VertexId> next;
  std::set<VertexId> reached;
  for (const Edge& e : edges.unpaired)
    if (!next.insert(e).second || !reached.insert(e.second).second) return std::nullopt;
  for (const VertexId v : reached)
    if (next.count(v) == 0) return std::nullopt;
  std::vector<CGAL::Polygon_2<Kernel>> loops;
  while (!next.empty()) {
    CGAL::Polygon_2<Kernel> loop;
    auto at = next.begin();
    while (at != next.end()) {
      loop.push_back(p[at->first]);
      const VertexId to = at->second;
      next.erase(at);
      at = next.find(to);
    }
    loops.push_back(loop);
  }
  return loops;
}

/// The member function would insist on a simple polygon.
Field area_of(const Locations& loop) {
  return CGAL::polygon_area_2(loop.begin(), loop.end(), Kernel());
}

bool is_simple(const CGAL::Polygon_2<Kernel>& loop) {
  const std::set<Location> places(loop.vertices_begin(), loop.vertices_end());
  return places.size() == loop.size() && loop.is_simple();
}

bool is_kept(const Point& point, const Edges& edges, const Locations& p) {
  const Location place{Field(point.x), Field(point.y)};
  return std::any_of(edges.vertices.begin(), edges.vertices.end(),
                     [&](VertexId v) { return p[v] == place; });
}

Field covered_area(const Mesh& mesh, const Locations& p) {
  Field covered = 0;
  for (const Quad& q : mesh.quads) covered += area_of({p[q[0]], p[q[1]], p[q[2]], p[q[3]]});
  return covered;
}

void judge_one_boundary(const Mesh& mesh, const Edges& edges, const Locations& p,
                        NaiveReport& report) {
  const auto loops = loops_of(edges, p);
  report.exact["one-boundary"] = verdict(loops && loops->size() == 1 && is_simple(loops->front()));
  report.exact["area"] = Verdict::not_decided;
  if (!loops || loops->empty()) return;
  Field enclosed = area_of(loops->front().container());
  for (const auto& loop : *loops) enclosed = std::max(enclosed, area_of(loop.container()));
  report.exact["area"] = verdict(covered_area(mesh, p) == enclosed);
}

Location location(const Point& point) { return {Field(point.x), Field(point.y)}; }

/// The unpaired edges that lie on a -> b in its direction, from a on.
std::vector<Edge> edges_along(const Location& a, const Location& b, const Edges& edges,
                              const Locations& p) {
  const Kernel::Segment_2 segment(a, b);
  std::vector<Edge> along;
  for (const Edge& e : edges.unpaired)
    if (segment.has_on(p[e.first]) && segment.has_on(p[e.second]) &&
        (p[e.second] - p[e.first]) * (b - a) > 0)
      along.push_back(e);
  std::sort(along.begin(), along.end(), [&](const Edge& e, const Edge& f) {
    return CGAL::has_smaller_distance_to_point(a, p[e.first], p[f.first]);
  });
  return along;
}

/// Every edge of the polygon is cut up into unpaired edges, and that is all of them.
bool is_boundary_kept(const Polygon& polygon, const Edges& edges, const Locations& p) {
  if (!loops_of(edges, p)) return false;
  std::size_t count = 0;
  for (const Ring& ring : polygon.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Location reached = location(ring[i]);
      const Location end = location(ring[(i + 1) % ring.size()]);
      for (const Edge& e : edges_along(reached, end, edges, p)) {
        if (p[e.first] != reached) return false;
        reached = p[e.second];
        ++count;
      }
      if (reached != end) return false;
    }
  }
  return count == edges.unpaired.size();
}

/// Corners that no other shares the vertex with, at a vertex of the polygon.
std::set<std::pair<std::uint64_t, int>> whole_corners(const Polygon& polygon, const Mesh& mesh,
                                                      const Locations& p) {
  std::map<VertexId, std::vector<std::pair<std::uint64_t, int>>> corners;
  for (std::uint64_t q = 0; q < mesh.quads.size(); ++q)
    for (std::size_t i = 0; i < 4; ++i)
      corners[mesh.quads[q][i]].emplace_back(q, static_cast<int>(i));
  std::set<std::pair<std::uint64_t, int>> whole;
  for (const auto& [v, ids] : corners)
    for (const Ring& ring : polygon.rings)
      for (const Point& point : ring)
        if (ids.size() == 1 && location(point) == p[v]) whole.insert(ids.front());
  return whole;
}

/// The corners without those that no bound judges.
std::vector<NaiveCorner> judged_corners(const Mesh& mesh, const Locations& p,
                                        const NaiveReport& report) {
  std::vector<NaiveCorner> corners = corners_of(mesh, p);
  std::erase_if(corners, [&](const NaiveCorner& c) { return report.whole.count(c.id) != 0; });
  return corners;
}

void judge_corners(const Mesh& mesh, const Locations& p, const Bounds& bounds,
                   NaiveReport& report) {
  const auto all = corners_of(mesh, p);
  report.exact["strictly-convex"] = verdict(std::all_of(all.begin(), all.end(), is_convex));
  const auto corners = judged_corners(mesh, p, report);
  bool small = false;
  bool large = false;
  for (const NaiveCorner& c : corners) {
    small |= bounds.is_too_small(c);
    large |= bounds.is_too_large(c);
  }
  report.exact["min-angle"] = verdict(!small);
  report.exact["max-angle"] = verdict(!large);
  const auto less = [](const NaiveCorner& a, const NaiveCorner& b) {
    return a.direction() < b.direction();
  };
  if (corners.empty()) return;
  report.smallest = std::min_element(corners.begin(), corners.end(), less)->id;
  report.largest = std::max_element(corners.begin(), corners.end(), less)->id;
}

void judge_stored(const Mesh& mesh, const Edges& edges, const Locations& p, const Bounds& bounds,
                  NaiveReport& report) {
  Locations stored;
  bool moved = false;
  for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
    const Point rounded = mesh.vertices.rounded(v);
    stored.push_back(location(rounded));
    moved |= edges.vertices.count(v) != 0 && stored[v] != p[v];
  }
  const auto corners = judged_corners(mesh, stored, report);
  report.stored["min-angle"] = stored_verdict(
      corners, [&](const NaiveCorner& c) { return bounds.is_too_small(c); }, bounds.low, moved);
  report.stored["max-angle"] = stored_verdict(
      corners, [&](const NaiveCorner& c) { return bounds.is_too_large(c); }, bounds.high, moved);
  const auto all = corners_of(mesh, stored);
  report.stored["strictly-convex"] =
      std::all_of(all.begin(), all.end(), is_convex) ? StoredVerdict::holds : StoredVerdict::fails;
}

Locations locations_of(const Mesh& mesh) {
  Locations p;
  for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
    const RationalPoint exact = mesh.vertices.exact(v);
    p.emplace_back(field(exact.x), field(exact.y));
  }
  return p;
}

/// What does not depend on the theorem. Returns whether there is anything else to judge.
bool judge_quads(const Mesh& mesh, std::uint64_t quads_per_cell, const char* size_claim,
                 std::initializer_list<const char*> undecided, NaiveReport& report) {
  report.exact[size_claim] = mesh.cells == 0
                                 ? Verdict::not_decided
                                 : verdict(mesh.quads.size() <= quads_per_cell * mesh.cells);
  report.exact["all-quad"] = verdict(!is_malformed(mesh) && mesh.other_faces.empty());
  if (!is_malformed(mesh)) return true;
  for (const char* id : {"distinct-vertices", "conforming", "strictly-convex", "no-overlap",
                         "euler", "area", "min-angle", "max-angle"})
    report.exact[id] = Verdict::not_decided;
  for (const char* id : undecided) report.exact[id] = Verdict::not_decided;
  return false;
}

void judge_mesh(const Mesh& mesh, const Edges& edges, const Locations& p, const Bounds& bounds,
                NaiveReport& report) {
  std::set<Location> places;
  for (const VertexId v : edges.vertices) places.insert(p[v]);
  report.exact["distinct-vertices"] = verdict(places.size() == edges.vertices.size());
  report.exact["conforming"] = verdict(is_conforming(edges, p));
  judge_corners(mesh, p, bounds, report);
  report.exact["no-overlap"] = report.exact["strictly-convex"] == Verdict::holds
                                   ? verdict(!has_overlap(mesh, p))
                                   : Verdict::not_decided;
  judge_stored(mesh, edges, p, bounds, report);
}

}  // namespace

NaiveReport naive_judge(const PointSet& points, const Mesh& mesh) {
  NaiveReport report;
  if (!judge_quads(mesh, 3, "size-3N", {"one-boundary", "points-kept"}, report)) return report;
  const Locations p = locations_of(mesh);
  const Edges edges = edges_of(mesh);
  report.exact["euler"] =
      verdict(edges.vertices.size() + mesh.quads.size() == edges.undirected.size() + 1);
  report.exact["points-kept"] =
      verdict(std::all_of(points.points.begin(), points.points.end(),
                          [&](const Point& point) { return is_kept(point, edges, p); }));
  judge_one_boundary(mesh, edges, p, report);
  judge_mesh(mesh, edges, p, kOfPoints, report);
  return report;
}

NaiveReport naive_judge(const Polygon& polygon, const Mesh& mesh) {
  NaiveReport report;
  if (!judge_quads(mesh, 5, "size-5N", {"boundary-kept"}, report)) return report;
  const Locations p = locations_of(mesh);
  const Edges edges = edges_of(mesh);
  report.whole = whole_corners(polygon, mesh, p);
  report.exact["euler"] =
      verdict(edges.vertices.size() + mesh.quads.size() + polygon.rings.size() ==
              edges.undirected.size() + 2);
  report.exact["boundary-kept"] = verdict(is_boundary_kept(polygon, edges, p));
  Field area = 0;
  for (const Ring& ring : polygon.rings) {
    Locations corners;
    for (const Point& point : ring) corners.push_back(location(point));
    area += area_of(corners);
  }
  report.exact["area"] = verdict(covered_area(mesh, p) == area);
  judge_mesh(mesh, edges, p, kOfPolygons, report);
  return report;
}

}  // namespace quadbound::test
