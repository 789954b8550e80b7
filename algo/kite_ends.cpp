// SPDX-License-Identifier: Apache-2.0
#include "algo/kite_ends.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadbound::filling {
namespace {

/// The paper's v_k lies on an edge of B, this many parts of it from the side at most.
constexpr int kPartsOfEdge = 64;
constexpr int kMostParts = 32;
/// Of a relaxation.
constexpr int kMostSweeps = 60;

bool improve(EndSearch::Result& best, const EndSearch::Result& other) {
  if (!(other.slack > best.slack)) return false;
  best = other;
  return true;
}

}  // namespace

EndSearch::EndSearch(const Draft& draft, const Mesh& mesh, const QuadsAt& quads, const Side& side,
                     const Quad& last, VertexId tip)
    : line_(side.line),
      moving_(side.chain[side.steps()]),
      end_(side.end()),
      origin_(draft.at(moving_)),
      end_at_(draft.at(end_)),
      to_tip_(draft.between(end_, tip)) {
  to_tip_ = 1 / length(to_tip_) * to_tip_;
  add(draft, last);
  for (const std::uint32_t id : quads.at(moving_)) add(draft, mesh.quads[id]);
  for (const std::uint32_t id : quads.at(end_)) {
    const Quad& quad = mesh.quads[id];
    if (std::find(quad.begin(), quad.end(), moving_) == quad.end()) add(draft, quad);
  }
  previous_ = draft.between(moving_, side.chain[side.steps() - 1]);
}

EndSearch::Result EndSearch::along_edges() const {
  Result best;
  for (const LocalQuad& quad : quads_) {
    if (quad.moving < 0) continue;
    for (const int turn : {1, 3}) {
      const Vector neighbour = quad.at[static_cast<std::size_t>((quad.moving + turn) & 3)];
      if (is_on_side(neighbour)) continue;
      for (int part = 1; part <= kMostParts; ++part)
        improve(best, evaluate({(1.0 * part / kPartsOfEdge) * neighbour, 0}));
    }
  }
  return best;
}

EndSearch::Result EndSearch::in_plane(Result best) const {
  const double scale = length(end_at_ - origin_);
  const Vector found = best.slack > -1 ? on_lattice(best.moving) - origin_ : Vector{};
  // Where v_k bends the side by 8.13 degrees, 0.14 of its length, it is within the bound; so it
  // is where p comes nearer to the tip by as much.
  const std::array<Move, 6> starts{{{found, 0},
                                    {{}, 0.15 * scale},
                                    {{}, 0.3 * scale},
                                    {found, 0.1 * scale},
                                    {-0.1 * scale * to_tip_, 0},
                                    {-0.1 * scale * to_tip_, 0.15 * scale}}};
  for (const Move& start : starts)
    if (best.slack < kGoodSlack) improve(best, climb(start, scale));
  return best;
}

void EndSearch::add(const Draft& draft, const Quad& quad) {
  LocalQuad local;
  for (int k = 0; k < 4; ++k) {
    const VertexId v = quad[static_cast<std::size_t>(k)];
    local.at[static_cast<std::size_t>(k)] = draft.at(v) - origin_;
    if (v == moving_) local.moving = k;
    if (v == end_) local.end = k;
  }
  quads_.push_back(local);
}

bool EndSearch::is_on_side(Vector neighbour) const {
  const Vector end = end_at_ - origin_;
  return (neighbour.x == end.x && neighbour.y == end.y) ||
         (neighbour.x == previous_.x && neighbour.y == previous_.y);
}

/// The places that a move leads to, rounded as they will be, and what they are worth.
EndSearch::Result EndSearch::evaluate(const Move& move) const {
  Result result{1, nearest_lattice_point(origin_, move.moving), std::nullopt};
  const Vector moving = on_lattice(result.moving) - origin_;
  Vector end = end_at_ - origin_;
  if (move.slide != 0) {
    result.foot = line_.foot_near(end_at_, move.slide * to_tip_);
    end = end + line_.offset_to(*result.foot, end_at_, to_tip_);
  }
  for (const LocalQuad& quad : quads_) {
    if (quad.moving < 0 && !result.foot) continue;  // does not change
    std::array<Vector, 4> at = quad.at;
    if (quad.moving >= 0) at[static_cast<std::size_t>(quad.moving)] = moving;
    if (quad.end >= 0) at[static_cast<std::size_t>(quad.end)] = end;
    const double slack = quad_slack(at);
    if (!(slack >= result.slack)) result.slack = slack;
  }
  return result;
}

EndSearch::Result EndSearch::climb(Move here, double scale) const {
  Result best = evaluate(here);
  constexpr double kFinest = 0x1p-10;
  for (double step = scale / 8; step > kFinest * scale && best.slack < kGoodSlack;)
    if (!climb_once(here, step, best)) step /= 2;
  return best;
}

