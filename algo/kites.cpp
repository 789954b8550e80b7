// SPDX-License-Identifier: Apache-2.0
#include "algo/kites.hpp"

// Boost 1.74's R-tree includes a header of Boost that is deprecated and says so on every build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <algorithm>
#include <array>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

#include "model/exact.hpp"

namespace quadbound {
namespace {

/// |ap| as a part of the shorter edge: the kites at both ends of an edge leave a third of it.
constexpr double kLargestPart = 1.0 / 3;
/// By how much a kite shrinks while it is in the way of something.
constexpr double kShrink = 0.7;
/// What must be free of edges and other vertices, so that the mesh of B has room around the kite:
/// the kite times this. At most 3, or the far ends of a's edges would be in the way.
constexpr double kClearOfEdges = 1.5;
/// What must be free of other kites, likewise. Below 3/2, at which neighbours would touch.
constexpr double kClearOfKites = 1.25;
/// The coordinates that may be chosen are multiples of a power of two of about 2^-12 |pv|: rounding
/// then turns the sides at p and q by less than 2^-11, a thirtieth of a degree, and rationals on
/// the input's edges stay short.
constexpr int kStepBits = 12;
/// Of pv, in lattice units. At 2^8 rounding to the lattice turns the kite's sides by less than a
/// degree, and cells of an eighth of the side still have extra points on the lattice.
constexpr int kShortestSideBits = 8;
/// Bounding boxes are doubles of coordinates up to 2^60: wrong by 2^6 at most.
constexpr double kBoxMargin = 0x1p8;
/// Relative to the kites, far below the room that enlarging them makes, far above rounding.
constexpr double kSeparationMargin = 0x1p-40;
/// Of a kite in search of vertices. Each costs a descent into the tree of vertices.
constexpr double kMostSlices = 16;
constexpr int kPiecesPerEdge = 6;

using BoxPoint = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
using Box = boost::geometry::model::box<BoxPoint>;
using PointTree = boost::geometry::index::rtree<std::pair<BoxPoint, std::uint32_t>,
                                                boost::geometry::index::quadratic<16>>;
using BoxTree = boost::geometry::index::rtree<std::pair<Box, std::uint32_t>,
                                              boost::geometry::index::quadratic<16>>;

Vector as_doubles(const FinePoint& point) {
  return Vector{static_cast<double>(point.floor.x), static_cast<double>(point.floor.y)} +
         point.fraction;
}

template <std::size_t count>
Box box_around(Vector origin, const std::array<Vector, count>& offsets) {
  Vector low = offsets[0];
  Vector high = offsets[0];
  for (const Vector offset : offsets) {
    low = {std::min(low.x, offset.x), std::min(low.y, offset.y)};
    high = {std::max(high.x, offset.x), std::max(high.y, offset.y)};
  }
  return {{origin.x + low.x - kBoxMargin, origin.y + low.y - kBoxMargin},
          {origin.x + high.x + kBoxMargin, origin.y + high.y + kBoxMargin}};
}

/// The two edges of an acute vertex and the size of its kite.
struct Tip {
  EdgeId a;
  Vector along_p;  ///< unit vectors from a towards p and q
  Vector along_q;
  double reach;  ///< |ap| = |aq|, in lattice units

  [[nodiscard]] Vector p(double scale) const { return scale * reach * along_p; }
  [[nodiscard]] Vector q(double scale) const { return scale * reach * along_q; }
  /// Where the perpendiculars at p and q meet: its projections to both edges have length `reach`.
  [[nodiscard]] Vector v(double scale) const {
    return scale * reach / (1 + dot(along_p, along_q)) * (along_p + along_q);
  }
  /// |pv|: half the tip's angle has the tangent sin / (1 + cos).
  [[nodiscard]] double side() const {
    return reach * cross(along_p, along_q) / (1 + dot(along_p, along_q));
  }
};

/// Finds how large the kites may be.
class KiteSizes {
 public:
  KiteSizes(const Domain& whole, const std::vector<bool>& cut) : whole_(whole) {
    for (EdgeId a = 0; a < whole.size(); ++a)
      if (cut[a]) tips_.push_back(largest_tip(a));
  }

  std::vector<Tip> settle() {
    if (tips_.empty()) return {};
    for (const Tip& tip : tips_) check_size(tip);
    clear_of_edges();
    clear_of_kites();
    return std::move(tips_);
  }

 private:
  [[nodiscard]] Tip largest_tip(EdgeId a) const {
    const Vector to_p = whole_.direction(a);
    const Vector to_q = -1.0 * whole_.direction(whole_.previous(a));
    const double p = length(to_p);
    const double q = length(to_q);
    return {a, 1 / p * to_p, 1 / q * to_q, kLargestPart * std::min(p, q)};
  }

