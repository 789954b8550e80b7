// SPDX-License-Identifier: Apache-2.0
#pragma once
// Exact signs for points in doubles. Floating point is only a filter in front of exact arithmetic.

#include "model/polygon.hpp"

namespace quadbound {

/// +1 where a, b, c turn counter-clockwise, -1 clockwise, 0 where they lie on one line.
///
/// Guarantees: 1. exact for all finite doubles, subnormals and values near the overflow limit too.
/// 2. orientation(a, b, c) == orientation(b, c, a) == -orientation(b, a, c).
/// Requires: finite coordinates.
int orientation(const Point& a, const Point& b, const Point& c);

/// The order of a sweep from left to right, on vertical lines from below.
inline bool lexicographically_before(const Point& a, const Point& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

enum class Meeting {
  kApart,
  kTouch,  ///< an end of one lies on the other, or they overlap
  kCross,  ///< one common point, inside both
};

/// How two closed segments ab and cd meet. Requires: a != b, c != d.
Meeting meeting(const Point& a, const Point& b, const Point& c, const Point& d);

/// Whether a point lies inside a closed chain (even-odd rule) and on none of its edges.
bool strictly_inside(const Point& point, const Ring& ring);

}  // namespace quadbound
