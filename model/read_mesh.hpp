// SPDX-License-Identifier: Apache-2.0
#pragma once
// Meshes from files, ours or anyone's, to be judged.

#include <optional>
#include <string>
#include <string_view>

#include "model/mesh.hpp"

namespace quadbound {

enum class MeshFormat {
  kJson,  ///< .json: the exact mesh file
  kGmsh,  ///< .msh: gmsh 4.1 or 2.2 in ASCII
  kObj,   ///< .obj: Wavefront
};

/// Reads a mesh; the format goes by the extension unless it is given. "-" is standard input and
/// needs a format.
///
/// Guarantees: 1. exact coordinates: rationals are kept as they are, decimal numbers become the
/// nearest doubles. 2. Vertices, quads and other faces keep the order of the file; every corner is
/// the number of a vertex that exists. 3. The lattice is the finest that the vertices need, or,
/// where the largest coordinate does not fit that one, the finest that it allows.
/// JSON: keys in any order; unknown keys are skipped; "construction" and "level" have an entry per
/// quad. gmsh: quadrangles, triangles of all entities; points and lines are skipped, elements of
/// higher order and solids refused. OBJ: all faces; everything else but vertices is skipped. In
/// gmsh and OBJ a coordinate z must be zero.
/// Not checked here: that the faces form a mesh of anything.
/// Errors: InputError with vertex and line where they are known.
/// Complexity: linear; JSON needs about 50 bytes for a vertex and 16 for a quad beside the text.
Mesh read_mesh(const std::string& path, std::optional<MeshFormat> format = {});

/// The same for a text in memory; `file` is the name in messages.
Mesh parse_mesh(std::string_view text, MeshFormat format, const std::string& file);

}  // namespace quadbound
