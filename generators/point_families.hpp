// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the families of point sets share; private to generators/.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "generators/random.hpp"
#include "generators/recipe.hpp"
#include "model/exact.hpp"

namespace quadbound {

/// mantissa * 2^exponent; exact, as no family leaves 53 bits or comes near the ends of the range.
inline double scaled(std::int64_t mantissa, int exponent) {
  return std::ldexp(static_cast<double>(mantissa), exponent);
}

/// Collects the points of a recipe in the order they come, each once.
class DistinctPoints {
 public:
  /// The recipe must outlive the collector.
  explicit DistinctPoints(const Recipe& recipe)
      : recipe_(recipe), wanted_(static_cast<std::size_t>(recipe.n)) {}

  [[nodiscard]] bool full() const { return points_.size() == wanted_; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }

  /// Whether the point was new. Requires: !full().
  /// Errors: RecipeError when so few of the offers were new that the family must be exhausted.
  bool add(Point point);

  std::vector<Point> take() { return std::move(points_); }

 private:
  struct Hash {
    std::size_t operator()(const Point& point) const;
  };

  const Recipe& recipe_;
  std::size_t wanted_;
  std::size_t offers_ = 0;
  std::vector<Point> points_;
  std::unordered_set<Point, Hash> seen_;
};

/// A recipe at work: its parameters by name and its random integers.
struct PointMaker {
  explicit PointMaker(const Recipe& completed_recipe)
      : recipe(completed_recipe), random(completed_recipe.seed), points(completed_recipe) {}

  [[nodiscard]] std::int64_t parameter(const char* name) const {
    return recipe.parameters.at(name);
  }
  [[nodiscard]] int small_parameter(const char* name) const {
    return static_cast<int>(parameter(name));
  }
  /// Errors: RecipeError unless twice n fits into the number of sites, so that drawing sites at
  /// random until n are distinct stays linear.
  void require_sites(double sites) const;

  const Recipe& recipe;
  RandomIntegers random;
  DistinctPoints points;
};

// Each fills maker.points; what it makes is said in the table of points.cpp.
void make_uniform(PointMaker& maker);
void make_clustered(PointMaker& maker);
void make_near_duplicate(PointMaker& maker);
void make_grid(PointMaker& maker);
void make_grid_perturbed(PointMaker& maker);
void make_lattice_corners(PointMaker& maker);
void make_line(PointMaker& maker);
void make_circle(PointMaker& maker);
void make_spiral(PointMaker& maker);
void make_exponential(PointMaker& maker);

}  // namespace quadbound
