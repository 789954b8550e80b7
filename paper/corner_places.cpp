// SPDX-License-Identifier: Apache-2.0
#include "paper/corner_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>
#include <variant>

#include "algo/mesh_polygon.hpp"
#include "generators/random.hpp"
#include "model/validate.hpp"
#include "verify/verify.hpp"

namespace quadbound {
namespace {

constexpr std::array<Share, 6> kShares{{{1, 2}, {1, 3}, {2, 3}, {2, 5}, {3, 5}, {3, 7}}};

/// A square of side 16, of 2^54 units, around polygons within 4 of the vertex: at a share of a
/// third they are a twelfth of the side inside.
constexpr int kSideBits = 54;
constexpr int kExponent = 4 - kSideBits;
constexpr double kReach = 4;

/// Far more than a corner takes. Dead ends that come back end sooner: at the depth of the lattice.
constexpr std::uint64_t kMaxCells = 300'000;

constexpr double kSmallestAngle = 1;  // degree
constexpr std::int64_t kSlopeParts = 1 << 20;
constexpr std::int64_t kSimple = 7;
constexpr std::int64_t kMostUnitsOff = 6;

struct EdgeDirection {
  std::int64_t x;
  std::int64_t y;
};

double degrees(EdgeDirection d) {
  return std::atan2(static_cast<double>(d.y), static_cast<double>(d.x)) * 180 / std::numbers::pi;
}

/// Counter-clockwise from one direction to the other, in (0, 360].
double turn(EdgeDirection from, EdgeDirection to) {
  const double angle = degrees(to) - degrees(from);
  return angle > 0 ? angle : angle + 360;
}

/// An edge that ends at the vertex comes from one direction, the next goes in the other.
struct Corner {
  EdgeDirection from;
  EdgeDirection to;
  [[nodiscard]] double angle() const { return turn(to, from); }
};

Point reached(EdgeDirection d) {
  const auto x = static_cast<double>(d.x);
  const auto y = static_cast<double>(d.y);
  const double scale = kReach / std::max(std::abs(x), std::abs(y));
  return {scale * x, scale * y};
}

/// Along the border of a square, counter-clockwise from the end of one edge to the start of the
/// other.
Polygon closed(const Corner& corner) {
  constexpr std::array<EdgeDirection, 4> kSquare{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  std::vector<std::pair<double, Point>> between;
  for (const EdgeDirection d : kSquare)
    if (const double angle = turn(corner.to, d); angle < corner.angle())
      between.emplace_back(angle, reached(d));
  std::sort(between.begin(), between.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  Ring ring{reached(corner.from), {0, 0}, reached(corner.to)};
  for (const auto& [angle, point] : between) ring.push_back(point);
  return normalised({"corner", {std::move(ring)}});
}

EdgeDirection any_direction(RandomIntegers& random) {
  const std::int64_t side = random.chance(50) ? kSlopeParts : -kSlopeParts;
  const std::int64_t other = random.between(-kSlopeParts, kSlopeParts);
  return random.chance(50) ? EdgeDirection{side, other} : EdgeDirection{other, side};
}

EdgeDirection simple_direction(RandomIntegers& random) {
  for (;;) {
    const EdgeDirection d{random.between(-kSimple, kSimple), random.between(-kSimple, kSimple)};
    if (d.x != 0 || d.y != 0) return d;
  }
}

/// The opposite direction but for one degree.
EdgeDirection nearly_opposite(EdgeDirection d, RandomIntegers& random) {
  const std::int64_t scale = kSlopeParts / std::max(std::abs(d.x), std::abs(d.y));
  const std::int64_t off = random.between(-kSlopeParts / 64, kSlopeParts / 64);
  return {-scale * d.x + off, -scale * d.y - off};
}

Corner random_corner(RandomIntegers& random) {
  for (;;) {
    Corner corner{simple_direction(random), simple_direction(random)};
    const std::uint64_t kind = random.below(4);
    if (kind == 1) corner.from = any_direction(random);
    if (kind == 2) corner = {any_direction(random), any_direction(random)};
    if (kind == 3) corner.to = nearly_opposite(corner.from, random);
    // Nor edges that lie on each other.
    if (const double angle = corner.angle(); angle >= kSmallestAngle && angle < 359.99)
      return corner;
  }
}

LatticePoint random_offset(RandomIntegers& random) {
  if (random.chance(50)) return {0, 0};
  return {random.between(-kMostUnitsOff, kMostUnitsOff),
          random.between(-kMostUnitsOff, kMostUnitsOff)};
}

std::int64_t units(Share share) {
  return static_cast<std::int64_t>((Int128{1} << kSideBits) * share.over / share.under);
}

std::string to_text(Share share) { return fmt::format("{}/{}", share.over, share.under); }

class Search {
 public:
  explicit Search(CornerPlaces& places) : places_(places) {}

  void try_corner(CornerPlace& place) {
    const Corner corner = random_corner(random_);
    const LatticePoint off = random_offset(random_);
    const RootSquare root{{-units(place.x) - off.x, -units(place.y) - off.y}, kSideBits, kExponent};
    const Polygon polygon = closed(corner);
    PolygonMeshOptions options;
    options.budget.max_cells = kMaxCells;
    const PolygonMeshResult result = mesh_polygon_in(root, polygon, options);
    const auto* made = std::get_if<PolygonMesh>(&result);
    const bool proved = made != nullptr && verify_polygon(polygon, made->mesh).holds();
    ++place.tally.corners;
    if (corner.angle() < 90) ++place.tally.acute;
    if (made == nullptr) ++place.tally.refused;
    if (made != nullptr && !proved) ++place.tally.not_proved;
    if (made != nullptr && made->counters.dead_end_splits > 0) ++place.tally.with_dead_ends;
    const std::uint64_t rounds = made != nullptr ? made->counters.rounds : 0;
    place.tally.most_rounds = std::max(place.tally.most_rounds, rounds);
    const std::uint64_t badness = proved ? rounds : ~std::uint64_t{0};
    if (badness <= worst_) return;
    worst_ = badness;
    places_.worst = fmt::format(
        "place ({}, {}), {} and {} units off, from ({}, {}) to ({}, {}): {}", to_text(place.x),
        to_text(place.y), off.x, off.y, corner.from.x, corner.from.y, corner.to.x, corner.to.y,
        proved ? fmt::format("{} rounds", rounds)
        : made ? "not proved"
               : std::get<Refusal>(result).message);
  }

 private:
  CornerPlaces& places_;
  RandomIntegers random_{12};
  std::uint64_t worst_ = 0;
};

std::string line_of(const std::string& x, const std::string& y, const DeadEndTally& t) {
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", x, y, t.corners, t.acute,
                     t.with_dead_ends, t.most_rounds, t.refused, t.not_proved);
}

}  // namespace

void DeadEndTally::add(const DeadEndTally& other) {
  corners += other.corners;
  acute += other.acute;
  with_dead_ends += other.with_dead_ends;
  most_rounds = std::max(most_rounds, other.most_rounds);
  refused += other.refused;
  not_proved += other.not_proved;
}

DeadEndTally CornerPlaces::total() const {
  DeadEndTally all;
  for (const CornerPlace& row : rows) all.add(row.tally);
  return all;
}

bool CornerPlaces::hold() const {
  const DeadEndTally all = total();
  return all.refused == 0 && all.not_proved == 0;
}

CornerPlaces search_corner_places(std::uint64_t corners_at_each, Watcher& watcher) {
  CornerPlaces places;
  Search search(places);
  watcher.stage("corners");
  for (const Share x : kShares) {
    for (const Share y : kShares) {
      CornerPlace place{x, y, {}};
      for (std::uint64_t i = 0; i < corners_at_each; ++i) search.try_corner(place);
      places.rows.push_back(place);
      watcher.steps(places.rows.size(), kShares.size() * kShares.size());
    }
  }
  return places;
}

std::string to_text(const CornerPlaces& places) {
  std::string text =
      "| x | y | corners | acute | with dead ends | most rounds | refused | not proved |\n"
      "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  for (const CornerPlace& row : places.rows)
    text += line_of(to_text(row.x), to_text(row.y), row.tally);
  text += line_of("all", "", places.total());
  return text + fmt::format("\nThe hardest: {}\n", places.worst);
}

}  // namespace quadbound
