// SPDX-License-Identifier: Apache-2.0
#include "algo/edge_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace quadbound {
namespace {

/// What is asked of an edge at every node on its way, side by side in memory.
struct PackedEdge {
  EdgeId id;
  LatticePoint low;  ///< its bounding box, of its ends rounded down
  LatticePoint high;
  FinePoint start;
  Vector direction;
  double size;  ///< of the direction, in the 1-norm
};

PackedEdge packed(const Domain& domain, EdgeId edge) {
  const LatticePoint a = domain.floor(edge);
  const LatticePoint b = domain.floor(domain.next(edge));
  const Vector d = domain.direction(edge);
  return {edge,
          {std::min(a.x, b.x), std::min(a.y, b.y)},
          {std::max(a.x, b.x), std::max(a.y, b.y)},
          domain.at(edge),
          d,
          std::abs(d.x) + std::abs(d.y)};
}

/// How much of its side a leaf is grown by, and a node that is none: what its leaves, half as large
/// at most, are grown by.
constexpr double kLeafPart = 0.25;
constexpr double kNodePart = 0.125;

std::int64_t growth(std::int64_t side, double part) {
  return part == kLeafPart ? side / 4 + 1 : side / 8 + 1;
}

/// Whether an edge may meet a leaf grown by a quarter of its side.
bool may_meet(const PackedEdge& edge, LatticePoint corner, std::int64_t side) {
  const std::int64_t grown = growth(side, kLeafPart);
  if (edge.high.x < corner.x - grown || edge.low.x > corner.x + side + grown) return false;
  if (edge.high.y < corner.y - grown || edge.low.y > corner.y + side + grown) return false;
  const Vector to_centre = on_lattice({corner.x + side / 2, corner.y + side / 2}) - edge.start;
  const double reach = (0.5 + kLeafPart) * static_cast<double>(side) + 2;
  // 2^-48 is more than the rounding of the cross product.
  return std::abs(cross(edge.direction, to_centre)) <=
         edge.size * (reach + 0x1p-48 * (std::abs(to_centre.x) + std::abs(to_centre.y)));
}

/// The children of a node that an edge may meet, as bits, and perhaps some more: what may_meet says
/// of four squares, for little more than one. `side` is that of the children.
unsigned children_near(const PackedEdge& edge, LatticePoint middle, std::int64_t side,
                       double part) {
  const std::int64_t grown = growth(side, part);
  constexpr unsigned kEast = 1U << kNorthEast | 1U << kSouthEast;
  constexpr unsigned kNorth = 1U << kNorthEast | 1U << kNorthWest;
  unsigned near = 15;
  if (edge.high.x < middle.x - grown) near &= ~kEast;
  if (edge.low.x > middle.x + grown) near &= kEast;
  if (edge.high.y < middle.y - grown) near &= ~kNorth;
  if (edge.low.y > middle.y + grown) near &= kNorth;
  if ((near & (near - 1)) == 0) return near;  // one
  const Vector d = edge.direction;
  const Vector to_middle = on_lattice(middle) - edge.start;
  const auto half = 0.5 * static_cast<double>(side);
  // Wider than in may_meet by more than any rounding here.
  const double limit = edge.size * ((1 + 2.02 * part) * half + 3 +
                                    0x1p-46 * (std::abs(to_middle.x) + std::abs(to_middle.y)));
  const double at_middle = cross(d, to_middle);
  const double rising = half * (d.x - d.y);  // from the middle to the centre in the north-east
  const double falling = half * (d.x + d.y);
  if (std::abs(at_middle + rising) > limit) near &= ~(1U << kNorthEast);
  if (std::abs(at_middle + falling) > limit) near &= ~(1U << kNorthWest);
  if (std::abs(at_middle - rising) > limit) near &= ~(1U << kSouthWest);
  if (std::abs(at_middle - falling) > limit) near &= ~(1U << kSouthEast);
  return near;
}

/// Leads edges down the tree. Visitor: enter(block, edges) for a node that edges may meet,
/// leaf(cell, edges) for such a leaf, and missed(cell) for a child of the former that none meets;
/// edges as a range of indices into edges().
template <class Visitor>
class Descent {
 public:
  Descent(const Domain& domain, const Quadtree& tree, const Window& window,
          const std::vector<EdgeId>& edges, Visitor& visitor)
      : tree_(tree), window_(window), visitor_(visitor) {
    packed_.reserve(edges.size());
    for (const EdgeId e : edges) packed_.push_back(packed(domain, e));
    stack_.resize(edges.size());
    std::iota(stack_.begin(), stack_.end(), 0U);
  }

  void run() { descend(0, 0); }
  [[nodiscard]] const std::vector<PackedEdge>& edges() const { return packed_; }

