// SPDX-License-Identifier: Apache-2.0
// The parts of the mesher of polygons, by the guarantees of their headers, against exact arithmetic
// on all pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "algo/cut_quads.hpp"
#include "algo/domain.hpp"
#include "algo/edge_separation.hpp"
#include "algo/kept_quads.hpp"
#include "algo/polygon_samples_for_tests.hpp"
#include "algo/separation.hpp"
#include "algo/sizing.hpp"
#include "algo/strip_pieces.hpp"
#include "algo/tree_mesh.hpp"
#include "generators/random.hpp"
#include "model/angle.hpp"
#include "model/validate.hpp"

namespace quadbound {
namespace {

/// A domain with its tree, as DomainMesher starts with it, or after edge separation.
class Stage {
 public:
  explicit Stage(Domain domain)
      : domain_(std::move(domain)), separation_(placed_vertices(domain_), Budget{}) {
    separation_.apply_conditions();
    separation_.refine_five_by_five();
    remake();
  }

  /// Until no edges are too close and K does not meet itself.
  void separate() {
    for (;;) {
      std::vector<Cell> split;
      const auto faults = separation_faults(domain_, *tree_mesh_, *cut_quads_);
      split.reserve(faults.size());
      for (const SeparationFault& fault : faults) split.push_back(fault.split);
      if (faults.empty())
        for (const VertexId v : keep_quads(*tree_mesh_, *cut_quads_).pinched)
          split.push_back(tree_mesh_->leaf_of(v));
      if (split.empty()) return;
      separation_.refine(split);
      remake();
    }
  }

  [[nodiscard]] const Domain& domain() const { return domain_; }
  [[nodiscard]] const TreeMesh& tree_mesh() const { return *tree_mesh_; }
  [[nodiscard]] const CutQuads& cut_quads() const { return *cut_quads_; }

  /// A vertex of the domain at its own place, not rounded.
  [[nodiscard]] RationalPoint place(VertexId v) const {
    if (tree_mesh_->is_site(v)) return in_units(domain_, tree_mesh_->site_near(v));
    return rational(tree_mesh_->at(v));
  }

 private:
  void remake() {
    const EdgeCells edge_cells(domain_, separation_.tree());
    tree_mesh_ = std::make_unique<TreeMesh>(domain_, separation_, edge_cells, counters_);
    cut_quads_ = std::make_unique<CutQuads>(domain_, *tree_mesh_, edge_cells);
  }

