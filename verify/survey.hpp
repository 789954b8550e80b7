// SPDX-License-Identifier: Apache-2.0
#pragma once
// The geometry of single quads: corners against the bounds, areas, and how often the corners at a
// vertex pass the direction of the x axis. All lengths are in units of the mesh's lattice.

#include <optional>
#include <span>
#include <vector>

#include "model/angle.hpp"
#include "model/mesh.hpp"
#include "verify/chunks.hpp"
#include "verify/plane.hpp"
#include "verify/report.hpp"
#include "verify/wide.hpp"

namespace quadbound::judge {

struct CornerId {
  std::uint64_t quad;
  int corner;
  friend bool operator==(const CornerId&, const CornerId&) = default;
  friend auto operator<=>(const CornerId&, const CornerId&) = default;
};

/// Angles in [0, 360) in the order of their size: 0, (0, 180), 180, (180, 360).
template <class Number>
int sector(const Corner<Number>& corner) {
  if (corner.cross > 0) return 1;
  if (corner.cross < 0) return 3;
  return corner.dot < 0 ? 2 : 0;
}

template <class Number>
bool is_smaller(const Corner<Number>& a, const Corner<Number>& b) {
  const int sector_a = sector(a);
  const int sector_b = sector(b);
  if (sector_a != sector_b) return sector_a < sector_b;
  // Within an open half-turn the cotangent dot / cross falls; both crosses have the same sign.
  return sector_a % 2 == 1 && compare_products(a.dot, b.cross, b.dot, a.cross) > 0;
}

/// An extreme corner so far, in the number type of its quad.
struct ExtremeCorner {
  CornerId id{};
  Corner<Int128> lattice{0, 0};
  std::optional<Corner<Rational>> rational;

  [[nodiscard]] Corner<Rational> exact() const {
    if (rational) return *rational;
    return {to_rational(lattice.cross), to_rational(lattice.dot)};
  }
};

/// What one end of the angle interval met.
struct BoundTally {
  std::optional<ExtremeCorner> extreme;
  std::uint64_t broken = 0;
  /// The first corner whose excess rounding does not explain; only where rounding was asked for.
  std::optional<CornerId> beyond_slack;
};

struct Survey {
  BoundTally smallest;
  BoundTally largest;
  std::uint64_t not_convex = 0;
  std::optional<CornerId> first_not_convex;
  /// The sum of from x to over the quads' edges from -> to with both ends on the lattice: twice the
  /// signed areas of the quads, less the share of their other edges. Of the exact plane only: in
  /// surveys of the stored one it means nothing.
  WideSum lattice_area;
  Report::Decisions decisions;
};

/// Tangent of the angle by which a corner lies beyond a bound, as a fraction of two numbers; the
/// second is not positive from a right angle on. For the upper bound pass the corner with -dot.
template <class Number>
std::pair<Number, Number> excess_tangent(const Corner<Number>& corner, Arctangent bound) {
  return {Number(bound.numerator * corner.dot - bound.denominator * corner.cross),
          Number(bound.denominator * corner.dot + bound.numerator * corner.cross)};
}

/// Largest coordinate M at a corner and the square of its shorter edge l.
struct CornerScale {
  Rational largest_coordinate;
  Rational shorter_edge_squared;
};
template <class Plane>
CornerScale corner_scale(const Plane& plane, const Quad& quad, int corner);

/// Surveys all quads.
///
/// Guarantees: 1. the result does not depend on the number of threads. 2. of equal extremes, that
/// of the smallest quad and corner number. 3. bit i of passes[q] is set exactly when the corner i
/// of a strictly convex quad q spans the direction of the positive x axis, its first edge excluded
/// and its last edge included. 4. The bounds leave the exempt corners out; strictly-convex does
/// not. Requires: well-formed quads; every position of the plane finite; bounds with parts up to 7;
/// exempt corners ascend.
template <class Plane>
Survey survey_quads(const Plane& plane, const std::vector<Quad>& quads,
                    const AngleInterval& interval, std::span<const CornerId> exempt,
                    const Threads& threads, std::vector<std::uint8_t>& passes);

/// Of the mesh as it is, and of the mesh that its rounded vertices make.
struct Surveys {
  Survey exact;
  Survey stored;
};

/// Both surveys in one go: quads with no vertex that rounding moves are the same in both planes,
/// and looked at once. `is_moved` by vertex: StoredPlane::changes of those that are used.
///
/// Guarantees: 1. exact and stored are what survey_quads says of the two planes, but for their
/// decisions, which only exact counts all of, and for beyond_slack, which means nothing in exact.
/// 2. passes are those of the exact plane. Requires: as survey_quads.
Surveys survey_both(const ExactPlane& plane, const StoredPlane& stored,
                    const std::vector<std::uint8_t>& is_moved, const std::vector<Quad>& quads,
                    const AngleInterval& interval, std::span<const CornerId> exempt,
                    const Threads& threads, std::vector<std::uint8_t>& passes);

/// Only these corners, each against the bounds; the result has only smallest and largest, with the
/// second guarantee of survey_quads.
/// Requires: as survey_quads; corners ascend.
Survey survey_corners(const ExactPlane& plane, const std::vector<Quad>& quads,
                      const AngleInterval& interval, std::span<const CornerId> corners);

extern template Survey survey_quads<ExactPlane>(const ExactPlane&, const std::vector<Quad>&,
                                                const AngleInterval&, std::span<const CornerId>,
                                                const Threads&, std::vector<std::uint8_t>&);
extern template Survey survey_quads<StoredPlane>(const StoredPlane&, const std::vector<Quad>&,
                                                 const AngleInterval&, std::span<const CornerId>,
                                                 const Threads&, std::vector<std::uint8_t>&);
extern template CornerScale corner_scale<StoredPlane>(const StoredPlane&, const Quad&, int);

}  // namespace quadbound::judge
