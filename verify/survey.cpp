// SPDX-License-Identifier: Apache-2.0
#include "verify/survey.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace quadbound::judge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The four edges of a quad on the lattice; edge i leaves corner i.
struct Edges {
  std::array<std::int64_t, 4> x;
  std::array<std::int64_t, 4> y;
};

Edges edges_of(const std::array<LatticePoint, 4>& p) {
  Edges edges;
  for (std::size_t i = 0; i < 4; ++i) {
    edges.x[i] = p[(i + 1) % 4].x - p[i].x;
    edges.y[i] = p[(i + 1) % 4].y - p[i].y;
  }
  return edges;
}

/// Corner i from its edges.
Corner<Int128> corner_of(const Edges& e, std::size_t i) {
  const std::size_t before = (i + 3) % 4;
  const auto times = [](std::int64_t a, std::int64_t b) { return static_cast<Int128>(a) * b; };
  return {times(e.x[before], e.y[i]) - times(e.y[before], e.x[i]),
          -times(e.x[before], e.x[i]) - times(e.y[before], e.y[i])};
}

/// The shoelace formula with differences only: half the cross product of the diagonals.
Int128 doubled_area(const Edges& e) {
  const std::int64_t first_x = e.x[0] + e.x[1];
  const std::int64_t first_y = e.y[0] + e.y[1];
  const std::int64_t second_x = e.x[1] + e.x[2];
  const std::int64_t second_y = e.y[1] + e.y[2];
  return static_cast<Int128>(first_x) * second_y - static_cast<Int128>(first_y) * second_x;
}

/// A corner of less than 180 degrees passes the positive x axis exactly when its first edge points
/// into the lower half-plane and its last edge, which is the edge before reversed, into the upper.
/// Bit i of `lower`: edge i points into the lower half-plane, the negative x axis included.
std::uint8_t passes_of(unsigned lower) {
  return static_cast<std::uint8_t>(lower & ((lower << 1) | (lower >> 3)) & 15U);
}

std::uint8_t passes_of(const Edges& e) {
  unsigned lower = 0;
  for (std::size_t i = 0; i < 4; ++i)
    lower |= static_cast<unsigned>(e.y[i] < 0 || (e.y[i] == 0 && e.x[i] < 0)) << i;
  return passes_of(lower);
}

/// Off by less than 2^11 and one unit of the last place, for two roundings. By halves, which the
/// processor converts; 128 bits take a call. Requires: at most 2^126.
double rounded(Int128 value) {
  const auto high = static_cast<std::int64_t>(value >> 64);
  const auto low = static_cast<std::int64_t>(static_cast<std::uint64_t>(value) >> 1);
  return static_cast<double>(high) * 0x1p64 + static_cast<double>(low) * 2;
}

/// An edge between fixed points, in units of 2^-64, and its length in the 1-norm.
struct Rounded {
  Rounded() = default;
  Rounded(const FixedPoint& from, const FixedPoint& to)
      : x(rounded(to.x.value - from.x.value)),
        y(rounded(to.y.value - from.y.value)),
        length(std::abs(x) + std::abs(y)) {}
  double x;
  double y;
  double length;
};

/// A corner between two such edges.
struct RoundedCorner {
  RoundedCorner(const Rounded& before, const Rounded& next)
      : cross(before.x * next.y - before.y * next.x),
        dot(-(before.x * next.x) - before.y * next.y),
        size(before.length * next.length),
        is_long(before.length >= 0x1p70 && next.length >= 0x1p70) {}
  double cross;
  double dot;
  double size;
  bool is_long;
};

/// Cotangent of a corner up to a few units of the last place, monotone in the sector at the ends.
double cotangent(const ExtremeCorner& extreme) {
  if (extreme.rational) {
    const Corner<Rational>& c = *extreme.rational;
    switch (sector(c)) {
      case 0:
        return kInfinity;
      case 1:
        return nearest_double(Rational(c.dot / c.cross));
      default:
        return -kInfinity;
    }
  }
  switch (sector(extreme.lattice)) {
    case 0:
      return kInfinity;
    case 1:
      return static_cast<double>(extreme.lattice.dot) / static_cast<double>(extreme.lattice.cross);
    default:
      return -kInfinity;
  }
}

