// SPDX-License-Identifier: Apache-2.0
#include "generators/polygon_families.hpp"

#include <fmt/core.h>

#include <cmath>

#include "generators/unit_circle.hpp"

namespace quadbound::generators {

void PolygonMaker::require(bool condition, const char* what) const {
  if (!condition) throw RecipeError(fmt::format("{}: {}", to_text(recipe), what));
}

LatticePoint rounded(double x, double y) {
  return {static_cast<std::int64_t>(std::floor(x + 0.5)),
          static_cast<std::int64_t>(std::floor(y + 0.5))};
}

LatticePoint at(LatticePoint centre, double radius, Point direction) {
  const LatticePoint offset = rounded(radius * direction.x, radius * direction.y);
  return {centre.x + offset.x, centre.y + offset.y};
}

LatticeRing regular(LatticePoint centre, double radius, std::int64_t sides, std::int64_t first) {
  LatticeRing ring;
  for (std::int64_t i = 0; i < sides; ++i)
    ring.push_back(
        at(centre, radius, direction_of_turn((64 * i + first) % (64 * sides), 64 * sides)));
  return ring;
}

bool non_acute(const LatticeRing& ring) {
  LatticePoint before = ring[ring.size() - 2];
  LatticePoint here = ring.back();
  for (const LatticePoint after : ring) {
    if (turn(before, here, after) > 0 && dot(here, before, after) > 0) return false;
    before = here;
    here = after;
  }
  return true;
}

}  // namespace quadbound::generators
