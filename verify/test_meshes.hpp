// SPDX-License-Identifier: Apache-2.0
#pragma once
// Small meshes for the tests of the judge, made by hand: nothing of algo/ is involved.

#include <random>
#include <string>
#include <vector>

#include "model/mesh.hpp"
#include "model/polygon.hpp"

namespace quadbound::test {

/// A mesh and what it was made for.
struct Case {
  std::string name;
  Mesh mesh;
  PointSet points;
  Polygon polygon;  ///< empty unless made by one of test_polygons.hpp
};

using Positions = std::vector<RationalPoint>;

/// Vertices at the given places, on a lattice of the given exponent where they fit. Quads that run
/// clockwise are turned round.
Case make_case(std::string name, const Positions& positions, const std::vector<Quad>& quads,
               int exponent = -10);

/// Adds a vertex at (x, y).
VertexId add(Mesh& mesh, const Rational& x, const Rational& y);

/// Unit squares, columns by rows; vertex j * (columns + 1) + i is at (i, j).
Case square_grid(unsigned columns, unsigned rows);

/// The same sheared by (x + slope * y, y).
Case sheared_grid(unsigned columns, unsigned rows, const Rational& slope);

/// Squares with inner vertices moved at random by up to a fifth, in steps of 1 / 1024.
Case perturbed_grid(unsigned columns, unsigned rows, std::mt19937_64& random);

/// Each chosen quad becomes a half-size copy of itself in its middle and four quads around it.
Case with_insets(const Case& base, std::mt19937_64& random);

/// All positions mapped to scale * p + (shift, shift), on a lattice of the given exponent. Input
/// points that are no doubles any more are dropped.
Case mapped(const Case& base, std::string name, const Rational& scale, const Rational& shift,
            int exponent);

/// The patterns of the mesher's stitching that come closest to the bounds of Theorem 1.
std::vector<Case> stitching_patterns();

/// All of the above in lattice, rational and mixed coordinates, and where rounding to doubles moves
/// vertices; every one is a valid mesh of at most 60 quads.
std::vector<Case> valid_cases(std::uint64_t seed);

}  // namespace quadbound::test