  void check_size(const Tip& tip) const {
    const double side = tip.side();
    if (side >= std::ldexp(1.0, kShortestSideBits)) return;
    const int level =
        whole_.root().side_bits - (side >= 1 ? std::ilogb(side) : 0);  // a cell as large as that
    throw TreeBudgetExceeded{RefusalKind::kTooDeep, whole_.floor(tip.a), level};
  }

  void shrink(Tip& tip) const {
    tip.reach *= kShrink;
    check_size(tip);
  }

  // --- clear of edges

  /// A kite that holds no vertex is met only by edges that pass in front of v: they cross the path
  /// p-v-q, since they cannot cross the polygon. So there are two searches, and each has little to
  /// look at even where thousands of long edges run side by side: vertices near the kite, and edges
  /// near its far end.
  void clear_of_edges() {
    std::vector<std::pair<BoxPoint, std::uint32_t>> points;
    for (EdgeId e = 0; e < whole_.size(); ++e) {
      const Vector at = as_doubles(whole_.at(e));
      points.emplace_back(BoxPoint(at.x, at.y), e);
    }
    const PointTree vertices(points);
    const BoxTree edges(boxes_of_edges());
    for (Tip& tip : tips_) {
      for (int slice = 0; slice < slices(tip); ++slice) clear_of_vertices(tip, slice, vertices);
      clear_far_end(tip, edges);
    }
  }

  /// The boxes of long slanted edges hold much besides, so edges come in pieces: kPiecesPerEdge for
  /// one of average length.
  [[nodiscard]] std::vector<std::pair<Box, std::uint32_t>> boxes_of_edges() const {
    double total = 0;
    for (EdgeId e = 0; e < whole_.size(); ++e) total += length(whole_.direction(e));
    const double longest = total / (kPiecesPerEdge * whole_.size());
    std::vector<std::pair<Box, std::uint32_t>> boxes;
    for (EdgeId e = 0; e < whole_.size(); ++e) {
      const Vector along = whole_.direction(e);
      const double count = std::ceil(length(along) / longest);
      for (double k = 0; k < count; ++k)
        boxes.emplace_back(box_around(as_doubles(whole_.at(e)),
                                      std::array{k / count * along, (k + 1) / count * along}),
                           e);
    }
    return boxes;
  }

  /// A long thin kite is searched in parts, whose boxes are small.
  static int slices(const Tip& tip) {
    return static_cast<int>(std::clamp(tip.reach / tip.side(), 1.0, kMostSlices));
  }

  void clear_of_vertices(Tip& tip, int slice, const PointTree& vertices) const {
    // Whatever is in the way makes the kite smaller at once, so that a kite costs the vertices near
    // the size it ends with, not those near the size it starts with.
    const int count = slices(tip);
    for (bool clear = false; !clear;) {
      clear = true;
      const double near = kClearOfEdges * slice / count;
      const double far = kClearOfEdges * (slice + 1) / count;
      const Box box = box_around(as_doubles(whole_.at(tip.a)),
                                 std::array{tip.p(near), tip.q(near), tip.p(far), tip.q(far),
                                            slice + 1 == count ? tip.v(far) : tip.p(far)});
      const auto end = vertices.qend();
      for (auto it = vertices.qbegin(boost::geometry::index::intersects(box)); clear && it != end;
           ++it) {
        while (is_inside(it->second, tip)) {
          shrink(tip);
          clear = false;
        }
      }
    }
  }

  void clear_far_end(Tip& tip, const BoxTree& edges) const {
    for (bool clear = false; !clear;) {
      clear = true;
      const Box box = box_around(as_doubles(whole_.at(tip.a)), cap(tip, kClearOfEdges));
      const auto end = edges.qend();
      for (auto it = edges.qbegin(boost::geometry::index::intersects(box)); clear && it != end;
           ++it) {
        while (is_in_the_way(it->second, tip)) {
          shrink(tip);
          clear = false;
        }
      }
    }
  }

  /// Whether the enlarged kite holds a vertex; exact for the kite's sides on the polygon, near
  /// which other edges may run as close as they like. The other sides have room.
  [[nodiscard]] bool is_inside(EdgeId vertex, const Tip& tip) const {
    if (vertex == tip.a) return false;
    const Vector at = whole_.at(vertex) - whole_.at(tip.a);
    const double far = kClearOfEdges * tip.reach;
    if (dot(tip.along_p, at) > far || dot(tip.along_q, at) > far) return false;
    const double margin = kSeparationMargin * (std::abs(at.x) + std::abs(at.y));
    if (cross(tip.along_p, at) < -margin || cross(at, tip.along_q) < -margin) return false;
    return whole_.side(tip.a, vertex) > 0 && whole_.side(whole_.previous(tip.a), vertex) > 0;
  }

