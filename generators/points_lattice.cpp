// SPDX-License-Identifier: Apache-2.0
// Families on a lattice: grid, grid-perturbed, lattice-corners.
#include "generators/point_families.hpp"

namespace quadbound {
namespace {

/// The smallest integer whose square is at least n.
std::uint64_t side_of_square(std::uint64_t n) {
  std::uint64_t side = 1;
  while (side * side < n) ++side;
  return side;
}

/// The first n points of the rows, in random order.
std::vector<LatticePoint> shuffled_rows(PointMaker& maker, std::uint64_t columns) {
  std::vector<LatticePoint> sites;
  sites.reserve(static_cast<std::size_t>(maker.recipe.n));
  for (std::uint64_t i = 0; i < maker.recipe.n; ++i)
    sites.push_back(
        {static_cast<std::int64_t>(i % columns), static_cast<std::int64_t>(i / columns)});
  maker.random.shuffle(sites);
  return sites;
}

/// A coordinate on the border of a cell of the given level: k / 2^level, 0 <= k <= 2^level.
double on_border(RandomIntegers& random, int level) {
  return scaled(random.between(0, std::int64_t{1} << level), -level);
}

}  // namespace

void make_grid(PointMaker& maker) {
  const auto columns = static_cast<std::uint64_t>(maker.parameter("columns"));
  for (const LatticePoint& site :
       shuffled_rows(maker, columns == 0 ? side_of_square(maker.recipe.n) : columns))
    maker.points.add({static_cast<double>(site.x), static_cast<double>(site.y)});
}

void make_grid_perturbed(PointMaker& maker) {
  // In units of 2^-32: a coordinate of at most 10^4 plus its move needs 46 bits. Moves of at most
  // a quarter keep the points apart.
  constexpr int kUnit = -32;
  const std::int64_t largest = std::int64_t{1} << (-kUnit - maker.small_parameter("amplitude"));
  for (const LatticePoint& site : shuffled_rows(maker, side_of_square(maker.recipe.n))) {
    const std::int64_t dx = maker.random.between(-largest, largest);
    const std::int64_t dy = maker.random.between(-largest, largest);
    maker.points.add({scaled(site.x * (std::int64_t{1} << -kUnit) + dx, kUnit),
                      scaled(site.y * (std::int64_t{1} << -kUnit) + dy, kUnit)});
  }
}

void make_lattice_corners(PointMaker& maker) {
  const int finest = maker.small_parameter("level");
  maker.require_sites(std::ldexp(1.0, 2 * finest));
  const std::int64_t borders = maker.parameter("borders");
  while (!maker.points.full()) {
    // Half of the corners are drawn from any level: the corners of large cells meet the most
    // levels of the tree. Drawing always so would hardly ever find the last free sites.
    const bool any_level = maker.random.bits(1) == 0;
    const int level = any_level ? static_cast<int>(maker.random.between(1, finest)) : finest;
    const bool border_only = maker.random.chance(borders);
    const double x = on_border(maker.random, level);
    const double y = on_border(maker.random, border_only ? level + 20 : level);
    maker.points.add(maker.random.bits(1) == 0 ? Point{x, y} : Point{y, x});
  }
}

}  // namespace quadbound
