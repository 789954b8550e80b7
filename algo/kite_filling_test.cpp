// SPDX-License-Identifier: Apache-2.0
#include "algo/kite_filling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "algo/construction.hpp"
#include "algo/kites.hpp"
#include "algo/point_separation.hpp"
#include "model/angle.hpp"
#include "model/validate.hpp"

namespace quadbound {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// A triangle with one tip that is cut off.
struct TipShape {
  double turn;     ///< of the edge that leaves the tip, in degrees
  double degrees;  ///< of the tip
  double q_length = 1;
};

Domain cut_tip(const TipShape& shape) {
  const auto at = [](double degrees, double length) {
    return Point{0.25 + length * std::cos(radians(degrees)),
                 -0.125 + length * std::sin(radians(degrees))};
  };
  const Polygon polygon = normalised(
      {"tip",
       {{{0.25, -0.125}, at(shape.turn, 1), at(shape.turn + shape.degrees, shape.q_length)}}});
  return cut_kites(polygon, place_root(polygon.rings.front()).root, {true, false, false});
}

bool is_within(const Vertices& vertices, const Quad& quad, VertexId exempt) {
  for (unsigned k = 0; k < 4; ++k) {
    if (quad[k] == exempt) continue;
    if (!within(corner_at<Rational>(vertices.exact(quad[k]), vertices.exact(quad[(k + 1) & 3U]),
                                    vertices.exact(quad[(k + 3) & 3U])),
                kTheorem13))
      return false;
  }
  return true;
}

/// What the band looks like on one side of the kite.
struct BandSide {
  std::size_t steiner;    ///< points between v and p
  double corner_degrees;  ///< between the side and the edge of B at p; 90: none but the boundary's
};

/// Quads along the two sides of a kite, as a mesh of the rest of the polygon might have them.
class Band {
 public:
  Band(const TipShape& shape, const BandSide& p, const BandSide& q, double disorder,
       std::uint64_t seed)
      : domain(cut_tip(shape)), disorder_(disorder), engine_(seed) {
    made.mesh.vertices = Vertices(domain.root().exponent);
    made.steiner.resize(domain.size());
    for (EdgeId i = 0; i < domain.size(); ++i)
      made.vertex_of.push_back(made.mesh.vertices.add_exact(domain.vertices().exact(i)));
    const Kite kite = domain.kites.front();
    const FinePoint v = domain.at(kite.v);
    const Vector to_p = domain.at(kite.p) - v;
    const Vector to_q = domain.at(kite.q) - v;
    const Vector middle = -1.0 * (1 / length(to_p) * to_p + 1 / length(to_q) * to_q);
    // The tip is on the other side of v than the middle of the reflex angle, or, where that is
    // nearly straight, across the sides.
    const Vector across = 1 / length(to_p) * turned_left(to_p);
    const Vector ahead = length(middle) > 0.05 ? 1 / length(middle) * middle : across;
    height_at_v_ = std::min(length(to_p) / static_cast<double>(p.steiner + 1) * width(p),
                            length(to_q) / static_cast<double>(q.steiner + 1) * width(q));
    opposite_v_ = add(v, height_at_v_ * ahead);
    add_side(p, kite.v, kite.p, kite.p, false);
    add_side(q, kite.q, kite.q, domain.previous(kite.q), true);
    made.mesh.construction.assign(made.mesh.quads.size(), 0);
    made.mesh.level.assign(made.mesh.quads.size(), 7);
  }

  [[nodiscard]] bool is_sound() const {
    return std::all_of(made.mesh.quads.begin(), made.mesh.quads.end(), [&](const Quad& quad) {
      return is_within(made.mesh.vertices, quad, kNoVertex);
    });
  }

  Domain domain;
  DomainMesh made;

 private:
  double jitter(double scale) {
    return disorder_ * scale * (static_cast<double>(engine_() >> 11) * 0x1p-52 - 1);
  }
  /// Of the band in spacings of the Steiner points: all of it is above the edge of B at p.
  static double width(const BandSide& side) {
    return side.corner_degrees == 90 ? 1
                                     : std::min(1.0, 0.6 * std::tan(radians(side.corner_degrees)));
  }
  VertexId add(const FinePoint& origin, Vector offset) {
    return made.mesh.vertices.add(nearest_lattice_point(origin, offset));
  }
  VertexId add_foot(EdgeId e, const FinePoint& origin, Vector offset) {
    const LatticePoint near = nearest_lattice_point(origin, offset);
    return made.mesh.vertices.add_exact(
        domain.foot_exact(e, domain.runs_in_x(e) ? near.x : near.y));
  }
  void add_quad(bool mirrored, Quad quad) {
    if (mirrored) std::reverse(quad.begin(), quad.end());
    made.mesh.quads.push_back(quad);
  }

