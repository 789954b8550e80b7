// SPDX-License-Identifier: Apache-2.0
#pragma once
// Wavefront OBJ.

#include <iosfwd>

#include "model/mesh.hpp"

namespace quadbound {

/// A comment with the numbers of vertices and faces, "v x y 0" for each vertex and "f i j k l" for
/// each quad, then the other faces; ids from 1.
///
/// Guarantees: 1. vertices and quads keep their order. 2. Coordinates are the nearest doubles, in
/// the fewest digits that read back as the same double (infinite where a double overflows).
/// Errors: show in the stream's state.
void write_obj(std::ostream& stream, const Mesh& mesh);

}  // namespace quadbound
