// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <numeric>

#include "paper/lemma_checks.hpp"

namespace quadbound {
namespace {

/// A closed rectangle.
struct Box {
  std::int64_t x0;
  std::int64_t x1;
  std::int64_t y0;
  std::int64_t y1;
};

Box box_of(const CellSquare& c) { return {c.low.x, c.low.x + c.side, c.low.y, c.low.y + c.side}; }

/// How much of a segment, 0 to 1, from a point of a box is in it: numerator and a positive
/// denominator.
struct Way {
  Int128 numerator = 1;
  Int128 denominator = 1;
};

Way way_within(const Box& box, LatticePoint from, LatticePoint to) {
  Way way;
  const auto limit = [&way](std::int64_t start, std::int64_t end, std::int64_t low,
                            std::int64_t high) {
    const std::int64_t d = end - start;
    if (d == 0) return;
    const Way here = d > 0 ? Way{high - start, d} : Way{start - low, -d};
    if (here.numerator * way.denominator < way.numerator * here.denominator) way = here;
  };
  limit(from.x, to.x, box.x0, box.x1);
  limit(from.y, to.y, box.y0, box.y1);
  return way;
}

bool has(const Box& box, LatticePoint p) {
  return box.x0 <= p.x && p.x <= box.x1 && box.y0 <= p.y && p.y <= box.y1;
}

/// Whether the segment lies in a box with one end and a box with the other.
bool is_within(LatticePoint u, LatticePoint v, const Box& of_u, const Box& of_v) {
  if (!has(of_u, u) || !has(of_v, v)) return false;
  const Way a = way_within(of_u, u, v);
  const Way b = way_within(of_v, v, u);
  return a.numerator * b.denominator + b.numerator * a.denominator >= a.denominator * b.denominator;
}

class QuadrangulationChecks {
 public:
  QuadrangulationChecks(const CutTree& tree, CheckLedger& ledger) : tree_(tree), ledger_(ledger) {}

  void run() {
    distinct_vertices();
    for (VertexId u = 0; u < tree_.vertex_count(); ++u) {
      if (!tree_.is_centre(u) && !tree_.is_outermost(u)) extra_point(u);
      for (const VertexId v : tree_.joined(u))
        if (u < v) edge(u, v);
    }
  }

 private:
  [[nodiscard]] CellSquare cell(VertexId v) const { return tree_.square(tree_.leaf_of(v)); }

  void distinct_vertices() {
    std::vector<VertexId> order(tree_.vertex_count());
    std::iota(order.begin(), order.end(), VertexId{0});
    const auto place = [this](VertexId v) { return std::pair{tree_.at(v).x, tree_.at(v).y}; };
    std::sort(order.begin(), order.end(),
              [&](VertexId a, VertexId b) { return place(a) < place(b); });
    for (std::size_t i = 1; i < order.size(); ++i)
      ledger_.count(Check::kDistinctVertices, place(order[i - 1]) != place(order[i]),
                    {order[i - 1], order[i]});
  }

  void edge(VertexId u, VertexId v) {
    const LatticePoint a = tree_.at(u);
    const LatticePoint b = tree_.at(v);
    ledger_.count(Check::kTwoCells, is_within(a, b, box_of(cell(u)), box_of(cell(v))), {u, v});
    if (touch(cell(u), cell(v)) != Touch::kEdge) return;
    ledger_.count(Check::kFacingHalves,
                  is_within(a, b, facing_half(cell(u), cell(v)), facing_half(cell(v), cell(u))),
                  {u, v});
  }

  /// The half of a square beside an edge neighbour.
  static Box facing_half(const CellSquare& c, const CellSquare& neighbour) {
    Box box = box_of(c);
    const std::int64_t half = c.side / 2;
    if (neighbour.low.x == box.x1) {
      box.x0 += half;
    } else if (neighbour.low.x + neighbour.side == box.x0) {
      box.x1 -= half;
    } else if (neighbour.low.y == box.y1) {
      box.y0 += half;
    } else {
      box.y1 -= half;
    }
    return box;
  }

