// SPDX-License-Identifier: Apache-2.0
#include "algo/kite_filling.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "algo/construction.hpp"
#include "algo/kite_draft.hpp"
#include "algo/kite_ends.hpp"

namespace quadbound {
namespace {

using filling::Draft;
using filling::EdgeLine;
using filling::EndSearch;
using filling::fine_point;
using filling::kGoodSlack;
using filling::kSmallestSlack;
using filling::Place;
using filling::QuadsAt;
using filling::Relaxation;
using filling::Side;

void append_sides(const DomainMesh& made, const Kite& kite, std::vector<VertexId>& vertices) {
  for (const EdgeId i : {kite.q, kite.v, kite.p}) vertices.push_back(made.vertex_of[i]);
  for (const EdgeId side : {kite.q, kite.v})
    vertices.insert(vertices.end(), made.steiner[side].begin(), made.steiner[side].end());
}

Quad oriented(const Side& side, const Quad& quad) {
  return side.mirrored ? Quad{quad[3], quad[2], quad[1], quad[0]} : quad;
}

/// What is known of the mesh around kites.
struct Surroundings {
  QuadsAt quads;
  /// By vertex of the mesh; empty where vertices of the inside must stay. Otherwise `quads` has
  /// those of all quads at v_k and p.
  std::vector<bool> on_boundary;
};

/// Fills one kite.
class KiteFiller {
 public:
  KiteFiller(const Domain& domain, DomainMesh& made, const Surroundings& around, const Kite& kite,
             KiteShape shape, KiteFilling& filling)
      : mesh_(made.mesh),
        around_(around),
        shape_(shape),
        filling_(filling),
        counters_(filling.counters),
        draft_(made.mesh),
        tip_(draft_.add({fine_point(kite.a, domain.root().exponent), kite.a})),
        p_{EdgeLine(domain, kite.p), {made.vertex_of[kite.v]}, false, made.vertex_of[kite.p], {}},
        q_{EdgeLine(domain, domain.previous(kite.q)),
           {made.vertex_of[kite.v]},
           true,
           made.vertex_of[kite.q],
           {}},
        exponent_(domain.root().exponent) {
    const std::vector<VertexId>& on_p = made.steiner[kite.v];
    const std::vector<VertexId>& on_q = made.steiner[kite.q];
    p_.chain.insert(p_.chain.end(), on_p.begin(), on_p.end());
    p_.chain.push_back(p_.first_step);
    q_.chain.insert(q_.chain.end(), on_q.rbegin(), on_q.rend());
    q_.chain.push_back(q_.first_step);
    for (Side* side : {&p_, &q_}) side->foot = draft_.at(side->end());
  }

  bool fill() && {
    const std::uint8_t level = finest_level();
    const KiteCounters before = counters_;
    if (!fill_whole()) {
      for (Side* side : {&p_, &q_})
        if (!fill_side(*side)) return forget(before);
      fill_tip();
    }
    if (!draft_.is_within_bounds(tip_)) {
      if (shape_ == KiteShape::kOurs) return forget(before);
      ++filling_.outside;
    }
    std::move(draft_).carry_out(mesh_, level);
    return true;
  }

 private:
  bool forget(const KiteCounters& before) {
    counters_ = before;
    return false;
  }

  [[nodiscard]] std::uint8_t finest_level() const {
    std::uint8_t level = 0;
    if (mesh_.level.empty()) return level;
    for (const Side* side : {&p_, &q_})
      for (const VertexId v : side->chain)
        for (const std::uint32_t id : around_.quads.at(v)) level = std::max(level, mesh_.level[id]);
    return level;
  }

  /// One quad, where its angle at v, 180 degrees less that at the tip, is within the bound.
  bool fill_whole() {
    if (p_.steps() + q_.steps() != 0) return false;
    const Quad quad{tip_, p_.end(), p_.chain.front(), q_.end()};
    if (shape_ == KiteShape::kOurs && !draft_.is_within(quad, tip_)) return false;
    draft_.add_quad(quad, StripConstruction::kKiteWhole);
    ++counters_.whole;
    return true;
  }

  /// The quads between a side and the polygon's edge, p_1 to p. False where v_k finds no place.
  bool fill_side(Side& side) {
    const std::size_t steps = side.steps();
    ++(steps == 0 ? counters_.plain_sides : counters_.stepped_sides);
    if (steps == 0) return true;
    std::vector<VertexId> feet = add_feet(side);
    side.first_step = feet.front();
    feet.push_back(side.end());
    for (std::size_t i = 0; i < steps; ++i)
      draft_.add_quad(oriented(side, quad_of(side, feet, i)), StripConstruction::kKiteSide);
    return settle_end(side, oriented(side, quad_of(side, feet, steps - 1)));
  }

