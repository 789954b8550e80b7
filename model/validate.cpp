// SPDX-License-Identifier: Apache-2.0
#include "model/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "model/errors.hpp"
#include "model/predicates.hpp"
#include "model/ring_sweep.hpp"

namespace quadbound {
namespace {

void require_in_range(const Point& point, const InputLocation& where) {
  for (const double value : {point.x, point.y}) {
    if (!std::isfinite(value)) throw InputError(where, "a coordinate is not finite");
    const double magnitude = std::abs(value);
    if (value != 0 && (magnitude < std::ldexp(1.0, -kLargestExponent) ||
                       magnitude > std::ldexp(1.0, kLargestExponent)))
      throw InputError(where, fmt::format("the coordinate {} is out of range: zero and magnitudes "
                                          "from 2^-{} to 2^{} are allowed",
                                          value, kLargestExponent, kLargestExponent));
  }
}

struct Repeat {
  std::size_t first;
  std::size_t second;
};

/// Of all points that occur again the first, with the next one that equals it.
std::optional<Repeat> first_repeat(const std::vector<Point>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (points[a] == points[b]) return a < b;
    return lexicographically_before(points[a], points[b]);
  });
  std::optional<Repeat> found;
  for (std::size_t i = 1; i < order.size(); ++i)
    if (points[order[i - 1]] == points[order[i]] && (!found || order[i - 1] < found->first))
      found = Repeat{order[i - 1], order[i]};
  return found;
}

/// A vertex of a polygon, also named by its ring and its place there.
class Corners {
 public:
  explicit Corners(const Polygon& polygon) : polygon_(&polygon) {
    for (const Ring& ring : polygon.rings) {
      first_.push_back(points_.size());
      points_.insert(points_.end(), ring.begin(), ring.end());
    }
  }
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  [[nodiscard]] std::size_t ring(std::size_t vertex) const {
    return static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), vertex) -
                                    first_.begin()) -
           1;
  }
  [[nodiscard]] std::size_t next(std::size_t vertex) const {
    const std::size_t r = ring(vertex);
    return vertex + 1 == first_[r] + polygon_->rings[r].size() ? first_[r] : vertex + 1;
  }
  [[nodiscard]] InputLocation location(std::size_t vertex) const {
    return {polygon_->file, ring(vertex), vertex - first_[ring(vertex)]};
  }
  [[nodiscard]] std::string name(std::size_t vertex) const {
    return fmt::format("ring {}, vertex {}", ring(vertex), vertex - first_[ring(vertex)]);
  }

 private:
  const Polygon* polygon_;
  std::vector<Point> points_;
  std::vector<std::size_t> first_;  ///< vertex of each ring
};

void require_rings(const Polygon& polygon) {
  if (polygon.rings.empty()) throw InputError({polygon.file, {}, {}}, "the polygon has no ring");
  for (std::size_t r = 0; r < polygon.rings.size(); ++r)
    if (const std::size_t size = polygon.rings[r].size(); size < 3)
      throw InputError({polygon.file, r, {}},
                       fmt::format("the ring has {} vertices; three is the least", size));
  for (std::size_t r = 0; r < polygon.rings.size(); ++r)
    for (std::size_t v = 0; v < polygon.rings[r].size(); ++v)
      require_in_range(polygon.rings[r][v], {polygon.file, r, v});
}

/// p, q and r lie on one line, p != q != r: does the chain turn back at q?
bool folds_back(const Point& p, const Point& q, const Point& r) {
  if (orientation(p, q, r) != 0) return false;
  return lexicographically_before(p, q) != lexicographically_before(q, r);
}

/// Calls action(ring number, vertex number, previous, at, next) for each vertex in order.
template <class Action>
void for_each_corner(const Polygon& polygon, Action action) {
  for (std::size_t r = 0; r < polygon.rings.size(); ++r) {
    const Ring& ring = polygon.rings[r];
    for (std::size_t v = 0; v < ring.size(); ++v)
      action(r, v, ring[v == 0 ? ring.size() - 1 : v - 1], ring[v],
             ring[v + 1 == ring.size() ? 0 : v + 1]);
  }
}