double cotangent(Arctangent bound) { return double{1} * bound.denominator / bound.numerator; }

bool is_smaller(const Corner<Int128>& a, const ExtremeCorner& b) {
  if (!b.rational) return judge::is_smaller(a, b.lattice);
  return judge::is_smaller(Corner<Rational>{to_rational(a.cross), to_rational(a.dot)}, *b.rational);
}
bool is_smaller(const ExtremeCorner& a, const Corner<Int128>& b) {
  if (!a.rational) return judge::is_smaller(a.lattice, b);
  return judge::is_smaller(*a.rational, Corner<Rational>{to_rational(b.cross), to_rational(b.dot)});
}
bool is_smaller(const Corner<Rational>& a, const ExtremeCorner& b) {
  return judge::is_smaller(a, b.exact());
}
bool is_smaller(const ExtremeCorner& a, const Corner<Rational>& b) {
  return judge::is_smaller(a.exact(), b);
}
bool is_smaller(const ExtremeCorner& a, const ExtremeCorner& b) {
  if (!a.rational && !b.rational) return judge::is_smaller(a.lattice, b.lattice);
  return judge::is_smaller(a.exact(), b.exact());
}

template <class Number>
ExtremeCorner as_extreme(CornerId id, const Corner<Number>& corner) {
  if constexpr (std::is_same_v<Number, Rational>) {
    return {id, {0, 0}, corner};
  } else {
    return {id, corner, std::nullopt};
  }
}

/// angle < bound, for any angle in [0, 360).
template <class Number>
bool is_below(const Corner<Number>& corner, Arctangent bound) {
  const int where = sector(corner);
  return where == 0 || (where == 1 && !at_least(corner, bound));
}
/// angle > 180 degrees - bound, for any angle in [0, 360).
template <class Number>
bool is_above(const Corner<Number>& corner, Arctangent bound) {
  const int where = sector(corner);
  return where >= 2 || (where == 1 && !at_most_straight_minus(corner, bound));
}

/// Whether tan(excess) <= 4 sqrt(2) 2^-53 M / l; since tan(e) >= e this never lets too much pass.
bool within_slack(const Rational& rise, const Rational& run, const CornerScale& scale) {
  if (run <= 0) return false;
  const Rational left = rise * rise * scale.shorter_edge_squared;
  const Rational right = run * run * scale.largest_coordinate * scale.largest_coordinate;
  return left <= right * dyadic(1, 5 - 2 * 53);
}

/// The filter in front of within_slack: 1 certainly, -1 certainly not, 0 unknown.
int slack_filter(Int128 rise, Int128 run, double largest, double edge_squared) {
  if (run <= 0) return -1;
  const double left = static_cast<double>(rise) * static_cast<double>(rise) * edge_squared;
  const double right = static_cast<double>(run) * static_cast<double>(run) * largest * largest *
                       std::ldexp(1.0, 5 - 2 * 53);
  if (left < right * 0.999) return 1;
  return left > right * 1.001 ? -1 : 0;
}

/// A corner that others are compared with again and again; in lowest terms, so that the usual ones
/// (right angles, the bounds themselves) are small numbers.
class Threshold {
 public:
  Threshold() = default;
  /// Requires: 0 < cross.
  explicit Threshold(Corner<Int128> corner) : corner_(corner) {
    Int128 a = corner.cross;
    for (Int128 b = corner.dot < 0 ? -corner.dot : corner.dot; b != 0;)
      a = std::exchange(b, Int128(a % b));
    corner_ = {Int128(corner.cross / a), Int128(corner.dot / a)};
    is_small_ = corner_.cross <= 8 && corner_.dot <= 8 && corner_.dot >= -8;
  }

