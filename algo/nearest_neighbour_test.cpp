// SPDX-License-Identifier: Apache-2.0
#include "algo/nearest_neighbour.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace quadbound {
namespace {

UInt128 square(std::int64_t a) { return UInt128(a < 0 ? -a : a) * UInt128(a < 0 ? -a : a); }

UInt128 brute_force(const std::vector<LatticePoint>& points, std::size_t query) {
  UInt128 best = ~UInt128{0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == query) continue;
    best = std::min(best,
                    square(points[i].x - points[query].x) + square(points[i].y - points[query].y));
  }
  return best;
}

std::vector<LatticePoint> random_points(std::mt19937_64& engine, std::size_t count, int bits) {
  const auto coordinate = [&] {
    return static_cast<std::int64_t>(engine() >> (64 - bits)) - (std::int64_t{1} << (bits - 1));
  };
  std::vector<LatticePoint> points;
  while (points.size() < count) points.push_back({coordinate(), coordinate()});
  return points;
}

TEST(NearestNeighbour, AgreesWithBruteForce) {
  std::mt19937_64 engine(1);
  for (const int bits : {4, 12, 61}) {
    for (const std::size_t count : {1U, 2U, 9U, 100U, 400U}) {
      const auto points = random_points(engine, count, bits);
      const auto squares = nearest_neighbour_squares(points, std::vector<bool>(count, false));
      for (std::size_t i = 0; i < count; ++i)
        ASSERT_EQ(squares[i], brute_force(points, i)) << bits << ' ' << i;
    }
  }
}

TEST(NearestNeighbour, NeverMoreThanTheDistanceOfWhatRoundedPointsStandFor) {
  // Points on a lattice 16 times finer, rounded down.
  std::mt19937_64 engine(2);
  const auto fine = random_points(engine, 300, 14);
  std::vector<LatticePoint> floors;
  std::vector<bool> rounded;
  for (const LatticePoint p : fine) {
    floors.push_back({p.x >> 4, p.y >> 4});
    rounded.push_back(p.x % 16 != 0 || p.y % 16 != 0);
  }
  const auto squares = nearest_neighbour_squares(floors, rounded);
  for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_LE(squares[i] * 256, brute_force(fine, i));
}

}  // namespace
}  // namespace quadbound
