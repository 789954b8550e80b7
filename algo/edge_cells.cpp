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
  LatticePoint low;  ///< its bounding box
  LatticePoint high;
  FinePoint start;
  Vector direction;
};

PackedEdge packed(const Domain& domain, EdgeId edge) {
  const LatticePoint a = domain.floor(edge);
  const LatticePoint b = domain.floor(domain.next(edge));
  return {edge,
          {std::min(a.x, b.x), std::min(a.y, b.y)},
          {std::max(a.x, b.x), std::max(a.y, b.y)},
          domain.at(edge),
          domain.direction(edge)};
}

/// Whether an edge may meet a cell grown by a quarter of its side, which is how far outside a
/// mirrored extra point lies.
bool may_meet(const PackedEdge& edge, LatticePoint corner, int side_bits) {
  const std::int64_t side = std::int64_t{1} << side_bits;
  const std::int64_t grown = side / 4 + 1;
  if (edge.high.x < corner.x - grown || edge.low.x > corner.x + side + grown) return false;
  if (edge.high.y < corner.y - grown || edge.low.y > corner.y + side + grown) return false;
  const Vector d = edge.direction;
  const Vector to_centre = on_lattice({corner.x + side / 2, corner.y + side / 2}) - edge.start;
  const double reach = 0.75 * static_cast<double>(side) + 2;
  const double size = std::abs(d.x) + std::abs(d.y);
  // 2^-48 is more than the rounding of the cross product.
  return std::abs(cross(d, to_centre)) <=
         size * (reach + 0x1p-48 * (std::abs(to_centre.x) + std::abs(to_centre.y)));
}

class Descent {
 public:
  Descent(const Domain& domain, const Quadtree& tree, const Window& window,
          const std::vector<EdgeId>& edges,
          const std::function<void(Cell, std::span<const EdgeId>)>& visit)
      : tree_(tree), window_(window), visit_(visit) {
    packed_.reserve(edges.size());
    for (const EdgeId e : edges) packed_.push_back(packed(domain, e));
    edges_.resize(edges.size());
    std::iota(edges_.begin(), edges_.end(), 0U);
  }

  /// The edges that may meet the block are those from `first` to the top of the stack.
  void descend(BlockId block, std::size_t first) {
    const std::size_t end = edges_.size();
    for (const Quadrant q : kQuadrants) {
      const Cell cell{block, q};
      if (!tree_.is_leaf(cell) && !window_.has(tree_.content(cell))) continue;
      const LatticePoint corner = tree_.corner(cell);
      for (std::size_t i = first; i < end; ++i)
        if (may_meet(packed_[edges_[i]], corner, tree_.side_bits(cell)))
          edges_.push_back(edges_[i]);
      if (edges_.size() > end) {
        if (tree_.is_leaf(cell)) {
          visit(cell, {edges_.data() + end, edges_.size() - end});
        } else {
          descend(tree_.content(cell), end);
        }
      }
      edges_.resize(end);
    }
  }

 private:
  void visit(Cell leaf, std::span<const std::uint32_t> edges) {
    met_.clear();
    for (const std::uint32_t i : edges) met_.push_back(packed_[i].id);
    visit_(leaf, met_);
  }

  const Quadtree& tree_;
  const Window& window_;
  const std::function<void(Cell, std::span<const EdgeId>)>& visit_;
  std::vector<PackedEdge> packed_;
  std::vector<std::uint32_t> edges_;  ///< a stack of indices into packed_
  std::vector<EdgeId> met_;
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

double distance(Vector point, const ClippedEdge& edge) {
  const Vector d = edge.end - edge.start;
  const double t = std::clamp(dot(point - edge.start, d) / dot(d, d), 0.0, 1.0);
  return length(point - edge.start - t * d);
}

bool on_left(const ClippedEdge& edge, const ClippedEdge& of) {
  const Vector middle = 0.5 * (of.start + of.end);
  return cross(edge.end - edge.start, middle - edge.start) > 0;
}

bool too_close(const ClippedEdge& e, const ClippedEdge& f, double limit) {
  if (!on_left(e, f) || !on_left(f, e)) return false;
  return std::min({distance(e.start, f), distance(e.end, f), distance(f.start, e),
                   distance(f.end, e)}) < limit;
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
      if (domain.next(e) != f && domain.next(f) != e && too_close(*part, other, side / 4))
        return true;
    inside.emplace_back(e, *part);
  }
  return false;
}

}  // namespace

void for_leaves_with_edges(const Domain& domain, const Quadtree& tree, const Window& window,
                           const std::vector<EdgeId>& edges,
                           const std::function<void(Cell, std::span<const EdgeId>)>& visit) {
  Descent(domain, tree, window, edges, visit).descend(0, 0);
}

std::vector<EdgeId> edges_of(const Domain& domain) {
  std::vector<EdgeId> edges(domain.size());
  std::iota(edges.begin(), edges.end(), EdgeId{0});
  return edges;
}

std::vector<Cell> leaves_too_large(const Domain& domain, const Quadtree& tree,
                                   const Window& window) {
  std::vector<Cell> leaves;
  for_leaves_with_edges(domain, tree, window, edges_of(domain),
                        [&](Cell leaf, std::span<const EdgeId> edges) {
                          if (edges.size() > 1 && is_too_large(domain, tree, leaf, edges))
                            leaves.push_back(leaf);
                        });
  return leaves;
}

}  // namespace quadbound
