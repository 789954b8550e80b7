// SPDX-License-Identifier: Apache-2.0
#pragma once
// Small meshes of polygons for the tests of the judge, made by hand: nothing of algo/ is involved.

#include <utility>
#include <vector>

#include "verify/test_meshes.hpp"

namespace quadbound::test {

/// The mesh with the polygon that it covers: corners of the boundary become vertices of the
/// polygon, and so do the straight ones whose number kept_straight divides (0: none); all others
/// are Steiner points. Requires: a valid mesh whose boundary consists of simple loops; vertices of
/// the polygon are doubles.
Case with_polygon(Case made, unsigned kept_straight = 0);

using Cells = std::vector<std::pair<unsigned, unsigned>>;  ///< (column, row), from 0

/// The cells of a grid of lines x = xs[i] and y = ys[j], less the removed ones, sheared by
/// (x + slope * y, y). Vertex j * xs.size() + i is at lines i and j, used or not.
Case rectangles(std::string name, const std::vector<Rational>& xs, const std::vector<Rational>& ys,
                const Cells& removed, const Rational& slope = 0, unsigned kept_straight = 0);

/// A square of 3 x 3 unit squares, an L of 4 x 4 less 2 x 2, and a square of 4 x 4 less the hole
/// from (1, 1) to (2, 2).
Case square();
Case l_shape();
Case square_with_hole();

/// The same hole with lines at thirds, on edges of the given slope.
Case hole_with_thirds(const Rational& slope);

/// Lattice, rational and mixed coordinates, slanted edges, holes, vertices of 180 degrees; every
/// one is a valid mesh of at most 30 quads with its polygon.
std::vector<Case> valid_polygon_cases();

}  // namespace quadbound::test
