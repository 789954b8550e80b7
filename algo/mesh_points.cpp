// SPDX-License-Identifier: Apache-2.0
#include "algo/mesh_points.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "algo/quadrangulation.hpp"
#include "algo/template_tree.hpp"

namespace quadbound {
namespace {

PointMesh build(const PointSet& points, const PointMeshOptions& options) {
  const PlacedPoints placed = place_root(points.points);
  std::optional<SeparatedTree> separated =
      separate_points(placed, options.refinement, options.budget);
  PointMesh result;
  result.root = placed.root;
  result.counters.splits = separated->tree.blocks().size();
  result.counters.refinement_splits = separated->refinement_splits;
  const std::vector<SiteCells> cells = site_cells(*separated);
  TemplateTree tree(separated->tree);
  separated.reset();  // the largest part of the memory, not needed any more
  result.mesh = quadrangulate(tree, placed.root, options.two_two, result.counters);
  result.mesh.input_vertices = points.points.size();
  const std::vector<WarpSite> sites = warp_sites(cells, tree);
  warp(result.mesh, points.points, sites, options.warping, result.counters);
  for (const WarpSite& site : sites) result.vertex_of_point.push_back(site.centre);
  return result;
}

std::string explain(const TreeBudgetExceeded& exceeded, const Point& where, const Budget& budget) {
  const std::string place =
      fmt::format("near ({}, {}) at level {}", where.x, where.y, exceeded.level);
  switch (exceeded.kind) {
    case RefusalKind::kTooDeep:
      return fmt::format(
          "two points {} are too close for the size of the coordinates: cells would be smaller "
          "than the 2^-60 of the largest that exact coordinates hold; move the set to the origin, "
          "merge the points or mesh them apart",
          place);
    case RefusalKind::kTooManyCells:
      return fmt::format(
          "the budget of {} cells ran out {}; raise --max-cells or thin out close points",
          budget.max_cells, place);
    case RefusalKind::kTooMuchTime:
      return fmt::format("the budget of {} seconds ran out {}; raise --max-seconds",
                         budget.max_seconds, place);
  }
  return {};
}

}  // namespace

PointMeshResult mesh_points(const PointSet& points, const PointMeshOptions& options) {
  try {
    return build(points, options);
  } catch (const TreeBudgetExceeded& exceeded) {
    const int exponent = place_root(points.points).root.exponent;
    const Point where{nearest_double(exceeded.where.x, exponent),
                      nearest_double(exceeded.where.y, exponent)};
    return Refusal{exceeded.kind, where, exceeded.level, explain(exceeded, where, options.budget)};
  }
}

}  // namespace quadbound
