// SPDX-License-Identifier: Apache-2.0
#include "model/mesh_shape.hpp"

#include <gtest/gtest.h>

namespace quadbound {
namespace {

TEST(Distribution, CountsByClassesAndKeepsTheExtremes) {
  Distribution d({0, 1, 2});
  for (const double value : {0.0, 0.5, 1.0, 7.5}) d.add(value);
  EXPECT_EQ(d.count(), 4U);
  EXPECT_EQ(d.counts(), (std::vector<std::uint64_t>{2, 2}));
  EXPECT_EQ(d.smallest(), 0);
  EXPECT_EQ(d.largest(), 7.5);
  EXPECT_EQ(d.mean(), 2.25);
}

/// Two squares side by side.
TEST(MeshShape, OfTwoSquares) {
  Mesh mesh;
  for (const LatticePoint p : {LatticePoint{0, 0}, LatticePoint{1, 0}, LatticePoint{2, 0},
                               LatticePoint{0, 1}, LatticePoint{1, 1}, LatticePoint{2, 1}})
    mesh.vertices.add(p);
  mesh.quads = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  const MeshShape shape = mesh_shape(mesh);
  EXPECT_EQ(shape.degrees, (std::map<std::uint32_t, std::uint64_t>{{2, 4}, {3, 2}}));
  EXPECT_EQ(shape.scaled_jacobian.mean(), 1);
  EXPECT_EQ(shape.scaled_jacobian.counts().back(), 2U);
  EXPECT_EQ(shape.aspect_ratio.largest(), 1);
}

}  // namespace
}  // namespace quadbound
