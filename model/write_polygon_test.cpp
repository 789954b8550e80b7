// SPDX-License-Identifier: Apache-2.0
#include "model/write_polygon.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "model/read_polygon.hpp"

namespace quadbound {
namespace {

TEST(WritePolygon, ReadsBackTheSameDoublesAndOrder) {
  const Polygon polygon{"a \"name\"",
                        {{{0.1, 1e-300}, {1e300, -0.3}, {1.0 / 3, 2.5e15}},
                         {{1, 2}, {3, 4}, {5, 7.000000000000001}}}};
  std::ostringstream stream;
  write_geojson(stream, polygon);
  EXPECT_EQ(parse_polygon(stream.str(), PolygonFormat::kGeoJson, "copy").rings, polygon.rings);
}

}  // namespace
}  // namespace quadbound