  /// The order of cot(corner) and cot(threshold). Requires: 0 < corner.cross.
  [[nodiscard]] std::strong_ordering compare_cotangent(const Corner<Int128>& corner) const {
    if (is_small_) {  // at most 2^123 * 8
      const auto cross = static_cast<std::int64_t>(corner_.cross);
      const auto dot = static_cast<std::int64_t>(corner_.dot);
      return corner.dot * cross <=> corner.cross * dot;
    }
    return compare_products(corner.dot, corner_.cross, corner_.dot, corner.cross);
  }

 private:
  Corner<Int128> corner_{1, 0};
  bool is_small_ = true;
};

/// Surveys one chunk of quads.
template <class Plane>
class Surveyor {
 public:
  /// `measures_rounding`: what lies beyond a bound is compared with what rounding explains.
  Surveyor(const Plane& plane, const std::vector<Quad>& quads, const AngleInterval& interval,
           std::span<const CornerId> exempt, bool measures_rounding)
      : plane_(plane),
        quads_(quads),
        interval_(interval),
        exempt_(exempt),
        measures_rounding_(measures_rounding) {
    update_filter();
  }

  /// Returns the passes of the quad.
  std::uint8_t look_at(std::size_t q) {
    const Quad& quad = quads_[q];
    if (plane_.on_lattice(quad[0]) && plane_.on_lattice(quad[1]) && plane_.on_lattice(quad[2]) &&
        plane_.on_lattice(quad[3]))
      return lattice_quad(q, quad);
    return off_lattice_quad(q, quad);
  }
  [[nodiscard]] Survey take_survey() { return std::move(survey_); }

  /// Only these corners, and of the result only the bounds. Requires: exempt is empty.
  Survey survey(std::span<const CornerId> corners) {
    for (const CornerId id : corners) {
      const Around around = around_corner(quads_[id.quad], static_cast<std::size_t>(id.corner));
      if (!is_filtered(around)) judge_exactly(id, around);
    }
    return std::move(survey_);
  }

 private:
  static constexpr bool kIsExact = std::is_same_v<Plane, ExactPlane>;
  using Doubles = std::array<double, 4>;
  using FixedQuad = std::array<FixedPoint, 4>;
  using Around = std::array<VertexId, 3>;  ///< the vertices before, at and after a corner