  /// Whether an edge meets the enlarged kite, likewise.
  ///
  /// Edges that have the tip on their right, or on their line, are left out: P lies on their left,
  /// so that what the tip sees first of the kite's surroundings has the tip on its left.
  [[nodiscard]] bool is_in_the_way(EdgeId e, const Tip& tip) const {
    if (e == tip.a || e == whole_.previous(tip.a)) return false;
    const Vector from = whole_.at(e) - whole_.at(tip.a);
    const Vector to = whole_.at(whole_.next(e)) - whole_.at(tip.a);
    const double far = kClearOfEdges * tip.reach;
    if (dot(tip.along_p, from) > far && dot(tip.along_p, to) > far) return false;
    if (dot(tip.along_q, from) > far && dot(tip.along_q, to) > far) return false;
    const Vector along = to - from;
    const double above = cross(from, along);
    if (above < -kSeparationMargin * length(along) * (length(from) + length(to))) return false;
    const std::array<Vector, 3> corners = cap(tip, kClearOfEdges);
    if (above > 0 && std::all_of(corners.begin(), corners.end(),
                                 [&](Vector corner) { return cross(along, corner - from) > 0; }))
      return false;
    return !is_right_of(tip.a, e) && !is_right_of(whole_.previous(tip.a), e) &&
           whole_.side(e, tip.a) > 0;
  }

  [[nodiscard]] bool is_right_of(EdgeId line, EdgeId e) const {
    return whole_.side(line, e) <= 0 && whole_.side(line, whole_.next(e)) <= 0;
  }

  // --- clear of other kites

  /// No edge separates two kites that meet, and no tip lies in another kite: so the paths p-v-q
  /// cross, and it is enough to keep the triangles p, v, q apart. They are small where tips are
  /// sharp.
  void clear_of_kites() {
    std::vector<std::pair<Box, std::uint32_t>> boxes;
    boxes.reserve(tips_.size());
    for (std::size_t i = 0; i < tips_.size(); ++i)
      boxes.emplace_back(
          box_around(as_doubles(whole_.at(tips_[i].a)), cap(tips_[i], kClearOfKites)),
          static_cast<std::uint32_t>(i));
    const BoxTree tree(boxes);
    std::vector<std::pair<Box, std::uint32_t>> near;
    for (const auto& [box, i] : boxes) {
      near.clear();
      tree.query(boost::geometry::index::intersects(box), std::back_inserter(near));
      for (const auto& other : near)
        if (other.second > i) keep_apart(tips_[i], tips_[other.second]);
    }
  }

  /// The far end of a kite, counter-clockwise.
  static std::array<Vector, 3> cap(const Tip& tip, double scale) {
    return {tip.p(scale), tip.v(scale), tip.q(scale)};
  }

  void keep_apart(Tip& first, Tip& second) const {
    const Vector between = whole_.at(second.a) - whole_.at(first.a);
    for (;;) {
      std::array<Vector, 3> moved = cap(second, kClearOfKites);
      for (Vector& corner : moved) corner = corner + between;
      const std::array<Vector, 3> still = cap(first, kClearOfKites);
      if (are_separated(still, moved) || are_separated(moved, still)) return;
      const double larger = std::max(first.reach, second.reach);
      if (first.reach == larger) shrink(first);
      if (second.reach == larger) shrink(second);
    }
  }

  /// Whether the line of a side of `triangle`, counter-clockwise, has the other one on its right.
  static bool are_separated(const std::array<Vector, 3>& triangle,
                            const std::array<Vector, 3>& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector at = triangle[k];
      const Vector along = triangle[(k + 1) % 3] - at;
      const double margin = kSeparationMargin * dot(along, along);
      if (std::all_of(other.begin(), other.end(),
                      [&](Vector corner) { return cross(along, corner - at) <= margin; }))
        return true;
    }
    return false;
  }

