// SPDX-License-Identifier: Apache-2.0
#include "algo/nearest_neighbour.hpp"

#include <algorithm>
#include <numeric>

namespace quadbound {
namespace {

/// A k-d tree laid out in a permutation of the points: the median of a range is its root.
class KdTree {
 public:
  KdTree(const std::vector<LatticePoint>& points, const std::vector<bool>& rounded)
      : points_(points), rounded_(rounded), order_(points.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    build(0, order_.size(), 0);
  }

  [[nodiscard]] UInt128 nearest_square(std::uint32_t query) const {
    UInt128 best = ~UInt128{0};
    search(0, order_.size(), 0, query, best);
    return best;
  }

 private:
  /// Below this size a range is searched one by one; found by timing, the result does not depend on
  /// it.
  static constexpr std::size_t kBucket = 8;

  [[nodiscard]] std::int64_t coordinate(std::uint32_t id, int axis) const {
    return axis == 0 ? points_[id].x : points_[id].y;
  }

  void build(std::size_t first, std::size_t last, int axis) {
    if (last - first <= kBucket) return;
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [this](std::size_t i) {
      return order_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t a, std::uint32_t b) {
      return coordinate(a, axis) < coordinate(b, axis);
    });
    build(first, middle, 1 - axis);
    build(middle + 1, last, 1 - axis);
  }

  /// A lower bound of |difference| that holds for what rounded points stand for.
  static UInt128 square(std::int64_t difference, bool is_rounded) {
    std::int64_t length = difference < 0 ? -difference : difference;
    if (is_rounded && length > 0) --length;
    return UInt128(length) * UInt128(length);
  }

  void consider(std::uint32_t candidate, std::uint32_t query, UInt128& best) const {
    if (candidate == query) return;
    const bool is_rounded = rounded_[candidate] || rounded_[query];
    const UInt128 distance = square(points_[candidate].x - points_[query].x, is_rounded) +
                             square(points_[candidate].y - points_[query].y, is_rounded);
    best = std::min(best, distance);
  }

  void search(std::size_t first, std::size_t last, int axis, std::uint32_t query,
              UInt128& best) const {
    if (last - first <= kBucket) {
      for (std::size_t i = first; i < last; ++i) consider(order_[i], query, best);
      return;
    }
    const std::size_t middle = first + (last - first) / 2;
    const std::int64_t side = coordinate(query, axis) - coordinate(order_[middle], axis);
    const auto near_half = side < 0 ? std::pair{first, middle} : std::pair{middle + 1, last};
    const auto far_half = side < 0 ? std::pair{middle + 1, last} : std::pair{first, middle};
    search(near_half.first, near_half.second, 1 - axis, query, best);
    consider(order_[middle], query, best);
    // `true`: points beyond the line may be rounded, so that it may be one unit nearer.
    if (square(side, true) < best) search(far_half.first, far_half.second, 1 - axis, query, best);
  }

  const std::vector<LatticePoint>& points_;
  const std::vector<bool>& rounded_;
  std::vector<std::uint32_t> order_;
};

}  // namespace

std::vector<UInt128> nearest_neighbour_squares(const std::vector<LatticePoint>& points,
                                               const std::vector<bool>& rounded) {
  const KdTree tree(points, rounded);
  std::vector<UInt128> squares(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    squares[i] = tree.nearest_square(static_cast<std::uint32_t>(i));
  return squares;
}

}  // namespace quadbound