  std::uint8_t lattice_quad(std::size_t q, const Quad& quad) {
    const Edges edges = edges_of(std::array{plane_.lattice(quad[0]), plane_.lattice(quad[1]),
                                            plane_.lattice(quad[2]), plane_.lattice(quad[3])});
    if constexpr (kIsExact) survey_.lattice_area.add(doubled_area(edges));
    Doubles x;
    Doubles y;
    Doubles length;
    for (std::size_t i = 0; i < 4; ++i) {
      x[i] = static_cast<double>(edges.x[i]);
      y[i] = static_cast<double>(edges.y[i]);
      length[i] = std::abs(x[i]) + std::abs(y[i]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t before = (i + 3) % 4;
      const double cross = x[before] * y[i] - y[before] * x[i];
      const double dot = -(x[before] * x[i]) - y[before] * y[i];
      if (is_uninteresting(cross, dot, length[before] * length[i])) {
        ++survey_.decisions.filter;
      } else {
        ++survey_.decisions.lattice;
        const auto corner = corner_of(edges, i);
        if (!is_exactly_uninteresting(corner)) judge(CornerId{q, static_cast<int>(i)}, corner);
      }
    }
    return passes_of(edges);
  }

  static Around around_corner(const Quad& quad, std::size_t i) {
    return {quad[(i + 3) % 4], quad[i], quad[(i + 1) % 4]};
  }

  std::uint8_t off_lattice_quad(std::size_t q, const Quad& quad) {
    if constexpr (kIsExact) add_lattice_edges(quad);
    FixedQuad p;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::optional<FixedPoint> point = plane_.fixed(quad[i]);
      if (!point) return rational_quad(q, quad);
      p[i] = *point;
    }
    unsigned lower = 0;
    for (std::size_t i = 0; i < 4; ++i)
      lower |= static_cast<unsigned>(points_down(quad, p, i, (i + 1) % 4)) << i;
    std::array<Rounded, 4> edges;
    for (std::size_t i = 0; i < 4; ++i) edges[i] = Rounded(p[i], p[(i + 1) % 4]);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t before = (i + 3) % 4;
      if (is_uninteresting(RoundedCorner(edges[before], edges[i]))) {
        ++survey_.decisions.filter;
      } else {
        judge_exactly(CornerId{q, static_cast<int>(i)}, around_corner(quad, i));
      }
    }
    return passes_of(lower);
  }

  /// As is_uninteresting of two differences.
  ///
  /// A difference of fixed points is off by less than 1, and then by what rounded() says. Where the
  /// edge is at least 2^70 long (64 units of the lattice), the part that is no rounding is at most
  /// 2^-58 of its length in both coordinates together. With two roundings of each difference, one
  /// of a product and one of the sum, the errors of cross and dot stay below (6 + 1/16) * 2^-53 *
  /// size, as is_uninteresting wants it.
  [[nodiscard]] bool is_uninteresting(const RoundedCorner& c) const {
    return c.is_long && is_uninteresting(c.cross, c.dot, c.size);
  }

  /// Whether the corner is certainly convex, no new extreme, and beyond one bound, which is then
  /// counted. Errors as for is_uninteresting.
  bool count_broken(const RoundedCorner& c) {
    const double error = 0x1p-48 * c.size;
    const auto is_larger = [&](double cot) {
      return cot * c.cross - c.dot > (1 + std::abs(cot)) * error;
    };
    const auto is_smaller = [&](double cot) {
      return c.dot - cot * c.cross > (1 + std::abs(cot)) * error;
    };
    const auto& smallest = survey_.smallest.extreme;
    const auto& largest = survey_.largest.extreme;
    if (!c.is_long || !(c.cross > error) || !smallest || !largest) return false;
    if (!is_larger(cotangent(*smallest)) || !is_smaller(cotangent(*largest))) return false;
    const bool below = is_smaller(cotangent(interval_.smallest));
    const bool above = is_larger(-cotangent(interval_.from_straight));
    survey_.smallest.broken += below ? 1 : 0;
    survey_.largest.broken += above ? 1 : 0;
    return below || above;
  }

  /// Whether edge from -> to points into the lower half-plane, the negative x axis included.
  [[nodiscard]] bool points_down(const Quad& quad, const FixedQuad& p, std::size_t from,
                                 std::size_t to) const {
    const auto sign_y = sign_of_difference(p[from].y, p[to].y);
    if (sign_y && *sign_y != 0) return *sign_y < 0;
    const auto sign_x = sign_of_difference(p[from].x, p[to].x);
    if (sign_y && sign_x) return *sign_x < 0;
    return points_down(plane_.rational(quad[from]), plane_.rational(quad[to]));
  }
  static bool points_down(const RationalPoint& from, const RationalPoint& to) {
    const int by_y = to.y.compare(from.y);
    return by_y < 0 || (by_y == 0 && to.x < from.x);
  }

  std::uint8_t rational_quad(std::size_t q, const Quad& quad) {
    unsigned lower = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Around around = around_corner(quad, i);
      judge_exactly(CornerId{q, static_cast<int>(i)}, around);
      const bool down = points_down(plane_.rational(around[1]), plane_.rational(around[2]));
      lower |= static_cast<unsigned>(down) << i;
    }
    return passes_of(lower);
  }

  void add_lattice_edges(const Quad& quad) {
    for (std::size_t i = 0; i < 4; ++i) {
      const VertexId from = quad[i];
      const VertexId to = quad[(i + 1) % 4];
      if (plane_.on_lattice(from) && plane_.on_lattice(to))
        survey_.lattice_area.add(cross_product(plane_.lattice(from), plane_.lattice(to)));
    }
  }

  bool is_filtered(const Around& around) {
    std::array<FixedPoint, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::optional<FixedPoint> point = plane_.fixed(around[i]);
      if (!point) return false;
      p[i] = *point;
    }
    const RoundedCorner corner(Rounded(p[0], p[1]), Rounded(p[1], p[2]));
    return is_uninteresting(corner) || count_broken(corner);
  }

  void judge_exactly(CornerId id, const Around& around) {
    const auto& [before, at, next] = around;
    if (plane_.on_lattice(before) && plane_.on_lattice(at) && plane_.on_lattice(next)) {
      ++survey_.decisions.lattice;
      const auto corner =
          corner_at<Int128>(plane_.lattice(at), plane_.lattice(next), plane_.lattice(before));
      if (!is_exactly_uninteresting(corner)) judge(id, corner);
    } else {
      ++survey_.decisions.rational;
      judge(id, corner_at<Rational>(plane_.rational(at), plane_.rational(next),
                                    plane_.rational(before)));
    }
  }

  /// Whether the corner is certainly convex, within the bounds, and no new extreme.
  ///
  /// `size` is the product of the edges' lengths in the 1-norm. Requires: cross and dot are each
  /// off by less than 6.5 * 2^-53 * size; on the lattice, where differences are rounded once, it is
  /// 4 at most (and terms of 2^-106). The cotangents of the extremes are off by 4 units of the last
  /// place, the products and differences below by one more rounding each: together less than
  /// 16 * 2^-53 * size * (1 + |cotangent|). 2^-48 leaves a factor of two.
  [[nodiscard]] bool is_uninteresting(double cross, double dot, double size) const {
    const double error = 0x1p-48 * size;
    return cross > error && low_ * cross - dot > low_error_ * error &&
           dot - high_ * cross > high_error_ * error;
  }

  /// The same, decided exactly; ties with the extremes are common. May say no out of caution.
  [[nodiscard]] bool is_exactly_uninteresting(const Corner<Int128>& corner) const {
    return has_thresholds_ && corner.cross > 0 && low_exact_.compare_cotangent(corner) <= 0 &&
           high_exact_.compare_cotangent(corner) >= 0;
  }

  void update_thresholds() {
    const auto& smallest = survey_.smallest.extreme;
    const auto& largest = survey_.largest.extreme;
    has_thresholds_ = smallest && !smallest->rational && sector(smallest->lattice) == 1 &&
                      largest && !largest->rational && sector(largest->lattice) == 1;
    if (!has_thresholds_) return;
    const Arctangent low = interval_.smallest;
    const Arctangent high = interval_.from_straight;
    low_exact_ =
        Threshold(survey_.smallest.broken == 0 ? smallest->lattice
                                               : Corner<Int128>{low.numerator, low.denominator});
    high_exact_ =
        Threshold(survey_.largest.broken == 0 ? largest->lattice
                                              : Corner<Int128>{high.numerator, -high.denominator});
  }

  void update_filter() {
    // Corners with a cotangent below low_ are larger than the smallest so far and than the bound.
    const auto& smallest = survey_.smallest.extreme;
    const auto& largest = survey_.largest.extreme;
    low_ = smallest ? std::min(cotangent(*smallest), cotangent(interval_.smallest)) : -kInfinity;
    high_ =
        largest ? std::max(cotangent(*largest), -cotangent(interval_.from_straight)) : kInfinity;
    low_error_ = 1 + std::abs(low_);
    high_error_ = 1 + std::abs(high_);
    update_thresholds();
  }

  template <class Number>
  void judge(CornerId id, const Corner<Number>& corner) {
    if (!(corner.cross > 0)) {
      if (survey_.not_convex++ == 0) survey_.first_not_convex = id;
    }
    if (!std::binary_search(exempt_.begin(), exempt_.end(), id)) judge_bounds(id, corner);
  }

  template <class Number>
  void judge_bounds(CornerId id, const Corner<Number>& corner) {
    if (is_below(corner, interval_.smallest)) {
      ++survey_.smallest.broken;
      check_slack(id, corner, interval_.smallest, survey_.smallest);
    }
    if (is_above(corner, interval_.from_straight)) {
      ++survey_.largest.broken;
      check_slack(id, Corner<Number>{corner.cross, Number(-corner.dot)}, interval_.from_straight,
                  survey_.largest);
    }
    bool changed = false;
    auto& smallest = survey_.smallest.extreme;
    if (!smallest || is_smaller(corner, *smallest)) {
      smallest = as_extreme(id, corner);
      changed = true;
    }
    auto& largest = survey_.largest.extreme;
    if (!largest || is_smaller(*largest, corner)) {
      largest = as_extreme(id, corner);
      changed = true;
    }
    if (changed) update_filter();
  }

  template <class Number>
  void check_slack(CornerId id, const Corner<Number>& corner, Arctangent bound, BoundTally& tally) {
    if (!measures_rounding_ || tally.beyond_slack) return;
    const auto [rise, run] = excess_tangent(corner, bound);
    const Quad& quad = quads_[id.quad];
    if constexpr (std::is_same_v<Number, Int128>) {
      const int known = filter_slack(rise, run, quad, static_cast<std::size_t>(id.corner));
      if (known > 0) return;
      if (known < 0) {
        tally.beyond_slack = id;
        return;
      }
    }
    if (!within_slack(to_rational(rise), to_rational(run), corner_scale(plane_, quad, id.corner)))
      tally.beyond_slack = id;
  }

  [[nodiscard]] int filter_slack(Int128 rise, Int128 run, const Quad& quad, std::size_t i) const {
    double largest = 0;
    for (const std::size_t k : {i, (i + 1) % 4, (i + 3) % 4}) {
      const LatticePoint p = plane_.lattice(quad[k]);
      largest = std::max(largest, static_cast<double>(std::max(std::abs(p.x), std::abs(p.y))));
    }
    const auto squared = [&](std::size_t k) {
      const LatticePoint p = plane_.lattice(quad[i]);
      const LatticePoint q = plane_.lattice(quad[k]);
      const double dx = static_cast<double>(q.x - p.x);
      const double dy = static_cast<double>(q.y - p.y);
      return dx * dx + dy * dy;
    };
    return slack_filter(rise, run, largest, std::min(squared((i + 1) % 4), squared((i + 3) % 4)));
  }

  const Plane& plane_;
  const std::vector<Quad>& quads_;
  AngleInterval interval_;
  std::span<const CornerId> exempt_;
  bool measures_rounding_;
  Survey survey_;
  Threshold low_exact_;
  Threshold high_exact_;
  bool has_thresholds_ = false;
  double low_ = 0;
  double high_ = 0;
  double low_error_ = 0;
  double high_error_ = 0;
};

