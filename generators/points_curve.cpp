// SPDX-License-Identifier: Apache-2.0
// Families along a curve: line, circle, spiral.
//
// Directions come from the rational parametrisation ((1 - t^2) / (1 + t^2), 2 t / (1 + t^2)) of
// the circle, as the sines of two libraries may differ in the last place.
#include <fmt/core.h>

#include "generators/point_families.hpp"

namespace quadbound {
namespace {

/// Exact up to the one rounding of each division where t has at most 26 bits.
Point direction(double t) {
  const double square = t * t;
  return {(1.0 - square) / (1.0 + square), 2.0 * t / (1.0 + square)};
}

Point quarter_turns(Point point, std::uint64_t count) {
  for (std::uint64_t i = 0; i < count; ++i) point = {-point.y, point.x};
  return point;
}

/// The point (a x) (b x) ... multiplied as complex numbers.
Point turned(const Point& a, const Point& b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

constexpr int kTurnBits = 26;

}  // namespace

void make_line(PointMaker& maker) {
  const std::int64_t dx = maker.parameter("dx");
  const std::int64_t dy = maker.parameter("dy");
  if (dx == 0 && dy == 0)
    throw RecipeError(fmt::format("{}: dx and dy must not both be 0", to_text(maker.recipe)));
  // 32 bits of t times 21 of the direction: the products are exact, the points exactly collinear.
  while (!maker.points.full()) {
    const std::int64_t t = maker.random.bits(32);
    maker.points.add({scaled(t * dx, -32), scaled(t * dy, -32)});
  }
}

void make_circle(PointMaker& maker) {
  // The parameters of a quarter are cut into as many strata as it gets points: no two are equal.
  const std::uint64_t strata = (maker.recipe.n + 3) / 4;
  const std::uint64_t width = (std::uint64_t{1} << kTurnBits) / strata;
  const bool even = maker.parameter("even") == 1;
  for (std::uint64_t i = 0; i < maker.recipe.n; ++i) {
    const std::uint64_t within = even ? 0 : maker.random.below(width);
    const auto t = static_cast<std::int64_t>(i / 4 * width + within);
    maker.points.add(quarter_turns(direction(scaled(t, -kTurnBits)), i % 4));
  }
}

void make_spiral(PointMaker& maker) {
  // turned() drifts from length one by at most a few roundings a point: far less than the growth
  // of the radius, so radii stay apart.
  const Point step = direction(1.0 / static_cast<double>(maker.parameter("turn")));
  const std::int64_t start = maker.random.bits(kTurnBits);
  Point heading = quarter_turns(direction(scaled(start, -kTurnBits)), maker.random.below(4));
  for (std::uint64_t i = 0; i < maker.recipe.n; ++i) {
    // The radius in units of a 256th of the mean gap, with the last third of the gap at random.
    const double radius = static_cast<double>(256 * (i + 1) + maker.random.below(86));
    maker.points.add({radius * heading.x, radius * heading.y});
    heading = turned(heading, step);
  }
}

}  // namespace quadbound
