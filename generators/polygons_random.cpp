// SPDX-License-Identifier: Apache-2.0
// Random points joined to a polygon, after Auer and Held: two-opt, space-partition, growth.
#include <algorithm>
#include <optional>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "generators/edge_grid.hpp"
#include "generators/polygon_families.hpp"

namespace quadbound::generators {
namespace {

using Index = std::uint32_t;

/// Three points on one line are so rare among random ones that a family may simply try again.
constexpr int kTries = 20;

/// n different points of a square.
std::vector<LatticePoint> random_points(PolygonMaker& maker) {
  std::vector<LatticePoint> points;
  std::unordered_set<std::int64_t> seen;
  while (std::ssize(points) < maker.n) {
    const LatticePoint p{maker.random.between(-kUnit, kUnit), maker.random.between(-kUnit, kUnit)};
    if (seen.insert(p.x * (4 * kUnit) + p.y).second) points.push_back(p);
  }
  return points;
}

LatticePolygon with_holes(PolygonMaker& maker, LatticeRing ring) {
  std::vector<LatticeRing> holes = holes_anywhere(maker, ring);
  return {std::move(ring), std::move(holes)};
}

/// The first ring that `attempt` makes of fresh random points.
template <class Attempt>
LatticePolygon first_success(PolygonMaker& maker, Attempt attempt) {
  for (int i = 0; i < kTries; ++i) {
    const std::vector<LatticePoint> points = random_points(maker);
    if (std::optional<LatticeRing> ring = attempt(points))
      return with_holes(maker, std::move(*ring));
  }
  maker.require(false, "the random points were never in general position");
  return {};
}

/// A closed tour through all points that gets shorter until it is simple.
class Untangler {
 public:
  /// The points in the order given, which is as random as they are.
  explicit Untangler(const std::vector<LatticePoint>& points)
      : points_(points),
        tour_(points.size()),
        place_(points.size()),
        grid_(points, box_around(points), points.size()) {
    for (std::size_t i = 0; i < tour_.size(); ++i) tour_[i] = place_[i] = static_cast<Index>(i);
    for (std::size_t i = 0; i < tour_.size(); ++i) add({tour_[i], next(tour_[i])});
  }

  /// nullopt where edges lie on each other.
  ///
  /// Every edge is looked at once after it came, and every pair of edges that met was replaced by a
  /// shorter one: the end is reached, and none of those that stay meet.
  std::optional<LatticeRing> run() {
    while (!pending_.empty()) {
      const VertexEdge edge = pending_.back();
      pending_.pop_back();
      if (!in_tour(edge)) continue;
      grid_.remove(edge);
      const std::optional<VertexEdge> other = grid_.conflict(edge);
      grid_.insert(edge);
      if (other && !replace(edge, *other)) return std::nullopt;
    }
    LatticeRing ring;
    for (const Index v : tour_) ring.push_back(points_[v]);
    return ring;
  }

 private:
  [[nodiscard]] Index next(Index v) const { return tour_[(place_[v] + 1) % tour_.size()]; }
  [[nodiscard]] bool in_tour(VertexEdge e) const {
    return next(e.from) == e.to || next(e.to) == e.from;
  }
  /// Edges are kept from the smaller index to the larger: reversing a part of the tour must not
  /// touch them.
  static VertexEdge sorted(VertexEdge e) {
    return {std::min(e.from, e.to), std::max(e.from, e.to)};
  }
  void add(VertexEdge e) {
    grid_.insert(sorted(e));
    pending_.push_back(sorted(e));
  }

  /// The 2-opt move: a-b and c-d, in the tour's direction, become a-c and b-d.
  bool replace(VertexEdge one, VertexEdge two) {
    if (next(one.from) != one.to) std::swap(one.from, one.to);
    if (next(two.from) != two.to) std::swap(two.from, two.to);
    if (one.to == two.from || two.to == one.from) return false;
    grid_.remove(sorted(one));
    grid_.remove(sorted(two));
    reverse(place_[one.to], place_[two.from]);
    add({one.from, two.from});
    add({one.to, two.to});
    return true;
  }

