// SPDX-License-Identifier: Apache-2.0
// Where edges run among the leaves, and what of Q is left out there, against all pairs of a leaf
// and an edge in exact arithmetic.
#include "algo/edge_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "algo/polygon_samples_for_tests.hpp"
#include "algo/quadrangulation.hpp"
#include "algo/separation.hpp"
#include "algo/tree_mesh.hpp"
#include "generators/polygons.hpp"
#include "generators/random.hpp"
#include "model/validate.hpp"

namespace quadbound {
namespace {

/// A domain, with vertices off the lattice or with kites too, and its tree.
class Sample {
 public:
  explicit Sample(const Polygon& polygon, RootShift shift = {3, 5})
      : domain_(non_acute_domain_of(polygon, shift)), separation_(placed_vertices(domain_), {}) {
    separation_.apply_conditions();
    separation_.refine_five_by_five();
  }
  [[nodiscard]] const Domain& domain() const { return domain_; }
  [[nodiscard]] const Separation& separation() const { return separation_; }
  [[nodiscard]] const Quadtree& tree() const { return separation_.tree(); }

  [[nodiscard]] RationalPoint at(EdgeId vertex) const { return in_units(domain_, vertex); }
  /// Positive on the left of an edge.
  [[nodiscard]] Rational cross(EdgeId e, const RationalPoint& p) const {
    const RationalPoint a = at(e);
    const RationalPoint b = at(domain_.next(e));
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  }
  [[nodiscard]] Where where(LatticePoint point) const {
    const RationalPoint p{Rational(point.x), Rational(point.y)};
    bool odd = false;
    for (EdgeId e = 0; e < domain_.size(); ++e) {
      const RationalPoint a = at(e);
      const RationalPoint b = at(domain_.next(e));
      const Rational side = cross(e, p);
      if (side == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
          std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y))
        return Where::kBoundary;
      if ((a.y <= p.y) != (b.y <= p.y) && (side > 0) == (b.y > a.y)) odd = !odd;
    }
    return odd ? Where::kInside : Where::kOutside;
  }
  /// Whether an edge meets a leaf grown by a quarter of its side: their boxes meet, and the corners
  /// of the leaf are not all on one side.
  [[nodiscard]] bool meets(EdgeId e, Cell leaf) const {
    const LatticePoint low = tree().corner(leaf);
    const std::int64_t side = std::int64_t{1} << tree().side_bits(leaf);
    const std::array<Rational, 2> x{Rational(low.x - side / 4), Rational(low.x + side + side / 4)};
    const std::array<Rational, 2> y{Rational(low.y - side / 4), Rational(low.y + side + side / 4)};
    const RationalPoint a = at(e);
    const RationalPoint b = at(domain_.next(e));
    if (std::max(a.x, b.x) < x[0] || x[1] < std::min(a.x, b.x)) return false;
    if (std::max(a.y, b.y) < y[0] || y[1] < std::min(a.y, b.y)) return false;
    int left = 0;
    int right = 0;
    for (const Rational& there : x) {
      left += cross(e, {there, y[0]}) >= 0 ? 1 : 0;
      left += cross(e, {there, y[1]}) >= 0 ? 1 : 0;
      right += cross(e, {there, y[0]}) <= 0 ? 1 : 0;
      right += cross(e, {there, y[1]}) <= 0 ? 1 : 0;
    }
    return left > 0 && right > 0;
  }