  /// (p_i, p_{i+1}, v_i, v_{i-1}), from i = 1 in the paper. p follows p_k.
  static Quad quad_of(const Side& side, const std::vector<VertexId>& feet, std::size_t i) {
    return {feet[i], feet[i + 1], side.chain[i + 1], side.chain[i]};
  }

  /// p_1 to p_k: from v, v_1, ... parallel to the bisector of the angle between v-p and v-a. They
  /// make angles between 22.5 and 45 degrees with the side.
  std::vector<VertexId> add_feet(const Side& side) {
    const VertexId v = side.chain.front();
    const Vector to_end = draft_.between(v, side.end());
    const Vector to_tip = draft_.between(v, tip_);
    const Vector bisector = 1 / length(to_end) * to_end + 1 / length(to_tip) * to_tip;
    const Vector edge = unit_to_tip(side);
    // to_end + x edge is on the bisector.
    const double part = -cross(to_end, bisector) / cross(edge, bisector) / length(to_end);
    std::vector<VertexId> feet;
    const FinePoint end = draft_.at(side.end());
    for (std::size_t i = 0; i < side.steps(); ++i) {
      const double distance = part * length(end - draft_.at(side.chain[i]));
      feet.push_back(draft_.add(side.line.place(side.line.foot_near(end, distance * edge))));
    }
    return feet;
  }

  [[nodiscard]] Vector unit_to_tip(const Side& side) const {
    const Vector edge = draft_.at(tip_) - side.foot;
    return 1 / length(edge) * edge;
  }

  bool settle_end(const Side& side, const Quad& last) {
    const VertexId moving = side.chain[side.steps()];
    const EndSearch search(draft_, mesh_, around_.quads, side, last, tip_);
    EndSearch::Result result = search.along_edges();
    if (shape_ == KiteShape::kPaper) return move_along_edge(moving, result);
    const bool is_good = result.slack >= kGoodSlack;
    if (!is_good) result = search.in_plane(result);
    if (!(result.slack >= kSmallestSlack)) return !around_.on_boundary.empty() && relax(side, last);
    ++(is_good ? counters_.moved_along_edge : counters_.moved_in_plane);
    draft_.move(moving, on_lattice_place(result.moving), around_.quads.at(moving));
    if (result.foot)
      draft_.move(side.end(), side.line.place(*result.foot), around_.quads.at(side.end()));
    return true;
  }

  /// v_k stays where it is, with its 180 degrees, if no place along an edge of B was found.
  bool move_along_edge(VertexId moving, const EndSearch::Result& result) {
    if (result.slack <= -1) return true;
    ++counters_.moved_along_edge;
    draft_.move(moving, on_lattice_place(result.moving), around_.quads.at(moving));
    return true;
  }

  bool relax(const Side& side, const Quad& last) {
    Relaxation relaxation(draft_, mesh_, around_.quads, around_.on_boundary, side, last, tip_);
    if (!relaxation.run()) return false;
    ++counters_.moved_with_neighbours;
    for (const VertexId v : relaxation.free()) {
      const Vector offset = relaxation.offset(v);
      const Place place =
          v == side.end() ? side.line.place(side.line.foot_near(relaxation.origin(), offset))
                          : on_lattice_place(nearest_lattice_point(relaxation.origin(), offset));
      draft_.move(v, place, around_.quads.at(v));
    }
    return true;
  }

  [[nodiscard]] Place on_lattice_place(LatticePoint point) const {
    return {on_lattice(point), {dyadic(point.x, exponent_), dyadic(point.y, exponent_)}};
  }