  /// Turns the part of the tour from one place to another around, or the rest, which is the same
  /// tour in the other direction.
  void reverse(std::size_t first, std::size_t last) {
    const std::size_t n = tour_.size();
    std::size_t length = (last + n - first) % n + 1;
    if (2 * length > n) {
      length = n - length;
      std::swap(first, last);
      first = (first + 1) % n;
      last = (last + n - 1) % n;
    }
    for (std::size_t swaps = length / 2; swaps > 0; --swaps) {
      std::swap(tour_[first], tour_[last]);
      place_[tour_[first]] = static_cast<Index>(first);
      place_[tour_[last]] = static_cast<Index>(last);
      first = first + 1 == n ? 0 : first + 1;
      last = last == 0 ? n - 1 : last - 1;
    }
  }

  const std::vector<LatticePoint>& points_;
  std::vector<Index> tour_;
  std::vector<Index> place_;  ///< of a vertex in the tour
  std::vector<VertexEdge> pending_;
  EdgeGrid grid_;
};

/// Chains through parts of a point set whose convex hulls have at most one vertex in common.
class Partitioner {
 public:
  Partitioner(RandomIntegers& random, std::vector<LatticePoint> points)
      : random_(random), points_(std::move(points)) {}

  /// nullopt where points in special position left no line to cut along.
  std::optional<LatticeRing> run() {
    const std::size_t n = points_.size();
    // The points are random: the first and the last are two random ones of them.
    const LatticePoint first = points_.front();
    const LatticePoint last = points_.back();
    const auto middle = split(1, n - 1, first, {last.x - first.x, last.y - first.y});
    if (!middle) return std::nullopt;
    ring_.push_back(first);
    if (!chain(*middle, n - 1, first, last)) return std::nullopt;  // to the right of the line
    ring_.push_back(last);
    if (!chain(1, *middle, last, first)) return std::nullopt;
    return std::move(ring_);
  }

 private:
  /// Puts the points [begin, end) on the left of a line in front of those on its right; the first
  /// of these, or nullopt where a point lies on the line.
  std::optional<std::size_t> split(std::size_t begin, std::size_t end, LatticePoint through,
                                   LatticePoint direction) {
    const auto side = [&](LatticePoint p) {
      return direction.x * (p.y - through.y) - direction.y * (p.x - through.x);
    };
    std::size_t left = begin;
    for (std::size_t i = begin; i < end; ++i) {
      if (side(points_[i]) == 0) return std::nullopt;
      if (side(points_[i]) > 0) std::swap(points_[i], points_[left++]);
    }
    return left;
  }

  /// Of the points [begin, end), the first is the pivot, then come those on the left of a line
  /// through it that separates two places, then those on the right.
  struct Cut {
    std::size_t middle;  ///< the first on the right
    bool from_left;      ///< the side of the first of the two places
  };

  std::optional<Cut> cut(std::size_t begin, std::size_t end, LatticePoint from, LatticePoint to) {
    for (int tries = 0; tries < kTries; ++tries) {
      std::swap(points_[begin], points_[begin + random_.below(end - begin)]);
      const LatticePoint pivot = points_[begin];
      if (turn(from, to, pivot) == 0) continue;
      // From a random place between the two to the pivot, in sixteenths.
      const std::int64_t share = random_.between(1, 15);
      const LatticePoint direction{16 * pivot.x - (16 - share) * from.x - share * to.x,
                                   16 * pivot.y - (16 - share) * from.y - share * to.y};
      if (const auto middle = split(begin + 1, end, pivot, direction))
        return Cut{*middle, turn(from, to, pivot) > 0};
    }
    return std::nullopt;
  }

