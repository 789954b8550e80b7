// SPDX-License-Identifier: Apache-2.0
#pragma once
// How large quadtree cells may be: finer trees keep the theorem, so the user may ask for them.

#include <limits>
#include <memory>
#include <vector>

#include "model/polygon.hpp"

namespace quadbound {

/// Near a segment (or a point: a == b) cells are no wider than `size`, and `growth` times the
/// distance more away from it.
struct SizeSource {
  Point a;
  Point b;
  double size = 0;
  double growth = 0;
};

struct Sizing {
  double largest = std::numeric_limits<double>::infinity();
  std::vector<SizeSource> sources;
  /// The same for all edges of the polygon, if its size is positive.
  double boundary_size = 0;
  double boundary_growth = 0;

  [[nodiscard]] bool is_free() const {
    return largest == std::numeric_limits<double>::infinity() && sources.empty() &&
           boundary_size <= 0;
  }
};

/// A sizing ready to be asked.
///
/// Requires: sizes are positive, growths are not negative. Complexity of a question: linear in the
/// sources, logarithmic in the edges of the polygon.
class SizeField {
 public:
  SizeField(const Sizing& sizing, const Polygon& polygon);
  ~SizeField();
  SizeField(const SizeField&) = delete;
  SizeField& operator=(const SizeField&) = delete;

  [[nodiscard]] bool is_free() const { return sizing_.is_free(); }
  /// The largest side that a cell with its centre here may have.
  [[nodiscard]] double size_at(const Point& point) const;

 private:
  struct Edges;
  const Sizing& sizing_;
  std::unique_ptr<Edges> edges_;
};

}  // namespace quadbound