void keep_first(std::optional<CornerId>& into, const std::optional<CornerId>& from) {
  if (from && (!into || *from < *into)) into = from;
}

template <class Smaller>
void merge(BoundTally& into, const BoundTally& from, const Smaller& comes_before) {
  into.broken += from.broken;
  keep_first(into.beyond_slack, from.beyond_slack);
  if (!from.extreme) return;
  if (!into.extreme || comes_before(*from.extreme, *into.extreme) ||
      (from.extreme->id < into.extreme->id && !comes_before(*into.extreme, *from.extreme)))
    into.extreme = from.extreme;
}

/// In any order of the parts.
void merge(Survey& into, const Survey& from) {
  merge(into.smallest, from.smallest,
        [](const ExtremeCorner& a, const ExtremeCorner& b) { return is_smaller(a, b); });
  merge(into.largest, from.largest,
        [](const ExtremeCorner& a, const ExtremeCorner& b) { return is_smaller(b, a); });
  into.not_convex += from.not_convex;
  keep_first(into.first_not_convex, from.first_not_convex);
  into.lattice_area.add(from.lattice_area);
  into.decisions.filter += from.decisions.filter;
  into.decisions.lattice += from.decisions.lattice;
  into.decisions.rational += from.decisions.rational;
}

}  // namespace