  Domain domain_;
  Separation separation_;
  Counters counters_;
  std::unique_ptr<TreeMesh> tree_mesh_;
  std::unique_ptr<CutQuads> cut_quads_;
};

TEST(Quadtree, TheLeafAtAPointHoldsIt) {
  RandomIntegers random(3);
  for (const Polygon& polygon : samples()) {
    const Stage stage(domain_of(polygon));
    const Quadtree& tree = stage.tree_mesh().tree();
    const RootSquare& root = tree.root();
    std::vector<LatticePoint> points;
    points.reserve(500);
    for (int i = 0; i < 500; ++i)
      points.push_back({root.corner.x + random.bits(root.side_bits),
                        root.corner.y + random.bits(root.side_bits)});
    for (const Quadtree::Block& block : tree.blocks()) points.push_back(block.corner);
    LeafFinder finder(tree);
    for (const LatticePoint p : points) {
      const Cell leaf = tree.leaf_at(p);
      EXPECT_EQ(finder.leaf_at(p), leaf);
      ASSERT_TRUE(tree.is_leaf(leaf));
      const LatticePoint corner = tree.corner(leaf);
      const std::int64_t side = std::int64_t{1} << tree.side_bits(leaf);
      EXPECT_TRUE(corner.x <= p.x && p.x < corner.x + side);
      EXPECT_TRUE(corner.y <= p.y && p.y < corner.y + side);
    }
  }
}

TEST(TreeMesh, ListsTheQuadsOfEveryVertexAndPlacesTheSites) {
  for (const Polygon& polygon : samples()) {
    const Stage stage(domain_of(polygon));
    const TreeMesh& tree_mesh = stage.tree_mesh();
    std::vector<std::vector<QuadId>> expected(tree_mesh.mesh().vertices.size());
    for (QuadId quad = 0; quad < tree_mesh.mesh().quads.size(); ++quad)
      for (const VertexId v : tree_mesh.mesh().quads[quad]) expected[v].push_back(quad);
    for (VertexId v = 0; v < expected.size(); ++v) {
      const auto listed = tree_mesh.quads_at(v);
      EXPECT_EQ(std::vector<QuadId>(listed.begin(), listed.end()), expected[v]);
    }
    for (EdgeId site = 0; site < stage.domain().size(); ++site) {
      const VertexId v = tree_mesh.vertex_of(site);
      EXPECT_EQ(tree_mesh.at(v), stage.domain().floor(site));
      EXPECT_EQ(tree_mesh.centre(tree_mesh.cell_of(site)), v);
      EXPECT_EQ(tree_mesh.leaf_of(v), tree_mesh.cell_of(site));
      EXPECT_EQ(tree_mesh.site_near(v), site);
      EXPECT_TRUE(tree_mesh.is_site(v));
    }
  }
}

TEST(TreeMesh, TellsCentresFromExtraPointsAndWhoseTheseAre) {
  std::size_t halves = 0;
  for (const Polygon& polygon : samples()) {
    const Stage stage(domain_of(polygon));
    const TreeMesh& tree_mesh = stage.tree_mesh();
    std::set<VertexId> centres;
    tree_mesh.for_centres([&](Cell, VertexId centre) { centres.insert(centre); });
    for (VertexId v = 0; v < tree_mesh.mesh().vertices.size(); ++v)
      EXPECT_EQ(tree_mesh.is_centre(v), centres.contains(v)) << v;
    EXPECT_TRUE(std::ranges::is_sorted(tree_mesh.halves_extras()));
    EXPECT_EQ(tree_mesh.halves_extras().size(),
              tree_mesh.mesh().vertices.size() - tree_mesh.vertices_of_leaves());
    for (const auto& [centre, extra] : tree_mesh.halves_extras())
      EXPECT_EQ(tree_mesh.centre(tree_mesh.leaf_of(extra)), centre);
    halves += tree_mesh.halves_extras().size();
  }
  EXPECT_GT(halves, 0U);
}

/// The part of an edge's line within a quad that is not all on its right: parameters, 0 at the
/// start of the edge.
std::optional<std::pair<Rational, Rational>> part_within(const Stage& stage, const Quad& quad,
                                                         EdgeId e) {
  const RationalPoint a = in_units(stage.domain(), e);
  const RationalPoint b = in_units(stage.domain(), stage.domain().next(e));
  const Rational dx = b.x - a.x;
  const Rational dy = b.y - a.y;
  std::array<Rational, 4> h;
  std::array<Rational, 4> t;
  for (unsigned k = 0; k < 4; ++k) {
    const RationalPoint p = stage.place(quad[k]);
    h[k] = cross_of(a, b, p);
    t[k] = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
  }
  if (*std::ranges::max_element(h) <= 0) return std::nullopt;
  std::vector<Rational> crossings;
  for (unsigned k = 0; k < 4; ++k) {
    const unsigned m = (k + 1) & 3U;
    if (h[k] == 0) crossings.push_back(t[k]);
    if (sign_of(h[k]) * sign_of(h[m]) < 0)
      crossings.push_back(t[k] + (t[m] - t[k]) * h[k] / (h[k] - h[m]));
  }
  if (crossings.empty()) return std::nullopt;
  return std::pair{*std::ranges::min_element(crossings), *std::ranges::max_element(crossings)};
}

bool cuts(const std::pair<Rational, Rational>& part) {
  const auto& [from, to] = part;
  return from == to ? 0 < from && from < 1 : 0 < to && from < 1;
}

Where where_exactly(const Stage& stage, VertexId v) {
  if (stage.tree_mesh().is_site(v)) return Where::kBoundary;
  const RationalPoint p = stage.place(v);
  bool odd = false;
  for (EdgeId e = 0; e < stage.domain().size(); ++e) {
    const RationalPoint a = in_units(stage.domain(), e);
    const RationalPoint b = in_units(stage.domain(), stage.domain().next(e));
    const int side = sign_of(cross_of(a, b, p));
    const Rational forward = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
    const Rational backward = (p.x - b.x) * (a.x - b.x) + (p.y - b.y) * (a.y - b.y);
    if (side == 0 && forward >= 0 && backward >= 0) return Where::kBoundary;
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    if ((side > 0) == (b.y > a.y)) odd = !odd;  // crosses the ray to the east
  }
  return odd ? Where::kInside : Where::kOutside;
}

TEST(CutQuads, AgainstAllPairsOfQuadsAndEdges) {
  for (const Polygon& polygon : samples()) {
    const Stage stage(domain_of(polygon));
    const CutQuads& cut_quads = stage.cut_quads();
    const Mesh& mesh = stage.tree_mesh().mesh();
    std::vector<std::pair<QuadId, EdgeId>> expected;
    std::set<Above> above;
    for (QuadId quad = 0; quad < mesh.quads.size(); ++quad) {
      bool is_cut = false;
      for (EdgeId e = 0; e < stage.domain().size(); ++e) {
        const auto part = part_within(stage, mesh.quads[quad], e);
        if (!part || !cuts(*part)) continue;
        expected.emplace_back(quad, e);
        is_cut = true;
        for (const VertexId v : mesh.quads[quad])
          if (where_exactly(stage, v) == Where::kInside &&
              stage.domain().side(e, stage.tree_mesh().at(v)) > 0)
            above.insert({v, e});
      }
      EXPECT_EQ(cut_quads.is_cut(quad), is_cut) << polygon.file << ", quad " << quad;
    }
    std::vector<std::pair<QuadId, EdgeId>> found;
    for (const Cut& cut : cut_quads.cuts()) {
      found.emplace_back(cut.quad, cut.edge);
      const auto part = part_within(stage, mesh.quads[cut.quad], cut.edge);
      ASSERT_TRUE(part) << polygon.file;
      const auto [from, to] = cut_quads.passage(cut);
      EXPECT_NEAR(from, nearest_double(part->first), 1e-9);
      EXPECT_NEAR(to, nearest_double(part->second), 1e-9);
    }
    EXPECT_EQ(found, expected) << polygon.file;
    EXPECT_TRUE(std::ranges::equal(cut_quads.all_above(), above)) << polygon.file;
    for (VertexId v = 0; v < mesh.vertices.size(); ++v)
      ASSERT_EQ(cut_quads.where(v), where_exactly(stage, v)) << polygon.file << ", vertex " << v;
  }
}

TEST(CutQuads, EdgesAlongSidesAndThroughVerticesOfQuads) {
  // With no shift the sides of this square run through mesh vertices all along.
  const Polygon polygon = normalised({"square", {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}}});
  const Domain domain = domain_of(polygon, {});
  Separation separation(
      {domain.root(), place_root(vertices_of(polygon)).floors, std::vector<bool>(domain.size())},
      Budget{});
  separation.apply_conditions();
  separation.refine_five_by_five();
  Counters counters;
  const EdgeCells edge_cells(domain, separation.tree());
  const TreeMesh tree_mesh(domain, separation, edge_cells, counters);
  const CutQuads cut_quads(domain, tree_mesh, edge_cells);
  std::uint64_t inside = 0;
  for (VertexId v = 0; v < tree_mesh.mesh().vertices.size(); ++v) {
    const LatticePoint at = tree_mesh.at(v);
    const LatticePoint low = domain.floor(0);
    const LatticePoint high = domain.floor(2);
    const bool out = at.x < low.x || at.x > high.x || at.y < low.y || at.y > high.y;
    const bool in = low.x < at.x && at.x < high.x && low.y < at.y && at.y < high.y;
    EXPECT_EQ(cut_quads.where(v), out ? Where::kOutside : in ? Where::kInside : Where::kBoundary);
    inside += in ? 1U : 0U;
  }
  EXPECT_GT(inside, 4U);
}

/// Guarantee 2: a rectangle with one side a few lattice units below a row of centres.
TEST(CutQuads, VerticesLessThanFourUnitsAboveAnEdgeCountAsOnIt) {
  const RootSquare root{{0, 0}, 20, 0};
  constexpr std::int64_t kRow = (1 << 18) + (1 << 16);  // of leaves with sides of 2^17
  for (std::int64_t units = 0; units < 8; ++units) {
    const auto low = static_cast<double>(kRow - units);
    const Polygon polygon{"rectangle", {{{3e5, low}, {7e5, low}, {7e5, 7e5}, {3e5, 7e5}}}};
    const Stage stage{Domain(root, polygon)};
    std::uint64_t seen = 0;
    for (VertexId v = 0; v < stage.tree_mesh().mesh().vertices.size(); ++v) {
      const LatticePoint at = stage.tree_mesh().at(v);
      if (at.y != kRow || at.x <= 300000 || at.x >= 700000 || stage.tree_mesh().is_site(v))
        continue;
      ++seen;
      EXPECT_EQ(stage.cut_quads().where(v), units < 4 ? Where::kBoundary : Where::kInside);
      EXPECT_EQ(stage.cut_quads().above(v).empty(), units < 4);
    }
    EXPECT_GT(seen, 0U) << units;
  }
}

/// separation_faults by all pairs of edges, with 5x5 grids by their coordinates.
class SlowFaults {
 public:
  using Corner = std::pair<std::int64_t, std::int64_t>;
  using Fault = std::pair<Corner, std::pair<EdgeId, EdgeId>>;
  explicit SlowFaults(const Stage& stage) : stage_(stage), tree_mesh_(stage.tree_mesh()) {
    for (const Cut& a : stage.cut_quads().cuts())
      for (const Cut& b : stage.cut_quads().cuts())
        if (a.quad == b.quad && a.edge < b.edge && !near_common_vertex(a.quad, a.edge, b.edge) &&
            is_left(a.quad, a.edge, b.edge) && is_left(a.quad, b.edge, a.edge))
          blame(a.quad, a.edge, b.edge);
    of_quads_ = faults_;
    for (VertexId v = 0; v < tree_mesh_.mesh().vertices.size(); ++v) check(v);
  }
  /// Those of (i).
  [[nodiscard]] const std::set<Fault>& of_quads() const { return of_quads_; }
  [[nodiscard]] const std::set<Fault>& faults() const { return faults_; }
  [[nodiscard]] Corner corner(Cell leaf) const {
    const LatticePoint at = tree_mesh_.tree().corner(leaf);
    return {at.x, at.y};
  }

