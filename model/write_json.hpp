// SPDX-License-Identifier: Apache-2.0
#pragma once
// The exact mesh file: JSON that loses nothing.

#include <iosfwd>

#include "model/mesh.hpp"

namespace quadbound {

/// {"format": "quadbound-mesh", "version": 1, "cells": N, "input_vertices": n,
///  "construction_names": [...], "construction": [...], "level": [...],
///  "vertices": [["x", "y"], ...], "quads": [[i, j, k, l], ...], "faces": [[i, j, k], ...]}
///
/// Guarantees: 1. coordinates are exact rationals in lowest terms, "num/den", or "num" where the
/// denominator is one. 2. The keys come in the order above; construction_names, construction, level
/// and faces are there only where the mesh has them. 3. The bytes depend on the mesh alone.
/// Errors: show in the stream's state.
/// Complexity: linear, several million vertices a second while they are on the lattice.
void write_json(std::ostream& stream, const Mesh& mesh);

}  // namespace quadbound
