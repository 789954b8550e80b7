// SPDX-License-Identifier: Apache-2.0
#include "algo/kite_filling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "algo/construction.hpp"
#include "model/angle.hpp"

namespace quadbound {
namespace {

/// What the search asks of a quad: far above the rounding of quad_slack (about 2^-46), so that the
/// exact test that follows agrees, and too little to be seen.
constexpr double kSmallestSlack = 1e-9;
/// Where the search for v_k stops: the sine of one degree. In the tightest corner that B may have
/// at p, arctan(1/2) beside the side, the best place leaves about two.
constexpr double kGoodSlack = 0.01745;
/// The paper's v_k lies on an edge of B, this many parts of it from the side at most.
constexpr int kPartsOfEdge = 64;
constexpr int kMostParts = 32;

/// A place for a vertex, for the search and exactly.
struct Place {
  FinePoint at;
  RationalPoint exact;
};

FinePoint fine_point(const RationalPoint& point, int exponent) {
  const Rational unit = dyadic(1, exponent);
  const auto split = [&](const Rational& value) {
    const LatticeFloor floor = *lattice_floor(value, exponent);
    const double fraction =
        floor.exact ? 0.0 : nearest_double(Rational(value / unit - Rational(floor.floor)));
    return std::pair(floor.floor, fraction);
  };
  const auto [x, x_fraction] = split(point.x);
  const auto [y, y_fraction] = split(point.y);
  return {{x, y}, {x_fraction, y_fraction}};
}

/// Which quads some vertices belong to.
class QuadsAt {
 public:
  QuadsAt(const Mesh& mesh, std::span<const VertexId> vertices)
      : slot_(mesh.vertices.size(), kNone) {
    for (const VertexId v : vertices) {
      if (slot_[v] != kNone) continue;
      slot_[v] = static_cast<std::uint32_t>(quads_.size());
      quads_.emplace_back();
    }
    for (std::uint32_t id = 0; id < mesh.quads.size(); ++id) {
      for (const VertexId v : mesh.quads[id])
        if (slot_[v] != kNone) quads_[slot_[v]].push_back(id);
    }
  }

  [[nodiscard]] std::span<const std::uint32_t> at(VertexId vertex) const {
    return quads_[slot_[vertex]];
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::uint32_t> slot_;
  std::vector<std::vector<std::uint32_t>> quads_;
};

void append_sides(const DomainMesh& made, const Kite& kite, std::vector<VertexId>& vertices) {
  for (const EdgeId i : {kite.q, kite.v, kite.p}) vertices.push_back(made.vertex_of[i]);
  for (const EdgeId side : {kite.q, kite.v})
    vertices.insert(vertices.end(), made.steiner[side].begin(), made.steiner[side].end());
}

/// New vertices and quads, and moves of old vertices, that are tried before the mesh changes.
class Draft {
 public:
  explicit Draft(const Mesh& mesh) : mesh_(mesh) {}

  VertexId add(Place place) {
    added_.push_back(std::move(place));
    return static_cast<VertexId>(mesh_.vertices.size() + added_.size() - 1);
  }
  void move(VertexId vertex, Place place, std::span<const std::uint32_t> quads) {
    moved_.emplace_back(vertex, std::move(place));
    for (const std::uint32_t id : quads)
      if (std::find(changed_.begin(), changed_.end(), id) == changed_.end()) changed_.push_back(id);
  }
  void add_quad(const Quad& quad, StripConstruction construction) {
    quads_.emplace_back(quad, construction);
  }

  [[nodiscard]] FinePoint at(VertexId vertex) const {
    if (const Place* place = find(vertex)) return place->at;
    if (mesh_.vertices.on_lattice(vertex)) return on_lattice(mesh_.vertices.lattice(vertex));
    return fine_point(mesh_.vertices.exact(vertex), mesh_.vertices.exponent());
  }
  [[nodiscard]] Vector between(VertexId from, VertexId to) const { return at(to) - at(from); }

  /// All quads that are new or have moved, but for the angle at the tip. Exact.
  [[nodiscard]] bool is_within_bounds(VertexId tip) const {
    return std::all_of(quads_.begin(), quads_.end(),
                       [&](const auto& quad) { return is_within(quad.first, tip); }) &&
           std::all_of(changed_.begin(), changed_.end(),
                       [&](std::uint32_t id) { return is_within(mesh_.quads[id], tip); });
  }
  [[nodiscard]] bool is_within(const Quad& quad, VertexId tip) const {
    std::array<RationalPoint, 4> at;
    for (unsigned k = 0; k < 4; ++k) at[k] = exact(quad[k]);
    for (unsigned k = 0; k < 4; ++k) {
      if (quad[k] == tip) continue;
      if (!within(corner_at<Rational>(at[k], at[(k + 1) & 3U], at[(k + 3) & 3U]), kTheorem13))
        return false;
    }
    return true;
  }

