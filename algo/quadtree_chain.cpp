// SPDX-License-Identifier: Apache-2.0
#include "algo/quadtree_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "algo/edge_cells.hpp"

namespace quadbound {
namespace {

std::int64_t along(LatticePoint axis, LatticePoint p) { return axis.x * p.x + axis.y * p.y; }
LatticePoint reversed(LatticePoint axis) { return {-axis.x, -axis.y}; }

class ChainFinder {
 public:
  ChainFinder(const Domain& domain, const TreeMesh& tree_mesh)
      : domain_(domain), tree_mesh_(tree_mesh), chains_(domain.size()) {}

  std::vector<std::vector<VertexId>> run() && {
    EdgeCells(domain_, tree_mesh_.tree()).for_met([this](Cell leaf, std::span<const EdgeId> edges) {
      for (const EdgeId e : edges) add(leaf, e);
    });
    for (EdgeId e = 0; e < domain_.size(); ++e) sort(e);
    return std::move(chains_);
  }

 private:
  void add(Cell leaf, EdgeId e) {
    // "C does not include the starting and ending cell centers, a and b."
    if (leaf == tree_mesh_.cell_of(e) || leaf == tree_mesh_.cell_of(domain_.next(e))) return;
    if (!is_crossed(leaf, e) || add_if_above(leaf, e)) return;
    const EdgeAxes axes = axes_of(domain_, e);
    for (const Cell north : neighbours(leaf, axes.north)) add_if_above(north, e);
    const bool rises = axes.slope.y >= 0;
    for (const Cell beside : neighbours(leaf, rises ? reversed(axes.east) : axes.east))
      add_if_above(beside, e);
  }

  /// Whether its centre is above. A leaf that Q leaves out is outside the domain.
  bool add_if_above(Cell leaf, EdgeId e) {
    if (!tree_mesh_.has(leaf)) return false;
    const VertexId centre = tree_mesh_.centre(leaf);
    if (domain_.side(e, tree_mesh_.at(centre)) <= 0) return false;
    if (!tree_mesh_.is_site(centre)) chains_[e].push_back(centre);
    return true;
  }

  /// It has a part above the edge, and meets it: a chord of the line that lies between the ends.
  [[nodiscard]] bool is_crossed(Cell leaf, EdgeId e) const {
    const LatticePoint low = tree_mesh_.tree().corner(leaf);
    const std::int64_t side = std::int64_t{1} << tree_mesh_.tree().side_bits(leaf);
    bool above = false;
    bool other = false;
    for (const std::int64_t x : {low.x, low.x + side})
      for (const std::int64_t y : {low.y, low.y + side})
        (domain_.side(e, LatticePoint{x, y}) > 0 ? above : other) = true;
    return above && other && is_met_between_ends(low, static_cast<double>(side), e);
  }

  /// Ends lie in other cells, so that the middle of the chord tells, and rounding does not matter.
  [[nodiscard]] bool is_met_between_ends(LatticePoint low, double side, EdgeId e) const {
    const Vector d = domain_.direction(e);
    const Vector from = on_lattice(low) - domain_.at(e);
    double first = -HUGE_VAL;
    double last = HUGE_VAL;
    const auto clip = [&](double start, double slope) {
      if (slope == 0) return;
      first = std::max(first, std::min(start / slope, (start + side) / slope));
      last = std::min(last, std::max(start / slope, (start + side) / slope));
    };
    clip(from.x, d.x);
    clip(from.y, d.y);
    const double middle = (first + last) / 2;
    return 0 < middle && middle < 1;
  }

  /// The one or two leaves beside a leaf.
  [[nodiscard]] std::vector<Cell> neighbours(Cell leaf, LatticePoint direction) const {
    const Quadtree& tree = tree_mesh_.tree();
    const LatticePoint low = tree.corner(leaf);
    const std::int64_t side = std::int64_t{1} << tree.side_bits(leaf);
    std::vector<Cell> found;
    for (const std::int64_t part : {side / 4, side - side / 4}) {
      const auto coordinate = [&](std::int64_t start, std::int64_t step) {
        return start + (step == 0 ? part : (step > 0 ? side : -1));
      };
      const LatticePoint p{coordinate(low.x, direction.x), coordinate(low.y, direction.y)};
      if (!is_in_root(p)) continue;
      const Cell there = tree.leaf_at(p);
      if (found.empty() || !(found.back() == there)) found.push_back(there);
    }
    return found;
  }

  [[nodiscard]] bool is_in_root(LatticePoint p) const {
    const RootSquare& root = tree_mesh_.tree().root();
    const std::int64_t side = std::int64_t{1} << root.side_bits;
    return root.corner.x <= p.x && p.x < root.corner.x + side && root.corner.y <= p.y &&
           p.y < root.corner.y + side;
  }

  void sort(EdgeId e) {
    const EdgeAxes axes = axes_of(domain_, e);
    const int sign = axes.slope.y >= 0 ? 1 : -1;
    const auto place = [&](VertexId v) {
      const LatticePoint p = tree_mesh_.at(v);
      return std::pair{along(axes.east, p), sign * along(axes.north, p)};
    };
    std::vector<VertexId>& chain = chains_[e];
    std::sort(chain.begin(), chain.end(),
              [&](VertexId a, VertexId b) { return place(a) < place(b); });
    chain.erase(std::unique(chain.begin(), chain.end()), chain.end());
  }

  const Domain& domain_;
  const TreeMesh& tree_mesh_;
  std::vector<std::vector<VertexId>> chains_;
};

}  // namespace

EdgeAxes axes_of(const Domain& domain, EdgeId edge) {
  const Vector d = domain.direction(edge);
  const LatticePoint east = std::abs(d.x) >= std::abs(d.y) ? LatticePoint{d.x > 0 ? 1 : -1, 0}
                                                           : LatticePoint{0, d.y > 0 ? 1 : -1};
  const LatticePoint north{-east.y, east.x};
  const auto part = [&](LatticePoint axis) {
    return static_cast<double>(axis.x) * d.x + static_cast<double>(axis.y) * d.y;
  };
  return {east, north, {part(east), part(north)}};
}

std::vector<std::vector<VertexId>> quadtree_chains(const Domain& domain,
                                                   const TreeMesh& tree_mesh) {
  return ChainFinder(domain, tree_mesh).run();
}

}  // namespace quadbound
