// SPDX-License-Identifier: Apache-2.0
#include "verify/polygon_boundary.hpp"

#include <algorithm>

#include "model/angle.hpp"

namespace quadbound::judge {
namespace {

enum class Step { between, off, passed };

/// Where `next` is that should lie on the edge a -> b, between `last` and b.
Step step(const RationalPoint& a, const RationalPoint& b, const RationalPoint& last,
          const RationalPoint& next) {
  const auto reached = corner_at<Rational>(a, b, next);
  if (reached.cross != 0) return Step::off;
  const bool is_between = corner_at<Rational>(a, b, last).dot < reached.dot &&
                          reached.dot < corner_at<Rational>(a, b, b).dot;
  return is_between ? Step::between : Step::passed;
}

/// An edge of the polygon between points on the lattice.
class LatticeEdge {
 public:
  LatticeEdge(LatticePoint a, LatticePoint b) : a_(a), dx_(b.x - a.x), dy_(b.y - a.y) {}

  /// Whether the point is on its line; nullopt where 128 bits are too few to tell.
  [[nodiscard]] std::optional<bool> holds(LatticePoint p) const { return cross(p.x, p.y) == 0; }
  [[nodiscard]] std::optional<bool> holds(const FractionPoint& p) const {
    if (p.x.denominator == 0 || p.y.denominator == 0) return std::nullopt;
    const Int128 floors = cross(p.x.floor, p.y.floor);
    if (p.x.remainder == 0) return is_fraction(p.y, dx_, -floors);
    if (p.y.remainder == 0) return is_fraction(p.x, dy_, floors);
    return std::nullopt;
  }

  /// Whether `next` is strictly further along the edge than `last`, both on its line; nullopt where
  /// what was cut off decides.
  [[nodiscard]] std::optional<bool> advances(const FixedPoint& last, const FixedPoint& next) const {
    const auto sign =
        dx_ != 0 ? sign_of_difference(last.x, next.x) : sign_of_difference(last.y, next.y);
    if (!sign) return std::nullopt;
    return (dx_ != 0 ? dx_ : dy_) > 0 ? *sign > 0 : *sign < 0;
  }

 private:
  /// (b - a) x (p - a), at most 2^123.
  [[nodiscard]] Int128 cross(std::int64_t x, std::int64_t y) const {
    return static_cast<Int128>(dx_) * (y - a_.y) - static_cast<Int128>(dy_) * (x - a_.x);
  }
  /// Whether length * remainder / denominator = value. The left side is at most |length| <= 2^61,
  /// so that all products stay below 2^124.
  static bool is_fraction(const LatticeFraction& fraction, std::int64_t length, Int128 value) {
    constexpr Int128 kLargest = Int128{1} << (kLatticeBits + 1);
    if (value < -kLargest || value > kLargest) return false;
    return static_cast<Int128>(length) * static_cast<Int128>(fraction.remainder) ==
           value * static_cast<Int128>(fraction.denominator);
  }

  LatticePoint a_;
  std::int64_t dx_;
  std::int64_t dy_;
};

class RingWalker {
 public:
  RingWalker(const ExactPlane& plane, const std::vector<DirectedEdge>& unpaired,
             const RingVertices& rings, std::span<const PlacedVertex> placed)
      : plane_(plane),
        unpaired_(unpaired),
        rings_(rings),
        vertex_of_(rings.points.size(), kNoVertex),
        visited_(unpaired.size()) {
    for (const PlacedVertex& p : placed)
      if (vertex_of_[p.point] == kNoVertex && edge_from(p.vertex) != unpaired_.size())
        vertex_of_[p.point] = p.vertex;
  }

  RingWalk walk() {
    for (std::size_t ring = 0; ring < rings_.rings(); ++ring)
      if (auto departure = find_lost(ring)) return {departure, {}};
    for (std::size_t ring = 0; ring < rings_.rings(); ++ring)
      if (auto departure = walk_ring(ring)) return {departure, {}};
    const auto stray = std::find(visited_.begin(), visited_.end(), false);
    if (stray != visited_.end()) {
      const auto index = static_cast<std::size_t>(stray - visited_.begin());
      return {Departure{Departure::Kind::stray_loop, 0, 0, unpaired_[index].from}, {}};
    }
    return {std::nullopt, steiner_};
  }

 private:
  /// Index of the unpaired edge that leaves a vertex; the number of edges where there is none.
  [[nodiscard]] std::size_t edge_from(VertexId v) const {
    const auto edge =
        std::lower_bound(unpaired_.begin(), unpaired_.end(), v,
                         [](const DirectedEdge& e, VertexId w) { return e.from < w; });
    if (edge == unpaired_.end() || edge->from != v) return unpaired_.size();
    return static_cast<std::size_t>(edge - unpaired_.begin());
  }