  const Domain& whole_;
  std::vector<Tip> tips_;
};

/// The three vertices of a kite on the lattice and on the edges.
struct PlacedKite {
  RationalPoint p;
  RationalPoint v;
  RationalPoint q;
};

/// A multiple of 2^bits near base + offset.
std::int64_t rounded_to(int bits, std::int64_t base, double offset) {
  const std::int64_t step = std::int64_t{1} << bits;
  return (base + std::llround(offset) + step / 2) & -step;
}
LatticePoint rounded_to(int bits, const FinePoint& base, Vector offset) {
  return {rounded_to(bits, base.floor.x, base.fraction.x + offset.x),
          rounded_to(bits, base.floor.y, base.fraction.y + offset.y)};
}

/// Number of the Steiner point of edge e near base + offset, see Domain::foot.
std::int64_t foot_near(const Domain& whole, EdgeId e, int bits, const FinePoint& base,
                       Vector offset) {
  const LatticePoint near = rounded_to(bits, base, offset);
  return whole.runs_in_x(e) ? near.x : near.y;
}

Rational dot_at(const RationalPoint& at, const RationalPoint& a, const RationalPoint& b) {
  return (a.x - at.x) * (b.x - at.x) + (a.y - at.y) * (b.y - at.y);
}
Rational cross_at(const RationalPoint& at, const RationalPoint& a, const RationalPoint& b) {
  return (a.x - at.x) * (b.y - at.y) - (a.y - at.y) * (b.x - at.x);
}

/// Guarantees 1 and 2 of cut_kites, exactly.
bool is_usable(const RationalPoint& a, const PlacedKite& kite) {
  return dot_at(a, kite.p, kite.q) > 0 && dot_at(kite.p, a, kite.v) >= 0 &&
         dot_at(kite.q, a, kite.v) >= 0 && cross_at(a, kite.p, kite.v) > 0 &&
         cross_at(a, kite.v, kite.q) > 0 && dot_at(kite.v, kite.p, kite.q) <= 0;
}

/// Only p is measured from the tip, q and v are from there: what is as small as the kite is wide
/// is never the difference of numbers as large as it is long.
PlacedKite place(const Domain& whole, const Tip& tip) {
  const int bits = std::max(0, std::ilogb(tip.side()) - kStepBits);
  const EdgeId incoming = whole.previous(tip.a);
  const std::int64_t p_foot = foot_near(whole, tip.a, bits, whole.at(tip.a), tip.p(1));
  const FinePoint p = whole.foot_point(tip.a, p_foot);
  const Vector sum = tip.along_p + tip.along_q;
  const Vector middle = 1 / length(sum) * sum;
  // q - p = 2 |ap| sin(angle / 2) across the bisector.
  const double tangent = tip.side() / tip.reach;
  const double cosine = 1 / std::sqrt(1 + tangent * tangent);
  const Vector chord = 2 * tip.side() * cosine * turned_left(middle);
  const std::int64_t q_foot = foot_near(whole, incoming, bits, p, chord);
  // How much farther from the tip q came out than p.
  const double excess = dot(whole.foot_point(incoming, q_foot) - p, middle) / cosine;
  // Rounding moves v by up to 0.71 steps: from a step short of the nearer foot it cannot pass the
  // perpendicular at either foot.
  const double short_of_p = std::ldexp(1.0, bits) - std::min(0.0, excess);
  const double height = tangent * (dot(p - whole.at(tip.a), tip.along_p) - short_of_p);
  const LatticePoint v =
      rounded_to(bits, p, height * turned_left(tip.along_p) - short_of_p * tip.along_p);
  const int exponent = whole.root().exponent;
  PlacedKite kite{whole.foot_exact(tip.a, p_foot),
                  {dyadic(v.x, exponent), dyadic(v.y, exponent)},
                  whole.foot_exact(incoming, q_foot)};
  // Only directions of tips so sharp that doubles cannot tell them can fail here.
  if (!is_usable(whole.vertices().exact(tip.a), kite))
    throw TreeBudgetExceeded{RefusalKind::kTooDeep, whole.floor(tip.a), whole.root().side_bits};
  return kite;
}

std::vector<std::vector<RationalPoint>> exact_rings(const Polygon& polygon) {
  std::vector<std::vector<RationalPoint>> rings;
  for (const Ring& ring : polygon.rings) {
    std::vector<RationalPoint>& exact = rings.emplace_back();
    exact.reserve(ring.size());
    for (const Point& point : ring) exact.push_back(exact_value(point));
  }
  return rings;
}

}  // namespace

Domain cut_kites(const Polygon& polygon, const RootSquare& root, const std::vector<bool>& cut) {
  Domain whole(root, polygon);
  const std::vector<Tip> tips = KiteSizes(whole, cut).settle();
  if (tips.empty()) return whole;
  std::vector<std::vector<RationalPoint>> rings = exact_rings(polygon);
  std::vector<Kite> kites;
  kites.reserve(tips.size());
  EdgeId vertex = 0;  // of the whole polygon
  EdgeId count = 0;   // of the domain's vertices
  for (std::vector<RationalPoint>& ring : rings) {
    std::vector<RationalPoint> shorter;
    for (RationalPoint& point : ring) {
      if (cut[vertex++]) {
        const PlacedKite kite = place(whole, tips[kites.size()]);
        shorter.insert(shorter.end(), {kite.q, kite.v, kite.p});
        count += 3;
        kites.push_back({std::move(point), count - 1, count - 2, count - 3});
      } else {
        shorter.push_back(std::move(point));
        ++count;
      }
    }
    ring = std::move(shorter);
  }
  Domain domain(root, rings);
  domain.kites = std::move(kites);
  return domain;
}

}  // namespace quadbound
