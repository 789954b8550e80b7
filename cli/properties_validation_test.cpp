// SPDX-License-Identifier: Apache-2.0
// Property: a valid polygon that is changed is either meshed and proved, or refused on one line.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cli/property_cases.hpp"
#include "generators/random.hpp"
#include "model/errors.hpp"
#include "model/validate.hpp"
#include "verify/verify.hpp"

namespace quadbound::cli {
namespace {

/// A random place in a polygon.
struct Spot {
  Spot(Polygon& polygon, RandomIntegers& random)
      : ring(polygon.rings[random.below(polygon.rings.size())]),
        vertex(random.below(ring.size())) {}
  [[nodiscard]] Point& point() const { return ring[vertex]; }
  [[nodiscard]] Point& next() const { return ring[(vertex + 1) % ring.size()]; }
  Ring& ring;
  std::size_t vertex;
};

double small_step(RandomIntegers& random) {
  return std::ldexp(static_cast<double>(random.between(-64, 64)), -8);
}

// --- changes, each on coordinates that are multiples of 2^-20 ------------------------------------

void move_a_little(Polygon& polygon, RandomIntegers& random) {
  const Spot spot(polygon, random);
  spot.point() = {spot.point().x + small_step(random), spot.point().y + small_step(random)};
}

void move_by_one_ulp(Polygon& polygon, RandomIntegers& random) {
  double& x = Spot(polygon, random).point().x;
  x = std::nextafter(x, random.chance(50) ? 10 : -10);
}

void move_onto_a_vertex(Polygon& polygon, RandomIntegers& random) {
  const Point place = Spot(polygon, random).point();
  Spot(polygon, random).point() = place;
}

void move_into_an_edge(Polygon& polygon, RandomIntegers& random) {
  const Spot edge(polygon, random);
  const Point middle{(edge.point().x + edge.next().x) / 2, (edge.point().y + edge.next().y) / 2};
  Spot(polygon, random).point() = middle;
}

void insert_middle(Polygon& polygon, RandomIntegers& random) {
  const Spot edge(polygon, random);
  const Point middle{(edge.point().x + edge.next().x) / 2, (edge.point().y + edge.next().y) / 2};
  edge.ring.insert(edge.ring.begin() + static_cast<std::ptrdiff_t>(edge.vertex) + 1, middle);
}

void repeat_vertex(Polygon& polygon, RandomIntegers& random) {
  const Spot spot(polygon, random);
  const Point copy = spot.point();
  spot.ring.insert(spot.ring.begin() + static_cast<std::ptrdiff_t>(random.below(spot.ring.size())),
                   copy);
}

void drop_vertex(Polygon& polygon, RandomIntegers& random) {
  const Spot spot(polygon, random);
  spot.ring.erase(spot.ring.begin() + static_cast<std::ptrdiff_t>(spot.vertex));
}

void swap_vertices(Polygon& polygon, RandomIntegers& random) {
  const Spot spot(polygon, random);
  std::swap(spot.point(), spot.ring[random.below(spot.ring.size())]);
}

void reverse_ring(Polygon& polygon, RandomIntegers& random) {
  std::ranges::reverse(Spot(polygon, random).ring);
}

void move_ring(Polygon& polygon, RandomIntegers& random) {
  const Point by{4 * small_step(random), 4 * small_step(random)};
  for (Point& p : Spot(polygon, random).ring) p = {p.x + by.x, p.y + by.y};
}

/// A small triangle halfway between two vertices: mostly inside, or in the way of a ring.
void add_hole(Polygon& polygon, RandomIntegers& random) {
  const Point a = Spot(polygon, random).point();
  const Point b = Spot(polygon, random).point();
  const Point at{(a.x + b.x) / 2, (a.y + b.y) / 2};
  const double size = std::ldexp(1.0, -static_cast<int>(random.between(2, 8)));
  polygon.rings.push_back({at, {at.x, at.y + size}, {at.x + size, at.y}});
}

void swap_rings(Polygon& polygon, RandomIntegers& random) {
  std::swap(polygon.rings.front(), polygon.rings[random.below(polygon.rings.size())]);
}

void spoil_number(Polygon& polygon, RandomIntegers& random) {
  constexpr std::array kBad{std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity(), 1e305, 1e-305, -0.0};
  Spot(polygon, random).point().y = kBad[random.below(kBad.size())];
}

void cut_ring_short(Polygon& polygon, RandomIntegers& random) {
  Spot(polygon, random).ring.resize(random.below(4));
}

struct Change {
  const char* name;
  void (*apply)(Polygon&, RandomIntegers&);
  bool expect_refused;
  bool expect_proved;
};

constexpr std::array<Change, 14> kChanges{{
    {"a vertex moved a little", move_a_little, true, true},
    {"a vertex moved by one ulp", move_by_one_ulp, false, true},
    {"a vertex moved onto another", move_onto_a_vertex, true, false},
    {"a vertex moved into an edge", move_into_an_edge, true, false},
    {"the middle of an edge inserted", insert_middle, false, true},
    {"a vertex repeated", repeat_vertex, true, false},
    {"a vertex dropped", drop_vertex, true, true},
    {"two vertices swapped", swap_vertices, true, false},
    {"a ring reversed", reverse_ring, false, true},
    {"a ring moved", move_ring, true, true},
    {"a hole added", add_hole, true, true},
    {"two rings swapped", swap_rings, true, false},
    {"a number spoiled", spoil_number, true, false},
    {"a ring cut short", cut_ring_short, true, false},
}};

/// Where the validation refuses a polygon, what it says.
std::optional<std::string> refusal(const Polygon& polygon) {
  try {
    validate(polygon);
    return std::nullopt;
  } catch (const InputError& error) {
    return error.what();
  }
}

void refusal_names_the_place(const std::string& message, const Polygon& polygon) {
  RC_ASSERT(is_one_line(message));
  RC_ASSERT(message.starts_with(polygon.file + ": "));
}

TEST(Validation, AChangedPolygonIsProvedOrRefusedOnOneLine) {
  Reached reached(Reached::Of::kPolygons);
  for (const Change& change : kChanges) {
    if (change.expect_refused) reached.expect(std::string(change.name) + ", refused");
    if (change.expect_proved) reached.expect(std::string(change.name) + ", proved");
  }
  check_property(700, reached, [&](const PolygonSample& sample) {
    const Change& change = *rc::gen::elementOf(kChanges);
    RandomIntegers random(*rc::gen::arbitrary<std::uint64_t>());
    Polygon polygon = sample.polygon;
    change.apply(polygon, random);
    if (const auto message = refusal(polygon)) {
      refusal_names_the_place(*message, polygon);
      reached.add(std::string(change.name) + ", refused");
      return;
    }
    polygon = normalised(polygon);
    const auto made = meshed(polygon);
    RC_PRE(made.has_value());
    RC_ASSERT(broken_claims(verify_polygon(polygon, made->mesh)) == "");
    reached.add(std::string(change.name) + ", proved");
    reached.add(*made);
  });
}

}  // namespace
}  // namespace quadbound::cli
