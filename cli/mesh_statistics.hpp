// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a mesh looks like in numbers, beside the judge's report: sizes, shapes of quads (Section 5),
// degrees of vertices (Table 2), and which construction made how many quads.

#include <optional>
#include <string>

#include "algo/mesh_polygon.hpp"
#include "model/mesh.hpp"

namespace quadbound::cli {

/// One JSON object:
/// - "input_vertices" n, "cells" N, "vertices", "quads", "cells_per_input_vertex",
///   "quads_per_cell";
/// - "degrees": number of vertices by their number of edges;
/// - "scaled_jacobian" and "aspect_ratio" (model/quad_shape.hpp): "smallest", "mean", "largest" and
///   a "histogram" of [lower end, upper end, quads], where the last class has no upper end;
/// - "constructions": quads by the construction they come from;
/// - "section_3_4": for polygons, what the mesher did (PolygonCounters);
/// - "lemmas": with --insertion paper, its cases and those outside the bounds (LemmaCounters).
///
/// Guarantees: 1. the same mesh gives the same bytes. Complexity: linear.
std::string statistics_json(const Mesh& mesh, const std::optional<PolygonCounters>& counters);

}  // namespace quadbound::cli