  /// `side` is the edge of the domain along the kite, `line` that along the polygon.
  void add_side(const BandSide& band, EdgeId side, EdgeId end, EdgeId line, bool mirrored) {
    const Kite kite = domain.kites.front();
    const FinePoint foot = domain.at(end);
    const Vector to_v = domain.at(kite.v) - foot;
    const double height = length(to_v) / static_cast<double>(band.steiner + 1);
    const Vector up = 1 / length(to_v) * to_v;
    const Vector out = mirrored ? turned_left(up) : -1.0 * turned_left(up);
    std::vector<VertexId> chain{made.vertex_of[kite.v]};
    std::vector<VertexId> opposite{opposite_v_};
    for (std::size_t i = 1; i <= band.steiner; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(band.steiner + 1);
      const double across = (1 - part) * height_at_v_ + part * height * width(band);
      const double y = (1 - part) * length(to_v) + jitter(0.35 * height);
      chain.push_back(add_foot(side, foot, y * up));
      opposite.push_back(
          add(foot, (across + jitter(0.3 * across)) * out + (y + jitter(0.3 * height)) * up));
    }
    made.steiner[side].assign(chain.begin() + 1, chain.end());
    if (mirrored) std::reverse(made.steiner[side].begin(), made.steiner[side].end());
    chain.push_back(made.vertex_of[end]);
    const Vector step = 0.5 * height * out;
    const VertexId beside = add_foot(line, foot, step);
    if (band.corner_degrees == 90) {
      opposite.push_back(beside);
    } else {
      const double angle = radians(band.corner_degrees);
      const Vector edge = 0.5 * height * (std::sin(angle) * out + std::cos(angle) * up);
      opposite.push_back(add(foot, edge));
      add_quad(mirrored, {chain.back(), beside, add(foot, edge + step), opposite.back()});
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      add_quad(mirrored, {chain[i + 1], opposite[i + 1], opposite[i], chain[i]});
  }

  double disorder_;
  std::mt19937_64 engine_;
  double height_at_v_ = 0;
  VertexId opposite_v_ = 0;
};

/// The most disordered of some bands that is a mesh within the bounds.
std::optional<Band> sound_band(const TipShape& shape, const BandSide& p, const BandSide& q,
                               std::uint64_t seed) {
  for (std::uint64_t attempt = 0; attempt < 20; ++attempt) {
    Band band(shape, p, q, 1 - 0.05 * static_cast<double>(attempt), 20 * seed + attempt);
    if (band.is_sound()) return band;
  }
  return std::nullopt;
}

using Edges = std::set<std::pair<VertexId, VertexId>>;

/// The directed edges that no other quad has in the other direction. Each may occur once.
Edges boundary(const Mesh& mesh) {
  Edges all;
  for (const Quad& quad : mesh.quads) {
    for (unsigned k = 0; k < 4; ++k) EXPECT_TRUE(all.emplace(quad[k], quad[(k + 1) & 3U]).second);
  }
  Edges result;
  for (const auto& [a, b] : all)
    if (!all.contains({b, a})) result.emplace(a, b);
  return result;
}

Rational area(const Mesh& mesh) {
  Rational sum = 0;
  for (const Quad& quad : mesh.quads) {
    for (unsigned k = 0; k < 4; ++k) {
      const RationalPoint a = mesh.vertices.exact(quad[k]);
      const RationalPoint b = mesh.vertices.exact(quad[(k + 1) & 3U]);
      sum += a.x * b.y - a.y * b.x;
    }
  }
  return sum;
}

Rational cross(const RationalPoint& at, const RationalPoint& a, const RationalPoint& b) {
  return (a.x - at.x) * (b.y - at.y) - (a.y - at.y) * (b.x - at.x);
}
Rational dot(const RationalPoint& at, const RationalPoint& a, const RationalPoint& b) {
  return (a.x - at.x) * (b.x - at.x) + (a.y - at.y) * (b.y - at.y);
}

/// The new part of the boundary runs along the polygon: from q straight to a and straight to p.
void expect_boundary_kept(const Band& band, const DomainMesh& before, const DomainMesh& after,
                          VertexId tip) {
  const Kite kite = band.domain.kites.front();
  const RationalPoint p = before.mesh.vertices.exact(after.vertex_of[kite.p]);
  const RationalPoint q = before.mesh.vertices.exact(after.vertex_of[kite.q]);
  std::map<VertexId, VertexId> next;
  const Edges old = boundary(before.mesh);
  for (const auto& [a, b] : boundary(after.mesh))
    if (!old.contains({a, b})) next[a] = b;
  std::size_t count = 0;
  bool behind_tip = false;
  for (VertexId at = after.vertex_of[kite.q]; at != after.vertex_of[kite.p]; ++count) {
    ASSERT_TRUE(next.contains(at));
    ASSERT_LE(count, next.size());
    const RationalPoint from = after.mesh.vertices.exact(at);
    const RationalPoint to = after.mesh.vertices.exact(next[at]);
    behind_tip = behind_tip || at == tip;
    EXPECT_EQ(cross(kite.a, to, behind_tip ? p : q), 0);
    EXPECT_EQ(cross(kite.a, from, behind_tip ? p : q), 0);
    // Towards the tip, and then away from it.
    EXPECT_EQ(dot(kite.a, from, from) < dot(kite.a, to, to), behind_tip);
    at = next[at];
  }
  EXPECT_EQ(count, next.size());
  EXPECT_TRUE(behind_tip);
  // All of the kite's sides are inside now.
  std::size_t sides = 2 + after.steiner[kite.q].size() + after.steiner[kite.v].size();
  EXPECT_EQ(boundary(after.mesh).size(), old.size() - sides + count);
}

Rational kite_area(const Band& band) {
  const Kite kite = band.domain.kites.front();
  const Vertices& vertices = band.domain.vertices();
  const RationalPoint v = vertices.exact(kite.v);
  return cross(kite.a, vertices.exact(kite.p), v) + cross(kite.a, v, vertices.exact(kite.q));
}

void expect_filled(Band& band, KiteCounters& total) {
  const DomainMesh before = band.made;
  const KiteFilling filling = fill_kites(band.domain, band.made);
  ASSERT_TRUE(filling.failed.empty());
  const Mesh& mesh = band.made.mesh;
  VertexId tip = kNoVertex;
  for (VertexId v = 0; v < mesh.vertices.size(); ++v)
    if (mesh.vertices.exact(v) == band.domain.kites.front().a) tip = v;
  ASSERT_NE(tip, kNoVertex);
  for (const Quad& quad : mesh.quads) ASSERT_TRUE(is_within(mesh.vertices, quad, tip));
  expect_boundary_kept(band, before, band.made, tip);
  EXPECT_EQ(area(mesh), area(before.mesh) + kite_area(band));
  EXPECT_EQ(mesh.construction.size(), mesh.quads.size());
  EXPECT_EQ(mesh.level.size(), mesh.quads.size());
  EXPECT_EQ(mesh.level.back(), 7);
  EXPECT_GE(mesh.construction.back(), number_of(StripConstruction::kKiteWhole));
  total.whole += filling.counters.whole;
  total.plain_sides += filling.counters.plain_sides;
  total.stepped_sides += filling.counters.stepped_sides;
  total.moved_along_edge += filling.counters.moved_along_edge;
  total.moved_in_plane += filling.counters.moved_in_plane;
  total.moved_with_neighbours += filling.counters.moved_with_neighbours;
}

TEST(FillKites, AllTipsSidesAndCorners) {
  KiteCounters total;
  std::size_t tried = 0;
  std::size_t sound = 0;
  for (const double tip : {89.0, 60.0, 30.0, 10.0, 8.0, 1.0, 0.1, 0.01, 1e-4, 1e-6}) {
    for (const double turn : {0.0, 31.0, 225.0}) {
      for (const std::size_t at_p : {0U, 1U, 3U, 10U}) {
        for (const std::size_t at_q : {0U, 1U, 2U, 10U}) {
          for (const double corner : {90.0, 60.0, 45.0, 27.0}) {
            std::optional<Band> band = sound_band({turn, tip}, {at_p, corner}, {at_q, 45}, ++tried);
            if (!band) continue;
            ++sound;
            SCOPED_TRACE(testing::Message()
                         << tip << " " << turn << " " << at_p << " " << at_q << " " << corner);
            expect_filled(*band, total);
          }
        }
      }
    }
  }
  RecordProperty("tried", static_cast<int>(tried));
  RecordProperty("sound", static_cast<int>(sound));
  RecordProperty("along_edge", static_cast<int>(total.moved_along_edge));
  RecordProperty("in_plane", static_cast<int>(total.moved_in_plane));
  RecordProperty("whole", static_cast<int>(total.whole));
  EXPECT_GT(sound, tried / 4);
  EXPECT_GT(total.whole, 0U);
  EXPECT_GT(total.plain_sides, 0U);
  EXPECT_GT(total.moved_along_edge, 0U);
  EXPECT_GT(total.moved_in_plane, 0U);
  EXPECT_EQ(total.moved_along_edge + total.moved_in_plane + total.moved_with_neighbours,
            total.stepped_sides);
}

TEST(FillKites, UnequalEdgesAndDisorder) {
  KiteCounters total;
  std::size_t sound = 0;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    const double tip = std::exp2(-static_cast<double>(seed % 11)) * 88;
    const double q_length = 0.3 + static_cast<double>(seed % 5) * 0.4;
    std::optional<Band> band =
        sound_band({static_cast<double>(seed * 37 % 360), tip, q_length},
                   {seed % 4, 90 - 7.0 * static_cast<double>(seed % 10)},
                   {seed / 4 % 6, 27 + 9.0 * static_cast<double>(seed / 7 % 8)}, seed);
    if (!band) continue;
    ++sound;
    SCOPED_TRACE(seed);
    expect_filled(*band, total);
  }
  RecordProperty("sound", static_cast<int>(sound));
  EXPECT_GT(sound, 100U);
}

TEST(FillKites, AVertexOfBCloseToTheSide) {
  for (const double closeness : {0.01, 0.001}) {
    Band band({33, 40}, {3, 45}, {1, 60}, 0, 1);
    Mesh& mesh = band.made.mesh;
    // The quads at p and at v_k, in the order in which they were added.
    const Quad corner = mesh.quads[0];
    const Quad last = mesh.quads[4];
    const Quad before_last = mesh.quads[3];
    const Kite kite = band.domain.kites.front();
    const FinePoint p = band.domain.at(kite.p);
    const Vector up = 0.25 * (band.domain.at(kite.v) - p);
    const Vector out = -1.0 * turned_left(up);
    const auto put = [&](VertexId vertex, double x, double y) {
      mesh.vertices.move_to(vertex, nearest_lattice_point(p, x * out + y * up));
    };
    // v_k at (0, 1) cannot leave the side, p cannot come nearer to the tip: the quad beside it has
    // an angle of 168 degrees that would grow.
    put(last[2], closeness, 1);
    put(last[1], 0.5, 0.5);
    put(before_last[2], 0.5, 1.5);
    put(corner[2], 0.92, 0.77);
    ASSERT_TRUE(band.is_sound());
    const Mesh before = mesh;
    const KiteFilling filling = fill_kites(band.domain, band.made);
    ASSERT_TRUE(filling.failed.empty());
    EXPECT_EQ(filling.counters.moved_with_neighbours, 1U);
    const VertexId tip = static_cast<VertexId>(before.vertices.size());
    for (const Quad& quad : mesh.quads) EXPECT_TRUE(is_within(mesh.vertices, quad, tip));
    for (const VertexId v : band.made.vertex_of) {
      if (v == band.made.vertex_of[kite.p]) continue;
      EXPECT_EQ(mesh.vertices.exact(v), before.vertices.exact(v));
    }
  }
}

TEST(FillKites, AKiteThatFailsLeavesTheMeshAsItWas) {
  std::optional<Band> band = sound_band({11, 20}, {2, 45}, {1, 60}, 1);
  ASSERT_TRUE(band);
  // A quad at p and v_k that no place of these two can bring within the bounds.
  Mesh& mesh = band->made.mesh;
  const Kite kite = band->domain.kites.front();
  const VertexId moving = band->made.steiner[kite.v].back();
  for (const Quad& quad : mesh.quads) {
    for (unsigned k = 0; k < 4; ++k) {
      if (quad[k] == moving && quad[(k + 1) & 3U] == band->made.vertex_of[kite.p])
        mesh.vertices.move_to(quad[(k + 2) & 3U], mesh.vertices.lattice(quad[(k + 3) & 3U]));
    }
  }
  const DomainMesh before = band->made;
  const KiteFilling filling = fill_kites(band->domain, band->made);
  EXPECT_EQ(filling.failed, std::vector<std::size_t>{0});
  EXPECT_EQ(filling.counters.stepped_sides, 0U);
  EXPECT_EQ(mesh.quads, before.mesh.quads);
  EXPECT_EQ(mesh.level, before.mesh.level);
  EXPECT_EQ(mesh.construction, before.mesh.construction);
  ASSERT_EQ(mesh.vertices.size(), before.mesh.vertices.size());
  for (VertexId v = 0; v < mesh.vertices.size(); ++v)
    EXPECT_EQ(mesh.vertices.exact(v), before.mesh.vertices.exact(v));
}

}  // namespace
}  // namespace quadbound