  void carry_out(Mesh& mesh, std::uint8_t level) && {
    for (const Place& place : added_) mesh.vertices.add_exact(place.exact);
    for (const auto& [vertex, place] : moved_) mesh.vertices.move_to_exact(vertex, place.exact);
    const bool has_construction = !mesh.construction.empty();
    const bool has_level = !mesh.level.empty();
    for (const auto& [quad, construction] : quads_) {
      mesh.quads.push_back(quad);
      if (has_construction) mesh.construction.push_back(number_of(construction));
      if (has_level) mesh.level.push_back(level);
    }
  }

 private:
  [[nodiscard]] const Place* find(VertexId vertex) const {
    if (vertex >= mesh_.vertices.size()) return &added_[vertex - mesh_.vertices.size()];
    const auto found = std::find_if(moved_.begin(), moved_.end(),
                                    [&](const auto& move) { return move.first == vertex; });
    return found == moved_.end() ? nullptr : &found->second;
  }
  [[nodiscard]] RationalPoint exact(VertexId vertex) const {
    const Place* place = find(vertex);
    return place != nullptr ? place->exact : mesh_.vertices.exact(vertex);
  }

  const Mesh& mesh_;
  std::vector<Place> added_;
  std::vector<std::pair<VertexId, Place>> moved_;  ///< a few
  std::vector<std::uint32_t> changed_;
  std::vector<std::pair<Quad, StripConstruction>> quads_;
};

/// An edge of the polygon at the tip, as an edge of the domain on the same line.
class EdgeLine {
 public:
  EdgeLine(const Domain& domain, EdgeId e) : domain_(&domain), edge_(e) {}

  /// Number of the point of the line near origin + offset, see Domain::foot.
  [[nodiscard]] std::int64_t foot_near(const FinePoint& origin, Vector offset) const {
    const LatticePoint near = nearest_lattice_point(origin, offset);
    return domain_->runs_in_x(edge_) ? near.x : near.y;
  }
  /// From a point of the line to a foot. `along` is any direction along the line.
  [[nodiscard]] Vector offset_to(std::int64_t foot, const FinePoint& origin, Vector along) const {
    const bool x = domain_->runs_in_x(edge_);
    const double distance = x ? static_cast<double>(foot - origin.floor.x) - origin.fraction.x
                              : static_cast<double>(foot - origin.floor.y) - origin.fraction.y;
    return distance / (x ? along.x : along.y) * along;
  }
  [[nodiscard]] Place place(std::int64_t foot) const {
    return {domain_->foot_point(edge_, foot), domain_->foot_exact(edge_, foot)};
  }

 private:
  const Domain* domain_;
  EdgeId edge_;
};

/// One half of a kite, named as the half at p.
struct Side {
  EdgeLine line;
  std::vector<VertexId> chain;  ///< v, v_1, ..., v_k, p
  bool mirrored;                ///< the half at q
  VertexId first_step;          ///< p_1; p where nothing is between v and p
  FinePoint foot;               ///< p where it was

