// SPDX-License-Identifier: Apache-2.0
#pragma once
// VTK's XML unstructured grid.

#include <iosfwd>

#include "model/mesh.hpp"

namespace quadbound {

/// Float64 points (z = 0), Int64 connectivity and offsets, cell type 9 (quad), and 7 (polygon) for
/// the other faces, which come last. Cell data: min_angle, max_angle, scaled_jacobian, aspect_ratio
/// (Float64, see quad_shape.hpp; NaN for the other faces), and construction and level (UInt8, 255
/// for the other faces) where the mesh has them.
///
/// Arrays are inline base64, uncompressed: the doubles are exact by construction, the file stays
/// well-formed XML (which raw appended data is not) and takes 11 bytes for a double where decimal
/// digits take up to 24.
///
/// Guarantees: 1. vertices and quads keep their order. 2. Points are the nearest doubles, bit for
/// bit (infinite where a double overflows). 3. The bytes are little-endian on every machine.
/// Errors: show in the stream's state.
/// Complexity: linear; 32 bytes for each quad.
void write_vtu(std::ostream& stream, const Mesh& mesh);

}  // namespace quadbound
