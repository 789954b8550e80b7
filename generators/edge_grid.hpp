// SPDX-License-Identifier: Apache-2.0
#pragma once
// Edges in square buckets; private to generators/. It answers what a family asks while it builds a
// polygon: what does this segment meet, how much room is here, is this place inside.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "generators/polygon_families.hpp"

namespace quadbound::generators {

struct LatticeBox {
  LatticePoint low;
  LatticePoint high;
};

/// The smallest box around some points. Requires: one point at least.
LatticeBox box_around(const std::vector<LatticePoint>& points);

/// A directed edge, by the indices of its ends.
struct VertexEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  friend bool operator==(const VertexEdge&, const VertexEdge&) = default;
};

/// Edges that may be put in and taken out; they may lie outside the box, but are slower there.
///
/// Answers depend on the order of the calls alone. Time for an edge or a question is proportional
/// to the buckets and edges near it: constant where edges are short and spread evenly, O(sqrt(n))
/// at most for one long edge or inside().
class EdgeGrid {
 public:
  /// Buckets for about so many edges. The points must outlive the grid; more may be appended.
  /// Requires: coordinates below 2^30.
  EdgeGrid(const std::vector<LatticePoint>& points, LatticeBox box, std::size_t edges);

  void insert(VertexEdge edge);
  /// Requires: the edge is there, in this direction.
  void remove(VertexEdge edge);
  /// The edges from each of the points [first, end) to the next, and back to the first.
  void insert_ring(std::size_t first, std::size_t end);

  /// An edge that the given one meets in more than a common end. Requires: it is not in the grid.
  [[nodiscard]] std::optional<VertexEdge> conflict(VertexEdge edge) const;

  /// The edges in the buckets at a distance of so many buckets, sorted by their ends, each once.
  [[nodiscard]] std::vector<VertexEdge> edges_around(LatticePoint place,
                                                     std::int64_t distance) const;
  /// The distance from which no bucket is left.
  [[nodiscard]] std::int64_t farthest() const { return std::max(columns_, rows_); }

  /// The distance to the nearest edge, to a few units in the last place. Requires: a place in the
  /// box, one edge at least.
  [[nodiscard]] double clearance(LatticePoint place) const;

  /// Whether the edges, closed rings all, lie around the place (even-odd rule). Requires: the place
  /// lies on none of them.
  [[nodiscard]] bool inside(LatticePoint place) const;

 private:
  using Bucket = std::vector<VertexEdge>;

  [[nodiscard]] std::int64_t column(std::int64_t x) const {
    return std::clamp((x - low_.x) >> shift_, std::int64_t{0}, columns_ - 1);
  }
  [[nodiscard]] std::int64_t row(std::int64_t y) const {
    return std::clamp((y - low_.y) >> shift_, std::int64_t{0}, rows_ - 1);
  }
  [[nodiscard]] std::size_t index(std::int64_t column, std::int64_t row) const {
    return static_cast<std::size_t>(row * columns_ + column);
  }
  /// Calls visit(index of a bucket) for a superset of those that the edge meets, until it is true.
  template <class Visit>
  bool any_bucket(VertexEdge edge, Visit visit) const;
  template <class Visit>
  void buckets_around(LatticePoint place, std::int64_t distance, Visit visit) const;
  [[nodiscard]] bool in_conflict(VertexEdge a, VertexEdge b) const;

  const std::vector<LatticePoint>& points_;
  LatticePoint low_;
  int shift_ = 0;  ///< buckets are 2^shift wide
  std::int64_t columns_ = 1;
  std::int64_t rows_ = 1;
  std::vector<Bucket> buckets_;
};

}  // namespace quadbound::generators
