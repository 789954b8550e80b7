// SPDX-License-Identifier: Apache-2.0
// Chains of special edges: collinear, slopes.
#include <algorithm>
#include <array>
#include <cstdlib>

#include "generators/polygon_families.hpp"
#include "generators/unit_circle.hpp"

namespace quadbound::generators {
namespace {

/// A side of a collinear polygon is a multiple of 2^kSideBits, so that this many of its points less
/// one are on the lattice.
constexpr int kSideBits = 14;
constexpr std::int64_t kPieces = std::int64_t{1} << kSideBits;

/// The corners of a star, multiples of 2^kSideBits. Rounding so coarse can spoil it: the centre
/// must see each side from the left.
LatticeRing coarse_star(PolygonMaker& maker) {
  const std::int64_t corners = maker.parameter("corners");
  constexpr double kRadius = static_cast<double>(kUnit) / kPieces;
  LatticeRing ring;
  const auto seen_whole = [&ring] {
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (turn({0, 0}, ring[i], ring[(i + 1) % ring.size()]) <= 0) return false;
    return true;
  };
  for (int tries = 0; tries < 1000; ++tries) {
    ring.clear();
    for (std::int64_t i = 0; i < corners; ++i)
      ring.push_back(at({0, 0}, kRadius * static_cast<double>(maker.random.between(40, 100)) / 100,
                        direction_of_turn(100 * i + maker.random.between(0, 60), 100 * corners)));
    if (seen_whole()) break;
  }
  maker.require(seen_whole(), "no star with so many corners was found");
  for (LatticePoint& corner : ring) corner = {corner.x * kPieces, corner.y * kPieces};
  return ring;
}

/// `count` places on a side, in order, in units of 1 / kPieces of it: one in each equal share.
std::vector<std::int64_t> places_on_side(PolygonMaker& maker, std::int64_t count) {
  std::vector<std::int64_t> places;
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t low = 1 + (kPieces - 1) * i / count;
    const std::int64_t high = (kPieces - 1) * (i + 1) / count;
    places.push_back(maker.random.between(low, high));
  }
  return places;
}

/// Moves a vertex of a side off it, across the axis that the side runs along: the chain goes on
/// that way without turning back. Near the corners, where two sides are close, it stays.
LatticePoint off_side(PolygonMaker& maker, LatticePoint p, std::int64_t place, LatticePoint side) {
  const std::int64_t off = maker.random.between(-maker.parameter("off"), maker.parameter("off"));
  if (place < kPieces / 8 || place > kPieces - kPieces / 8) return p;
  if (std::abs(side.x) >= std::abs(side.y)) return {p.x, p.y + off};
  return {p.x + off, p.y};
}

}  // namespace

/// The vertices of every other side lie on it exactly, those of the rest nearly.
LatticePolygon make_collinear(PolygonMaker& maker) {
  const std::int64_t corners = maker.parameter("corners");
  maker.require(maker.n >= corners && maker.n <= corners * kPieces,
                "n must be from 1 to 2^14 times the number of corners");
  const LatticeRing star = coarse_star(maker);
  LatticePolygon polygon;
  const std::int64_t between = maker.n - corners;
  for (std::int64_t i = 0; i < corners; ++i) {
    const LatticePoint a = star[static_cast<std::size_t>(i)];
    const LatticePoint b = star[static_cast<std::size_t>((i + 1) % corners)];
    const LatticePoint side{(b.x - a.x) / kPieces, (b.y - a.y) / kPieces};
    polygon.outer.push_back(a);
    for (const std::int64_t place :
         places_on_side(maker, (i + 1) * between / corners - i * between / corners)) {
      const LatticePoint p{a.x + side.x * place, a.y + side.y * place};
      polygon.outer.push_back(i % 2 == 0 ? p : off_side(maker, p, place, side));
    }
  }
  polygon.holes = holes_on_circle(maker, static_cast<double>(kUnit) / 20);
  return polygon;
}

