// SPDX-License-Identifier: Apache-2.0
#pragma once
// gmsh's MSH 4.1, ASCII.

#include <iosfwd>

#include "model/mesh.hpp"

namespace quadbound {

/// One surface with the quads (element type 3) in the physical group "domain", and one curve for
/// each boundary ring (see mesh_edges.hpp for their order) with its edges as line elements in the
/// physical group "ring 0", "ring 1", ...; the lines run with the mesh on their left.
///
/// Guarantees: 1. vertex v has node tag v + 1; quads keep their order and orientation and come
/// after the lines and before the other faces. 2. A node on the boundary belongs to the (first)
/// curve that it lies on, all others to the surface. 3. Coordinates are the nearest doubles, in the
/// fewest digits that read back as the same double (infinite where a double overflows).
/// Requires: the other faces are triangles (the format has no polygons of more than four sides;
/// see can_be_msh).
/// Errors: show in the stream's state.
/// Complexity: that of boundary_rings, and linear.
void write_msh(std::ostream& stream, const Mesh& mesh);

/// Every face is a quad or a triangle.
bool can_be_msh(const Mesh& mesh);

}  // namespace quadbound