  /// Appends the points [begin, end) in an order that makes a simple chain with the two ends, which
  /// are not among them: the convex hulls of the two parts have the pivot in common only.
  bool chain(std::size_t begin, std::size_t end, LatticePoint from, LatticePoint to) {
    if (begin == end) return true;
    const std::optional<Cut> found = cut(begin, end, from, to);
    if (!found) return false;
    const LatticePoint pivot = points_[begin];
    const auto part = [&](bool left, LatticePoint a, LatticePoint b) {
      return left ? chain(begin + 1, found->middle, a, b) : chain(found->middle, end, a, b);
    };
    if (!part(found->from_left, from, pivot)) return false;
    ring_.push_back(pivot);
    return part(!found->from_left, pivot, to);
  }

  RandomIntegers& random_;
  std::vector<LatticePoint> points_;
  LatticeRing ring_;
};

/// A polygon that takes in one point after the other.
class Grower {
 public:
  Grower(RandomIntegers& random, std::vector<LatticePoint> points)
      : random_(random),
        points_(std::move(points)),
        next_(points_.size()),
        grid_(points_, box_around(points_), points_.size()) {}

  /// By their distance from the origin: all points that were not taken in yet lie outside of a disk
  /// around those that were, hence outside of their convex hull, as Steady Growth wants it.
  std::optional<LatticeRing> run() {
    const auto squared = [](LatticePoint p) { return p.x * p.x + p.y * p.y; };
    std::ranges::sort(points_, [&](LatticePoint a, LatticePoint b) {
      return std::tuple(squared(a), a.x, a.y) < std::tuple(squared(b), b.x, b.y);
    });
    const std::int64_t area = turn(points_[0], points_[1], points_[2]);
    if (area == 0) return std::nullopt;
    if (area < 0) std::swap(points_[1], points_[2]);
    for (const Index v : {0U, 1U, 2U}) link(v, (v + 1) % 3);
    for (std::size_t v = 3; v < points_.size(); ++v)
      if (!take_in(static_cast<Index>(v))) return std::nullopt;
    return ring();
  }

 private:
  void link(Index from, Index to) {
    next_[from] = to;
    grid_.insert({from, to});
  }

  /// Whether the vertex, outside of the polygon, sees the whole edge: nothing is between them where
  /// nothing meets the two sides of the triangle.
  [[nodiscard]] bool sees(Index vertex, VertexEdge edge) const {
    return turn(points_[edge.from], points_[edge.to], points_[vertex]) < 0 &&
           !grid_.conflict({edge.from, vertex}) && !grid_.conflict({vertex, edge.to});
  }

  /// Puts the vertex between the ends of a random one of the nearest edges that it sees. There is
  /// always one (Auer and Held), near in most cases.
  bool take_in(Index vertex) {
    for (std::int64_t distance = 0; distance <= grid_.farthest(); ++distance) {
      std::vector<VertexEdge> edges = grid_.edges_around(points_[vertex], distance);
      std::erase_if(edges, [&](VertexEdge edge) { return !sees(vertex, edge); });
      if (edges.empty()) continue;
      const VertexEdge edge = edges[random_.below(edges.size())];
      grid_.remove(edge);
      link(edge.from, vertex);
      link(vertex, edge.to);
      return true;
    }
    return false;
  }

  [[nodiscard]] LatticeRing ring() const {
    LatticeRing result;
    Index v = 0;
    do {
      result.push_back(points_[v]);
      v = next_[v];
    } while (v != 0);
    return result;
  }

  RandomIntegers& random_;
  std::vector<LatticePoint> points_;
  std::vector<Index> next_;
  EdgeGrid grid_;
};

}  // namespace

LatticePolygon make_two_opt(PolygonMaker& maker) {
  return first_success(maker, [](const auto& points) { return Untangler(points).run(); });
}

LatticePolygon make_space_partition(PolygonMaker& maker) {
  return first_success(maker,
                       [&](const auto& points) { return Partitioner(maker.random, points).run(); });
}

LatticePolygon make_growth(PolygonMaker& maker) {
  return first_success(maker,
                       [&](const auto& points) { return Grower(maker.random, points).run(); });
}

}  // namespace quadbound::generators