namespace {

/// Steps to the right with the slopes 0, 1/7, 1/3, 1/2, 3/4, 1 and what a mirror in the diagonal
/// makes of them, all of the width or height 84, the least that makes them integers.
constexpr std::array<LatticePoint, 10> kSteps{{{84, 0},
                                               {84, 12},
                                               {84, 28},
                                               {84, 42},
                                               {84, 63},
                                               {84, 84},
                                               {63, 84},
                                               {42, 84},
                                               {28, 84},
                                               {12, 84}}};

/// Random steps up and down that keep the height between -bound and bound, but for one step.
std::vector<LatticePoint> random_steps(PolygonMaker& maker, std::int64_t count,
                                       std::int64_t bound) {
  // Wide enough for the extent wanted; where there are many steps, all of the smallest size.
  const std::int64_t scale = std::clamp<std::int64_t>(2 * kUnit / (150 * count), 1, kUnit / 4096);
  const std::int64_t most = scale == 1 ? 1 : 4;
  std::vector<LatticePoint> steps;
  std::int64_t height = 0;
  for (std::int64_t i = 0; i < count; ++i) {
    LatticePoint step = kSteps.at(maker.random.below(kSteps.size()));
    const std::int64_t factor = scale * maker.random.between(1, most);
    const bool down = maker.random.bits(1) == 0;
    step = {step.x * factor, step.y * factor};
    if (height > bound || (height >= -bound && down)) step.y = -step.y;
    height += step.y;
    steps.push_back(step);
  }
  return steps;
}

/// The same steps in another order within the same bounds.
///
/// Where the bound is passed upwards and no step goes down any more, the rest only leads further
/// up to the same end as before, which was within the bounds.
std::vector<LatticePoint> reordered(PolygonMaker& maker, std::vector<LatticePoint> steps,
                                    std::int64_t bound) {
  maker.random.shuffle(steps);
  std::array<std::vector<LatticePoint>, 2> heap;  // those that go down, and the others
  for (const LatticePoint step : steps) heap.at(step.y < 0 ? 0 : 1).push_back(step);
  std::int64_t height = 0;
  for (LatticePoint& step : steps) {
    const bool down = height > bound || (height >= -bound && maker.random.bits(1) == 0);
    auto& from = heap.at(heap.at(down ? 0 : 1).empty() ? (down ? 1 : 0) : (down ? 0 : 1));
    step = from.back();
    from.pop_back();
    height += step.y;
  }
  return steps;
}

/// A convex ring of all 40 directions. Requires: radius >= 32.
LatticeRing slopes_hole(LatticePoint centre, std::int64_t radius) {
  // The shortest integer steps, from slope 0 on to the vertical excluded.
  constexpr std::array<LatticePoint, 10> kShort{
      {{1, 0}, {7, 1}, {3, 1}, {2, 1}, {4, 3}, {1, 1}, {3, 4}, {1, 2}, {1, 3}, {1, 7}}};
  const std::int64_t scale = radius / 32;
  LatticeRing ring{{centre.x, centre.y - 24 * scale}};
  for (int quarter = 0; quarter < 4; ++quarter)
    for (LatticePoint step : kShort) {
      for (int i = 0; i < quarter; ++i) step = {-step.y, step.x};
      ring.push_back({ring.back().x + scale * step.x, ring.back().y + scale * step.y});
    }
  ring.pop_back();  // the first again
  return ring;
}

LatticePoint quarter_turns(LatticePoint p, std::int64_t count) {
  for (std::int64_t i = 0; i < count; ++i) p = {-p.y, p.x};
  return p;
}

/// In a row along the middle of the strip that the chains leave free.
std::vector<LatticeRing> slopes_holes(PolygonMaker& maker, std::int64_t width) {
  std::vector<LatticeRing> holes;
  const std::int64_t count = maker.parameter("holes");
  if (count == 0) return holes;
  const std::int64_t radius = std::min(width / count / 3, kUnit / 16);
  maker.require(radius >= 32, "too many holes for the polygon's size");
  for (std::int64_t i = 0; i < count; ++i)
    holes.push_back(slopes_hole({width * (2 * i + 1) / (2 * count), 0}, radius));
  return holes;
}

}  // namespace

namespace {

/// Two chains from left to right made of the same steps, closed by two vertical edges.
LatticeRing closed(const std::vector<LatticePoint>& below, const std::vector<LatticePoint>& above) {
  LatticePoint p{0, -kUnit / 2};
  LatticeRing ring{p};
  for (const LatticePoint step : below) ring.push_back(p = {p.x + step.x, p.y + step.y});
  p.y += kUnit;
  ring.push_back(p);
  for (auto step = above.rbegin(); step != above.rend(); ++step)
    ring.push_back(p = {p.x - step->x, p.y - step->y});
  return ring;
}

}  // namespace

LatticePolygon make_slopes(PolygonMaker& maker) {
  constexpr std::int64_t kBound = kUnit / 4;
  const std::vector<LatticePoint> below = random_steps(maker, maker.n / 2 - 1, kBound);
  LatticePolygon polygon{closed(below, reordered(maker, below, kBound)), {}};
  polygon.holes = slopes_holes(maker, polygon.outer[below.size()].x);
  const std::int64_t off = maker.parameter("off");
  for (LatticePoint& v : polygon.outer)
    v = {v.x + maker.random.between(-off, off), v.y + maker.random.between(-off, off)};
  const std::int64_t turns = maker.parameter("turn");
  for (LatticePoint& v : polygon.outer) v = quarter_turns(v, turns);
  for (LatticeRing& hole : polygon.holes)
    for (LatticePoint& v : hole) v = quarter_turns(v, turns);
  return polygon;
}

}  // namespace quadbound::generators
