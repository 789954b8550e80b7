// SPDX-License-Identifier: Apache-2.0
#include "model/write_polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "model/predicates.hpp"
#include "model/refusal_for_tests.hpp"

namespace quadbound {
namespace {

std::string text_of(const Polygon& polygon, PolygonFormat format) {
  std::ostringstream stream;
  write_polygon(stream, polygon, format);
  return stream.str();
}

TEST(WritePolygon, ReadsBackTheSameDoublesAndOrder) {
  const Polygon polygon{"a \"name\"\nof two lines",
                        {{{-0.1, 1e-300}, {1e300, -0.3}, {1.0 / 3, 2.5e15}},
                         {{1, 2}, {3, 4}, {5, 7.000000000000001}}}};
  for (const PolygonFormat format :
       {PolygonFormat::kGeoJson, PolygonFormat::kPoly, PolygonFormat::kWkt})
    EXPECT_EQ(parse_polygon(text_of(polygon, format), format, "copy").rings, polygon.rings);
}

TEST(WritePolygon, APointInsideEachHole) {
  const Ring needle{{0, 0}, {1, std::ldexp(1, -50)}, {1, 0}};
  const Ring comb{{0, 0}, {9, 0}, {9, 5}, {8, 1e-9}, {7, 5}, {6, 1e-9}, {5, 5}, {4, 1e-9}, {0, 5}};
  const Ring dart{{0, 0}, {4, 4}, {8, 0}, {4, 4.00000000000001}};
  const Ring stairs{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}};
  for (const Ring& ring : {needle, comb, dart, stairs}) {
    const auto place = point_inside(ring);
    ASSERT_TRUE(place.has_value());
    EXPECT_TRUE(strictly_inside(*place, ring));
    const auto reversed = point_inside(Ring(ring.rbegin(), ring.rend()));
    ASSERT_TRUE(reversed.has_value());
    EXPECT_TRUE(strictly_inside(*reversed, ring));
  }
}

TEST(WritePolygon, AHoleWithoutADoubleInsideIsRefusedForPolyOnly) {
  const double next = std::nextafter(1.0, 2.0);
  const Polygon polygon{"tiny", {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, next}, {next, 1}}}};
  EXPECT_EQ(refusal([&] { (void)text_of(polygon, PolygonFormat::kPoly); }),
            "tiny: ring 1: no double was found inside this hole, which .poly asks for");
  for (const PolygonFormat format : {PolygonFormat::kGeoJson, PolygonFormat::kWkt})
    EXPECT_EQ(parse_polygon(text_of(polygon, format), format, "copy").rings, polygon.rings);
}

}  // namespace
}  // namespace quadbound
