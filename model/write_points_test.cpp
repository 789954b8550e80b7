// SPDX-License-Identifier: Apache-2.0
#include "model/write_points.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace quadbound {
namespace {

TEST(WritePoints, ReadsBackTheSameDoublesAndOrderInEveryFormat) {
  const PointSet points{"set", {{0.1, 1e-300}, {1e300, -0.3}, {1.0 / 3, 2.5e15}, {-2, 0}}};
  for (const PointFormat format :
       {PointFormat::kCsv, PointFormat::kNode, PointFormat::kXyz, PointFormat::kText}) {
    std::ostringstream stream;
    write_points(stream, points, format);
    EXPECT_EQ(parse_points(stream.str(), format, "copy").points, points.points);
  }
}

}  // namespace
}  // namespace quadbound