 private:
  [[nodiscard]] Cell leaf_of(VertexId v) const { return tree_mesh_.leaf_of(v); }

  [[nodiscard]] bool in_grid(VertexId v, EdgeId site) const {
    const Quadtree& tree = tree_mesh_.tree();
    const Cell cell = tree_mesh_.cell_of(site);
    const Cell leaf = leaf_of(v);
    const std::int64_t side = std::int64_t{1} << tree.side_bits(cell);
    return tree.side_bits(leaf) == tree.side_bits(cell) &&
           std::abs(tree.corner(leaf).x - tree.corner(cell).x) <= 2 * side &&
           std::abs(tree.corner(leaf).y - tree.corner(cell).y) <= 2 * side;
  }

  [[nodiscard]] bool near_common_vertex(QuadId quad, EdgeId e, EdgeId f) const {
    const auto all_near = [&](EdgeId site) {
      return std::ranges::all_of(tree_mesh_.mesh().quads[quad],
                                 [&](VertexId v) { return in_grid(v, site); });
    };
    return (stage_.domain().next(e) == f && all_near(f)) ||
           (stage_.domain().next(f) == e && all_near(e));
  }

  /// Whether the middle of what `of` has in the quad is on the left of an edge.
  [[nodiscard]] bool is_left(QuadId quad, EdgeId edge, EdgeId of) const {
    const auto part = part_within(stage_, tree_mesh_.mesh().quads[quad], of);
    const Rational middle =
        (std::max(part->first, Rational(0)) + std::min(part->second, Rational(1))) / 2;
    const RationalPoint a = in_units(stage_.domain(), of);
    const RationalPoint b = in_units(stage_.domain(), stage_.domain().next(of));
    return cross_of(in_units(stage_.domain(), edge),
                    in_units(stage_.domain(), stage_.domain().next(edge)),
                    {a.x + middle * (b.x - a.x), a.y + middle * (b.y - a.y)}) > 0;
  }

