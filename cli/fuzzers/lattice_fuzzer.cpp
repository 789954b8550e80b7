// SPDX-License-Identifier: Apache-2.0
// libFuzzer target for the whole road of a polygon on a small integer lattice: validation, mesh,
// judge.
//
// The first byte is even for a lattice of 16 x 16 points, one byte a vertex, and odd for one of
// 256 x 256, two bytes a vertex. A vertex at the place of the first one of its ring ends the ring.
#include <new>
#include <string>
#include <utility>
#include <variant>

#include "algo/mesh_polygon.hpp"
#include "cli/fuzzers/fuzzer.hpp"
#include "model/errors.hpp"
#include "model/validate.hpp"
#include "verify/verify.hpp"

namespace quadbound::fuzzer {
namespace {

/// So few that a case takes milliseconds.
constexpr std::size_t kMostVertices = 32;
constexpr std::uint64_t kMostCells = 15'000;

Polygon polygon_of(const std::uint8_t* data, std::size_t size) {
  Polygon polygon{"input", {}};
  const std::size_t bytes = size > 0 && data[0] % 2 == 1 ? 2 : 1;
  Ring ring;
  for (std::size_t i = 1; i + bytes <= size; i += bytes) {
    const Point p = bytes == 2 ? Point{double(data[i]), double(data[i + 1])}
                               : Point{double(data[i] >> 4U), double(data[i] & 15U)};
    if (ring.empty() || p != ring.front())
      ring.push_back(p);
    else
      polygon.rings.push_back(std::exchange(ring, {}));
  }
  if (!ring.empty()) polygon.rings.push_back(ring);
  return polygon;
}

void try_polygon(const Polygon& polygon) {
  PolygonMeshOptions options;
  options.budget.max_cells = kMostCells;
  const PolygonMeshResult result = mesh_polygon(polygon, options);
  if (const auto* refusal = std::get_if<Refusal>(&result)) {
    require_one_line(refusal->message);
    require(refusal->kind == RefusalKind::kTooManyCells, refusal->message);
    return;
  }
  const Report report = verify_polygon(polygon, std::get<PolygonMesh>(result).mesh);
  for (const Claim& claim : report.claims)
    require(claim.exact == Verdict::holds, claim.id + ": " + claim.detail);
  require(report.holds(), report.theorem);
}

}  // namespace
}  // namespace quadbound::fuzzer

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace quadbound;
  if (size > 2 * fuzzer::kMostVertices) return 0;
  Polygon polygon = fuzzer::polygon_of(data, size);
  try {
    polygon = normalised(std::move(polygon));
  } catch (const InputError& error) {
    fuzzer::require_one_line(error.what());
    return 0;
  }
  fuzzer::try_polygon(polygon);
  return 0;
}
