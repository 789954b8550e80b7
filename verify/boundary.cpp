// SPDX-License-Identifier: Apache-2.0
#include "verify/boundary.hpp"

#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <span>
#include <utility>

#include "verify/wide.hpp"

namespace quadbound::judge {
namespace {

namespace bg = boost::geometry;
using BoxCorner = bg::model::point<double, 2, bg::cs::cartesian>;
using Box = bg::model::box<BoxCorner>;
using BoxedEdge = std::pair<Box, std::size_t>;
using Tree = bg::index::rtree<BoxedEdge, bg::index::quadratic<16>>;

template <class Wide, class PointType>
Wide doubled_triangle(const PointType& a, const PointType& b, const PointType& c) {
  return Wide(Wide(b.x - a.x) * (c.y - a.y) - Wide(b.y - a.y) * (c.x - a.x));
}

template <class Wide>
int sign(const Wide& value) {
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

template <class Number>
bool is_between(const Number& a, const Number& value, const Number& b) {
  return a < b ? a <= value && value <= b : b <= value && value <= a;
}

/// An edge with the positions of its ends.
template <class PointType>
struct Segment {
  std::array<VertexId, 2> vertices;
  std::array<PointType, 2> ends;
};

/// What two segments have in common, besides the vertices that they share.
struct Meeting {
  std::optional<Contacts::Coincident> coincident;
  std::optional<VertexId> inside_first;   ///< an end of the second inside the first
  std::optional<VertexId> inside_second;  ///< an end of the first inside the second
  bool crossing = false;
};

template <class PointType>
bool is_inside(const PointType& p, int side, const Segment<PointType>& s) {
  return side == 0 && p != s.ends[0] && p != s.ends[1] &&
         is_between(s.ends[0].x, p.x, s.ends[1].x) && is_between(s.ends[0].y, p.y, s.ends[1].y);
}

template <class Wide, class PointType>
Meeting meet(const Segment<PointType>& first, const Segment<PointType>& second) {
  Meeting meeting;
  std::array<int, 2> first_side;   // of the ends of the first, seen from the second
  std::array<int, 2> second_side;  // of the ends of the second, seen from the first
  for (std::size_t i = 0; i < 2; ++i) {
    second_side[i] = sign(doubled_triangle<Wide>(first.ends[0], first.ends[1], second.ends[i]));
    first_side[i] = sign(doubled_triangle<Wide>(second.ends[0], second.ends[1], first.ends[i]));
  }
  meeting.crossing = first_side[0] * first_side[1] < 0 && second_side[0] * second_side[1] < 0;
  for (std::size_t i = 0; i < 2; ++i) {
    if (is_inside(second.ends[i], second_side[i], first)) meeting.inside_first = second.vertices[i];
    if (is_inside(first.ends[i], first_side[i], second)) meeting.inside_second = first.vertices[i];
    for (std::size_t j = 0; j < 2; ++j) {
      const VertexId a = first.vertices[i];
      const VertexId b = second.vertices[j];
      if (a != b && first.ends[i] == second.ends[j])
        meeting.coincident = {std::min(a, b), std::max(a, b)};
    }
  }
  return meeting;
}

class ContactFinder {
 public:
  ContactFinder(const ExactPlane& plane, const std::vector<DirectedEdge>& edges)
      : plane_(plane), edges_(edges) {
    std::vector<BoxedEdge> boxes;
    boxes.reserve(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) boxes.emplace_back(box(i), i);
    tree_ = Tree(boxes.begin(), boxes.end());
  }

  Contacts find() {
    std::vector<BoxedEdge> near;
    std::vector<std::size_t> later;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (found_.hanging && found_.coincident && found_.crossing) break;
      near.clear();
      later.clear();
      tree_.query(bg::index::intersects(box(i)), std::back_inserter(near));
      for (const BoxedEdge& other : near)
        if (other.second > i) later.push_back(other.second);
      std::sort(later.begin(), later.end());
      for (const std::size_t j : later) look_at(i, j);
    }
    return found_;
  }

 private:
  [[nodiscard]] Box box(std::size_t i) const {
    const Point a = plane_.approximate(edges_[i].from);
    const Point b = plane_.approximate(edges_[i].to);
    return {BoxCorner(std::min(a.x, b.x), std::min(a.y, b.y)),
            BoxCorner(std::max(a.x, b.x), std::max(a.y, b.y))};
  }

  [[nodiscard]] bool on_lattice(std::size_t i) const {
    return plane_.on_lattice(edges_[i].from) && plane_.on_lattice(edges_[i].to);
  }
  [[nodiscard]] Segment<LatticePoint> lattice(std::size_t i) const {
    const DirectedEdge& e = edges_[i];
    return {{e.from, e.to}, {plane_.lattice(e.from), plane_.lattice(e.to)}};
  }
  [[nodiscard]] Segment<RationalPoint> rational(std::size_t i) const {
    const DirectedEdge& e = edges_[i];
    return {{e.from, e.to}, {plane_.rational(e.from), plane_.rational(e.to)}};
  }

  void look_at(std::size_t i, std::size_t j) {
    const Meeting meeting = on_lattice(i) && on_lattice(j)
                                ? meet<Int128>(lattice(i), lattice(j))
                                : meet<Rational>(rational(i), rational(j));
    if (meeting.coincident && !found_.coincident) found_.coincident = meeting.coincident;
    if (meeting.crossing && !found_.crossing) found_.crossing = {i, j};
    if (found_.hanging) return;
    if (meeting.inside_first) {
      found_.hanging = {i, *meeting.inside_first};
    } else if (meeting.inside_second) {
      found_.hanging = {j, *meeting.inside_second};
    }
  }

  const ExactPlane& plane_;
  const std::vector<DirectedEdge>& edges_;
  Tree tree_;
  Contacts found_;
};

template <class Wide, class PointAt>
void add_triangles(std::span<const VertexId> loop, const PointAt& at, WideSum& sum) {
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum.add(doubled_triangle<Wide>(at(loop[0]), at(loop[i]), at(loop[i + 1])));
}

Rational doubled_area(const ExactPlane& plane, std::span<const VertexId> loop) {
  WideSum sum;
  if (std::all_of(loop.begin(), loop.end(), [&](VertexId v) { return plane.on_lattice(v); })) {
    add_triangles<Int128>(
        loop, [&](VertexId v) { return plane.lattice(v); }, sum);
  } else {
    add_triangles<Rational>(
        loop, [&](VertexId v) { return plane.rational(v); }, sum);
  }
  return sum.value();
}

}  // namespace

std::optional<VertexId> find_branching(const std::vector<DirectedEdge>& edges) {
  std::vector<VertexId> from;
  std::vector<VertexId> to;
  for (const DirectedEdge& edge : edges) {
    from.push_back(edge.from);
    to.push_back(edge.to);
  }
  std::sort(to.begin(), to.end());
  std::optional<VertexId> smallest;
  const auto offer = [&](VertexId v) { smallest = smallest ? std::min(*smallest, v) : v; };
  for (const auto* list : {&from, &to}) {
    const auto twice = std::adjacent_find(list->begin(), list->end());
    if (twice != list->end()) offer(*twice);
  }
  const auto [a, b] = std::mismatch(from.begin(), from.end(), to.begin(), to.end());
  if (a != from.end()) offer(std::min(*a, *b));
  return smallest;
}

Loops trace_loops(const std::vector<DirectedEdge>& edges) {
  Loops result;
  result.branching = find_branching(edges);
  if (result.branching) return result;
  std::vector<bool> visited(edges.size());
  for (std::size_t start = 0; start < edges.size(); ++start) {
    if (visited[start]) continue;
    const std::size_t before = result.vertices.size();
    for (std::size_t i = start; !visited[i];) {
      visited[i] = true;
      result.vertices.push_back(edges[i].from);
      const auto next =
          std::lower_bound(edges.begin(), edges.end(), edges[i].to,
                           [](const DirectedEdge& e, VertexId v) { return e.from < v; });
      i = static_cast<std::size_t>(next - edges.begin());
    }
    result.loops.push_back({edges[start].from, result.vertices.size() - before});
  }
  return result;
}

std::optional<Outermost> find_outermost(const ExactPlane& plane, const Loops& loops) {
  std::optional<Outermost> outermost;
  std::span<const VertexId> rest = loops.vertices;
  for (std::size_t i = 0; i < loops.loops.size(); ++i) {
    Rational area = doubled_area(plane, rest.first(loops.loops[i].edges));
    rest = rest.subspan(loops.loops[i].edges);
    if (!outermost || area > outermost->doubled_area) outermost = {i, std::move(area)};
  }
  return outermost;
}

Contacts find_contacts(const ExactPlane& plane, const std::vector<DirectedEdge>& edges) {
  return ContactFinder(plane, edges).find();
}

}  // namespace quadbound::judge
