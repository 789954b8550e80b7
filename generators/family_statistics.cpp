// SPDX-License-Identifier: Apache-2.0
#include "generators/family_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "model/predicates.hpp"

namespace quadbound {
namespace {

double distance(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// Of a point from a segment.
double distance(const Point& p, const Point& a, const Point& b) {
  const Point d{b.x - a.x, b.y - a.y};
  const double t = ((p.x - a.x) * d.x + (p.y - a.y) * d.y) / (d.x * d.x + d.y * d.y);
  const double clamped = std::clamp(t, 0.0, 1.0);
  return distance(p, {a.x + clamped * d.x, a.y + clamped * d.y});
}

/// The angle on the left of a corner in degrees, in (0, 360).
double angle(const Point& before, const Point& at, const Point& after) {
  const Point in{before.x - at.x, before.y - at.y};
  const Point out{after.x - at.x, after.y - at.y};
  const double turned = std::atan2(out.x * in.y - out.y * in.x, in.x * out.x + in.y * out.y);
  return (turned < 0 ? turned + 2 * std::numbers::pi : turned) * 180 / std::numbers::pi;
}

std::size_t angle_class(double degrees) {
  const auto after = std::upper_bound(kAngleEnds.begin() + 1, kAngleEnds.end() - 1, degrees);
  return static_cast<std::size_t>(after - kAngleEnds.begin()) - 1;
}

std::size_t decade(double ratio) {
  std::size_t number = 0;
  for (double end = 0.1; number + 1 < kDecades && ratio < end; end /= 10) ++number;
  return number;
}

struct Edge {
  Point a;
  Point b;
  [[nodiscard]] double left() const { return std::min(a.x, b.x); }
  [[nodiscard]] double right() const { return std::max(a.x, b.x); }
};

std::vector<Edge> edges_from_left(const Polygon& polygon) {
  std::vector<Edge> edges;
  for (const Ring& ring : polygon.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
  std::ranges::sort(edges, {}, [](const Edge& e) { return e.left(); });
  return edges;
}

double extent(const Ring& ring) {
  const auto [left, right] = std::ranges::minmax_element(ring, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax_element(ring, {}, &Point::y);
  return std::max(right->x - left->x, high->y - low->y);
}

template <class Counts>
void add_each(Counts& sums, const Counts& values) {
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += values[i];
}

}  // namespace

double smallest_feature_size(const Polygon& polygon) {
  const std::vector<Edge> edges = edges_from_left(polygon);
  double smallest = std::numeric_limits<double>::infinity();
  for (const Edge& e : edges) smallest = std::min(smallest, distance(e.a, e.b));
  const auto try_vertex = [&smallest](const Point& p, const Edge& e) {
    if (p != e.a && p != e.b) smallest = std::min(smallest, distance(p, e.a, e.b));
  };
  // A vertex is near an edge only where the edges that start there and the edge are: each pair of
  // edges that are near in x is looked at once.
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      if (edges[j].left() > edges[i].right() + smallest) break;
      try_vertex(edges[i].a, edges[j]);
      try_vertex(edges[i].b, edges[j]);
      try_vertex(edges[j].a, edges[i]);
      try_vertex(edges[j].b, edges[i]);
    }
  return smallest;
}

void FamilyStatistics::add(const Polygon& polygon) {
  FamilyStatistics one;
  one.polygons = 1;
  one.holes = polygon.rings.size() - 1;
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0;
  for (const Ring& ring : polygon.rings) {
    one.vertices += ring.size();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& before = ring[(i + ring.size() - 1) % ring.size()];
      const Point& after = ring[(i + 1) % ring.size()];
      shortest = std::min(shortest, distance(ring[i], after));
      longest = std::max(longest, distance(ring[i], after));
      if (orientation(before, ring[i], after) == 0) {
        ++one.straight;
        continue;
      }
      const double degrees = angle(before, ring[i], after);
      ++one.angles[angle_class(degrees)];
      one.smallest_angle = std::min(one.smallest_angle, degrees);
      one.largest_angle = std::max(one.largest_angle, degrees);
    }
  }
  one.smallest_feature = smallest_feature_size(polygon) / extent(polygon.rings.front());
  one.largest_feature = one.smallest_feature;
  ++one.features[decade(one.smallest_feature)];
  one.smallest_edge_ratio = shortest / longest;
  one.largest_edge_ratio = one.smallest_edge_ratio;
  ++one.edges[decade(one.smallest_edge_ratio)];
  merge(one);
}

void FamilyStatistics::merge(const FamilyStatistics& other) {
  polygons += other.polygons;
  vertices += other.vertices;
  holes += other.holes;
  straight += other.straight;
  add_each(angles, other.angles);
  add_each(features, other.features);
  add_each(edges, other.edges);
  smallest_angle = std::min(smallest_angle, other.smallest_angle);
  largest_angle = std::max(largest_angle, other.largest_angle);
  smallest_feature = std::min(smallest_feature, other.smallest_feature);
  largest_feature = std::max(largest_feature, other.largest_feature);
  smallest_edge_ratio = std::min(smallest_edge_ratio, other.smallest_edge_ratio);
  largest_edge_ratio = std::max(largest_edge_ratio, other.largest_edge_ratio);
}

double FamilyStatistics::acute_share() const {
  const auto right = std::ranges::find(kAngleEnds, 90.0) - kAngleEnds.begin();
  return static_cast<double>(
             std::accumulate(angles.begin(), angles.begin() + right, std::uint64_t{0})) /
         static_cast<double>(vertices);
}

double FamilyStatistics::reflex_share() const {
  const auto flat = std::ranges::find(kAngleEnds, 180.0) - kAngleEnds.begin();
  return static_cast<double>(
             std::accumulate(angles.begin() + flat, angles.end(), std::uint64_t{0})) /
         static_cast<double>(vertices);
}

}  // namespace quadbound