  void check(VertexId v) {
    const auto above = stage_.cut_quads().above(v);
    if (above.empty()) return;
    bool in_some_grid = false;
    for (EdgeId site = 0; site < stage_.domain().size(); ++site) {
      if (!in_grid(v, site)) continue;
      in_some_grid = true;
      for (const Above& a : above)
        if (a.edge != site && a.edge != stage_.domain().previous(site)) blame_at(v, a.edge, site);
    }
    if (!in_some_grid && above.size() > 1) blame_at(v, above.front().edge, above.back().edge);
  }

  void blame_at(VertexId v, EdgeId e, EdgeId f) {
    for (const QuadId quad : tree_mesh_.quads_at(v))
      if (stage_.cut_quads().is_cut(quad)) blame(quad, e, f);
  }

  void blame(QuadId quad, EdgeId e, EdgeId f) {
    const Quadtree& tree = tree_mesh_.tree();
    int largest = 0;
    for (const VertexId v : tree_mesh_.mesh().quads[quad])
      largest = std::max(largest, tree.side_bits(leaf_of(v)));
    for (const VertexId v : tree_mesh_.mesh().quads[quad])
      if (tree.side_bits(leaf_of(v)) == largest)
        faults_.insert({corner(leaf_of(v)), std::minmax(e, f)});
  }