template <class Plane>
CornerScale corner_scale(const Plane& plane, const Quad& quad, int corner) {
  const auto i = static_cast<std::size_t>(corner);
  const RationalPoint at = plane.rational(quad[i]);
  CornerScale scale;
  for (const std::size_t k : {i, (i + 1) % 4, (i + 3) % 4}) {
    const RationalPoint p = plane.rational(quad[k]);
    for (const Rational& coordinate : {p.x, p.y}) {
      const Rational size = abs(coordinate);
      if (size > scale.largest_coordinate) scale.largest_coordinate = size;
    }
    const Rational dx = p.x - at.x;
    const Rational dy = p.y - at.y;
    const Rational squared = dx * dx + dy * dy;
    if (k == (i + 1) % 4 || (k != i && squared < scale.shorter_edge_squared))
      scale.shorter_edge_squared = squared;
  }
  return scale;
}

Survey survey_corners(const ExactPlane& plane, const std::vector<Quad>& quads,
                      const AngleInterval& interval, std::span<const CornerId> corners) {
  return Surveyor<ExactPlane>(plane, quads, interval, {}, false).survey(corners);
}

template <class Plane>
Survey survey_quads(const Plane& plane, const std::vector<Quad>& quads,
                    const AngleInterval& interval, std::span<const CornerId> exempt,
                    const Threads& threads, std::vector<std::uint8_t>& passes) {
  passes.resize(quads.size());
  const auto parts =
      for_chunks<Survey>(threads, quads.size(), [&](std::size_t begin, std::size_t end) {
        constexpr bool kMeasuresRounding = std::is_same_v<Plane, StoredPlane>;
        Surveyor<Plane> surveyor(plane, quads, interval, exempt, kMeasuresRounding);
        for (std::size_t q = begin; q < end; ++q) passes[q] = surveyor.look_at(q);
        return surveyor.take_survey();
      });
  Survey total;
  for (const Survey& part : parts) merge(total, part);
  return total;
}

