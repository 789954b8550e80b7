// SPDX-License-Identifier: Apache-2.0
#include "generators/polygons.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "generators/random.hpp"
#include "generators/unit_circle.hpp"
#include "model/validate.hpp"

namespace quadbound {
namespace {

/// Lattice units in the unit of length.
constexpr std::int64_t kUnit = std::int64_t{1} << 20;

using LatticeRing = std::vector<LatticePoint>;

struct LatticePolygon {
  LatticeRing outer;
  std::vector<LatticeRing> holes;
};

/// A recipe at work: its parameters by name and its random integers.
struct PolygonMaker {
  explicit PolygonMaker(const Recipe& completed_recipe)
      : recipe(completed_recipe),
        random(completed_recipe.seed),
        n(static_cast<std::int64_t>(completed_recipe.n)) {}

  [[nodiscard]] std::int64_t parameter(const char* name) const {
    return recipe.parameters.at(name);
  }
  void require(bool condition, const char* what) const {
    if (!condition) throw RecipeError(fmt::format("{}: {}", to_text(recipe), what));
  }

  const Recipe& recipe;
  RandomIntegers random;
  std::int64_t n;
};

LatticePoint at(LatticePoint centre, double radius, Point direction) {
  return {centre.x + static_cast<std::int64_t>(std::floor(radius * direction.x + 0.5)),
          centre.y + static_cast<std::int64_t>(std::floor(radius * direction.y + 0.5))};
}

/// A regular polygon, turned by first / (sides * 64) of a turn.
LatticeRing regular(LatticePoint centre, double radius, std::int64_t sides,
                    std::int64_t first = 0) {
  LatticeRing ring;
  for (std::int64_t i = 0; i < sides; ++i)
    ring.push_back(
        at(centre, radius, direction_of_turn((64 * i + first) % (64 * sides), 64 * sides)));
  return ring;
}

constexpr std::int64_t kHoleSides = 6;

/// Small hexagons evenly spaced on a circle, none near another.
std::vector<LatticeRing> holes_on_circle(const PolygonMaker& maker, double radius) {
  std::vector<LatticeRing> holes;
  const std::int64_t count = maker.parameter("holes");
  const double size = radius / static_cast<double>(count + 1);
  maker.require(count == 0 || size >= 8, "too many holes for the polygon's size");
  for (std::int64_t i = 0; i < count; ++i)
    holes.push_back(
        regular(at({0, 0}, radius, direction_of_turn(i, count)), size, kHoleSides, 7 * i % 64));
  return holes;
}

/// Small hexagons evenly spaced on the segment from (left, y) to (right, y), at most `room` high.
std::vector<LatticeRing> holes_in_row(const PolygonMaker& maker, std::int64_t left,
                                      std::int64_t right, std::int64_t y, std::int64_t room) {
  std::vector<LatticeRing> holes;
  const std::int64_t count = maker.parameter("holes");
  if (count == 0) return holes;
  const std::int64_t step = (right - left) / count;
  const auto size = static_cast<double>(std::min(step / 4, room / 4));
  maker.require(size >= 8, "too many holes for the polygon's size");
  for (std::int64_t i = 0; i < count; ++i)
    holes.push_back(regular({left + step * i + step / 2, y}, size, kHoleSides, 7 * i % 64));
  return holes;
}

// --- around a centre
// ----------------------------------------------------------------------------------

/// Angles in order, each at random in the first four fifths of its share of the turn.
LatticePolygon make_star(PolygonMaker& maker) {
  maker.require(maker.n >= 4, "a star has 4 vertices at least");
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
  maker.require(maker.n >= 3, "a polygon has 3 vertices at least");
  return {regular({0, 0}, static_cast<double>(kUnit), maker.n, maker.parameter("turn")),
          holes_on_circle(maker, static_cast<double>(kUnit) / 4)};
}

/// Teeth with steep flanks: four vertices each.
LatticePolygon make_gear(PolygonMaker& maker) {
  maker.require(maker.n >= 12 && maker.n % 4 == 0,
                "a gear has 4 vertices for each of 3 teeth or more");
  const auto inner = static_cast<double>(kUnit * maker.parameter("low") / 100);
  LatticePolygon polygon;
  for (std::int64_t i = 0; i < maker.n; ++i) {
    const double radius = i % 4 < 2 ? static_cast<double>(kUnit) : inner;
    polygon.outer.push_back(at({0, 0}, radius, direction_of_turn(i, maker.n)));
  }
  polygon.holes = holes_on_circle(maker, inner / 4);
  return polygon;
}

LatticePolygon make_annulus(PolygonMaker& maker) {
  maker.require(maker.n >= 5, "the outer ring needs 5 vertices");
  const auto inner = static_cast<double>(kUnit * maker.parameter("low") / 100);
  return {regular({0, 0}, static_cast<double>(kUnit), maker.n, maker.random.between(0, 63)),
          {regular({0, 0}, inner, maker.n, maker.random.between(0, 63))}};
}

/// Tips between vertices near the centre: 2^-depth of the radius there.
LatticePolygon make_sharp(PolygonMaker& maker) {
  maker.require(maker.n >= 6 && maker.n % 2 == 0,
                "a sharp star has 3 tips or more, 2 vertices each");
  const double inner =
      std::ldexp(static_cast<double>(kUnit), -static_cast<int>(maker.parameter("depth")));
  LatticePolygon polygon;
  for (std::int64_t i = 0; i < maker.n; ++i) {
    const auto outer = static_cast<double>(kUnit * maker.random.between(50, 100) / 100);
    polygon.outer.push_back(at({0, 0}, i % 2 == 0 ? outer : inner, direction_of_turn(i, maker.n)));
  }
  polygon.holes = holes_on_circle(maker, inner / 4);
  return polygon;
}

/// A regular polygon with slits cut into its sides: reflex corners near 360 degrees.
LatticePolygon make_notch(PolygonMaker& maker) {
  maker.require(maker.n >= 16 && maker.n % 4 == 0,
                "notches come with 4 vertices each, 4 of them at least");
  const std::int64_t sides = maker.n / 4;
  const std::int64_t width = std::max<std::int64_t>(1, kUnit >> maker.parameter("depth"));
  LatticePolygon polygon;
  for (std::int64_t i = 0; i < sides; ++i) {
    const Point middle = direction_of_turn(2 * i + 1, 2 * sides);
    const LatticePoint mouth =
        at({0, 0}, static_cast<double>(kUnit) * 0.98 * direction_of_turn(1, 2 * sides).x, middle);
    const LatticePoint aside = at({0, 0}, static_cast<double>(width), {-middle.y, middle.x});
    polygon.outer.push_back(at({0, 0}, static_cast<double>(kUnit), direction_of_turn(i, sides)));
    polygon.outer.push_back({mouth.x - aside.x, mouth.y - aside.y});
    polygon.outer.push_back(at({0, 0}, static_cast<double>(kUnit) / 2, middle));
    polygon.outer.push_back({mouth.x + aside.x, mouth.y + aside.y});
  }
  polygon.holes = holes_on_circle(maker, static_cast<double>(kUnit) / 5);
  return polygon;
}

// --- along an axis
// ------------------------------------------------------------------------------------

/// Both chains go from left to right; holes sit in the middle strip that both keep free.
LatticePolygon make_x_monotone(PolygonMaker& maker) {
  maker.require(maker.n >= 4 && maker.n < kUnit, "between 4 and 2^20 vertices");
  const std::int64_t step = 2 * kUnit / maker.n;
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
  polygon.holes = holes_in_row(maker, kUnit / 2, 3 * kUnit / 2, 0, std::min(step, kUnit / 32));
  return polygon;
}

/// Columns of random heights on a common base, all coordinates multiples of `grain`.
LatticePolygon columns(PolygonMaker& maker, std::int64_t grain) {
  maker.require(maker.n >= 4 && maker.n % 2 == 0,
                "an orthogonal polygon has an even number of vertices");
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

LatticePolygon make_orthogonal(PolygonMaker& maker) { return columns(maker, 1); }

LatticePolygon make_grid_aligned(PolygonMaker& maker) {
  return columns(maker, kUnit >> maker.parameter("level"));
}

/// A back with thin teeth: pairs of long edges close to each other.
LatticePolygon make_comb(PolygonMaker& maker) {
  maker.require(maker.n >= 8 && maker.n % 4 == 0,
                "a comb has 4 vertices for each tooth, 2 teeth at least");
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

/// A square plate with round holes in rows; the holes share n - 4 vertices between them.
LatticePolygon make_plate(PolygonMaker& maker) {
  maker.require(maker.n == 4, "the outer ring of a plate has 4 vertices");
  const std::int64_t holes = std::max<std::int64_t>(1, maker.parameter("holes"));
  std::int64_t rows = 1;
  while (rows * rows < holes) ++rows;
  const std::int64_t pitch = 2 * kUnit / rows;
  maker.require(pitch >= 64, "too many holes");
  LatticePolygon polygon;
  polygon.outer = {{0, 0}, {rows * pitch, 0}, {rows * pitch, rows * pitch}, {0, rows * pitch}};
  for (std::int64_t i = 0; i < holes; ++i) {
    const LatticePoint centre{i % rows * pitch + pitch / 2, i / rows * pitch + pitch / 2};
    polygon.holes.push_back(
        regular(centre, static_cast<double>(pitch) / 4, maker.parameter("sides")));
  }
  return polygon;
}

/// A right-angled band wound around itself, all coordinates multiples of its width.
LatticePolygon make_spiral(PolygonMaker& maker) {
  maker.require(maker.n >= 6 && maker.n % 2 == 0,
                "a spiral has an even number of vertices, 6 at least");
  maker.require(maker.parameter("holes") == 0, "a spiral has no holes");
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

// --- the table
// ----------------------------------------------------------------------------------------

struct Family {
  FamilyDescription description;
  LatticePolygon (*make)(PolygonMaker&);
};

Parameter holes(std::int64_t largest = 10'000) {
  return {"holes", 0, 0, largest, "small hexagons inside"};
}

const std::vector<Family>& families() {
  static const std::vector<Family> table = {
      {{"star",
        "seen whole from its centre, radii at random",
        {holes(), {"low", 30, 5, 100, "smallest radius in percent"}}},
       make_star},
      {{"regular",
        "a regular polygon",
        {holes(), {"turn", 0, 0, 63, "turned by so many 64ths of a side's angle"}}},
       make_regular},
      {{"gear",
        "teeth around a disk",
        {holes(), {"low", 80, 20, 99, "radius between the teeth in percent"}}},
       make_gear},
      {{"annulus",
        "a ring between two regular polygons",
        {holes(0), {"low", 50, 1, 90, "inner radius in percent"}}},
       make_annulus},
      {{"sharp",
        "tips around a small body",
        {holes(), {"depth", 4, 1, 16, "the body's radius is 2^-depth"}}},
       make_sharp},
      {{"notch",
        "a regular polygon with a slit in each side",
        {holes(), {"depth", 6, 4, 18, "half the slit's mouth is 2^-depth"}}},
       make_notch},
      {{"x-monotone", "two chains that run from left to right", {holes()}}, make_x_monotone},
      {{"orthogonal", "columns of random heights", {holes()}}, make_orthogonal},
      {{"grid-aligned",
        "orthogonal, vertices on corners of quadtree cells",
        {holes(), {"level", 5, 3, 20, "coordinates are multiples of 2^-level"}}},
       make_grid_aligned},
      {{"comb",
        "teeth with narrow gaps",
        {holes(), {"depth", 1, 1, 16, "a gap is 2^-depth of the pitch"}}},
       make_comb},
      {{"plate",
        "a square with round holes",
        {{"holes", 1, 0, 100'000, "number of holes, one at least"},
         {"sides", 32, 3, 100'000, "vertices of a hole"}}},
       make_plate},
      {{"spiral-band", "a right-angled band wound around itself", {holes(0)}}, make_spiral},
  };
  return table;
}

const std::vector<FamilyDescription>& descriptions() {
  static const std::vector<FamilyDescription> table = [] {
    std::vector<FamilyDescription> result;
    for (const Family& family : families()) result.push_back(family.description);
    return result;
  }();
  return table;
}

Ring to_ring(const LatticeRing& lattice) {
  Ring ring;
  ring.reserve(lattice.size());
  for (const LatticePoint p : lattice)
    ring.push_back(
        {std::ldexp(static_cast<double>(p.x), -20), std::ldexp(static_cast<double>(p.y), -20)});
  return ring;
}

}  // namespace

std::span<const FamilyDescription> polygon_families() { return descriptions(); }

PolygonRecipe parse_polygon_recipe(std::string_view text) {
  return parse_recipe(text, polygon_families());
}

Polygon generate_polygon(const PolygonRecipe& recipe) {
  const Recipe full = completed(recipe, polygon_families());
  const auto index = &find_family(polygon_families(), full.family) - descriptions().data();
  PolygonMaker maker(full);
  const LatticePolygon made = families()[static_cast<std::size_t>(index)].make(maker);
  Polygon polygon{to_text(full), {to_ring(made.outer)}};
  for (const LatticeRing& hole : made.holes) polygon.rings.push_back(to_ring(hole));
  return normalised(std::move(polygon));
}

}  // namespace quadbound
