// SPDX-License-Identifier: Apache-2.0
// Families along an axis: x-monotone, orthogonal, grid-aligned, near-grid, comb.
#include <algorithm>

#include "generators/polygon_families.hpp"

namespace quadbound::generators {

/// Both chains go from left to right; holes sit in the middle strip that both keep free.
LatticePolygon make_x_monotone(PolygonMaker& maker) {
  const auto height = [&] { return maker.random.between(kUnit / 16, kUnit); };
  LatticePolygon polygon;
  const std::int64_t below = (maker.n - 2) / 2;
  polygon.outer.push_back({0, 0});
  for (std::int64_t i = 1; i <= below; ++i)
    polygon.outer.push_back({i * 2 * kUnit / (below + 1), -height()});
  polygon.outer.push_back({2 * kUnit, 0});
  const std::int64_t above = maker.n - 2 - below;
  for (std::int64_t i = above; i >= 1; --i)
    polygon.outer.push_back({i * 2 * kUnit / (above + 1), height()});
  polygon.holes = holes_in_row(maker, kUnit / 2, 3 * kUnit / 2, 0, kUnit / 32);
  return polygon;
}

namespace {

/// Columns of random heights on a common base, all coordinates multiples of `grain`.
LatticePolygon columns(PolygonMaker& maker, std::int64_t grain) {
  const std::int64_t count = (maker.n - 2) / 2;
  const std::int64_t step = std::max<std::int64_t>(1, 2 * kUnit / count / grain) * grain;
  LatticePolygon polygon;
  polygon.outer = {{0, 0}, {count * step, 0}};
  std::int64_t previous = 0;
  for (std::int64_t i = count; i-- > 0;) {
    std::int64_t height = previous;
    while (height == previous)
      height = maker.random.between(kUnit / 4 / grain, kUnit / grain) * grain;
    polygon.outer.push_back({(i + 1) * step, height});
    polygon.outer.push_back({i * step, height});
    previous = height;
  }
  polygon.holes = holes_in_row(maker, 0, count * step, kUnit / 8, kUnit / 8);
  return polygon;
}

}  // namespace

LatticePolygon make_orthogonal(PolygonMaker& maker) { return columns(maker, 1); }

LatticePolygon make_grid_aligned(PolygonMaker& maker) {
  return columns(maker, kUnit >> maker.parameter("level"));
}

/// Vertices and edges of a grid-aligned polygon are a grain apart at least where they do not meet:
/// moves of up to a quarter, less than half of that along a diagonal, cannot make them meet.
LatticePolygon make_near_grid(PolygonMaker& maker) {
  const std::int64_t grain = kUnit >> maker.parameter("level");
  const std::int64_t largest = grain >> maker.parameter("amplitude");
  LatticePolygon polygon = columns(maker, grain);
  for (LatticePoint& vertex : polygon.outer) {
    vertex.x += maker.random.between(-largest, largest);
    vertex.y += maker.random.between(-largest, largest);
  }
  return polygon;
}

/// A back with thin teeth: pairs of long edges close to each other.
LatticePolygon make_comb(PolygonMaker& maker) {
  const std::int64_t teeth = maker.n / 4;
  const std::int64_t pitch = kUnit / 4;
  const std::int64_t gap = std::max<std::int64_t>(1, pitch >> maker.parameter("depth"));
  LatticePolygon polygon;
  polygon.outer = {{0, -kUnit / 2}, {teeth * pitch - gap, -kUnit / 2}};
  for (std::int64_t i = teeth; i-- > 0;) {
    polygon.outer.push_back({(i + 1) * pitch - gap, kUnit});
    polygon.outer.push_back({i * pitch, kUnit});
    if (i == 0) break;
    polygon.outer.push_back({i * pitch, 0});
    polygon.outer.push_back({i * pitch - gap, 0});
  }
  polygon.holes = holes_in_row(maker, 0, teeth * pitch - gap, -kUnit / 4, kUnit / 4);
  return polygon;
}

}  // namespace quadbound::generators
