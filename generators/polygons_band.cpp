// SPDX-License-Identifier: Apache-2.0
// Bands wound around themselves: spiral-band, obtuse-spiral.
#include <array>
#include <utility>

#include "generators/polygon_families.hpp"
#include "generators/unit_circle.hpp"

namespace quadbound::generators {

/// A right-angled band wound around itself, all coordinates multiples of its width.
LatticePolygon make_spiral_band(PolygonMaker& maker) {
  const std::int64_t arms = (maker.n - 2) / 2;
  constexpr std::array<LatticePoint, 4> kAhead{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  LatticeRing centre_line{{0, 0}};
  for (std::int64_t i = 0; i < arms; ++i) {
    const LatticePoint step = kAhead[static_cast<std::size_t>(i % 4)];
    const std::int64_t length = (i / 2 + 1) * 2;
    centre_line.push_back(
        {centre_line.back().x + step.x * length, centre_line.back().y + step.y * length});
  }
  // The band is one unit wide; the gaps between its turns are too. Offsets double to stay integers.
  LatticeRing right;
  LatticeRing left;
  for (std::size_t i = 0; i < centre_line.size(); ++i) {
    const LatticePoint in = kAhead[(i + 3) % 4];
    const LatticePoint out = kAhead[i % 4];
    const bool first = i == 0;
    const bool last = i + 1 == centre_line.size();
    // Right of a direction (x, y) is (y, -x); at a bend the two offsets add up.
    const LatticePoint offset{(first ? 0 : in.y) + (last ? 0 : out.y),
                              -((first ? 0 : in.x) + (last ? 0 : out.x))};
    right.push_back({2 * centre_line[i].x + offset.x, 2 * centre_line[i].y + offset.y});
    left.push_back({2 * centre_line[i].x - offset.x, 2 * centre_line[i].y - offset.y});
  }
  LatticePolygon polygon{right, {}};
  polygon.outer.insert(polygon.outer.end(), left.rbegin(), left.rend());
  for (LatticePoint& p : polygon.outer) p = {p.x * kUnit / 16, p.y * kUnit / 16};
  return polygon;
}

namespace {

/// The bends of a band wound around the origin, and how wide it is.
struct Winding {
  std::int64_t bends;
  std::int64_t sides;  ///< bends in a turn
  double first;        ///< the distance of bend 0 from the centre, in turns of the band
  [[nodiscard]] double pitch() const {
    const double turns = static_cast<double>(bends) / static_cast<double>(sides);
    return static_cast<double>(kUnit) / (first + turns + 0.5);
  }
  [[nodiscard]] double half_width() const { return pitch() / 4; }
  /// A place of bend i, `across` half widths outside of the middle and `ahead` before it.
  [[nodiscard]] LatticePoint place(std::int64_t i, double across, double ahead = 0) const {
    const double turns = first + static_cast<double>(i) / static_cast<double>(sides);
    const double radius = pitch() * turns + across * half_width();
    const Point outward = direction_of_turn(i % sides, sides);
    const double aside = ahead * half_width();
    return rounded(radius * outward.x - aside * outward.y, radius * outward.y + aside * outward.x);
  }
};

/// Both ends are blunt, as a cut straight across would make an acute corner: one has a vertex more
/// on its nose, the other one or two, whatever makes the number wanted.
LatticeRing wound(const Winding& winding, bool two_on_nose) {
  LatticeRing ring;
  const std::int64_t last = winding.bends - 1;
  for (std::int64_t i = 0; i <= last; ++i) ring.push_back(winding.place(i, 1));
  if (two_on_nose) {
    ring.push_back(winding.place(last, 0.4, 0.7));
    ring.push_back(winding.place(last, -0.4, 0.7));
  } else {
    ring.push_back(winding.place(last, 0, 0.7));
  }
  for (std::int64_t i = last; i >= 0; --i) ring.push_back(winding.place(i, -1));
  ring.push_back(winding.place(0, 0, -0.7));
  return ring;
}

}  // namespace

/// Like the spiral of 33 edges of the paper's Figure 49. The tighter it starts, the sharper are the
/// corners there: the hole in the middle grows until no angle is acute.
LatticePolygon make_obtuse_spiral(PolygonMaker& maker) {
  const bool odd = maker.n % 2 != 0;
  Winding winding{(maker.n - (odd ? 3 : 2)) / 2, maker.parameter("sides"), 1};
  LatticeRing ring = wound(winding, odd);
  while (!non_acute(ring) && winding.first < 16) {
    winding.first *= 1.25;
    ring = wound(winding, odd);
  }
  maker.require(non_acute(ring), "the lattice is too coarse for a non-acute spiral of this size");
  LatticePolygon polygon{std::move(ring), {}};
  const std::int64_t holes = maker.parameter("holes");
  maker.require(holes <= winding.bends, "no more holes than bends fit into a spiral");
  for (std::int64_t i = 0; i < holes; ++i)
    polygon.holes.push_back(
        regular(winding.place(winding.bends * i / holes, 0), winding.half_width() / 3, 6));
  return polygon;
}

}  // namespace quadbound::generators