 private:
  /// The edges that may meet the block are those from `first` to the top of the stack.
  void descend(BlockId block, std::size_t first) {
    const std::size_t end = stack_.size();
    visitor_.enter(block, top(first));
    const LatticePoint low = tree_.blocks()[block].corner;
    const int side_bits = tree_.side_bits({block, kNorthEast});
    const std::int64_t side = std::int64_t{1} << side_bits;
    const double part = std::any_of(kQuadrants.begin(), kQuadrants.end(),
                                    [&](Quadrant q) {
                                      return tree_.is_leaf({block, q});
                                    })
                            ? kLeafPart
                            : kNodePart;
    near_.resize(std::max(near_.size(), end));
    for (std::size_t i = first; i < end; ++i)
      near_[i] = static_cast<std::uint8_t>(
          children_near(packed_[stack_[i]], {low.x + side, low.y + side}, side, part));
    for (const Quadrant q : kQuadrants) {
      const Cell cell{block, q};
      const bool is_leaf = tree_.is_leaf(cell);
      if (!is_leaf && !window_.has(tree_.content(cell))) continue;
      const LatticePoint corner{low.x + (is_east(q) ? side : 0), low.y + (is_north(q) ? side : 0)};
      for (std::size_t i = first; i < end; ++i)
        if ((unsigned{near_[i]} >> q & 1U) != 0 &&
            (!is_leaf || may_meet(packed_[stack_[i]], corner, side)))
          stack_.push_back(stack_[i]);
      if (stack_.size() == end) {
        visitor_.missed(cell);
      } else if (is_leaf) {
        visitor_.leaf(cell, top(end));
      } else {
        descend(tree_.content(cell), end);
      }
      stack_.resize(end);
    }
  }

  [[nodiscard]] std::span<const std::uint32_t> top(std::size_t first) const {
    return {stack_.data() + first, stack_.size() - first};
  }

  const Quadtree& tree_;
  const Window& window_;
  Visitor& visitor_;
  std::vector<PackedEdge> packed_;
  std::vector<std::uint32_t> stack_;  ///< indices into packed_
  std::vector<std::uint8_t> near_;    ///< beside the stack: what children_near says at its level
};

std::vector<EdgeId> edges_of(const Domain& domain) {
  std::vector<EdgeId> edges(domain.size());
  std::iota(edges.begin(), edges.end(), EdgeId{0});
  return edges;
}

LatticePoint middle_of(const Quadtree& tree, BlockId id) {
  const Quadtree::Block& block = tree.blocks()[id];
  const std::int64_t half = std::int64_t{1} << tree.side_bits({id, kNorthEast});
  return {block.corner.x + half, block.corner.y + half};
}

/// Follows a straight line between two points, and turns sides where it crosses an edge. Both are
/// moved as by Domain::moved_off: then no end is on an edge, and no vertex on the line.
class Crossings {
 public:
  Crossings(const Domain& domain, LatticePoint from, LatticePoint to)
      : domain_(domain), from_(from), to_(to) {}

  void pass(EdgeId edge) {
    const int side = domain_.side(edge, to_);
    ends_on_boundary_ = ends_on_boundary_ || (side == 0 && domain_.holds(edge, to_));
    if (moved(side, edge) != moved(domain_.side(edge, from_), edge) &&
        domain_.moved_turn(from_, to_, edge) != domain_.moved_turn(from_, to_, domain_.next(edge)))
      odd_ = !odd_;
  }
  [[nodiscard]] bool ends_on_boundary() const { return ends_on_boundary_; }
  /// Where the moved end is, `start` being where the moved start is.
  [[nodiscard]] Where moved_end(Where start) const {
    return (start == Where::kInside) != odd_ ? Where::kInside : Where::kOutside;
  }

 private:
  [[nodiscard]] int moved(int side, EdgeId edge) const {
    return side != 0 ? side : domain_.moved_off(edge);
  }

  const Domain& domain_;
  LatticePoint from_;
  LatticePoint to_;
  bool ends_on_boundary_ = false;
  bool odd_ = false;
};

/// The part of an edge within a square, from its middle; nullopt where there is none.
struct ClippedEdge {
  Vector start;
  Vector end;
};
std::optional<ClippedEdge> clipped(const Domain& domain, EdgeId edge, const FinePoint& middle,
                                   double half) {
  const Vector a = domain.at(edge) - middle;
  const Vector d = domain.direction(edge);
  double from = 0;
  double to = 1;
  const auto clip = [&](double start, double slope) {
    if (slope == 0) {
      if (std::abs(start) > half) to = -1;
      return;
    }
    const double low = std::min((-half - start) / slope, (half - start) / slope);
    const double high = std::max((-half - start) / slope, (half - start) / slope);
    from = std::max(from, low);
    to = std::min(to, high);
  };
  clip(a.x, d.x);
  clip(a.y, d.y);
  if (from >= to) return std::nullopt;
  return ClippedEdge{a + from * d, a + to * d};
}

bool on_left(const ClippedEdge& edge, const ClippedEdge& of) {
  const Vector middle = 0.5 * (of.start + of.end);
  return cross(edge.end - edge.start, middle - edge.start) > 0;
}

bool interior_between(const ClippedEdge& e, const ClippedEdge& f) {
  return on_left(e, f) && on_left(f, e);
}

bool is_too_large(const Domain& domain, const Quadtree& tree, Cell leaf,
                  std::span<const EdgeId> edges) {
  const auto side = static_cast<double>(std::int64_t{1} << tree.side_bits(leaf));
  const LatticePoint low = tree.corner(leaf);
  const std::int64_t half = std::int64_t{1} << (tree.side_bits(leaf) - 1);
  const FinePoint middle = on_lattice({low.x + half, low.y + half});
  std::vector<std::pair<EdgeId, ClippedEdge>> inside;
  for (const EdgeId e : edges) {
    const auto part = clipped(domain, e, middle, side / 2);
    if (!part) continue;
    for (const auto& [f, other] : inside)
      if (domain.next(e) != f && domain.next(f) != e && interior_between(*part, other)) return true;
    inside.emplace_back(e, *part);
  }
  return false;
}

}  // namespace

