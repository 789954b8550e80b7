// SPDX-License-Identifier: Apache-2.0
#pragma once
// Meshes for the viewer of the report (paper/page/): compact, and exact.

#include <optional>
#include <string>
#include <vector>

#include "model/angle.hpp"
#include "model/mesh.hpp"
#include "model/picture.hpp"
#include "verify/report.hpp"

namespace quadbound {

/// A mesh that the page holds.
struct ViewerMesh {
  std::string id;
  std::string json;
};

/// What the viewer's menu offers: a mesh, or a part of one.
struct ViewerView {
  std::string id;
  std::string text;
  std::string mesh;  ///< id of a ViewerMesh
  std::optional<PictureWindow> window;
};

/// {"exponent": e, "xy": "x y x y ...", "rational": {"v": ["x", "y"], ...}, "quads": [i, j, k, l,
///  i, ...], "input": [v, ...], "polygon": whether input angles may stay whole, "bounds": {...},
///  "worst": {"smallest": corner, "largest": corner}, "colours": [{"title", "classes", "of_quad"}]}
///
/// Coordinates are whole multiples of 2^e, but for the vertices in "rational". `input` are the
/// vertices at input points. A worst corner is the judge's, with its exact tangent (null at a right
/// angle). `of_quad` has a character for each quad, '0' for the first class.
///
/// Guarantees: 1. nothing of the coordinates is lost. 2. Equal meshes give equal bytes. 3. The text
/// may stand inside an HTML script element.
/// Requires: a report on this mesh with worst corners; constructions and levels of all quads.
/// Complexity: O(v log n) for v vertices and n input points; about 50 bytes a quad.
std::string viewer_mesh_json(const Mesh& mesh, const Report& report,
                             const std::vector<Point>& input);

/// The menu, as JSON with the same guarantees.
std::string viewer_views_json(const std::vector<ViewerView>& views);

}  // namespace quadbound
