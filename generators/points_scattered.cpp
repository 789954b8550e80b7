// SPDX-License-Identifier: Apache-2.0
// Families without structure: uniform, clustered, near-duplicate, exponential.
#include <bit>

#include "generators/point_families.hpp"

namespace quadbound {
namespace {

constexpr int kUnitBits = 53;

/// Bell-shaped on (-2^bits, 2^bits): the sum of four uniform integers. Requires: bits >= 2.
std::int64_t bell(RandomIntegers& random, int bits) {
  const std::int64_t largest = (std::int64_t{1} << (bits - 2)) - 1;
  std::int64_t sum = 0;
  for (int i = 0; i < 4; ++i) sum += random.between(-largest, largest);
  return sum;
}

/// The double `count` units in the last place above a positive one.
double units_above(double value, std::int64_t count) {
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(value) + count);
}

}  // namespace

void make_uniform(PointMaker& maker) {
  const int bits = maker.small_parameter("bits");
  maker.require_sites(std::ldexp(1.0, 2 * bits));
  while (!maker.points.full()) {
    const double x = scaled(maker.random.bits(bits), -bits);
    const double y = scaled(maker.random.bits(bits), -bits);
    maker.points.add({x, y});
  }
}

void make_clustered(PointMaker& maker) {
  const int bits = kUnitBits - maker.small_parameter("spread");
  maker.require_sites(std::ldexp(static_cast<double>(maker.parameter("clusters")), 2 * bits));
  std::vector<LatticePoint> centres(static_cast<std::size_t>(maker.parameter("clusters")));
  for (LatticePoint& centre : centres) {
    // The middle half of the unit square: with an offset below 1/4 nothing leaves it.
    const std::int64_t quarter = std::int64_t{1} << (kUnitBits - 2);
    centre.x = quarter + maker.random.bits(kUnitBits - 1);
    centre.y = quarter + maker.random.bits(kUnitBits - 1);
  }
  while (!maker.points.full()) {
    const LatticePoint& centre = centres[maker.random.below(centres.size())];
    const std::int64_t x = centre.x + bell(maker.random, bits);
    const std::int64_t y = centre.y + bell(maker.random, bits);
    maker.points.add({scaled(x, -kUnitBits), scaled(y, -kUnitBits)});
  }
}

void make_near_duplicate(PointMaker& maker) {
  const double offset = static_cast<double>(maker.parameter("offset"));
  const std::int64_t ulps = maker.parameter("ulps");
  const auto share = static_cast<std::uint64_t>(maker.parameter("share"));
  std::uint64_t pairs_left = maker.recipe.n * share / 200;
  while (!maker.points.full()) {
    // Odd, hence positive: the unit of zero would be the smallest double there is. 52 bits, so
    // that adding the offset is exact.
    const Point point{offset + scaled(maker.random.bits(52) | 1, -52),
                      offset + scaled(maker.random.bits(52) | 1, -52)};
    if (!maker.points.add(point) || pairs_left == 0 || maker.points.full()) continue;
    const std::int64_t direction = maker.random.between(1, 3);
    const Point partner{direction != 2 ? units_above(point.x, ulps) : point.x,
                        direction != 1 ? units_above(point.y, ulps) : point.y};
    if (maker.points.add(partner)) --pairs_left;
  }
}

void make_exponential(PointMaker& maker) {
  const int bits = maker.small_parameter("bits");
  const auto octaves = static_cast<std::size_t>(maker.parameter("octaves"));
  maker.require_sites(std::ldexp(3.0 * static_cast<double>(octaves), 2 * bits - 2));
  while (!maker.points.full()) {
    const int exponent = -static_cast<int>(maker.points.size() % octaves) - bits;
    // The larger coordinate in [1/2, 1) of the scale, the other anywhere below one.
    const std::int64_t top = std::int64_t{1} << (bits - 1);
    const double major = scaled(maker.random.between(top, 2 * top - 1), exponent);
    const double minor = scaled(maker.random.bits(bits), exponent);
    maker.points.add(maker.random.bits(1) == 0 ? Point{major, minor} : Point{minor, major});
  }
}

}  // namespace quadbound
