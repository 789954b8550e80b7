// SPDX-License-Identifier: Apache-2.0
#pragma once
// The formats behind read_mesh, one function each; contracts as there.

#include <string>
#include <string_view>
#include <vector>

#include "model/mesh.hpp"

namespace quadbound {

Mesh parse_mesh_json(std::string_view text, const std::string& file);
Mesh parse_mesh_gmsh(std::string_view text, const std::string& file);
Mesh parse_mesh_obj(std::string_view text, const std::string& file);

/// The vertices of a mesh on the lattice that suits them best.
/// Errors: InputError where there are more than a VertexId can tell apart.
Vertices lattice_vertices(const std::vector<Point>& points, const std::string& file);

/// Puts a face where it belongs: four corners to the quads, any other number to the other faces.
void add_face(Mesh& mesh, std::vector<VertexId> corners);

}  // namespace quadbound