  void extra_point(VertexId a) {
    const auto joined = tree_.joined(a);
    const VertexId centre = tree_.centre(tree_.leaf_of(a));
    ledger_.count(Check::kExtraDegree, joined.size() == 3, {a});
    ledger_.count(Check::kExtraOwnCentre, tree_.are_joined(a, centre), {a, centre});
    std::vector<VertexId> others;
    for (const VertexId v : joined)
      if (v != centre) others.push_back(v);
    if (others.size() != 2) return;
    other_edges(a, others[0], others[1]);
    for (const VertexId v : joined)
      ledger_.count(Check::kExtraQuadrant, is_in_quadrant(a, v), {a, v});
  }

  void other_edges(VertexId a, VertexId u, VertexId v) {
    const LatticePoint k = nearest_corner(a);
    const LatticePoint c = cell_centre(a);
    const auto on_line = [&](VertexId w) {
      const LatticePoint p = tree_.at(w);
      return (p.x - k.x) * (k.x - c.x) + (p.y - k.y) * (k.y - c.y) == 0;
    };
    const auto beside = [&](VertexId w) { return touch(cell(a), cell(w)) == Touch::kEdge; };
    ledger_.count(Check::kExtraOnLine, on_line(u) && on_line(v), {a, u, v});
    ledger_.count(Check::kExtraNeighbours, beside(u) && beside(v), {a, u, v});
    const auto side_of_u = side_crossed(a, u);
    const auto side_of_v = side_crossed(a, v);
    ledger_.count(Check::kExtraTwoSides, side_of_u && side_of_v && *side_of_u != *side_of_v,
                  {a, u, v});
  }

  [[nodiscard]] LatticePoint cell_centre(VertexId a) const {
    const auto [low, side] = cell(a);
    return {low.x + side / 2, low.y + side / 2};
  }

  /// Requires: the vertex is nearer to one corner of its cell than to all others.
  [[nodiscard]] LatticePoint nearest_corner(VertexId a) const {
    const auto [low, side] = cell(a);
    const LatticePoint c = cell_centre(a);
    return {tree_.at(a).x > c.x ? low.x + side : low.x, tree_.at(a).y > c.y ? low.y + side : low.y};
  }

  /// Which side of the cell of `a` its edge to `v` crosses, its corners excluded.
  [[nodiscard]] std::optional<Direction> side_crossed(VertexId a, VertexId v) const {
    const Box box = box_of(cell(a));
    const LatticePoint from = tree_.at(a);
    const LatticePoint to = tree_.at(v);
    if (has(box, to)) return std::nullopt;
    const Way in_x =
        way_within({box.x0, box.x1, from.y - kCutTreeSide, from.y + kCutTreeSide}, from, to);
    const Way in_y =
        way_within({from.x - kCutTreeSide, from.x + kCutTreeSide, box.y0, box.y1}, from, to);
    const Int128 difference = in_x.numerator * in_y.denominator - in_y.numerator * in_x.denominator;
    if (difference == 0) return std::nullopt;
    if (difference < 0) return to.x > from.x ? kEast : kWest;
    return to.y > from.y ? kNorth : kSouth;
  }

  /// What of the edge lies in the cell of `a` lies in the quadrant of `a`: it leaves both in one
  /// point, or ends in the centre.
  [[nodiscard]] bool is_in_quadrant(VertexId a, VertexId v) const {
    const LatticePoint c = cell_centre(a);
    const LatticePoint k = nearest_corner(a);
    const Box quadrant{std::min(c.x, k.x), std::max(c.x, k.x), std::min(c.y, k.y),
                       std::max(c.y, k.y)};
    const Way of_cell = way_within(box_of(cell(a)), tree_.at(a), tree_.at(v));
    const Way of_quadrant = way_within(quadrant, tree_.at(a), tree_.at(v));
    return of_cell.numerator * of_quadrant.denominator ==
           of_quadrant.numerator * of_cell.denominator;
  }

  const CutTree& tree_;
  CheckLedger& ledger_;
};

}  // namespace

void check_quadrangulation(const CutTree& tree, CheckLedger& ledger) {
  QuadrangulationChecks(tree, ledger).run();
}

}  // namespace quadbound
