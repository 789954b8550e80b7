// SPDX-License-Identifier: Apache-2.0
// Table 2 without the redundant quads of template T2b.
#include "paper/redundant_quads.hpp"

#include <gtest/gtest.h>

#include <variant>

#include "algo/mesh_polygon.hpp"
#include "generators/polygons.hpp"
#include "verify/verify.hpp"

namespace quadbound {
namespace {

/// Each takes a quad and a vertex, and two edges of the two vertices beside it, and the bounds hold
/// without it.
TEST(RedundantQuads, MeshesStayProved) {
  std::uint64_t removed = 0;
  for (const char* const recipe : {"blob:n=100,seed=1", "coast:n=200,seed=1", "star:n=60,seed=2"}) {
    const Polygon polygon = generate_polygon(parse_polygon_recipe(recipe));
    const auto made = std::get<PolygonMesh>(mesh_polygon(polygon));
    const ThinnedMesh thinned = without_redundant_quads(made.mesh, made.root);
    EXPECT_EQ(thinned.mesh.quads.size() + thinned.removed, made.mesh.quads.size());
    EXPECT_EQ(thinned.mesh.vertices.size() + thinned.removed, made.mesh.vertices.size());
    EXPECT_TRUE(verify_polygon(polygon, thinned.mesh).holds()) << recipe;
    EXPECT_EQ(without_redundant_quads(thinned.mesh, made.root).removed, 0U) << recipe;
    removed += thinned.removed;
  }
  EXPECT_GT(removed, 3U);  // or nothing was tried
}

}  // namespace
}  // namespace quadbound