  const Stage& stage_;
  const TreeMesh& tree_mesh_;
  std::set<Fault> faults_;  ///< the corners of leaves, each with two edges
  std::set<Fault> of_quads_;
};

/// Guarantees 1 to 3.
TEST(SeparationFaults, AgainstAllPairsOfEdges) {
  std::vector<Polygon> polygons = samples();
  for (const char* recipe :
       {"comb:n=40", "gear:n=60", "coast:n=200,seed=2", "growth:n=60", "two-opt:n=40,seed=3"})
    polygons.push_back(normalised(generate_polygon(parse_polygon_recipe(recipe))));
  std::size_t leaves_at_fault = 0;
  std::size_t of_quads = 0;
  for (const Polygon& polygon : polygons) {
    const Stage stage(domain_of(polygon));
    const SlowFaults slow(stage);
    std::set<SlowFaults::Corner> expected;
    for (const auto& [leaf, edges] : slow.faults()) expected.insert(leaf);
    std::set<SlowFaults::Corner> found;
    std::set<SlowFaults::Fault> pairs;
    std::map<SlowFaults::Corner, std::pair<EdgeId, EdgeId>> last;
    for (const SeparationFault& fault :
         separation_faults(stage.domain(), stage.tree_mesh(), stage.cut_quads())) {
      const SlowFaults::Corner leaf = slow.corner(fault.split);
      const std::pair<EdgeId, EdgeId> edges{fault.edge, fault.other};
      pairs.insert({leaf, std::minmax(fault.edge, fault.other)});
      const auto [before, is_first] = last.try_emplace(leaf, edges);
      EXPECT_TRUE(is_first || before->second != edges) << polygon.file;
      before->second = edges;
      found.insert(leaf);
    }
    EXPECT_EQ(found, expected) << polygon.file;
    EXPECT_TRUE(std::ranges::includes(slow.faults(), pairs)) << polygon.file;
    EXPECT_TRUE(std::ranges::includes(pairs, slow.of_quads())) << polygon.file;
    leaves_at_fault += found.size();
    of_quads += slow.of_quads().size();
  }
  EXPECT_GT(leaves_at_fault, 500U);
  EXPECT_GT(of_quads, 10U);
}

TEST(KeptQuads, AlphasCloseWithKOnTheirLeftAndThereIsOneForEachRing) {
  for (const Polygon& polygon : samples()) {
    Stage stage(non_acute_domain_of(polygon));
    stage.separate();
    const Mesh& mesh = stage.tree_mesh().mesh();
    const KeptQuads kept = keep_quads(stage.tree_mesh(), stage.cut_quads());
    std::set<std::pair<VertexId, VertexId>> sides;
    for (QuadId quad = 0; quad < mesh.quads.size(); ++quad) {
      const Quad& q = mesh.quads[quad];
      const bool keep =
          !stage.cut_quads().is_cut(quad) && std::ranges::all_of(q, [&stage](VertexId v) {
            return stage.cut_quads().where(v) == Where::kInside;
          });
      EXPECT_EQ(kept.is_kept[quad], keep);
      if (!keep) continue;
      for (unsigned k = 0; k < 4; ++k) sides.emplace(q[k], q[(k + 1) & 3U]);
    }
    std::set<std::pair<VertexId, VertexId>> boundary;
    for (const auto& [a, b] : sides)
      if (!sides.contains({b, a})) boundary.emplace(a, b);
    std::set<std::pair<VertexId, VertexId>> along;
    std::set<VertexId> met;
    for (const std::vector<VertexId>& alpha : kept.alphas)
      for (std::size_t i = 0; i < alpha.size(); ++i) {
        along.emplace(alpha[i], alpha[(i + 1) % alpha.size()]);
        EXPECT_TRUE(met.insert(alpha[i]).second) << polygon.file;
      }
    EXPECT_EQ(along, boundary) << polygon.file;
    EXPECT_EQ(kept.alphas.size(), polygon.rings.size()) << polygon.file;
  }
}

// --- pieces of the strip -------------------------------------------------------------------------

/// A quad in lattice units, with feet where they exactly are.
bool is_within_bounds(const std::array<RationalPoint, 4>& quad) {
  for (unsigned k = 0; k < 4; ++k)
    if (!within(corner_at<Rational>(quad[k], quad[(k + 1) & 3U], quad[(k + 3) & 3U]), kTheorem13))
      return false;
  return true;
}

RationalPoint exact_foot(const Domain& domain, EdgeId e, std::int64_t foot) {
  const Rational unit = dyadic(1, domain.root().exponent);
  const RationalPoint exact = domain.foot_exact(e, foot);
  return {exact.x / unit, exact.y / unit};
}

TEST(StripPieces, APentagonHasTheSlackItSaysAndKeepsTheBounds) {
  RandomIntegers random(5);
  const Polygon polygon = normalised({"p", {{{0, 0}, {8, 1}, {6, 9}, {-1, 7}}}});
  const Domain domain = domain_of(polygon);
  std::uint64_t meshed = 0;
  for (int round = 0; round < 400; ++round) {
    const auto e = static_cast<EdgeId>(random.below(4));
    const Vector d = domain.direction(e);
    const Vector u = (1 / length(d)) * d;
    const double size = length(d) / 16;
    const auto jitter = [&random, size] {
      return 0.35 * size * static_cast<double>(random.between(-100, 100)) / 100;
    };
    const FinePoint middle = {
        {domain.floor(e).x + std::llround(d.x / 2), domain.floor(e).y + std::llround(d.y / 2)}, {}};
    const auto point = [&](double along, double up) {
      return nearest_lattice_point(middle, along * u + up * turned_left(u));
    };
    const LatticePoint a = point(-size + jitter(), size + jitter());
    const LatticePoint b = point(jitter(), 1.4 * size + jitter());
    const LatticePoint c = point(size + jitter(), size + jitter());
    const std::int64_t fx = domain.foot(e, a, jitter());
    const std::int64_t fy = domain.foot(e, c, jitter());
    const FinePoint x = domain.foot_point(e, fx);
    const FinePoint y = domain.foot_point(e, fy);
    const auto made = mesh_pentagon(domain, e, x, y, a, b, c, kSmallestSlack);
    if (!made) continue;
    ++meshed;
    EXPECT_GT(made->slack, kSmallestSlack);
    EXPECT_LT(domain.along(e, fx), domain.along(e, made->foot));
    EXPECT_LT(domain.along(e, made->foot), domain.along(e, fy));
    const FinePoint z = domain.foot_point(e, made->foot);
    const FinePoint s = on_lattice(made->steiner);
    const double slack =
        std::min({quad_slack(std::array{x, z, s, on_lattice(a)}),
                  quad_slack(std::array{z, y, on_lattice(c), s}),
                  quad_slack(std::array{on_lattice(a), s, on_lattice(c), on_lattice(b)})});
    EXPECT_DOUBLE_EQ(made->slack, slack);
    const RationalPoint ex = exact_foot(domain, e, fx);
    const RationalPoint ey = exact_foot(domain, e, fy);
    const RationalPoint ez = exact_foot(domain, e, made->foot);
    const RationalPoint es = rational(made->steiner);
    EXPECT_TRUE(is_within_bounds({ex, ez, es, rational(a)}));
    EXPECT_TRUE(is_within_bounds({ez, ey, rational(c), es}));
    EXPECT_TRUE(is_within_bounds({rational(a), es, rational(c), rational(b)}));
    // Asked for more than that, it has none.
    EXPECT_FALSE(mesh_pentagon(domain, e, x, y, a, b, c, 0.9));
  }
  EXPECT_GT(meshed, 100U);
}

TEST(StripPieces, AHexagonHasTheSlackItSaysAndKeepsTheBounds) {
  RandomIntegers random(6);
  std::uint64_t meshed = 0;
  for (int round = 0; round < 400; ++round) {
    const auto jittered = [&random](double value) {
      return std::llround(std::ldexp(value, 40)) + random.between(-1, 1) * random.bits(37);
    };
    // Around v, counter-clockwise; the inside is above x, v, y.
    const LatticePoint x{jittered(-1), jittered(0)};
    const LatticePoint v{0, 0};
    const LatticePoint y{jittered(1), jittered(0)};
    const LatticePoint c{jittered(1), jittered(1)};
    const LatticePoint b{jittered(0), jittered(1.5)};
    const LatticePoint a{jittered(-1), jittered(1)};
    const auto made = mesh_hexagon(on_lattice(x), on_lattice(v), on_lattice(y), a, b, c);
    if (!made || made->slack <= kSmallestSlack) continue;
    ++meshed;
    const FinePoint s = on_lattice(made->steiner);
    const double slack =
        std::min({quad_slack(std::array{on_lattice(x), on_lattice(v), s, on_lattice(a)}),
                  quad_slack(std::array{on_lattice(v), on_lattice(y), on_lattice(c), s}),
                  quad_slack(std::array{s, on_lattice(c), on_lattice(b), on_lattice(a)})});
    EXPECT_DOUBLE_EQ(made->slack, slack);
    const RationalPoint es = rational(made->steiner);
    EXPECT_TRUE(is_within_bounds({rational(x), rational(v), es, rational(a)}));
    EXPECT_TRUE(is_within_bounds({rational(v), rational(y), rational(c), es}));
    EXPECT_TRUE(is_within_bounds({es, rational(c), rational(b), rational(a)}));
  }
  EXPECT_GT(meshed, 100U);
}

// --- SizeField -----------------------------------------------------------------------------------

TEST(SizeField, IsTheSmallestOfAllThatIsAskedFor) {
  const Polygon polygon = normalised({"square", {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}}});
  EXPECT_TRUE(SizeField(Sizing{}, polygon).is_free());
  Sizing sizing;
  sizing.largest = 2;
  sizing.sources = {{{4, 4}, {4, 4}, 0.25, 0.5}, {{6, 2}, {7, 2}, 0.125, 0}};
  sizing.boundary_size = 0.5;
  sizing.boundary_growth = 1;
  const SizeField everywhere(sizing, polygon);
  EXPECT_FALSE(everywhere.is_free());
  EXPECT_DOUBLE_EQ(everywhere.size_at({4, 4}), 0.125);  // that of the segment, which has no growth
  sizing.sources.pop_back();
  const SizeField field(sizing, polygon);
  EXPECT_DOUBLE_EQ(field.size_at({4, 4}), 0.25);
  EXPECT_DOUBLE_EQ(field.size_at({5, 4}), 0.75);
  EXPECT_DOUBLE_EQ(field.size_at({6.5, 4}), 1.5);
  EXPECT_DOUBLE_EQ(field.size_at({4, 0}), 0.5);
  EXPECT_DOUBLE_EQ(field.size_at({4, 0.5}), 1);
  EXPECT_DOUBLE_EQ(field.size_at({0.25, 7}), 0.75);
}

}  // namespace
}  // namespace quadbound
