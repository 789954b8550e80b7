// SPDX-License-Identifier: Apache-2.0
#pragma once
// Small meshes that writers get wrong, for the tests.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "model/mesh.hpp"

namespace quadbound {

struct SampleMesh {
  std::string name;
  Mesh mesh;
};

/// Maps a node (column, row) of a grid to its exact place.
using GridPlace = std::function<RationalPoint(int column, int row)>;
/// Which cells of a grid there are.
using GridCells = std::function<bool(int column, int row)>;

/// Columns x rows quads on a lattice of the given exponent; places that the lattice does not hold
/// are kept as rationals. Nodes that no quad has are left out.
Mesh sample_grid(
    int columns, int rows, int exponent, const GridPlace& place,
    const GridCells& cells = [](int, int) { return true; });

/// The grid of unit squares.
Mesh sample_grid(int columns, int rows);

/// With constructions and levels; with coordinates like 0.1, 1e6 + 0.3 and 1e-9; with thirds; with
/// a hole; with two parts that touch at a vertex; with a triangle; without anything.
std::vector<SampleMesh> sample_meshes();

}  // namespace quadbound
