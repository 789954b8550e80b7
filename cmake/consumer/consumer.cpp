// SPDX-License-Identifier: Apache-2.0
// Ten lines that mesh three points and have the mesh judged.
#include <quadbound/algo/mesh_points.hpp>
#include <quadbound/verify/verify.hpp>

int main() {
  const quadbound::PointSet points{"three points", {{0, 0}, {1, 0.25}, {0.5, 1}}};
  const auto result = quadbound::mesh_points(points);
  const auto* made = std::get_if<quadbound::PointMesh>(&result);
  return made != nullptr && quadbound::verify_points(points, made->mesh).holds() ? 0 : 1;
}
