// SPDX-License-Identifier: Apache-2.0
#include "verify/test_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace quadbound::test {
namespace {

Rational doubled_area(const Positions& p, const Quad& q) {
  Rational sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const RationalPoint& a = p[q[i]];
    const RationalPoint& b = p[q[(i + 1) % 4]];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

Positions positions_of(const Mesh& mesh) {
  Positions positions;
  for (VertexId v = 0; v < mesh.vertices.size(); ++v) positions.push_back(mesh.vertices.exact(v));
  return positions;
}

/// Every third vertex that is a double becomes an input point.
void choose_points(Case& made) {
  for (VertexId v = 0; v < made.mesh.vertices.size(); v += 3) {
    const Point point = made.mesh.vertices.rounded(v);
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
    if (exact_value(point) == made.mesh.vertices.exact(v)) made.points.points.push_back(point);
  }
  made.mesh.input_vertices = made.points.points.size();
}

/// The two-leaf case c = (1,1), d = (1,3) of the stitching, and what lies right of the line x = 2.
struct TwoLeaves {
  Positions p{{1, 1}, {1, 3}};

  VertexId at(const Rational& x, const Rational& y) {
    const RationalPoint point{x, y};
    const auto it = std::find(p.begin(), p.end(), point);
    if (it != p.end()) return static_cast<VertexId>(it - p.begin());
    p.push_back(point);
    return static_cast<VertexId>(p.size() - 1);
  }
  VertexId s(int i) { return at(Rational(5, 2), Rational(2 * i - 1, 2)); }
};

const Rational kQuarter(1, 4);

Case four_four() {
  TwoLeaves t;
  const VertexId e1 = t.at(9 * kQuarter, kQuarter);
  const VertexId e4 = t.at(9 * kQuarter, 15 * kQuarter);
  const std::vector<Quad> quads{
      {0, e1, t.s(1), t.s(2)}, {0, t.s(2), t.s(3), 1}, {1, t.s(3), t.s(4), e4}};
  return make_case("two leaves, 4|4", t.p, quads);
}

Case two_two() {
  TwoLeaves t;
  const VertexId mc = t.at(Rational(3, 2), Rational(3, 2));
  const VertexId md = t.at(Rational(3, 2), Rational(5, 2));
  const std::vector<Quad> quads{
      {0, t.s(1), t.s(2), mc}, {mc, t.s(2), t.s(3), md}, {md, t.s(3), t.s(4), 1}, {0, mc, md, 1}};
  return make_case("two leaves, 2|2", t.p, quads);
}

Case leaf_four() {
  TwoLeaves t;
  const VertexId ec = t.at(Rational(5, 2), Rational(1, 2));
  const VertexId c = t.at(3, 1);
  const VertexId moved = t.at(9 * kQuarter, 7 * kQuarter);
  const VertexId e4 = t.at(9 * kQuarter, 15 * kQuarter);
  const std::vector<Quad> quads{{0, ec, c, moved}, {0, moved, t.s(3), 1}, {1, t.s(3), t.s(4), e4}};
  return make_case("two leaves, L|4", t.p, quads);
}

/// Fig. 5(5): 26.57 and 153.43 degrees exactly.
Case leaf_against_node() {
  const Positions p{{1, 1},
                    {7, 7},  // belongs to no quad, which breaks nothing
                    {9 * kQuarter, kQuarter},
                    {Rational(5, 2), Rational(1, 2)},
                    {Rational(5, 2), Rational(3, 2)},
                    {9 * kQuarter, 7 * kQuarter},
                    {Rational(3, 2), Rational(3, 2)}};
  return make_case("leaf against a node with extras", p, {{0, 2, 3, 4}, {0, 4, 5, 6}});
}

Case three_leaves() {
  const Positions p{{1, 3},
                    {kQuarter, 7 * kQuarter},
                    {Rational(1, 2), Rational(3, 2)},
                    {Rational(3, 2), Rational(3, 2)},
                    {3, 1},
                    {Rational(3, 2), Rational(1, 2)},
                    {7 * kQuarter, kQuarter},
                    {3, 3}};
  return make_case("T3 with extras", p, {{0, 1, 2, 3}, {4, 3, 5, 6}, {0, 3, 4, 7}});
}

}  // namespace

Case make_case(std::string name, const Positions& positions, const std::vector<Quad>& quads,
               int exponent) {
  Case made;
  made.name = std::move(name);
  made.mesh.vertices = Vertices(exponent);
  for (const RationalPoint& p : positions) made.mesh.vertices.add_exact(p);
  made.mesh.quads = quads;
  for (Quad& q : made.mesh.quads)
    if (doubled_area(positions, q) < 0) std::reverse(q.begin(), q.end());
  made.mesh.cells = quads.size();
  choose_points(made);
  return made;
}

VertexId add(Mesh& mesh, const Rational& x, const Rational& y) {
  return mesh.vertices.add_exact({x, y});
}

Case square_grid(unsigned columns, unsigned rows) {
  Case made = sheared_grid(columns, rows, 0);
  made.name = "squares";
  return made;
}

Case sheared_grid(unsigned columns, unsigned rows, const Rational& slope) {
  Positions positions;
  for (unsigned j = 0; j <= rows; ++j)
    for (unsigned i = 0; i <= columns; ++i)
      positions.push_back({Rational(i) + slope * j, Rational(j)});
  std::vector<Quad> quads;
  for (unsigned j = 0; j < rows; ++j) {
    for (unsigned i = 0; i < columns; ++i) {
      const VertexId v = j * (columns + 1) + i;
      quads.push_back({v, v + 1, v + columns + 2, v + columns + 1});
    }
  }
  return make_case("parallelograms", positions, quads);
}

Case perturbed_grid(unsigned columns, unsigned rows, std::mt19937_64& random) {
  const Case base = square_grid(columns, rows);
  Positions positions = positions_of(base.mesh);
  const auto offset = [&] { return Rational(static_cast<int>(random() % 409) - 204, 1024); };
  for (unsigned j = 1; j < rows; ++j) {
    for (unsigned i = 1; i < columns; ++i) {
      RationalPoint& p = positions[j * (columns + 1) + i];
      p.x += offset();
      p.y += offset();
    }
  }
  return make_case("perturbed squares", positions, base.mesh.quads);
}

Case with_insets(const Case& base, std::mt19937_64& random) {
  Positions p = positions_of(base.mesh);
  std::vector<Quad> quads;
  for (const Quad& q : base.mesh.quads) {
    if (random() % 3 != 0) {
      quads.push_back(q);
      continue;
    }
    const Rational x = (p[q[0]].x + p[q[1]].x + p[q[2]].x + p[q[3]].x) / 4;
    const Rational y = (p[q[0]].y + p[q[1]].y + p[q[2]].y + p[q[3]].y) / 4;
    Quad inner;
    for (std::size_t i = 0; i < 4; ++i) {
      inner[i] = static_cast<VertexId>(p.size());
      const RationalPoint corner = p[q[i]];
      p.push_back({(corner.x + x) / 2, (corner.y + y) / 2});
    }
    quads.push_back(inner);
    for (std::size_t i = 0; i < 4; ++i)
      quads.push_back({q[i], q[(i + 1) % 4], inner[(i + 1) % 4], inner[i]});
  }
  return make_case(base.name + " with insets", p, quads, -16);
}

Case mapped(const Case& base, std::string name, const Rational& scale, const Rational& shift,
            int exponent) {
  Positions positions = positions_of(base.mesh);
  for (RationalPoint& p : positions) {
    p.x = scale * p.x + shift;
    p.y = scale * p.y + shift;
  }
  return make_case(base.name + ", " + std::move(name), positions, base.mesh.quads, exponent);
}

std::vector<Case> stitching_patterns() {
  return {four_four(), two_two(), leaf_four(), leaf_against_node(), three_leaves()};
}

std::vector<Case> valid_cases(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Case> plain = stitching_patterns();
  plain.push_back(square_grid(3, 3));
  plain.push_back(square_grid(1, 4));
  plain.push_back(sheared_grid(4, 3, 2));
  plain.push_back(sheared_grid(3, 2, Rational(-1, 2)));
  plain.push_back(perturbed_grid(4, 4, random));
  plain.push_back(with_insets(square_grid(3, 3), random));
  std::vector<Case> all = plain;
  const Rational large = Rational(boost::multiprecision::mpz_int(1) << 57) + 1;
  for (const Case& base : plain) {
    all.push_back(mapped(base, "thirds", Rational(1, 3), 0, -10));
    all.push_back(mapped(base, "partly on the lattice", Rational(1, 2), 0, 0));
    all.push_back(mapped(base, "far away", 1000003, large, 0));
    all.push_back(mapped(base, "fine", dyadic(1, -1000), 0, -1030));
  }
  return all;
}

}  // namespace quadbound::test
