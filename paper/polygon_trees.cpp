// SPDX-License-Identifier: Apache-2.0
#include "paper/polygon_trees.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "algo/domain.hpp"
#include "algo/edge_cells.hpp"
#include "algo/separation.hpp"
#include "generators/polygons.hpp"
#include "model/errors.hpp"
#include "model/validate.hpp"

namespace quadbound {
namespace {

/// The middle quarter of the root's side, where random lines go too (cut_tree.hpp).
constexpr std::int64_t kExtent = kCutTreeSide / 4;
/// Differences of coordinates are multiples of it, so that those of an edge, divided by it, are
/// within what a CutLine holds.
constexpr std::int64_t kStep = kExtent / CutLine::kSteepest;

/// All families of generators/ that need no fonts.
constexpr std::array<std::string_view, 24> kFamilies{
    "star",         "regular",   "gear",          "annulus",    "sharp",     "notch",
    "slit",         "blob",      "x-monotone",    "orthogonal", "near-grid", "comb",
    "spiral-band",  "collinear", "obtuse-spiral", "slopes",     "two-opt",   "space-partition",
    "grid-aligned", "growth",    "coast",         "koch",       "needle",    "clusters"};
/// Vertices: the families ask for multiples of 3 and 4, and koch is complete.
constexpr int kVertices = 48;

/// In multiples of kStep.
struct Rounding {
  Point low;
  double unit = 1;

  [[nodiscard]] Point operator()(const Point& p) const {
    return {std::round((p.x - low.x) / unit), std::round((p.y - low.y) / unit)};
  }
};

Rounding rounding_of(const Polygon& polygon) {
  const Ring& outer = polygon.rings.front();
  const auto [left, right] = std::minmax_element(
      outer.begin(), outer.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  const auto [bottom, top] = std::minmax_element(
      outer.begin(), outer.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
  const double extent = std::max(right->x - left->x, top->y - bottom->y);
  return {{left->x, bottom->y}, extent * kStep / kExtent};
}

Polygon rounded(const Polygon& polygon) {
  const Rounding round = rounding_of(polygon);
  Polygon result{polygon.file, {}};
  for (const Ring& ring : polygon.rings) {
    Ring& made = result.rings.emplace_back();
    for (const Point& p : ring) made.push_back(round(p));
  }
  return result;
}

LatticePoint placed(const Point& p, int turns) {
  LatticePoint at{3 * (kCutTreeSide / 8) + kStep * static_cast<std::int64_t>(p.x),
                  3 * (kCutTreeSide / 8) + kStep * static_cast<std::int64_t>(p.y)};
  for (int i = 0; i < turns; ++i) at = {kCutTreeSide - at.y, at.x};
  return at;
}

std::optional<CutLine> line_through(LatticePoint from, LatticePoint to) {
  const CutLine line{from, (to.x - from.x) / kStep, (to.y - from.y) / kStep};
  if (line.dx <= 0 || std::abs(line.dy) > line.dx) return std::nullopt;
  return line;
}

Quadtree separated_tree(const std::vector<LatticePoint>& vertices, const Domain& domain) {
  Separation separation({domain.root(), vertices, std::vector<bool>(vertices.size())}, Budget{});
  separation.apply_conditions();
  separation.refine_five_by_five();
  for (auto large = leaves_too_large(domain, separation.tree(), {domain, separation.tree()});
       !large.empty();
       large = leaves_too_large(domain, separation.tree(), {domain, separation.tree()}))
    separation.refine(large);
  return std::move(separation).take_tree();
}

}  // namespace

std::optional<PolygonTree> tree_of_polygon(const Polygon& polygon, int turns) {
  const Polygon coarse = rounded(polygon);
  std::vector<LatticePoint> vertices;
  std::vector<CutLine> lines;
  std::vector<std::vector<RationalPoint>> rings;
  for (const Ring& ring : coarse.rings) {
    auto& exact = rings.emplace_back();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      vertices.push_back(placed(ring[i], turns));
      exact.push_back({Rational(vertices.back().x), Rational(vertices.back().y)});
      if (const auto line =
              line_through(vertices.back(), placed(ring[(i + 1) % ring.size()], turns)))
        lines.push_back(*line);
    }
  }
  try {
    validate(coarse);
    const Domain domain({{0, 0}, kCutTreeBits, 0}, rings);
    Quadtree tree = separated_tree(vertices, domain);
    return PolygonTree{std::move(tree), std::move(vertices), std::move(lines)};
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const TreeBudgetExceeded&) {
    return std::nullopt;
  }
}

PolygonTreesAudit audit_polygon_trees(std::uint64_t count, const std::vector<Polygon>& more,
                                      Watcher& watcher) {
  PolygonTreesAudit result;
  const std::uint64_t total = count + more.size();
  const auto look_at = [&](const Polygon& polygon) {
    watcher.steps(result.polygons++, total);
    for (int turns = 0; turns < 4; ++turns) {
      auto made = tree_of_polygon(polygon, turns);
      if (!made) {
        ++result.refused;
        return;
      }
      audit_tree(CutTree(std::move(made->tree), TwoTwoVariant::kExact), TwoTwoVariant::kExact,
                 made->lines, result.audit);
    }
  };
  for (std::uint64_t i = 0; i < count; ++i)
    look_at(generate_polygon(parse_polygon_recipe(fmt::format(
        "{}:n={},seed={}", kFamilies[i % kFamilies.size()], kVertices, 1 + i / kFamilies.size()))));
  for (const Polygon& polygon : more) look_at(polygon);
  return result;
}

}  // namespace quadbound
