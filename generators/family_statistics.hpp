// SPDX-License-Identifier: Apache-2.0
#pragma once
// What polygons are like in numbers, so that one sees what a family does not cover.

#include <array>
#include <cstddef>
#include <cstdint>

#include "model/polygon.hpp"

namespace quadbound {

/// Ends of the classes of interior angles, in degrees. 18.43, 90 and 171.87 are where the theorem's
/// bounds and the kites begin; straight angles, decided exactly, have a class of their own.
inline constexpr std::array kAngleEnds{0.0,   0.1,    1.0,   18.43, 45.0,  90.0,
                                       135.0, 171.87, 180.0, 188.0, 225.0, 270.0,
                                       315.0, 350.0,  359.0, 359.9, 360.0};
inline constexpr std::size_t kAngleClasses = kAngleEnds.size() - 1;
/// Ratios are counted by the power of ten below them: [0.1, 1], [0.01, 0.1) and so on; the last
/// class has all that are smaller.
inline constexpr std::size_t kDecades = 8;

/// Shares and extremes over the polygons that were added.
///
/// The local feature size at a place is the radius of the smallest disk around it that meets two
/// edges or vertices without a common point (J. Ruppert, A Delaunay refinement algorithm for
/// quality 2-dimensional mesh generation, J. Algorithms 18, 1995); the smallest of a polygon is the
/// least distance of a vertex from an edge that does not end there. The extent is the longer side
/// of the bounding box.
struct FamilyStatistics {
  std::uint64_t polygons = 0;
  std::uint64_t vertices = 0;
  std::uint64_t holes = 0;
  std::array<std::uint64_t, kAngleClasses> angles{};
  std::uint64_t straight = 0;
  double smallest_angle = 360;  ///< in degrees; this and the next but for straight ones
  double largest_angle = 0;
  std::array<std::uint64_t, kDecades> features{};  ///< polygons by feature size / extent
  double smallest_feature = 1;                     ///< the same
  double largest_feature = 0;
  std::array<std::uint64_t, kDecades> edges{};  ///< polygons by shortest / longest edge
  double smallest_edge_ratio = 1;
  double largest_edge_ratio = 0;

  /// Requires: valid and normalised. Complexity: O(v log v) for v vertices, and their pairs of a
  /// vertex and an edge as near in x as the smallest feature.
  void add(const Polygon& polygon);
  /// Guarantees: 1. neither the order nor the grouping of what is added matters.
  void merge(const FamilyStatistics& other);

  /// Share of the corners in [0, 1].
  [[nodiscard]] double acute_share() const;
  [[nodiscard]] double reflex_share() const;
};

/// The smallest local feature size of a polygon. Requires and complexity: as for add.
double smallest_feature_size(const Polygon& polygon);

}  // namespace quadbound