/// The best of the 26 neighbours of a move, if one is better.
bool EndSearch::climb_once(Move& here, double step, Result& best) const {
  const Move from = here;
  bool improved = false;
  for (int direction = 0; direction < 27; ++direction) {
    const int y = direction / 3 % 3;
    const int slide = direction / 9;
    const Move there{from.moving + step * Vector{direction % 3 - 1.0, y - 1.0},
                     from.slide + step * (slide - 1.0)};
    if (improve(best, evaluate(there))) {
      here = there;
      improved = true;
    }
  }
  return improved;
}

Relaxation::Relaxation(const Draft& draft, const Mesh& mesh, const QuadsAt& quads,
                       const std::vector<bool>& on_boundary, const Side& side, const Quad& last,
                       VertexId tip)
    : origin_(draft.at(side.chain[side.steps()])), end_(side.end()) {
  const VertexId moving = side.chain[side.steps()];
  const Vector to_tip = draft.between(end_, tip);
  to_tip_ = 1 / length(to_tip) * to_tip;
  scale_ = length(draft.between(moving, end_));
  free_ = {moving, end_};
  for (const VertexId center : {moving, end_})
    for (const std::uint32_t id : quads.at(center))
      for (const VertexId v : mesh.quads[id])
        if (!on_boundary[v] && std::find(free_.begin(), free_.end(), v) == free_.end())
          free_.push_back(v);
  add(draft, last);
  std::vector<std::uint32_t> ids;
  for (const VertexId v : free_) ids.insert(ids.end(), quads.at(v).begin(), quads.at(v).end());
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  for (const std::uint32_t id : ids) add(draft, mesh.quads[id]);
}

bool Relaxation::run() {
  const std::vector<Vector> before = at_;
  // The smaller is the least that brings v_k within the bound, see EndSearch.
  for (const double slide : {0.15, 0.25}) {
    at_ = before;
    position(end_) = position(end_) + slide * scale_ * to_tip_;
    for (int sweep = 0; sweep < kMostSweeps && worst() < kGoodSlack; ++sweep)
      for (const VertexId v : free_) improve(v);
    if (worst() >= kSmallestSlack) return true;
  }
  return false;
}

void Relaxation::add(const Draft& draft, const Quad& quad) {
  for (const VertexId v : quad) {
    if (std::find(ids_.begin(), ids_.end(), v) != ids_.end()) continue;
    ids_.push_back(v);
    at_.push_back(draft.at(v) - origin_);
  }
  std::array<std::size_t, 4> local{};
  for (std::size_t k = 0; k < 4; ++k) local[k] = index(quad[k]);
  quads_.push_back(local);
}

std::size_t Relaxation::index(VertexId vertex) const {
  return static_cast<std::size_t>(std::find(ids_.begin(), ids_.end(), vertex) - ids_.begin());
}

double Relaxation::slack(const std::array<std::size_t, 4>& quad) const {
  const double value =
      quad_slack(std::array<Vector, 4>{at_[quad[0]], at_[quad[1]], at_[quad[2]], at_[quad[3]]});
  return value >= -1 ? value : -1;  // -1 where vertices coincide
}

double Relaxation::worst() const {
  double result = 1;
  for (const auto& quad : quads_) result = std::min(result, slack(quad));
  return result;
}

double Relaxation::worst_at(std::size_t local) const {
  double result = 1;
  for (const auto& quad : quads_)
    if (std::find(quad.begin(), quad.end(), local) != quad.end())
      result = std::min(result, slack(quad));
  return result;
}

/// The shortest edge at a vertex: what it may move by.
double Relaxation::reach(std::size_t local) const {
  double result = std::numeric_limits<double>::infinity();
  for (const auto& quad : quads_) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (quad[k] != local) continue;
      result = std::min({result, length(at_[quad[(k + 1) & 3U]] - at_[local]),
                         length(at_[quad[(k + 3) & 3U]] - at_[local])});
    }
  }
  return result;
}

void Relaxation::improve(VertexId vertex) {
  const std::size_t local = index(vertex);
  double best = worst_at(local);
  const double largest = reach(local) / 2;
  constexpr double kFinest = 0x1p-8;
  for (double step = largest; step > kFinest * largest;)
    if (!step_once(local, vertex == end_, step, best)) step /= 2;
}

bool Relaxation::step_once(std::size_t local, bool on_line, double step, double& best) {
  const Vector from = at_[local];
  Vector found = from;
  for (int direction = 0; direction < 9; ++direction) {
    const int y = direction / 3;
    const Vector unit = on_line ? (y - 1.0) * to_tip_ : Vector{direction % 3 - 1.0, y - 1.0};
    at_[local] = from + step * unit;
    const double value = worst_at(local);
    if (value > best + kSmallestSlack) {
      best = value;
      found = at_[local];
    }
  }
  at_[local] = found;
  return found.x != from.x || found.y != from.y;
}

}  // namespace quadbound::filling
