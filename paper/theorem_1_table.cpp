// SPDX-License-Identifier: Apache-2.0
#include "paper/theorem_1_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "generators/points.hpp"

namespace quadbound {
namespace {

constexpr std::uint64_t kLeavesPerTree = 400;
constexpr std::uint64_t kPointsPerSet = 40;

bool is_of(const Configuration& c, Theorem1Table::Of which, std::string_view construction) {
  const bool warped = which == Theorem1Table::Of::kWarped;
  if (which != Theorem1Table::Of::kAll && c.moves() != warped) return false;
  return construction.empty() ||
         construction == kConstructionNames[static_cast<std::size_t>(c.construction)];
}

std::string quad_name(const Configuration& c) { return c.name + (c.moves() ? ", warped" : ""); }

}  // namespace

bool smaller_angle(const Corner<Rational>& a, const Corner<Rational>& b) {
  return a.dot * b.cross > b.dot * a.cross;  // cot falls; both cross products are positive
}

double degrees(const Corner<Rational>& corner) {
  const Rational scale = abs(corner.cross) + abs(corner.dot);
  return std::atan2(nearest_double(Rational(corner.cross / scale)),
                    nearest_double(Rational(corner.dot / scale))) *
         180 / std::numbers::pi;
}

bool Theorem1Table::holds() const {
  bool good = census.unlisted() == 0;
  for (std::size_t i = 0; i < census.configurations().size(); ++i)
    good = good && census.configurations()[i].proved && (census.count(i) > 0 || trees == 0);
  return good;
}

Corner<Rational> Theorem1Table::smallest(Of which, std::string_view construction) const {
  std::optional<Corner<Rational>> best;
  for (const Configuration& c : census.configurations())
    if (is_of(c, which, construction) && (!best || smaller_angle(c.smallest, *best)))
      best = c.smallest;
  return best.value();
}

Corner<Rational> Theorem1Table::largest(Of which, std::string_view construction) const {
  std::optional<Corner<Rational>> best;
  for (const Configuration& c : census.configurations())
    if (is_of(c, which, construction) && (!best || smaller_angle(*best, c.largest)))
      best = c.largest;
  return best.value();
}

Theorem1Table make_theorem_1_table(std::uint64_t trees, Watcher& watcher) {
  Theorem1Table table;
  table.trees = trees;
  watcher.stage("census of configurations");
  for (std::uint64_t seed = 0; seed < trees; ++seed) {
    watcher.steps(seed, trees);
    table.census.add_tree(random_balanced_tree(seed, kLeavesPerTree));
    const auto recipe = fmt::format("uniform:n={},seed={}", kPointsPerSet, seed);
    table.census.add_points(
        generate_points(parse_point_recipe(recipe)).points,
        seed % 2 == 0 ? GridRefinement::kSixBySix : GridRefinement::kFiveByFive);
  }
  return table;
}

std::string to_text(const Theorem1Table& table) {
  const ConfigurationCensus& census = table.census;
  std::string text =
      "thm-1: every angle is in [arctan(1/2), 180 - arctan(1/2)] = [26.57, 153.43] degrees\n\n";
  constexpr const char* kRow = "{:<18} {:<28} {:<12} {:<22} {:<10} {}\n";
  text += fmt::format(kRow, "construction", "quad", "smallest", "largest", "verdict", "met");
  for (std::size_t i = 0; i < census.configurations().size(); ++i) {
    const Configuration& c = census.configurations()[i];
    text += fmt::format(kRow, kConstructionNames[static_cast<std::size_t>(c.construction)],
                        quad_name(c), arctangent_text(c.smallest), arctangent_text(c.largest),
                        c.proved ? "proved" : "BROKEN", census.count(i));
  }
  return text +
         fmt::format(
             "\nWarped quads: the worst of the closed range of positions; proved for all of them.\n"
             "Census: {} quads of {} random trees and {} point sets, {} of them of a shape not "
             "listed.\n",
             census.quads(), table.trees, table.trees, census.unlisted());
}

}  // namespace quadbound
