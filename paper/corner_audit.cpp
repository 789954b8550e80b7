// SPDX-License-Identifier: Apache-2.0
#include "paper/corner_audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "generators/random.hpp"
#include "model/angle.hpp"
#include "paper/strip_audit.hpp"

namespace quadbound {
namespace {

constexpr std::int64_t kSide = CornerCase::kSide;

constexpr std::array<std::string_view, kCornerCheckCount> kDescriptions{
    "both chains beta end in the 3x3 cells around v",
    "E has one to seven edges",
    "no foot of u or w lies beyond v",
    "case 1: P_v is meshed by four quads as drawn",
    "case 2: P_v is meshed with perpendicular feet",
    "case 2: the same with feet anywhere on their edges",
    "case 3: the angles at v beside e and f are within 18.43 and 171.86",
    "case 3: where they are, P_v is meshed with perpendicular feet",
    "case 3: the same with feet that are moved along their edges",
};

/// A cell of the grid; v is in (0, 0).
struct GridCell {
  std::int64_t i = 0;
  std::int64_t j = 0;
  friend bool operator==(const GridCell&, const GridCell&) = default;
};

LatticePoint centre(GridCell c) { return {c.i * kSide + kSide / 2, c.j * kSide + kSide / 2}; }

/// The 8 cells around v, counter-clockwise.
constexpr std::array<GridCell, 8> kRing{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

int place_in_ring(GridCell c) {
  return static_cast<int>(std::find(kRing.begin(), kRing.end(), c) - kRing.begin());
}
GridCell ring(int place) { return kRing[static_cast<std::size_t>(place & 7)]; }
bool is_edge_neighbour(int place) { return (place & 1) == 0; }

std::int64_t cross(LatticePoint a, LatticePoint b) { return a.x * b.y - a.y * b.x; }
std::int64_t dot(LatticePoint a, LatticePoint b) { return a.x * b.x + a.y * b.y; }
LatticePoint operator-(LatticePoint a, LatticePoint b) { return {a.x - b.x, a.y - b.y}; }

// --- beta ----------------------------------------------------------------------------------------

/// An edge at v in a frame where its line is within 45 degrees of the x axis: turned by quarter
/// turns around the middle of v's cell.
class TurnedEdge {
 public:
  /// `incoming`: e, which ends in v; or else f, which starts there.
  TurnedEdge(LatticePoint v, LatticePoint direction, bool incoming)
      : v_(v), d_(direction), incoming_(incoming) {
    while (!(d_.x > 0 && std::abs(d_.y) <= d_.x)) {
      d_ = {-d_.y, d_.x};
      v_ = {kSide - v_.y, v_.x};
      ++turns_;
    }
  }

  /// The last or first cell of beta within the 3x3 cells around v.
  [[nodiscard]] std::optional<GridCell> end_of_beta() const {
    std::optional<GridCell> best;
    for (const GridCell c : beta())
      if (!best || comes_after(c, *best) == incoming_) best = c;
    if (!best) return std::nullopt;
    for (int k = 0; k < turns_; ++k) best = GridCell{best->j, -best->i};
    return best;
  }

 private:
  [[nodiscard]] bool above(LatticePoint p) const { return cross(d_, p - v_) > 0; }
  [[nodiscard]] bool above(GridCell c) const { return above(centre(c)); }

  /// By x, and then y, falling for theta < 0.
  [[nodiscard]] bool comes_after(GridCell a, GridCell b) const {
    if (a.i != b.i) return a.i > b.i;
    return d_.y < 0 ? a.j < b.j : a.j > b.j;
  }

  [[nodiscard]] std::vector<GridCell> beta() const {
    std::vector<GridCell> cells;
    const auto add = [&](GridCell c) {
      const bool is_v = c == GridCell{};
      if (!is_v && std::max(std::abs(c.i), std::abs(c.j)) <= 1 && above(c)) cells.push_back(c);
    };
    for (std::int64_t i = -3; i <= 3; ++i) {
      for (std::int64_t j = -4; j <= 4; ++j) {
        const GridCell c{i, j};
        if (c == GridCell{} || !is_crossed(c)) continue;
        add(c);
        if (above(c)) continue;
        add({i, j + 1});
        add(d_.y >= 0 ? GridCell{i - 1, j} : GridCell{i + 1, j});
      }
    }
    return cells;
  }

  /// By the edge, not by its line beyond v.
  [[nodiscard]] bool is_crossed(GridCell c) const {
    const std::int64_t x = c.i * kSide;
    const std::int64_t y = c.j * kSide;
    bool has_above = false;
    bool has_other = false;
    for (const std::int64_t cx : {x, x + kSide})
      for (const std::int64_t cy : {y, y + kSide})
        (above(LatticePoint{cx, cy}) ? has_above : has_other) = true;
    if (!has_above || !has_other) return false;
    // Where the line is in the cell, from its corner in x, times |dy|, or 1 for a horizontal one.
    const std::int64_t scale = d_.y == 0 ? 1 : std::abs(d_.y);
    std::int64_t low = (x - v_.x) * scale;
    std::int64_t high = (x + kSide - v_.x) * scale;
    if (d_.y != 0) {
      const std::int64_t at_bottom = (y - v_.y) * d_.x * (d_.y > 0 ? 1 : -1);
      const std::int64_t at_top = (y + kSide - v_.y) * d_.x * (d_.y > 0 ? 1 : -1);
      low = std::max(low, std::min(at_bottom, at_top));
      high = std::min(high, std::max(at_bottom, at_top));
    }
    return low <= high && (incoming_ ? low < 0 : high > 0);
  }

  LatticePoint v_;
  LatticePoint d_;
  bool incoming_;
  int turns_ = 0;
};

// --- P_v -----------------------------------------------------------------------------------------

/// P_v between u and w, in the frame of e or of f with v at the origin.
class CornerPolygon {
 public:
  CornerPolygon(const CornerCase& corner, int u, int edges)
      : c_(corner), u_(u), edges_(edges), e_{-corner.back.x, -corner.back.y} {}

  [[nodiscard]] bool no_foot_beyond_v() const {
    return in_e(at(0)).t <= 0 && in_f(at(edges_)).t >= 0;
  }
  [[nodiscard]] bool feet_apart_from_v() const {
    return in_e(at(0)).t < 0 && in_f(at(edges_)).t > 0;
  }

  /// Case 1, Fig. 39: t on the diagonal of u's cell, q on the parallel to u w through t.
  [[nodiscard]] bool case_1() const {
    return is_edge_neighbour(u_) ? try_t(at(0), at(1)) : try_t(at(1), at(0));
  }

  /// Fig. 40, with the feet of u and w anywhere on e and f if they may move: decided, not searched.
  [[nodiscard]] bool case_2(bool may_move) const {
    if (!may_move) return first_quad(at(1), false) && last_quad(at(1), false);
    const auto mirrored = [](const Framed& p) { return Framed{-p.t, p.h}; };
    return some_foot_is_good(in_e(at(0)), in_e(at(1))) &&
           some_foot_is_good(mirrored(in_f(at(edges_))), mirrored(in_f(at(1))));
  }

  /// Case 3 joins v to these and to nothing between them and its edges: the angles there are those
  /// of quads.
  [[nodiscard]] bool angles_at_v() const {
    const auto good = [](const Framed& next, const Framed& previous) {
      return within(Corner<Int128>{cross(next, previous), dot(next, previous)}, kTheorem13);
    };
    const Framed back{-1, 0};
    const Framed out{1, 0};
    return good(in_e(aligned(first_joined())), back) && good(out, in_f(aligned(last_joined())));
  }

  /// Case 3, Fig. 41: v joined to the edge neighbours between u and w, which are aligned with it.
  [[nodiscard]] bool case_3(bool may_move) const {
    const int first = first_joined();
    const int last = last_joined();
    for (int k = first; k + 2 <= last; k += 2)
      if (!is_good({in_e(c_.v), in_e(aligned(k + 2)), in_e(at(k + 1)), in_e(aligned(k))}))
        return false;
    const bool begins =
        first == 1 ? first_quad(aligned(1), may_move) : first_pentagon(at(1), aligned(2), may_move);
    if (!begins) return false;
    return last == edges_ - 1 ? last_quad(aligned(last), may_move)
                              : last_pentagon(aligned(last), at(edges_ - 1), may_move);
  }

 private:
  static constexpr int kSteps = 16;

  [[nodiscard]] int first_joined() const { return is_edge_neighbour(u_) ? 2 : 1; }
  [[nodiscard]] int last_joined() const {
    return is_edge_neighbour(u_ - edges_) ? edges_ - 2 : edges_ - 1;
  }
  /// The k-th vertex of E, from u clockwise.
  [[nodiscard]] LatticePoint at(int k) const { return centre(ring(u_ - k)); }
  [[nodiscard]] LatticePoint aligned(int k) const {
    const LatticePoint p = at(k);
    return ring(u_ - k).i == 0 ? LatticePoint{c_.v.x, p.y} : LatticePoint{p.x, c_.v.y};
  }
  [[nodiscard]] static Framed framed(LatticePoint direction, LatticePoint offset) {
    // Finer, for feet and Steiner points that are integers.
    constexpr Int128 kFiner = 1 << 10;
    return {kFiner * dot(direction, offset), kFiner * cross(direction, offset)};
  }
  [[nodiscard]] Framed in_e(LatticePoint p) const { return framed(e_, p - c_.v); }
  [[nodiscard]] Framed in_f(LatticePoint p) const { return framed(c_.out, p - c_.v); }

  /// Whether a foot z on the edge before v makes the quad z, v, x, u good. Its corners at v and x
  /// do not depend on z; those at u and z are linear conditions on z.
  [[nodiscard]] static bool some_foot_is_good(const Framed& u, const Framed& x) {
    const Framed before_v{-1, 0};
    const Framed to_x = x - u;
    const auto fixed = [](const Framed& next, const Framed& previous) {
      return within(Corner<Int128>{cross(next, previous), dot(next, previous)}, kTheorem13);
    };
    if (!fixed(x, before_v) || !fixed(u - x, Framed{} - x)) return false;
    // a z + b >= 0, with 3 cross >= dot and 7 cross >= -dot at u and at z.
    const Int128 cross_at_0 = u.h * to_x.t - u.t * to_x.h;
    const Int128 dot_at_0 = -u.t * to_x.t - u.h * to_x.h;
    const std::array<std::array<Int128, 2>, 5> conditions{
        {{3 * to_x.h - to_x.t, 3 * cross_at_0 - dot_at_0},
         {7 * to_x.h + to_x.t, 7 * cross_at_0 + dot_at_0},
         {1, 3 * u.h - u.t},
         {-1, 7 * u.h + u.t},
         {-1, -1}}};
    return have_solution(conditions);
  }

  template <std::size_t kCount>
  [[nodiscard]] static bool have_solution(const std::array<std::array<Int128, 2>, kCount>& of) {
    for (const auto& [a, b] : of) {
      if (a == 0 && b < 0) return false;
      for (const auto& [c, d] : of)
        if (a > 0 && c < 0 && -b * -c > d * a) return false;  // -b / a > d / -c
    }
    return true;
  }

  static std::vector<int> moves(bool may_move) {
    if (!may_move) return {0};
    std::vector<int> sixteenths;
    for (int k = 0; k <= 2 * kSteps; ++k) {
      sixteenths.push_back(k);
      if (k > 0) sixteenths.push_back(-k);
    }
    return sixteenths;
  }
  /// The foot of u on e or of w on f, moved by parts of its height; nullopt beyond v.
  static std::optional<Framed> foot(const Framed& p, int sixteenths, int side) {
    const Framed z{p.t + p.h * sixteenths / kSteps, 0};
    return z.t * side > 0 ? std::optional(z) : std::nullopt;
  }

  template <class Good>
  [[nodiscard]] static bool with_foot(const Framed& p, int side, bool may_move, const Good& good) {
    for (const int move : moves(may_move))
      if (const auto z = foot(p, move, side); z && good(*z)) return true;
    return false;
  }

  [[nodiscard]] bool first_quad(LatticePoint x, bool may_move) const {
    const Framed u = in_e(at(0));
    return with_foot(u, -1, may_move, [&](const Framed& z) {
      return is_good({z, Framed{}, in_e(x), u});
    });
  }
  [[nodiscard]] bool last_quad(LatticePoint x, bool may_move) const {
    const Framed w = in_f(at(edges_));
    return with_foot(w, 1, may_move, [&](const Framed& z) {
      return is_good({Framed{}, z, w, in_f(x)});
    });
  }
  [[nodiscard]] bool first_pentagon(LatticePoint t, LatticePoint x, bool may_move) const {
    const Framed u = in_e(at(0));
    return with_foot(u, -1, may_move, [&](const Framed& z) {
      return is_pentagon_meshed(z, Framed{}, u, in_e(t), in_e(x), may_move);
    });
  }
  [[nodiscard]] bool last_pentagon(LatticePoint x, LatticePoint t, bool may_move) const {
    const Framed w = in_f(at(edges_));
    return with_foot(w, 1, may_move, [&](const Framed& z) {
      return is_pentagon_meshed(Framed{}, z, in_f(x), in_f(t), w, may_move);
    });
  }

  /// `near` is the edge neighbour of v's cell among u and w, `far` the corner neighbour.
  [[nodiscard]] bool try_t(LatticePoint near, LatticePoint far) const {
    const LatticePoint middle{kSide / 2, kSide / 2};
    const LatticePoint k{(near.x + far.x) / 2 + (middle.x - near.x) / 2,
                         (near.y + far.y) / 2 + (middle.y - near.y) / 2};
    for (int i = 1; i < kSteps; ++i) {
      const LatticePoint t{near.x + (k.x - near.x) * i / kSteps,
                           near.y + (k.y - near.y) * i / kSteps};
      for (int j = 1; j <= kSteps; ++j)
        if (try_q(near, far, t, j)) return true;
    }
    return false;
  }

  /// q at j / 16 of the way from t to the line from v to `far`, parallel to `near` `far`.
  [[nodiscard]] bool try_q(LatticePoint near, LatticePoint far, LatticePoint t, int j) const {
    const LatticePoint along = far - near;
    const LatticePoint to_far = far - c_.v;
    const std::int64_t slope = cross(along, to_far);
    if (slope == 0) return false;
    const std::int64_t reach = cross(c_.v - t, to_far);  // over slope: where the line is met
    const LatticePoint q{t.x + along.x * reach / slope * j / kSteps,
                         t.y + along.y * reach / slope * j / kSteps};
    return is_edge_neighbour(u_) ? is_good_with(t, q) : is_good_mirrored(t, q);
  }

  [[nodiscard]] bool is_good_with(LatticePoint t, LatticePoint q) const {
    const LatticePoint u = at(0);
    const LatticePoint w = at(1);
    const Framed foot_u{in_e(u).t, 0};
    const Framed foot_w{in_f(w).t, 0};
    if (!is_good({in_e(u), in_e(t), in_e(q), in_e(w)})) return false;
    const Framed foot_q{in_f(q).t, 0};
    if (foot_q.t > 0 && foot_q.t < foot_w.t && is_good({foot_u, Framed{}, in_e(t), in_e(u)}) &&
        is_good({Framed{}, foot_q, in_f(q), in_f(t)}) &&
        is_good({foot_q, foot_w, in_f(w), in_f(q)}))
      return true;
    const Framed foot_t{in_e(t).t, 0};
    return foot_u.t < foot_t.t && foot_t.t < 0 && is_good({foot_u, foot_t, in_e(t), in_e(u)}) &&
           is_good({foot_t, Framed{}, in_e(q), in_e(t)}) &&
           is_good({Framed{}, foot_w, in_f(w), in_f(q)});
  }

  [[nodiscard]] bool is_good_mirrored(LatticePoint t, LatticePoint q) const {
    const LatticePoint u = at(0);
    const LatticePoint w = at(1);
    const Framed foot_u{in_e(u).t, 0};
    const Framed foot_w{in_f(w).t, 0};
    if (!is_good({in_e(u), in_e(q), in_e(t), in_e(w)})) return false;
    const Framed foot_q{in_e(q).t, 0};
    if (foot_u.t < foot_q.t && foot_q.t < 0 && is_good({foot_u, foot_q, in_e(q), in_e(u)}) &&
        is_good({foot_q, Framed{}, in_e(t), in_e(q)}) &&
        is_good({Framed{}, foot_w, in_f(w), in_f(t)}))
      return true;
    const Framed foot_t{in_f(t).t, 0};
    return 0 < foot_t.t && foot_t.t < foot_w.t && is_good({foot_u, Framed{}, in_e(q), in_e(u)}) &&
           is_good({Framed{}, foot_t, in_f(t), in_f(q)}) &&
           is_good({foot_t, foot_w, in_f(w), in_f(t)});
  }

  CornerCase c_;
  int u_;
  int edges_;
  LatticePoint e_;
};

// --- counting ------------------------------------------------------------------------------------

/// The size of the numbers that write a corner down; v on a border or on a middle line of its cell
/// counts as larger than any other.
std::int64_t size_of(const CornerCase& c) {
  constexpr std::int64_t kLarge = 1 << 20;
  const bool special = c.v.x % (kSide / 2) == 0 || c.v.y % (kSide / 2) == 0;
  const std::int64_t step = std::gcd(std::gcd(c.v.x, c.v.y), kSide);
  return (special ? kLarge : 0) + kSide / step + std::abs(c.back.x) + std::abs(c.back.y) +
         std::abs(c.out.x) + std::abs(c.out.y);
}

void count(CornerAudit& audit, CornerCheck check, bool holds, const CornerCase& corner) {
  CornerTally& tally = audit.checks[static_cast<std::size_t>(check)];
  ++tally.looked_at;
  if (holds) return;
  ++tally.failed;
  if (!tally.smallest || size_of(corner) < size_of(*tally.smallest)) tally.smallest = corner;
}

/// u beyond w looks like a full turn less one edge; no corner below 180 degrees has that many.
int edges_of(const CornerCase& corner, int u, int w) {
  const int edges = (u - w) & 7;
  const bool is_convex = cross(corner.out, corner.back) > 0;
  return is_convex && edges > 5 ? edges - 8 : edges;
}

void check_corner(const CornerCase& corner, CornerAudit& audit) {
  ++audit.corners;
  const auto u = TurnedEdge(corner.v, {-corner.back.x, -corner.back.y}, true).end_of_beta();
  const auto w = TurnedEdge(corner.v, corner.out, false).end_of_beta();
  count(audit, CornerCheck::kEndsInGrid, u && w, corner);
  if (!u || !w) return;
  const int edges = edges_of(corner, place_in_ring(*u), place_in_ring(*w));
  const int place = std::max(edges + 1, 0);
  ++audit.by_edges[static_cast<std::size_t>(place)];
  count(audit, CornerCheck::kOneToSevenEdges, edges >= 1, corner);
  const CornerPolygon polygon(corner, place_in_ring(*u), edges);
  if (edges >= 0) count(audit, CornerCheck::kFeetOnEdges, polygon.no_foot_beyond_v(), corner);
  if (edges < 1 || !polygon.feet_apart_from_v()) return;
  if (edges == 1) count(audit, CornerCheck::kCase1, polygon.case_1(), corner);
  if (edges == 2) {
    count(audit, CornerCheck::kCase2AsWritten, polygon.case_2(false), corner);
    count(audit, CornerCheck::kCase2, polygon.case_2(true), corner);
  }
  if (edges >= 3) {
    count(audit, CornerCheck::kCase3Angles, polygon.angles_at_v(), corner);
    if (!polygon.angles_at_v()) return;
    count(audit, CornerCheck::kCase3AsWritten, polygon.case_3(false), corner);
    count(audit, CornerCheck::kCase3, polygon.case_3(true), corner);
  }
}

bool is_valid(const CornerCase& c) {
  const std::int64_t turn = cross(c.out, c.back);
  const std::int64_t along = dot(c.out, c.back);
  return !(turn > 0 && along > 0) && !(turn == 0 && along >= 0);
}

std::vector<LatticePoint> small_directions() {
  constexpr std::int64_t kMost = 3;
  std::vector<LatticePoint> directions;
  for (std::int64_t x = -kMost; x <= kMost; ++x)
    for (std::int64_t y = -kMost; y <= kMost; ++y)
      if (std::gcd(x, y) == 1) directions.push_back({x, y});
  // Less than arctan(1/7) off the axes.
  for (const std::int64_t eight : {-8, 8})
    for (const std::int64_t one : {-1, 1}) {
      directions.push_back({eight, one});
      directions.push_back({one, eight});
    }
  return directions;
}

/// The odd sixteenths of a cell, and where the lines through its corners and its centre meet.
std::vector<LatticePoint> small_places() {
  std::vector<LatticePoint> places;
  for (std::int64_t x = kSide / 16; x < kSide; x += kSide / 8)
    for (std::int64_t y = kSide / 16; y < kSide; y += kSide / 8) places.push_back({x, y});
  for (const std::int64_t x : {std::int64_t{0}, kSide / 2})
    for (const std::int64_t y : {std::int64_t{0}, kSide / 2}) places.push_back({x, y});
  return places;
}

void check_small_corners(CornerAudit& audit) {
  const std::vector<LatticePoint> directions = small_directions();
  for (const LatticePoint v : small_places())
    for (const LatticePoint back : directions)
      for (const LatticePoint out : directions)
        if (const CornerCase corner{v, back, out}; is_valid(corner)) check_corner(corner, audit);
}

/// Case 2 fails where the edge from v to t goes on almost in line with e.
constexpr CornerCase kInLineWithT{{kSide / 64, kSide - kSide / 64}, {-6, -5}, {1, 0}};

CornerCase random_corner(RandomIntegers& random) {
  constexpr std::int64_t kMost = 1 << 12;
  CornerCase corner{{random.between(0, kSide - 1), random.between(0, kSide - 1)}, {}, {}};
  do {
    corner.back = {random.between(-kMost, kMost), random.between(-kMost, kMost)};
    corner.out = {random.between(-kMost, kMost), random.between(-kMost, kMost)};
    // A right angle, as most polygons have.
    if (random.chance(20)) corner.out = {corner.back.y, -corner.back.x};
  } while (!is_valid(corner));
  return corner;
}

}  // namespace

std::string_view describe(CornerCheck check) {
  return kDescriptions[static_cast<std::size_t>(check)];
}

CornerAudit audit_corner(const CornerCase& corner) {
  CornerAudit audit;
  check_corner(corner, audit);
  return audit;
}

CornerAudit audit_corners(std::uint64_t random_corners) {
  CornerAudit audit;
  check_small_corners(audit);
  check_corner(kInLineWithT, audit);
  RandomIntegers random(12);
  for (std::uint64_t i = 0; i < random_corners; ++i) check_corner(random_corner(random), audit);
  return audit;
}

std::string to_text(const CornerCase& corner) {
  const auto part = [](std::int64_t x) { return to_text(Rational(x) / kSide); };
  return fmt::format("v = ({}, {}) of its cell, e from ({}, {}), f towards ({}, {})",
                     part(corner.v.x), part(corner.v.y), corner.back.x, corner.back.y, corner.out.x,
                     corner.out.y);
}

std::string to_text(const CornerAudit& audit) {
  std::string text = fmt::format("{} corners; edges of E", audit.corners);
  for (std::size_t k = 0; k < audit.by_edges.size(); ++k)
    text += fmt::format("{} {}: {}", k == 0 ? "" : ",", static_cast<int>(k) - 1, audit.by_edges[k]);
  text += "\n";
  for (std::size_t i = 0; i < kCornerCheckCount; ++i) {
    const CornerTally& t = audit.checks[i];
    text += fmt::format("{:<64} {:>9} {:>9}{}\n", kDescriptions[i], t.looked_at, t.failed,
                        t.smallest ? "  " + to_text(*t.smallest) : "");
  }
  return text;
}

}  // namespace quadbound
