// SPDX-License-Identifier: Apache-2.0
// Judging the judge at random: valid meshes are damaged in every way we could think of, and a
// second, naive judge must agree on every claim. A kind of damage that (almost) never changes a
// verdict would test nothing, so that is counted too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "verify/naive_judge.hpp"
#include "verify/test_meshes.hpp"

namespace quadbound::test {
namespace {

using Random = std::mt19937_64;

std::size_t pick(Random& random, std::size_t count) { return random() % count; }
Quad& any_quad(Mesh& mesh, Random& random) { return mesh.quads[pick(random, mesh.quads.size())]; }
VertexId any_vertex(Mesh& mesh, Random& random) { return any_quad(mesh, random)[pick(random, 4)]; }

void move_by(Mesh& mesh, VertexId v, const Rational& dx, const Rational& dy) {
  const RationalPoint p = mesh.vertices.exact(v);
  mesh.vertices.move_to_exact(v, {p.x + dx, p.y + dy});
}

/// From -size to size, in hundredths of it.
Rational random_step(Random& random, const Rational& size) {
  return size * Rational(static_cast<int>(pick(random, 201)) - 100, 100);
}

/// The length of the first edge of some quad, in the 1-norm.
Rational edge_size(const Mesh& mesh) {
  const RationalPoint a = mesh.vertices.exact(mesh.quads[0][0]);
  const RationalPoint b = mesh.vertices.exact(mesh.quads[0][1]);
  return Rational(abs(Rational(a.x - b.x))) + Rational(abs(Rational(a.y - b.y)));
}

VertexId add_between(Mesh& mesh, VertexId a, VertexId b, const Rational& t) {
  const RationalPoint p = mesh.vertices.exact(a);
  const RationalPoint q = mesh.vertices.exact(b);
  return mesh.vertices.add_exact({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
}

// --- the kinds of damage
// --------------------------------------------------------------------------

void move_tiny(Case& c, Random& random) {
  const int exponent = static_cast<int>(pick(random, 2)) * 40;
  const Rational step = dyadic(1, c.mesh.vertices.exponent() - exponent);
  const auto sign = [&] { return static_cast<int>(pick(random, 3)) - 1; };
  move_by(c.mesh, any_vertex(c.mesh, random), sign() * step, sign() * step);
}
void move_some(Case& c, Random& random) {
  const Rational size = edge_size(c.mesh);
  move_by(c.mesh, any_vertex(c.mesh, random), random_step(random, size), random_step(random, size));
}
void move_far(Case& c, Random& random) {
  const Rational size = 8 * edge_size(c.mesh);
  move_by(c.mesh, any_vertex(c.mesh, random), random_step(random, size), random_step(random, size));
}
void move_onto_vertex(Case& c, Random& random) {
  const VertexId to = any_vertex(c.mesh, random);
  c.mesh.vertices.move_to_exact(any_vertex(c.mesh, random), c.mesh.vertices.exact(to));
}
void move_onto_edge(Case& c, Random& random) {
  const Quad q = any_quad(c.mesh, random);
  const std::size_t i = pick(random, 4);
  const RationalPoint a = c.mesh.vertices.exact(q[i]);
  const RationalPoint b = c.mesh.vertices.exact(q[(i + 1) % 4]);
  const Rational t(static_cast<int>(1 + pick(random, 3)), 4);
  c.mesh.vertices.move_to_exact(any_vertex(c.mesh, random),
                                {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
}
void straighten_corner(Case& c, Random& random) {
  const Quad q = any_quad(c.mesh, random);
  const std::size_t i = pick(random, 4);
  const RationalPoint a = c.mesh.vertices.exact(q[(i + 3) % 4]);
  const RationalPoint b = c.mesh.vertices.exact(q[(i + 1) % 4]);
  c.mesh.vertices.move_to_exact(q[i], {(a.x + b.x) / 2, (a.y + b.y) / 2});
}
void flip_quad(Case& c, Random& random) {
  Quad& q = any_quad(c.mesh, random);
  std::reverse(q.begin(), q.end());
}
void drop_quad(Case& c, Random& random) {
  c.mesh.quads.erase(c.mesh.quads.begin() +
                     static_cast<std::ptrdiff_t>(pick(random, c.mesh.quads.size())));
}
void double_quad(Case& c, Random& random) {
  Quad q = any_quad(c.mesh, random);
  std::rotate(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(pick(random, 4)), q.end());
  if (pick(random, 3) == 0) std::reverse(q.begin(), q.end());
  c.mesh.quads.push_back(q);
}
void split_into_triangles(Case& c, Random& random) {
  const std::size_t i = pick(random, c.mesh.quads.size());
  const Quad q = c.mesh.quads[i];
  c.mesh.quads.erase(c.mesh.quads.begin() + static_cast<std::ptrdiff_t>(i));
  c.mesh.other_faces.push_back({q[0], q[1], q[2]});
  c.mesh.other_faces.push_back({q[0], q[2], q[3]});
}
void add_other_face(Case& c, Random& random) {
  c.mesh.other_faces.push_back({any_vertex(c.mesh, random), 0, 1});
}
void hang_nodes(Case& c, Random& random) {
  const std::size_t i = pick(random, c.mesh.quads.size());
  Quad q = c.mesh.quads[i];
  std::rotate(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(pick(random, 2)), q.end());
  const Rational t(static_cast<int>(2 + pick(random, 3)), 6);
  const VertexId m = add_between(c.mesh, q[0], q[1], t);
  const VertexId n = add_between(c.mesh, q[3], q[2], t);
  c.mesh.quads[i] = {q[0], m, n, q[3]};
  c.mesh.quads.push_back({m, q[1], q[2], n});
}
/// One corner of one quad gets a vertex of its own at the same place.
void tear_corner(Case& c, Random& random) {
  VertexId& v = any_quad(c.mesh, random)[pick(random, 4)];
  v = c.mesh.vertices.add_exact(c.mesh.vertices.exact(v));
}
/// All quads after some one get a vertex of their own: slits, and cuts right through.
void tear_vertex(Case& c, Random& random) {
  const VertexId v = any_vertex(c.mesh, random);
  const VertexId twin = c.mesh.vertices.add_exact(c.mesh.vertices.exact(v));
  for (std::size_t i = pick(random, c.mesh.quads.size()); i < c.mesh.quads.size(); ++i)
    std::replace(c.mesh.quads[i].begin(), c.mesh.quads[i].end(), v, twin);
}
/// A quad on some edge, on either side of it and of any size: mostly a second sheet.
void glue_quad(Case& c, Random& random) {
  const Quad q = any_quad(c.mesh, random);
  const std::size_t i = pick(random, 4);
  const VertexId a = q[i];
  const VertexId b = q[(i + 1) % 4];
  const RationalPoint p = c.mesh.vertices.exact(a);
  const RationalPoint r = c.mesh.vertices.exact(b);
  Rational side(static_cast<int>(pick(random, 4)) + 1, 2);
  if (pick(random, 2) == 0) side = -side;
  const Rational dx = side * (r.y - p.y);
  const Rational dy = -side * (r.x - p.x);
  const VertexId far_b = c.mesh.vertices.add_exact({r.x + dx, r.y + dy});
  const VertexId far_a = c.mesh.vertices.add_exact({p.x + dx, p.y + dy});
  if (side > 0) {
    c.mesh.quads.push_back({b, a, far_a, far_b});
  } else {
    c.mesh.quads.push_back({a, b, far_b, far_a});
  }
}
/// A copy of the whole mesh that shares a vertex, or nothing, with it.
void add_copy(Case& c, Random& random) {
  const std::size_t count = c.mesh.quads.size();
  const auto vertices = static_cast<VertexId>(c.mesh.vertices.size());
  const Rational size = edge_size(c.mesh);
  const Rational reach = pick(random, 4) == 0 ? Rational(8 * size) : size;
  const Rational dx = random_step(random, reach);
  const Rational dy = random_step(random, reach);
  for (VertexId v = 0; v < vertices; ++v) {
    const RationalPoint p = c.mesh.vertices.exact(v);
    c.mesh.vertices.add_exact({p.x + dx, p.y + dy});
  }
  for (std::size_t i = 0; i < count; ++i) {
    Quad q = c.mesh.quads[i];
    for (VertexId& v : q) v += vertices;
    c.mesh.quads.push_back(q);
  }
}
void merge_vertices(Case& c, Random& random) {
  const VertexId from = any_vertex(c.mesh, random);
  const VertexId to = any_vertex(c.mesh, random);
  for (Quad& q : c.mesh.quads) std::replace(q.begin(), q.end(), from, to);
}
void swap_within_quad(Case& c, Random& random) {
  Quad& q = any_quad(c.mesh, random);
  const std::size_t i = pick(random, 4);
  std::swap(q[i], q[(i + 1 + pick(random, 3)) % 4]);
}
void swap_between_quads(Case& c, Random& random) {
  std::swap(any_quad(c.mesh, random)[pick(random, 4)], any_quad(c.mesh, random)[pick(random, 4)]);
}
void change_id(Case& c, Random& random) {
  any_quad(c.mesh, random)[pick(random, 4)] =
      static_cast<VertexId>(pick(random, c.mesh.vertices.size() + 1));
}
void exchange_positions(Case& c, Random& random) {
  const VertexId v = any_vertex(c.mesh, random);
  const VertexId w = any_vertex(c.mesh, random);
  const RationalPoint p = c.mesh.vertices.exact(v);
  c.mesh.vertices.move_to_exact(v, c.mesh.vertices.exact(w));
  c.mesh.vertices.move_to_exact(w, p);
}
void mirror(Case& c, Random&) {
  for (VertexId v = 0; v < c.mesh.vertices.size(); ++v) {
    const RationalPoint p = c.mesh.vertices.exact(v);
    c.mesh.vertices.move_to_exact(v, {-p.x, p.y});
  }
}
void squeeze(Case& c, Random& random) {
  const Rational factor(static_cast<int>(1 + pick(random, 12)), 8);
  for (VertexId v = 0; v < c.mesh.vertices.size(); ++v) {
    const RationalPoint p = c.mesh.vertices.exact(v);
    c.mesh.vertices.move_to_exact(v, {factor * p.x, p.y});
  }
}
void nudge_point(Case& c, Random& random) {
  if (c.points.points.empty()) return;
  Point& p = c.points.points[pick(random, c.points.points.size())];
  double& value = pick(random, 2) == 0 ? p.x : p.y;
  value = std::nextafter(value, pick(random, 2) == 0 ? -INFINITY : INFINITY);
}
void add_point(Case& c, Random& random) {
  const auto coordinate = [&] { return static_cast<double>(pick(random, 8)) / 2; };
  c.points.points.push_back({coordinate(), coordinate()});
}
void change_cells(Case& c, Random& random) {
  c.mesh.cells = (c.mesh.quads.size() - 1) / 3 + pick(random, 2);
}

// Damage that is none.
void rotate_corners(Case& c, Random& random) {
  for (Quad& q : c.mesh.quads)
    std::rotate(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(pick(random, 4)), q.end());
}
void reorder_quads(Case& c, Random& random) {
  std::shuffle(c.mesh.quads.begin(), c.mesh.quads.end(), random);
}
void renumber_vertices(Case& c, Random& random) {
  std::vector<VertexId> order(c.mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), random);
  const Vertices old = c.mesh.vertices;
  for (VertexId v = 0; v < order.size(); ++v) c.mesh.vertices.move_to_exact(order[v], old.exact(v));
  for (Quad& q : c.mesh.quads)
    for (VertexId& v : q) v = order[v];
}

struct Kind {
  const char* name;
  void (*damage)(Case&, Random&);
  /// Least share of mutants, in percent, that must change a verdict; 0 for no damage: none may.
  int effective_percent;
};

constexpr Kind kKinds[] = {
    {"vertex moved by a unit", move_tiny, 5},
    {"vertex moved within its surroundings", move_some, 50},
    {"vertex moved far", move_far, 80},
    {"vertex moved onto another", move_onto_vertex, 50},
    {"vertex moved onto an edge", move_onto_edge, 80},
    {"corner straightened", straighten_corner, 80},
    {"quad flipped", flip_quad, 95},
    {"quad dropped", drop_quad, 30},
    {"quad doubled", double_quad, 95},
    {"quad split into triangles", split_into_triangles, 95},
    {"other face added", add_other_face, 95},
    {"hanging nodes", hang_nodes, 50},
    {"corner torn off", tear_corner, 60},
    {"vertex torn in two", tear_vertex, 10},
    {"quad glued on", glue_quad, 70},
    {"whole mesh copied", add_copy, 95},
    {"vertices merged", merge_vertices, 50},
    {"corners of a quad exchanged", swap_within_quad, 95},
    {"corners of two quads exchanged", swap_between_quads, 80},
    {"corner given to any vertex", change_id, 80},
    {"positions exchanged", exchange_positions, 50},
    {"mesh mirrored", mirror, 95},
    {"mesh squeezed", squeeze, 30},
    {"input point moved by one ulp", nudge_point, 70},
    {"input point added", add_point, 30},
    {"cells counted wrongly", change_cells, 30},
    {"corners of all quads rotated", rotate_corners, 0},
    {"quads reordered", reorder_quads, 0},
    {"vertices renumbered", renumber_vertices, 0},
};

// --- agreement
// ------------------------------------------------------------------------------------

/// no-overlap is the one claim that our judge may leave open where the naive one does not.
void expect_same_overlap(Verdict ours, const NaiveReport& naive) {
  const Verdict theirs = naive.exact.at("no-overlap");
  const bool must_decide = naive.exact.at("strictly-convex") == Verdict::holds &&
                           naive.exact.at("conforming") == Verdict::holds &&
                           naive.exact.at("one-boundary") == Verdict::holds;
  if (must_decide || ours != Verdict::not_decided) {
    EXPECT_EQ(name(ours), name(theirs));
  }
}

void expect_same_corners(const Report& report, const NaiveReport& naive) {
  if (report.find("min-angle")->exact == Verdict::not_decided) return;
  for (const auto& [id, corner] :
       {std::pair{"min-angle", naive.smallest}, std::pair{"max-angle", naive.largest}}) {
    const Place& place = report.find(id)->worst->place;
    EXPECT_EQ(std::pair(*place.quad, *place.corner), corner) << id;
  }
}

/// Both judges on one mesh; returns our verdicts.
std::map<std::string, std::string> expect_agreement(const Case& c) {
  VerifyOptions options;
  const Report report = verify_points(c.points, c.mesh, options);
  options.always_compare_positions = true;
  EXPECT_EQ(to_json(report), to_json(verify_points(c.points, c.mesh, options)));
  const NaiveReport naive = naive_judge(c.points, c.mesh);
  std::map<std::string, std::string> verdicts;
  for (const Claim& claim : report.claims) {
    verdicts[claim.id] = name(claim.exact);
    if (claim.stored) verdicts[claim.id + " as stored"] = name(claim.stored->verdict);
    if (claim.id == "no-overlap") {
      expect_same_overlap(claim.exact, naive);
    } else if (claim.id != report.theorem) {
      EXPECT_EQ(name(claim.exact), name(naive.exact.at(claim.id))) << claim.id;
    }
    const auto stored = naive.stored.find(claim.id);
    EXPECT_EQ(claim.stored.has_value(), stored != naive.stored.end()) << claim.id;
    if (claim.stored && stored != naive.stored.end()) {
      EXPECT_EQ(name(claim.stored->verdict), name(stored->second)) << claim.id;
    }
  }
  expect_same_corners(report, naive);
  return verdicts;
}

/// How often each verdict on each claim was given.
using Tally = std::map<std::string, std::map<std::string, int>>;

/// Every claim must have been found to hold and to fail, and to be open where that is possible.
void expect_all_verdicts(Tally& tally) {
  for (auto& [claim, verdicts] : tally) {
    EXPECT_GE(verdicts["holds"], 50) << claim;
    EXPECT_GE(verdicts["fails"], 25) << claim;
    const bool is_stored = claim.find("stored") != std::string::npos;
    if (!is_stored && claim != "all-quad" && claim != "size-3N" && claim != "thm-1") {
      EXPECT_GE(verdicts["not-decided"], 50) << claim;
    }
  }
  EXPECT_GE(tally["min-angle as stored"]["within-rounding"], 50);
  EXPECT_GE(tally["max-angle as stored"]["within-rounding"], 50);
}

class Mutants : public testing::TestWithParam<int> {};

TEST_P(Mutants, BothJudgesAgreeOnEveryClaim) {
  const auto seed = static_cast<std::uint64_t>(GetParam());
  Random random(seed);
  const std::vector<Case> bases = valid_cases(seed);
  std::vector<std::map<std::string, std::string>> sound;
  for (const Case& base : bases) sound.push_back(expect_agreement(base));
  constexpr int kMutantsOfAKind = 180;
  Tally tally;
  for (const Kind& kind : kKinds) {
    int effective = 0;
    for (int i = 0; i < kMutantsOfAKind; ++i) {
      const std::size_t base = pick(random, bases.size());
      Case mutant = bases[base];
      kind.damage(mutant, random);
      SCOPED_TRACE(std::string(kind.name) + ", " + mutant.name + ", number " + std::to_string(i));
      const auto verdicts = expect_agreement(mutant);
      if (verdicts != sound[base]) ++effective;
      for (const auto& [claim, verdict] : verdicts) ++tally[claim][verdict];
      if (HasFailure()) return;
    }
    RecordProperty(kind.name, effective);
    if (kind.effective_percent == 0) {
      EXPECT_EQ(effective, 0) << kind.name;
    } else {
      EXPECT_GE(100 * effective, kind.effective_percent * kMutantsOfAKind) << kind.name;
    }
  }
  expect_all_verdicts(tally);
}

TEST_P(Mutants, BothJudgesAgreeOnMutantsOfMutants) {
  const auto seed = static_cast<std::uint64_t>(GetParam()) + 1000;
  Random random(seed);
  const std::vector<Case> bases = valid_cases(seed);
  for (int i = 0; i < 600; ++i) {
    Case mutant = bases[pick(random, bases.size())];
    std::string names;
    for (std::size_t k = 2 + pick(random, 3); k-- > 0;) {
      const Kind& kind = kKinds[pick(random, std::size(kKinds))];
      if (mutant.mesh.quads.empty()) break;
      bool exists = true;
      for (const Quad& q : mutant.mesh.quads)
        for (const VertexId v : q) exists &= v < mutant.mesh.vertices.size();
      if (!exists) break;
      kind.damage(mutant, random);
      names += std::string(kind.name) + ", ";
    }
    SCOPED_TRACE(names + mutant.name);
    expect_agreement(mutant);
    if (HasFailure()) return;
  }
}

// 4 * (29 * 180 + 600) = 23,280 mutants.
INSTANTIATE_TEST_SUITE_P(Seeds, Mutants, testing::Range(1, 5));

}  // namespace
}  // namespace quadbound::test
