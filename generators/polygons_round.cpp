// SPDX-License-Identifier: Apache-2.0
// Families around a centre: star, regular, gear, annulus, sharp, notch, slit, blob.
#include <algorithm>
#include <array>
#include <cmath>

#include "generators/polygon_families.hpp"
#include "generators/unit_circle.hpp"

namespace quadbound::generators {
namespace {

/// In whole lattice units.
double percent_of_unit(std::int64_t percent) {
  const std::int64_t units = kUnit * percent / 100;
  return static_cast<double>(units);
}

}  // namespace

/// Angles in order, each at random in the first four fifths of its share of the turn.
LatticePolygon make_star(PolygonMaker& maker) {
  const std::int64_t low = maker.parameter("low");
  LatticePolygon polygon;
  for (std::int64_t i = 0; i < maker.n; ++i) {
    const std::int64_t jitter = maker.random.between(0, 799);
    const double radius =
        static_cast<double>(kUnit * maker.random.between(low * 1000, 100'000)) / 100'000;
    polygon.outer.push_back(
        at({0, 0}, radius, direction_of_turn(1000 * i + jitter, 1000 * maker.n)));
  }
  polygon.holes = holes_on_circle(maker, static_cast<double>(kUnit * low) / 400);
  return polygon;
}

LatticePolygon make_regular(PolygonMaker& maker) {
  return {regular({0, 0}, static_cast<double>(kUnit), maker.n, maker.parameter("turn")),
          holes_on_circle(maker, static_cast<double>(kUnit) / 4)};
}

/// Teeth with steep flanks: four vertices each.
LatticePolygon make_gear(PolygonMaker& maker) {
  const double inner = percent_of_unit(maker.parameter("low"));
  LatticePolygon polygon;
  for (std::int64_t i = 0; i < maker.n; ++i) {
    const double radius = i % 4 < 2 ? static_cast<double>(kUnit) : inner;
    polygon.outer.push_back(at({0, 0}, radius, direction_of_turn(i, maker.n)));
  }
  polygon.holes = holes_on_circle(maker, inner / 4);
  return polygon;
}

LatticePolygon make_annulus(PolygonMaker& maker) {
  const double inner = percent_of_unit(maker.parameter("low"));
  return {regular({0, 0}, static_cast<double>(kUnit), maker.n, maker.random.between(0, 63)),
          {regular({0, 0}, inner, maker.n, maker.random.between(0, 63))}};
}

/// Tips between vertices near the centre: 2^-depth of the radius there.
LatticePolygon make_sharp(PolygonMaker& maker) {
  const double inner =
      std::ldexp(static_cast<double>(kUnit), -static_cast<int>(maker.parameter("depth")));
  LatticePolygon polygon;
  for (std::int64_t i = 0; i < maker.n; ++i) {
    const double outer = percent_of_unit(maker.random.between(50, 100));
    polygon.outer.push_back(at({0, 0}, i % 2 == 0 ? outer : inner, direction_of_turn(i, maker.n)));
  }
  polygon.holes = holes_on_circle(maker, inner / 4);
  return polygon;
}

/// A regular polygon with slits cut into its sides: reflex corners near 360 degrees.
LatticePolygon make_notch(PolygonMaker& maker) {
  const std::int64_t sides = maker.n / 4;
  const Point half_side = direction_of_turn(1, 2 * sides);
  // Half as wide as half a side at most.
  const auto widest = static_cast<std::int64_t>(static_cast<double>(kUnit) * half_side.y / 2);
  const std::int64_t width = std::clamp<std::int64_t>(kUnit >> maker.parameter("depth"), 1,
                                                      std::max<std::int64_t>(1, widest));
  LatticePolygon polygon;
  for (std::int64_t i = 0; i < sides; ++i) {
    const Point middle = direction_of_turn(2 * i + 1, 2 * sides);
    const LatticePoint mouth = at({0, 0}, static_cast<double>(kUnit) * 0.98 * half_side.x, middle);
    const LatticePoint aside = at({0, 0}, static_cast<double>(width), {-middle.y, middle.x});
    polygon.outer.push_back(at({0, 0}, static_cast<double>(kUnit), direction_of_turn(i, sides)));
    polygon.outer.push_back({mouth.x - aside.x, mouth.y - aside.y});
    polygon.outer.push_back(at({0, 0}, static_cast<double>(kUnit) / 2, middle));
    polygon.outer.push_back({mouth.x + aside.x, mouth.y + aside.y});
  }
  polygon.holes = holes_on_circle(maker, static_cast<double>(kUnit) / 5);
  return polygon;
}

namespace {

/// Where the slit of a side starts, and how wide it opens.
struct Slit {
  LatticePoint tip;
  std::array<LatticePoint, 2> mouth;  ///< on the side, in the order of the ring
};

/// Where the ray from a tip meets the line of a side. Requires: the ray points to that side.
LatticePoint on_side(LatticePoint tip, Point ray, Point outward, double inradius) {
  const double height =
      inradius - (static_cast<double>(tip.x) * outward.x + static_cast<double>(tip.y) * outward.y);
  return at(tip, height / (ray.x * outward.x + ray.y * outward.y), ray);
}

/// A slit in the wedge between the centre and side i of `sides`: both its ends stay in the middle
/// half of the wedge, so that no slit comes near another.
Slit slit_in_side(PolygonMaker& maker, std::int64_t i, std::int64_t sides) {
  const Point half_wedge = direction_of_turn(1, 2 * sides);
  const Point outward = direction_of_turn(2 * i + 1, 2 * sides);
  // Half of what the corner falls short of 360 degrees.
  const Point opening = direction_of_turn(36'000 - maker.parameter("reflex"), 72'000);
  const double inradius = static_cast<double>(kUnit) * half_wedge.x;
  // Twice as long, the slit would be as wide as its side.
  const double longest = static_cast<double>(kUnit) * half_wedge.y * opening.x / opening.y / 2;
  const double wanted = inradius * static_cast<double>(maker.random.between(20, 65)) / 100;
  const std::int64_t aside = maker.random.between(-250, 250);
  const LatticePoint tip = at({0, 0}, inradius - std::min(wanted, longest),
                              direction_of_turn(1000 * (2 * i + 1) + aside, 2000 * sides));
  const Point axis{inradius * outward.x - static_cast<double>(tip.x),
                   inradius * outward.y - static_cast<double>(tip.y)};
  const auto turned = [&](double sine) {
    return Point{axis.x * opening.x - axis.y * sine, axis.x * sine + axis.y * opening.x};
  };
  return {tip,
          {on_side(tip, turned(-opening.y), outward, inradius),
           on_side(tip, turned(opening.y), outward, inradius)}};
}

}  // namespace

/// A regular polygon, some of its sides with a slit of the given reflex angle.
LatticePolygon make_slit(PolygonMaker& maker) {
  const std::int64_t slits = maker.parameter("slits");
  const std::int64_t sides = maker.n - 3 * slits;
  maker.require(sides >= 5 && sides >= slits,
                "n must be 4 for each slit at least, and 5 + 3 slits");
  LatticePolygon polygon;
  for (std::int64_t i = 0; i < sides; ++i) {
    polygon.outer.push_back(at({0, 0}, static_cast<double>(kUnit), direction_of_turn(i, sides)));
    if (i * slits / sides == (i + 1) * slits / sides) continue;
    const Slit slit = slit_in_side(maker, i, sides);
    polygon.outer.push_back(slit.mouth[0]);
    polygon.outer.push_back(slit.tip);
    polygon.outer.push_back(slit.mouth[1]);
  }
  polygon.holes = holes_on_circle(maker, static_cast<double>(kUnit) / 5);
  return polygon;
}

namespace {

/// One term of a blob's radius: swing * cos(turns * angle + phase).
struct Wave {
  std::int64_t turns;
  std::int64_t phase;  ///< in thousandths of a turn
  double swing;
};

/// Waves whose swings add up to `swing` at most; the faster, the smaller.
std::vector<Wave> random_waves(PolygonMaker& maker, double swing) {
  std::vector<Wave> waves;
  double sum = 0;
  for (std::int64_t k = 1; k <= maker.parameter("waves"); ++k) {
    const auto share = static_cast<double>(maker.random.between(200, 1000));
    waves.push_back({k, maker.random.between(0, 999), share / static_cast<double>(k)});
    sum += waves.back().swing;
  }
  for (Wave& wave : waves) wave.swing *= swing / sum;
  return waves;
}

/// n vertices at equal angles, their distance from the centre 1 + the sum of the waves, scaled so
/// that it is 1 at most.
LatticeRing wavy_ring(const std::vector<Wave>& waves, std::int64_t n) {
  double largest = 1;
  for (const Wave& wave : waves) largest += wave.swing;
  LatticeRing ring;
  for (std::int64_t i = 0; i < n; ++i) {
    double radius = 1;
    for (const Wave& wave : waves)
      radius +=
          wave.swing *
          direction_of_turn((1000 * wave.turns * i + wave.phase * n) % (1000 * n), 1000 * n).x;
    ring.push_back(
        at({0, 0}, static_cast<double>(kUnit) * radius / largest, direction_of_turn(i, n)));
  }
  return ring;
}

}  // namespace

/// Few vertices cannot follow fast waves without sharp corners: the waves then get lower.
LatticePolygon make_blob(PolygonMaker& maker) {
  const double swing = static_cast<double>(maker.parameter("swing")) / 100;
  std::vector<Wave> waves = random_waves(maker, swing);
  LatticeRing ring = wavy_ring(waves, maker.n);
  for (int halvings = 0; halvings < 20 && !non_acute(ring); ++halvings) {
    for (Wave& wave : waves) wave.swing /= 2;
    ring = wavy_ring(waves, maker.n);
  }
  maker.require(non_acute(ring), "the lattice is too coarse for a non-acute blob of this size");
  const double smallest = (1 - swing) / (1 + swing);
  return {ring, holes_on_circle(maker, static_cast<double>(kUnit) * smallest / 4)};
}

}  // namespace quadbound::generators