Surveys survey_both(const ExactPlane& plane, const StoredPlane& stored,
                    const std::vector<std::uint8_t>& is_moved, const std::vector<Quad>& quads,
                    const AngleInterval& interval, std::span<const CornerId> exempt,
                    const Threads& threads, std::vector<std::uint8_t>& passes) {
  passes.resize(quads.size());
  const auto survey_chunk = [&](std::size_t begin, std::size_t end) {
    Surveyor<ExactPlane> unmoved(plane, quads, interval, exempt, true);
    Surveyor<ExactPlane> before(plane, quads, interval, exempt, false);
    Surveyor<StoredPlane> after(stored, quads, interval, exempt, true);
    for (std::size_t q = begin; q < end; ++q) {
      const auto& [a, b, c, d] = quads[q];
      if ((is_moved[a] | is_moved[b] | is_moved[c] | is_moved[d]) == 0) {
        passes[q] = unmoved.look_at(q);
      } else {
        passes[q] = before.look_at(q);
        after.look_at(q);
      }
    }
    Surveys part{unmoved.take_survey(), after.take_survey()};
    merge(part.stored, part.exact);
    merge(part.exact, before.take_survey());
    return part;
  };
  Surveys total;
  for (const Surveys& part : for_chunks<Surveys>(threads, quads.size(), survey_chunk)) {
    merge(total.exact, part.exact);
    merge(total.stored, part.stored);
  }
  return total;
}

template Survey survey_quads<ExactPlane>(const ExactPlane&, const std::vector<Quad>&,
                                         const AngleInterval&, std::span<const CornerId>,
                                         const Threads&, std::vector<std::uint8_t>&);
template Survey survey_quads<StoredPlane>(const StoredPlane&, const std::vector<Quad>&,
                                          const AngleInterval&, std::span<const CornerId>,
                                          const Threads&, std::vector<std::uint8_t>&);
template CornerScale corner_scale<StoredPlane>(const StoredPlane&, const Quad&, int);

}  // namespace quadbound::judge