  /// The quad at the tip and the two beside it. With p' and q' at the feet of v', as in the paper,
  /// the angle at v' is 180 degrees less that at the tip: beyond the bound for tips below 8.13
  /// degrees. So p' and q' are nearer to the tip by a quarter of their distance from v', which
  /// turns the edges to v' by arctan(1/4) = 14.04 degrees and leaves 152 less the tip at v'. Not so
  /// with KiteShape::kPaper.
  ///
  /// Each of the three is measured from the one before, see `place` in kites.cpp.
  void fill_tip() {
    const double scale = 0.5 * std::min(part_at_first_step(p_), part_at_first_step(q_));
    const double nearer = shape_ == KiteShape::kPaper ? 0 : 0.25;
    const VertexId v = p_.chain.front();
    const auto across = [&](const Side& side) {
      const Vector to_v = draft_.at(v) - side.foot;
      return scale * (to_v - nearer * length(to_v) * unit_to_tip(side));
    };
    const Vector to_p = p_.foot - draft_.at(tip_);
    const double part = scale * (1 - nearer * length(draft_.at(v) - p_.foot) / length(to_p));
    const FinePoint tip = draft_.at(tip_);
    const VertexId p = draft_.add(p_.line.place(p_.line.foot_near(tip, part * to_p)));
    const VertexId middle =
        draft_.add(on_lattice_place(nearest_lattice_point(draft_.at(p), across(p_))));
    const VertexId q =
        draft_.add(q_.line.place(q_.line.foot_near(draft_.at(middle), -1.0 * across(q_))));
    draft_.add_quad({tip_, p, middle, q}, StripConstruction::kKiteTip);
    draft_.add_quad({p, p_.first_step, v, middle}, StripConstruction::kKiteWing);
    draft_.add_quad({middle, v, q_.first_step, q}, StripConstruction::kKiteWing);
  }

  /// |a p_1| as a part of |a p|.
  [[nodiscard]] double part_at_first_step(const Side& side) const {
    return std::min(
        1.0, length(draft_.between(tip_, side.first_step)) / length(side.foot - draft_.at(tip_)));
  }

  Mesh& mesh_;
  const Surroundings& around_;
  KiteShape shape_;
  KiteFilling& filling_;
  KiteCounters& counters_;
  Draft draft_;
  VertexId tip_;
  Side p_;
  Side q_;
  int exponent_;
};

Surroundings sides_of(const Domain& domain, const DomainMesh& made) {
  std::vector<VertexId> vertices;
  for (const Kite& kite : domain.kites) append_sides(made, kite, vertices);
  return {QuadsAt(made.mesh, vertices), {}};
}

/// With the vertices of the quads at v_k and p.
Surroundings wide_surroundings(const Domain& domain, const DomainMesh& made, const QuadsAt& quads,
                               const std::vector<std::size_t>& kites) {
  std::vector<VertexId> vertices;
  for (const std::size_t i : kites) {
    const Kite& kite = domain.kites[i];
    append_sides(made, kite, vertices);
    std::vector<VertexId> centres{made.vertex_of[kite.p], made.vertex_of[kite.q]};
    if (!made.steiner[kite.v].empty()) centres.push_back(made.steiner[kite.v].back());
    if (!made.steiner[kite.q].empty()) centres.push_back(made.steiner[kite.q].front());
    for (const VertexId centre : centres) {
      for (const std::uint32_t id : quads.at(centre)) {
        const Quad& quad = made.mesh.quads[id];
        vertices.insert(vertices.end(), quad.begin(), quad.end());
      }
    }
  }
  std::vector<bool> on_boundary(made.mesh.vertices.size(), false);
  for (const VertexId v : made.vertex_of) on_boundary[v] = true;
  for (const std::vector<VertexId>& on_edge : made.steiner)
    for (const VertexId v : on_edge) on_boundary[v] = true;
  return {QuadsAt(made.mesh, vertices), std::move(on_boundary)};
}

/// Returns those of the kites that fail.
std::vector<std::size_t> fill(const Domain& domain, DomainMesh& made, const Surroundings& around,
                              const std::vector<std::size_t>& kites, KiteShape shape,
                              KiteFilling& filling) {
  std::vector<std::size_t> failed;
  for (const std::size_t i : kites)
    if (!KiteFiller(domain, made, around, domain.kites[i], shape, filling).fill())
      failed.push_back(i);
  return failed;
}

}  // namespace

KiteFilling fill_kites(const Domain& domain, DomainMesh& made, KiteShape shape) {
  KiteFilling filling;
  filling.failed.resize(domain.kites.size());
  std::iota(filling.failed.begin(), filling.failed.end(), std::size_t{0});
  if (filling.failed.empty()) return filling;
  const Surroundings sides = sides_of(domain, made);
  filling.failed = fill(domain, made, sides, filling.failed, shape, filling);
  if (filling.failed.empty()) return filling;
  const Surroundings wide = wide_surroundings(domain, made, sides.quads, filling.failed);
  filling.failed = fill(domain, made, wide, filling.failed, shape, filling);
  return filling;
}

}  // namespace quadbound
