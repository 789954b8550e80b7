// SPDX-License-Identifier: Apache-2.0
// polygon_memory RECIPE: the peak of memory that meshing one polygon and proving its mesh takes, in
// a process that did nothing else before, as `quadbound mesh` does not either. In one that did,
// holes in the allocator's heap come on top: peak_bytes_per_quad of polygons_bench. Writes a row of
// a table in Markdown to standard output. Exit status: 1 where the mesh is not proved, 2 for a bad
// recipe, 3 where there is no mesh or the system does not tell the memory.
#include <fmt/format.h>

#include <cstddef>
#include <cstdio>
#include <exception>
#include <optional>
#include <variant>

#include "algo/mesh_polygon.hpp"
#include "bench/resident_memory.hpp"
#include "generators/polygons.hpp"
#include "verify/verify.hpp"

namespace quadbound {
namespace {

int measure(const Recipe& recipe) {
  const Polygon polygon = generate_polygon(recipe);
  const ResidentPeak peak;
  const PolygonMeshResult result = mesh_polygon(polygon);
  const auto* made = std::get_if<PolygonMesh>(&result);
  if (made == nullptr) return 3;
  const bool is_proved = verify_polygon(polygon, made->mesh).holds();
  const auto bytes = peak.beyond_start();
  if (!is_proved) return 1;
  if (!bytes) return 3;
  const std::size_t quads = made->mesh.quads.size();
  fmt::print("| {} | {} | {:.1f} |\n", to_text(recipe), quads,
             static_cast<double>(*bytes) / static_cast<double>(quads));
  return 0;
}

}  // namespace
}  // namespace quadbound

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "Usage: polygon_memory RECIPE, for example polygon_memory blob:n=10000\n");
    return 2;
  }
  try {
    return quadbound::measure(quadbound::parse_polygon_recipe(argv[1]));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
