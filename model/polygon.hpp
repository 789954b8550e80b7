// SPDX-License-Identifier: Apache-2.0
#pragma once
// What is meshed: a set of points (Section 2 of the paper) or a polygon with holes (Sections 3, 4).
// y points up. Coordinates are doubles and are taken as exact.

#include <string>
#include <vector>

#include "model/exact.hpp"

namespace quadbound {

struct PointSet {
  std::string file;  ///< where it came from, for messages
  std::vector<Point> points;
};

/// A closed chain; the edge from the last vertex to the first is implied.
using Ring = std::vector<Point>;

/// Ring 0 is the outer ring, counter-clockwise once normalised; the others are holes, clockwise.
struct Polygon {
  std::string file;  ///< where it came from, for messages
  std::vector<Ring> rings;
};

}  // namespace quadbound