bool on_one_line(const Ring& ring) {
  return std::all_of(ring.begin() + 2, ring.end(),
                     [&](const Point& p) { return orientation(ring[0], ring[1], p) == 0; });
}

void require_proper_corners(const Polygon& polygon) {
  for_each_corner(
      polygon, [&](std::size_t r, std::size_t v, const Point&, const Point& at, const Point& next) {
        if (at == next)
          throw InputError({polygon.file, r, v},
                           "the next vertex is at the same place (an edge of zero length)");
      });
  for (std::size_t r = 0; r < polygon.rings.size(); ++r)
    if (on_one_line(polygon.rings[r]))
      throw InputError({polygon.file, r, {}}, "zero area: all vertices lie on one line");
  for_each_corner(polygon, [&](std::size_t r, std::size_t v, const Point& previous, const Point& at,
                               const Point& next) {
    if (folds_back(previous, at, next))
      throw InputError({polygon.file, r, v},
                       "a spike: the edge from here folds back on the edge before it");
  });
}

void require_different(const Corners& corners) {
  if (const auto repeat = first_repeat(corners.points()))
    throw InputError(corners.location(repeat->first),
                     fmt::format("{} is at the same place", corners.name(repeat->second)));
}

/// The first edge that meets an earlier one, and the first that it meets.
[[noreturn]] void name_edges_that_meet(const Polygon& polygon, const Corners& corners) {
  const auto& points = corners.points();
  const std::size_t later = first_edge_that_meets_an_earlier_one(polygon.rings);
  const std::size_t end = corners.next(later);
  for (std::size_t v = 0; v < later; ++v) {
    const std::size_t next = corners.next(v);
    if (next == later || end == v) continue;
    const Meeting how = meeting(points[v], points[next], points[later], points[end]);
    if (how == Meeting::kApart) continue;
    throw InputError(
        corners.location(v),
        fmt::format("the edge from here {} the edge from {}",
                    how == Meeting::kCross ? "crosses" : "touches", corners.name(later)));
  }
  throw std::logic_error("an edge was said to meet an earlier one, but meets none");
}

void require_nesting(const Polygon& polygon, const RingNesting& nesting) {
  const std::size_t outer = 0;
  for (std::size_t r = 1; r < polygon.rings.size(); ++r) {
    const auto around = nesting.around[r];
    if (around == outer) continue;
    const bool surrounds_outer = nesting.around[outer] == r;
    throw InputError({polygon.file, r, {}},
                     surrounds_outer ? "the hole surrounds the outer ring"
                     : around        ? fmt::format("the hole lies inside ring {}, a hole", *around)
                                     : "the hole lies outside the outer ring");
  }
}

}  // namespace

void validate(const PointSet& points) {
  if (points.points.empty()) throw InputError({points.file, {}, {}}, "there is no point");
  for (std::size_t v = 0; v < points.points.size(); ++v)
    require_in_range(points.points[v], {points.file, {}, v});
  if (const auto repeat = first_repeat(points.points))
    throw InputError({points.file, {}, repeat->first},
                     fmt::format("vertex {} is at the same place", repeat->second));
}

void validate(const Polygon& polygon) {
  require_rings(polygon);
  require_proper_corners(polygon);
  const Corners corners(polygon);
  require_different(corners);
  const auto nesting = nesting_of_disjoint_rings(polygon.rings);
  if (!nesting) name_edges_that_meet(polygon, corners);
  require_nesting(polygon, *nesting);
}

Polygon normalised(Polygon polygon) {
  validate(polygon);
  for (std::size_t r = 0; r < polygon.rings.size(); ++r) {
    Ring& ring = polygon.rings[r];
    for (Point& point : ring) point = {point.x + 0.0, point.y + 0.0};  // -0 + 0 is 0
    if ((ring_orientation(ring) > 0) != (r == 0)) std::reverse(ring.begin() + 1, ring.end());
  }
  return polygon;
}

}  // namespace quadbound
