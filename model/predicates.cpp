// SPDX-License-Identifier: Apache-2.0
#include "model/predicates.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace quadbound {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 kernel_point(const Point& p) { return {p.x, p.y}; }

/// Requires: p on the line through a and b.
bool between(const Point& p, const Point& a, const Point& b) {
  const auto [low, high] = std::minmax(a, b, lexicographically_before);
  return !lexicographically_before(p, low) && !lexicographically_before(high, p);
}

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c) {
  return CGAL::orientation(kernel_point(a), kernel_point(b), kernel_point(c));
}

Meeting meeting(const Point& a, const Point& b, const Point& c, const Point& d) {
  const int c_side = orientation(a, b, c);
  const int d_side = orientation(a, b, d);
  if (c_side * d_side > 0) return Meeting::kApart;
  const int a_side = orientation(c, d, a);
  const int b_side = orientation(c, d, b);
  if (c_side * d_side < 0 && a_side * b_side < 0) return Meeting::kCross;
  const bool touch = (c_side == 0 && between(c, a, b)) || (d_side == 0 && between(d, a, b)) ||
                     (a_side == 0 && between(a, c, d)) || (b_side == 0 && between(b, c, d));
  return touch ? Meeting::kTouch : Meeting::kApart;
}

bool strictly_inside(const Point& point, const Ring& ring) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[i + 1 == ring.size() ? 0 : i + 1];
    const bool a_above = a.y > point.y;
    const bool b_above = b.y > point.y;
    // Edges whose box misses the point and that a ray to the right misses need no exact sign.
    if (std::max(a.x, b.x) < point.x || std::min(a.y, b.y) > point.y ||
        std::max(a.y, b.y) < point.y)
      continue;
    const int side = orientation(a, b, point);
    if (side == 0 && between(point, a, b)) return false;
    if (a_above != b_above && (side > 0) == b_above) inside = !inside;
  }
  return inside;
}

}  // namespace quadbound