 private:
  Domain domain_;
  Separation separation_;
};

std::vector<Sample> separated_samples() {
  std::vector<Sample> result;
  result.emplace_back(
      normalised({"through centres", {{{0, -1}, {1, 0}, {1.5, 0}, {0, 1}, {-1, 0}}}}), RootShift{});
  result.emplace_back(polygon_off_the_lattice());
  for (const char* recipe : {"star:n=8,seed=1,holes=1", "grid-aligned:n=8,seed=3,level=3"})
    result.emplace_back(normalised(generate_polygon(parse_polygon_recipe(recipe))));
  return result;
}

TEST(EdgeCells, ListEveryEdgeAtTheLeavesThatItMeetsAndTheSidesOfTheOthers) {
  for (const Sample& sample : separated_samples()) {
    const EdgeCells edge_cells(sample.domain(), sample.tree());
    std::vector<std::vector<EdgeId>> listed(4 * sample.tree().blocks().size());
    edge_cells.for_met([&](Cell leaf, std::span<const EdgeId> edges) {
      EXPECT_TRUE(std::is_sorted(edges.begin(), edges.end()));
      EXPECT_EQ(edge_cells.where(leaf), Where::kUnknown);
      listed[4 * std::size_t{leaf.block} + leaf.quadrant].assign(edges.begin(), edges.end());
    });
    for (BlockId block = 0; block < sample.tree().blocks().size(); ++block) {
      for (const Quadrant q : kQuadrants) {
        const Cell leaf{block, q};
        if (!sample.tree().is_leaf(leaf)) continue;
        const std::vector<EdgeId>& edges = listed[4 * std::size_t{block} + q];
        for (EdgeId e = 0; e < sample.domain().size(); ++e)
          EXPECT_TRUE(!sample.meets(e, leaf) || std::count(edges.begin(), edges.end(), e) == 1);
        if (edges.empty()) {
          EXPECT_EQ(edge_cells.where(leaf), sample.where(sample.tree().corner(leaf)));
        }
      }
    }
  }
}

TEST(EdgeCells, AreSeenWithCentresOfNodesOnEdges) {
  const Sample sample = std::move(separated_samples().front());
  int on_edge = 0;
  for (BlockId block = 0; block < sample.tree().blocks().size(); ++block) {
    const std::int64_t half = std::int64_t{1} << sample.tree().side_bits({block, kNorthEast});
    const LatticePoint low = sample.tree().blocks()[block].corner;
    on_edge += sample.where({low.x + half, low.y + half}) == Where::kBoundary ? 1 : 0;
  }
  EXPECT_GT(on_edge, 2);
}

TEST(EdgeCells, TellWherePointsOfMetLeavesLie) {
  RandomIntegers random(5);
  std::array<int, 4> found{};
  for (const Sample& sample : separated_samples()) {
    const EdgeCells edge_cells(sample.domain(), sample.tree());
    edge_cells.for_met([&](Cell leaf, std::span<const EdgeId> edges) {
      const int side_bits = sample.tree().side_bits(leaf);
      const LatticePoint low = sample.tree().corner(leaf);
      const std::int64_t half = std::int64_t{1} << (side_bits - 1);
      std::vector<LatticePoint> points{
          {low.x + random.bits(side_bits), low.y + random.bits(side_bits)},
          {low.x + half, low.y + half},
          {low.x + half, low.y},
          low};
      for (const EdgeId e : edges)
        if (sample.tree().leaf_at(sample.domain().floor(e)) == leaf)
          points.push_back(sample.domain().floor(e));
      for (const LatticePoint point : points) {
        const Where where = edge_cells.where_at(leaf, edges, point);
        EXPECT_EQ(where, sample.where(point));
        ++found[static_cast<std::size_t>(where)];
      }
    });
  }
  EXPECT_GT(*std::min_element(found.begin() + 1, found.end()), 3);
}

using PlacedQuad = std::array<std::pair<std::int64_t, std::int64_t>, 4>;

template <class At>
PlacedQuad placed(const Quad& quad, const At& at) {
  PlacedQuad result{};
  for (unsigned k = 0; k < 4; ++k) result[k] = {at(quad[k]).x, at(quad[k]).y};
  return result;
}

TEST(TreeMesh, LeavesOutNothingButQuadsOutsideAndKeepsTheOrder) {
  std::size_t left_out = 0;
  for (const Sample& sample : separated_samples()) {
    const Quadtree& tree = sample.tree();
    const EdgeCells edge_cells(sample.domain(), tree);
    Counters counters;
    const TreeMesh made(sample.domain(), sample.separation(), edge_cells, counters);
    TemplateTree whole(tree);
    Counters all;
    const Mesh q = quadrangulate(whole, tree.root(), TwoTwoVariant::kExact, all);
    EXPECT_EQ(counters, all);
    // Sites are back at the centres of their cells.
    const auto before = [&](VertexId v) {
      if (!made.is_site(v)) return made.at(v);
      const Cell cell = made.cell_of(made.site_near(v));
      const std::int64_t half = std::int64_t{1} << (tree.side_bits(cell) - 1);
      return LatticePoint{tree.corner(cell).x + half, tree.corner(cell).y + half};
    };
    const auto is_outside = [&](const auto& at) {
      return sample.where({at.first, at.second}) == Where::kOutside;
    };
    QuadId next = 0;
    for (const Quad& quad : q.quads) {
      const PlacedQuad here = placed(quad, [&](VertexId v) { return q.vertices.lattice(v); });
      if (next < made.mesh().quads.size() && placed(made.mesh().quads[next], before) == here) {
        ++next;
      } else {
        ++left_out;
        EXPECT_TRUE(std::all_of(here.begin(), here.end(), is_outside));
      }
    }
    EXPECT_EQ(next, made.mesh().quads.size());
  }
  EXPECT_GT(left_out, 20U);
}

/// The part of an edge in a leaf, as parameters; nullopt where that is no more than a point.
std::optional<std::pair<Rational, Rational>> part_in(const Sample& sample, EdgeId e, Cell leaf) {
  const RationalPoint a = sample.at(e);
  const RationalPoint b = sample.at(sample.domain().next(e));
  const LatticePoint low = sample.tree().corner(leaf);
  const std::int64_t side = std::int64_t{1} << sample.tree().side_bits(leaf);
  Rational from = 0;
  Rational to = 1;
  const auto clip = [&](const Rational& start, const Rational& slope, std::int64_t corner) {
    if (slope == 0) {
      if (start < corner || start > corner + side) to = from;
      return;
    }
    const Rational t = (corner - start) / slope;
    const Rational u = (corner + side - start) / slope;
    from = std::max(from, std::min(t, u));
    to = std::min(to, std::max(t, u));
  };
  clip(a.x, b.x - a.x, low.x);
  clip(a.y, b.y - a.y, low.y);
  if (from >= to) return std::nullopt;
  return std::pair{from, to};
}

/// Whether the middle of the part of f in a leaf is on the left of e.
bool on_left(const Sample& sample, EdgeId e, EdgeId f, const std::pair<Rational, Rational>& part) {
  const RationalPoint a = sample.at(f);
  const RationalPoint b = sample.at(sample.domain().next(f));
  const Rational t = (part.first + part.second) / 2;
  return sample.cross(e, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}) > 0;
}