  [[nodiscard]] std::optional<Departure> find_lost(std::size_t ring) const {
    const auto begin = vertex_of_.begin() + static_cast<std::ptrdiff_t>(rings_.starts[ring]);
    const auto end = vertex_of_.begin() + static_cast<std::ptrdiff_t>(rings_.starts[ring + 1]);
    const auto lost = std::find(begin, end, kNoVertex);
    if (lost == end) return std::nullopt;
    const bool all = std::all_of(begin, end, [](VertexId v) { return v == kNoVertex; });
    return Departure{all ? Departure::Kind::ring_lost : Departure::Kind::vertex_lost, ring,
                     static_cast<std::size_t>(lost - begin)};
  }

  std::optional<Departure> walk_ring(std::size_t ring) {
    for (std::size_t i = 0; i < rings_.size(ring); ++i)
      if (auto departure = walk_edge(ring, i)) return departure;
    return std::nullopt;
  }

  /// Ends: positions strictly advance along the edge.
  std::optional<Departure> walk_edge(std::size_t ring, std::size_t i) {
    const VertexId a = vertex_of_[rings_.starts[ring] + i];
    const VertexId b = vertex_of_[rings_.starts[ring] + (i + 1) % rings_.size(ring)];
    std::uint64_t steiner = 0;
    for (VertexId last = a;; ++steiner) {
      const std::size_t edge = edge_from(last);
      visited_[edge] = true;
      const VertexId next = unpaired_[edge].to;
      if (next == b) break;
      const Step found = step_to(a, b, last, next);
      if (found != Step::between)
        return Departure{found == Step::off ? Departure::Kind::off_edge : Departure::Kind::passed,
                         ring, i, next};
      last = next;
    }
    count(steiner);
    return std::nullopt;
  }

  [[nodiscard]] Step step_to(VertexId a, VertexId b, VertexId last, VertexId next) const {
    if (plane_.on_lattice(a) && plane_.on_lattice(b))
      if (const auto found = step_along(a, b, last, next)) return *found;
    return step(plane_.rational(a), plane_.rational(b), plane_.rational(last),
                plane_.rational(next));
  }

  /// Without rationals; nullopt where that does not decide it.
  [[nodiscard]] std::optional<Step> step_along(VertexId a, VertexId b, VertexId last,
                                               VertexId next) const {
    const auto last_point = plane_.fixed(last);
    const auto point = plane_.fixed(next);
    if (!last_point || !point) return std::nullopt;
    const LatticeEdge edge(plane_.lattice(a), plane_.lattice(b));
    const auto on_line = plane_.on_lattice(next) ? edge.holds(plane_.lattice(next))
                                                 : edge.holds(plane_.off_lattice().fractions(next));
    if (!on_line) return std::nullopt;
    if (!*on_line) return Step::off;
    const auto advances = edge.advances(*last_point, *point);
    const auto ends = edge.advances(*point, *plane_.fixed(b));
    if (!advances || !ends) return std::nullopt;
    return *advances && *ends ? Step::between : Step::passed;
  }

  void count(std::uint64_t steiner) {
    steiner_.fewest = steiner_.edges == 0 ? steiner : std::min(steiner_.fewest, steiner);
    steiner_.most = std::max(steiner_.most, steiner);
    steiner_.total += steiner;
    ++steiner_.edges;
  }

  const ExactPlane& plane_;
  const std::vector<DirectedEdge>& unpaired_;
  const RingVertices& rings_;
  std::vector<VertexId> vertex_of_;  ///< the boundary vertex at each ring vertex; kNoVertex: none
  std::vector<bool> visited_;
  PolygonFacts::Steiner steiner_;
};

}  // namespace

RingVertices::RingVertices(const Polygon& polygon) : starts{0} {
  for (const Ring& ring : polygon.rings) {
    points.insert(points.end(), ring.begin(), ring.end());
    starts.push_back(points.size());
  }
}

RingWalk walk_rings(const ExactPlane& plane, const std::vector<DirectedEdge>& unpaired,
                    const RingVertices& rings, std::span<const PlacedVertex> placed) {
  if (const auto branching = find_branching(unpaired))
    return {Departure{Departure::Kind::branching, 0, 0, *branching}, {}};
  return RingWalker(plane, unpaired, rings, placed).walk();
}

}  // namespace quadbound::judge
