// SPDX-License-Identifier: Apache-2.0
#include "model/mesh_edges.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "model/write_samples.hpp"

namespace quadbound {
namespace {

using Edges = std::map<std::pair<VertexId, VertexId>, int>;

/// Each directed edge with the number of faces that run along it.
Edges directed_edges(const Mesh& mesh) {
  Edges edges;
  const auto add = [&](const auto& face) {
    for (std::size_t i = 0; i < face.size(); ++i) ++edges[{face[i], face[(i + 1) % face.size()]}];
  };
  for (const Quad& quad : mesh.quads) add(quad);
  for (const auto& face : mesh.other_faces) add(face);
  return edges;
}

int count(const Edges& edges, VertexId from, VertexId to) {
  const auto found = edges.find({from, to});
  return found == edges.end() ? 0 : found->second;
}

/// Quads with random corners: no mesh at all, but every rule must still hold.
Mesh jumble(std::mt19937_64& engine) {
  Mesh mesh;
  mesh.vertices = Vertices(0);
  for (int i = 0; i < 12; ++i)
    mesh.vertices.add(LatticePoint{static_cast<std::int64_t>(engine() % 50),
                                   static_cast<std::int64_t>(engine() % 50)});
  for (int i = 0; i < 15; ++i) {
    std::set<VertexId> corners;
    while (corners.size() < 4) corners.insert(static_cast<VertexId>(engine() % 12));
    Quad quad{};
    std::copy(corners.begin(), corners.end(), quad.begin());
    std::shuffle(quad.begin(), quad.end(), engine);
    mesh.quads.push_back(quad);
  }
  return mesh;
}

void expect_edges(const Mesh& mesh) {
  const Edges expected = directed_edges(mesh);
  Edges seen;
  std::pair<VertexId, VertexId> last{0, 0};
  for_each_edge(mesh, [&](const EdgeUse& use) {
    EXPECT_LT(use.low, use.high);
    EXPECT_LT(last, std::pair(use.low, use.high));
    last = {use.low, use.high};
    EXPECT_EQ(static_cast<int>(use.forward), count(expected, use.low, use.high));
    EXPECT_EQ(static_cast<int>(use.backward), count(expected, use.high, use.low));
    if (use.forward > 0) seen[{use.low, use.high}] = static_cast<int>(use.forward);
    if (use.backward > 0) seen[{use.high, use.low}] = static_cast<int>(use.backward);
  });
  EXPECT_EQ(seen, expected);
}

void expect_rings(const Mesh& mesh) {
  const Edges edges = directed_edges(mesh);
  Edges unpaired;
  for (const auto& [edge, uses] : edges)
    if (const int left = uses - count(edges, edge.second, edge.first); left > 0)
      unpaired[edge] = left;
  Edges walked;
  for (const auto& ring : boundary_rings(mesh)) {
    EXPECT_EQ(std::set<VertexId>(ring.begin(), ring.end()).size(), ring.size());
    EXPECT_EQ(*std::min_element(ring.begin(), ring.end()), ring.front());
    for (std::size_t i = 0; i < ring.size(); ++i) ++walked[{ring[i], ring[(i + 1) % ring.size()]}];
  }
  EXPECT_EQ(walked, unpaired);
}

TEST(MeshEdges, AreCountedAndTheBoundaryIsWalkedOnce) {
  for (const SampleMesh& sample : sample_meshes()) {
    SCOPED_TRACE(sample.name);
    expect_edges(sample.mesh);
    expect_rings(sample.mesh);
  }
  std::mt19937_64 engine(1);
  for (int i = 0; i < 200; ++i) {
    const Mesh mesh = jumble(engine);
    expect_edges(mesh);
    expect_rings(mesh);
  }
}

TEST(BoundaryRings, TheLargestComesFirstAndHolesRunClockwise) {
  // A frame of unit squares around a hole; the hole has the smaller numbers.
  const auto place = [](int column, int row) { return RationalPoint{column, row}; };
  const Mesh mesh =
      sample_grid(3, 3, 0, place, [](int column, int row) { return column != 1 || row != 1; });
  const auto rings = boundary_rings(mesh);
  ASSERT_EQ(rings.size(), 2U);
  EXPECT_EQ(rings[0].size(), 12U);
  EXPECT_EQ(rings[1].size(), 4U);
  double twice = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = mesh.vertices.rounded(rings[1][i]);
    const Point b = mesh.vertices.rounded(rings[1][(i + 1) % 4]);
    twice += a.x * b.y - a.y * b.x;
  }
  EXPECT_EQ(twice, -2);
}

TEST(BoundaryRings, PartsThatTouchAtAVertexAreSeparated) {
  const auto place = [](int column, int row) { return RationalPoint{column, row}; };
  const Mesh mesh = sample_grid(2, 2, 0, place, [](int column, int row) { return column == row; });
  EXPECT_EQ(boundary_rings(mesh), (std::vector<std::vector<VertexId>>{{0, 1, 2, 3}, {2, 4, 5, 6}}));
}

}  // namespace
}  // namespace quadbound
