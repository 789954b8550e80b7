// SPDX-License-Identifier: Apache-2.0
// Fractals: coast, koch.
#include <algorithm>
#include <deque>
#include <utility>

#include "generators/edge_grid.hpp"
#include "generators/polygon_families.hpp"
#include "generators/unit_circle.hpp"

namespace quadbound::generators {
namespace {

using Index = std::uint32_t;

/// A ring whose edges are replaced by chains.
class RefinedRing {
 public:
  explicit RefinedRing(const LatticeRing& start) : points_(start) {
    for (Index v = 0; v < start.size(); ++v)
      next_.push_back(static_cast<Index>((v + 1) % start.size()));
  }

  [[nodiscard]] const std::vector<LatticePoint>& points() const { return points_; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] Index next(Index v) const { return next_[v]; }

  /// A new vertex after v; its index.
  Index insert_after(Index v, LatticePoint point) {
    points_.push_back(point);
    next_.push_back(next_[v]);
    next_[v] = static_cast<Index>(points_.size() - 1);
    return next_[v];
  }
  /// Requires: v is the last vertex that was inserted, after `previous`.
  void take_back(Index previous, Index v) {
    next_[previous] = next_[v];
    points_.pop_back();
    next_.pop_back();
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

 private:
  std::vector<LatticePoint> points_;
  std::vector<Index> next_;
};

/// a + along * (b - a) to the right of it by `aside` * |b - a|.
LatticePoint beside(LatticePoint a, LatticePoint b, double along, double aside) {
  const auto x = static_cast<double>(b.x - a.x);
  const auto y = static_cast<double>(b.y - a.y);
  return rounded(static_cast<double>(a.x) + along * x + aside * y,
                 static_cast<double>(a.y) + along * y - aside * x);
}

/// Midpoint displacement that keeps its ring simple.
class Coast {
 public:
  Coast(PolygonMaker& maker, const LatticeRing& start)
      : maker_(maker),
        ring_(start),
        grid_(ring_.points(), box_around(start), static_cast<std::size_t>(maker.n)) {
    grid_.insert_ring(0, start.size());
  }

  /// Breaks the edge after v and puts its middle aside, less and less until the ring stays simple;
  /// whether it came to that.
  bool refine(Index v) {
    const VertexEdge edge{v, ring_.next(v)};
    const LatticePoint a = ring_.points()[edge.from];
    const LatticePoint b = ring_.points()[edge.to];
    double aside = static_cast<double>(maker_.random.between(-1000, 1000)) / 1000 *
                   static_cast<double>(maker_.parameter("rough")) / 100;
    grid_.remove(edge);
    for (int halvings = 0; halvings < 6; ++halvings, aside /= 2)
      if (put(edge, beside(a, b, 0.5, aside))) return true;
    grid_.insert(edge);
    return false;
  }

  [[nodiscard]] const RefinedRing& ring() const { return ring_; }

 private:
  bool put(VertexEdge edge, LatticePoint middle) {
    const Index v = ring_.insert_after(edge.from, middle);
    const bool free = middle != ring_.points()[edge.from] && middle != ring_.points()[edge.to] &&
                      !grid_.conflict({edge.from, v}) && !grid_.conflict({v, edge.to});
    if (free) {
      grid_.insert({edge.from, v});
      grid_.insert({v, edge.to});
    } else {
      ring_.take_back(edge.from, v);
    }
    return free;
  }

  PolygonMaker& maker_;
  RefinedRing ring_;
  EdgeGrid grid_;
};

}  // namespace

namespace {

/// A hexagon with corners at random distances; fewer corners where fewer are wanted.
LatticeRing island(PolygonMaker& maker) {
  LatticeRing ring;
  const std::int64_t corners = std::min<std::int64_t>(maker.n, 6);
  for (std::int64_t i = 0; i < corners; ++i)
    ring.push_back(at({0, 0}, static_cast<double>(kUnit * maker.random.between(60, 100)) / 100,
                      direction_of_turn(i, corners)));
  return ring;
}

}  // namespace

/// One generation of edges after the other, so that all stay about as long as each other.
LatticePolygon make_coast(PolygonMaker& maker) {
  Coast coast(maker, island(maker));
  std::deque<Index> waiting;
  for (Index v = 0; v < coast.ring().size(); ++v) waiting.push_back(v);
  for (std::size_t failures = 0; std::ssize(waiting) < maker.n;) {
    const Index v = waiting.front();
    waiting.pop_front();
    waiting.push_back(v);
    if (coast.refine(v)) {
      waiting.push_back(coast.ring().next(v));
      failures = 0;
    } else {
      maker.require(++failures < waiting.size(), "the lattice is too coarse for so many vertices");
    }
  }
  LatticeRing ring = coast.ring().ring();
  std::vector<LatticeRing> holes = holes_anywhere(maker, ring);
  return {std::move(ring), std::move(holes)};
}

/// Koch's curve (1904) on the sides of a triangle: the middle third of an edge becomes a tip.
LatticePolygon make_koch(PolygonMaker& maker) {
  const double height = static_cast<double>(maker.parameter("height")) / 1000;
  RefinedRing ring(regular({0, 0}, static_cast<double>(kUnit), 3));
  std::deque<Index> waiting{0, 1, 2};
  while (std::ssize(ring.points()) < maker.n) {
    const Index first = waiting.front();
    waiting.pop_front();
    waiting.push_back(first);
    const LatticePoint a = ring.points()[first];
    const LatticePoint b = ring.points()[ring.next(first)];
    Index last = first;
    for (const Point place : {Point{1.0 / 3, 0}, Point{0.5, height}, Point{2.0 / 3, 0}}) {
      last = ring.insert_after(last, beside(a, b, place.x, place.y));
      waiting.push_back(last);
    }
  }
  return {ring.ring(), holes_on_circle(maker, static_cast<double>(kUnit) / 4)};
}

}  // namespace quadbound::generators