bool is_too_large(const Sample& sample, Cell leaf) {
  const Domain& domain = sample.domain();
  for (EdgeId e = 0; e < domain.size(); ++e) {
    const auto part = part_in(sample, e, leaf);
    if (!part) continue;
    for (EdgeId f = 0; f < e; ++f) {
      if (domain.next(e) == f || domain.next(f) == e) continue;
      const auto other = part_in(sample, f, leaf);
      if (other && on_left(sample, e, f, *other) && on_left(sample, f, e, *part)) return true;
    }
  }
  return false;
}

TEST(LeavesTooLarge, AreThoseThatTwoEdgesRunThroughWithTheInsideBetween) {
  std::size_t count = 0;
  for (const char* recipe : {"comb:n=24", "needle:n=20,seed=1", "spiral-band:n=24"}) {
    const Sample sample(normalised(generate_polygon(parse_polygon_recipe(recipe))));
    const EdgeCells edge_cells(sample.domain(), sample.tree());
    const std::vector<Cell> found = leaves_too_large(sample.domain(), sample.tree(), edge_cells);
    count += found.size();
    for (BlockId block = 0; block < sample.tree().blocks().size(); ++block) {
      for (const Quadrant q : kQuadrants) {
        const Cell leaf{block, q};
        if (!sample.tree().is_leaf(leaf)) continue;
        EXPECT_EQ(std::count(found.begin(), found.end(), leaf), is_too_large(sample, leaf) ? 1 : 0);
      }
    }
  }
  EXPECT_GT(count, 0U);
}

}  // namespace
}  // namespace quadbound
