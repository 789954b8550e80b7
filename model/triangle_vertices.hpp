// SPDX-License-Identifier: Apache-2.0
#pragma once
// The vertex section that Triangle's .node and .poly files share.

#include <cstdint>
#include <vector>

#include "model/exact.hpp"
#include "model/text_scanner.hpp"

namespace quadbound {

struct TriangleVertices {
  std::vector<Point> points;
  std::uint64_t first_number = 0;  ///< 0 or 1, the number of the first vertex in the file
};

/// Reads "count 2 attributes markers" and that many lines "number x y ...".
///
/// Guarantees: 1. vertices are numbered consecutively from 0 or 1. 2. Attributes and markers must
/// be numbers and are dropped; they may be missing.
/// Errors: InputError naming line and vertex (counted from 0).
TriangleVertices read_triangle_vertices(TextScanner& scanner);

}  // namespace quadbound