  [[nodiscard]] std::size_t steps() const { return chain.size() - 2; }
  [[nodiscard]] VertexId end() const { return chain.back(); }
};

Quad oriented(const Side& side, const Quad& quad) {
  return side.mirrored ? Quad{quad[3], quad[2], quad[1], quad[0]} : quad;
}

/// Searches a place for v_k, which would have an angle of 180 degrees, and for p.
class EndSearch {
 public:
  EndSearch(const Draft& draft, const Mesh& mesh, const QuadsAt& quads, const Side& side,
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

  struct Result {
    double slack = -1;
    LatticePoint moving;
    std::optional<std::int64_t> foot;  ///< where p goes; nullopt where it stays
  };

  [[nodiscard]] Result along_edges() const {
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

  /// A pattern search from several places; `best` is where to begin.
  [[nodiscard]] Result in_plane(Result best) const {
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

 private:
  struct LocalQuad {
    std::array<Vector, 4> at;  ///< from v_k where it is now
    int moving = -1;           ///< the corner that is v_k, that is p
    int end = -1;
  };
  /// From where they are: v_k in the plane, p towards the tip.
  struct Move {
    Vector moving;
    double slide;
  };

  void add(const Draft& draft, const Quad& quad) {
    LocalQuad local;
    for (int k = 0; k < 4; ++k) {
      const VertexId v = quad[static_cast<std::size_t>(k)];
      local.at[static_cast<std::size_t>(k)] = draft.at(v) - origin_;
      if (v == moving_) local.moving = k;
      if (v == end_) local.end = k;
    }
    quads_.push_back(local);
  }

  [[nodiscard]] bool is_on_side(Vector neighbour) const {
    const Vector end = end_at_ - origin_;
    return (neighbour.x == end.x && neighbour.y == end.y) ||
           (neighbour.x == previous_.x && neighbour.y == previous_.y);
  }

  /// The places that a move leads to, rounded as they will be, and what they are worth.
  [[nodiscard]] Result evaluate(const Move& move) const {
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

  static bool improve(Result& best, const Result& other) {
    if (!(other.slack > best.slack)) return false;
    best = other;
    return true;
  }

  [[nodiscard]] Result climb(Move here, double scale) const {
    Result best = evaluate(here);
    constexpr double kFinest = 0x1p-10;
    for (double step = scale / 8; step > kFinest * scale && best.slack < kGoodSlack;)
      if (!climb_once(here, step, best)) step /= 2;
    return best;
  }

  /// The best of the 26 neighbours of a move, if one is better.
  bool climb_once(Move& here, double step, Result& best) const {
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

  EdgeLine line_;
  VertexId moving_;
  VertexId end_;
  FinePoint origin_;
  FinePoint end_at_;
  Vector to_tip_;    ///< unit vector from p to the tip
  Vector previous_;  ///< from v_k to v_{k-1}
  std::vector<LocalQuad> quads_;
};

/// Moves v_k, p and the vertices of the inside around them in turn, each to where the worst of its
/// own quads is best. Needed where a vertex of B lies so close to v_k that v_k cannot move alone.
class Relaxation {
 public:
  Relaxation(const Draft& draft, const Mesh& mesh, const QuadsAt& quads,
             const std::vector<bool>& on_boundary, const Side& side, const Quad& last, VertexId tip)
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

  /// Whether it comes to an end with all quads within the bounds.
  bool run() {
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

  [[nodiscard]] std::span<const VertexId> free() const { return free_; }
  [[nodiscard]] Vector offset(VertexId vertex) const { return at_[index(vertex)]; }
  [[nodiscard]] const FinePoint& origin() const { return origin_; }

 private:
  static constexpr int kMostSweeps = 60;

  void add(const Draft& draft, const Quad& quad) {
    for (const VertexId v : quad) {
      if (std::find(ids_.begin(), ids_.end(), v) != ids_.end()) continue;
      ids_.push_back(v);
      at_.push_back(draft.at(v) - origin_);
    }
    std::array<std::size_t, 4> local{};
    for (std::size_t k = 0; k < 4; ++k) local[k] = index(quad[k]);
    quads_.push_back(local);
  }
  [[nodiscard]] std::size_t index(VertexId vertex) const {
    return static_cast<std::size_t>(std::find(ids_.begin(), ids_.end(), vertex) - ids_.begin());
  }
  Vector& position(VertexId vertex) { return at_[index(vertex)]; }

  [[nodiscard]] double slack(const std::array<std::size_t, 4>& quad) const {
    const double value =
        quad_slack(std::array<Vector, 4>{at_[quad[0]], at_[quad[1]], at_[quad[2]], at_[quad[3]]});
    return value >= -1 ? value : -1;  // -1 where vertices coincide
  }
  [[nodiscard]] double worst() const {
    double result = 1;
    for (const auto& quad : quads_) result = std::min(result, slack(quad));
    return result;
  }
  [[nodiscard]] double worst_at(std::size_t local) const {
    double result = 1;
    for (const auto& quad : quads_)
      if (std::find(quad.begin(), quad.end(), local) != quad.end())
        result = std::min(result, slack(quad));
    return result;
  }
  /// The shortest edge at a vertex: what it may move by.
  [[nodiscard]] double reach(std::size_t local) const {
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

  void improve(VertexId vertex) {
    const std::size_t local = index(vertex);
    double best = worst_at(local);
    const double largest = reach(local) / 2;
    constexpr double kFinest = 0x1p-8;
    for (double step = largest; step > kFinest * largest;)
      if (!step_once(local, vertex == end_, step, best)) step /= 2;
  }

  bool step_once(std::size_t local, bool on_line, double step, double& best) {
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

  FinePoint origin_;
  VertexId end_;
  Vector to_tip_;
  double scale_ = 0;
  std::vector<VertexId> free_;  ///< v_k, p, and others
  std::vector<VertexId> ids_;
  std::vector<Vector> at_;
  std::vector<std::array<std::size_t, 4>> quads_;
};

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