/// The centre of a node is a corner of its four children, and no edge between it and the centre of
/// one of them misses that child.
class EdgeCells::Finder {
 public:
  Finder(EdgeCells& cells, const Window& window)
      : cells_(cells),
        window_(window),
        descent_(cells.domain_, cells.tree_, window, edges_of(cells.domain_), *this) {
    cells_.leaves_.resize(cells_.tree_.blocks().size());
    cells_.centres_.resize(cells_.tree_.blocks().size(), Where::kUnknown);
  }
  void run() { descent_.run(); }

  void enter(BlockId id, std::span<const std::uint32_t> edges) {
    const Quadtree::Block& block = cells_.tree_.blocks()[id];
    // The corner of the tree lies outside by place_root.
    const bool is_root = id == 0;
    const LatticePoint from = is_root ? block.corner : middle_of(cells_.tree_, block.parent);
    const LatticePoint to = middle_of(cells_.tree_, id);
    const auto [low_x, high_x] = std::minmax(from.x, to.x);
    const auto [low_y, high_y] = std::minmax(from.y, to.y);
    Crossings crossings(cells_.domain_, from, to);
    for (const std::uint32_t i : edges) {
      const PackedEdge& edge = descent_.edges()[i];
      if (edge.high.x + 1 < low_x || edge.low.x > high_x || edge.high.y + 1 < low_y ||
          edge.low.y > high_y)
        continue;
      crossings.pass(edge.id);
    }
    cells_.centres_[id] =
        crossings.moved_end(is_root ? Where::kOutside : cells_.centres_[block.parent]);
  }

  void leaf(Cell cell, std::span<const std::uint32_t> edges) {
    for (const std::uint32_t i : edges) cells_.edges_.push_back(descent_.edges()[i].id);
    cells_.met_.push_back({cell, static_cast<std::uint32_t>(cells_.edges_.size())});
  }

  void missed(Cell cell) { mark(cell, cells_.centres_[cell.block]); }

 private:
  void mark(Cell cell, Where where) {
    const Quadtree& tree = cells_.tree_;
    if (tree.is_leaf(cell)) {
      cells_.leaves_[cell.block] = static_cast<std::uint8_t>(
          cells_.leaves_[cell.block] | static_cast<unsigned>(where) << (2U * cell.quadrant));
    } else if (const BlockId inner = tree.content(cell); window_.has(inner)) {
      for (const Quadrant q : kQuadrants) mark({inner, q}, where);
    }
  }

  EdgeCells& cells_;
  const Window& window_;
  Descent<Finder> descent_;
};

EdgeCells::EdgeCells(const Domain& domain, const Quadtree& tree, const Window& window)
    : domain_(domain), tree_(tree) {
  Finder(*this, window).run();
}

Where EdgeCells::where_at(Cell leaf, std::span<const EdgeId> edges, LatticePoint point) const {
  Crossings crossings(domain_, middle_of(tree_, leaf.block), point);
  for (const EdgeId edge : edges) crossings.pass(edge);
  if (crossings.ends_on_boundary()) return Where::kBoundary;
  return crossings.moved_end(centres_[leaf.block]);
}

void for_leaves_with_edges(const Domain& domain, const Quadtree& tree,
                           const std::vector<EdgeId>& edges,
                           const std::function<void(Cell, std::span<const EdgeId>)>& visit) {
  struct Lister {
    void enter(BlockId /*id*/, std::span<const std::uint32_t> /*met*/) {}
    void missed(Cell /*cell*/) {}
    void leaf(Cell cell, std::span<const std::uint32_t> met) {
      listed.clear();
      for (const std::uint32_t i : met) listed.push_back(edges[i]);
      visit(cell, listed);
    }
    const std::vector<EdgeId>& edges;
    const std::function<void(Cell, std::span<const EdgeId>)>& visit;
    std::vector<EdgeId> listed;
  };
  Lister lister{edges, visit, {}};
  const Window whole;
  Descent<Lister>(domain, tree, whole, edges, lister).run();
}

std::vector<Cell> leaves_too_large(const Domain& domain, const Quadtree& tree,
                                   const EdgeCells& edge_cells) {
  std::vector<Cell> leaves;
  edge_cells.for_met([&](Cell leaf, std::span<const EdgeId> edges) {
    if (edges.size() > 1 && is_too_large(domain, tree, leaf, edges)) leaves.push_back(leaf);
  });
  return leaves;
}

}  // namespace quadbound
