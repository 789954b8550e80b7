// SPDX-License-Identifier: Apache-2.0
#include "bench/feature_size.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "algo/fine_point.hpp"

namespace quadbound {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

struct Segment {
  Vector from;
  Vector to;
};

double distance(Vector at, const Segment& edge) {
  const Vector d = edge.to - edge.from;
  const double t = std::clamp(dot(at - edge.from, d) / dot(d, d), 0.0, 1.0);
  return length(at - edge.from - t * d);
}

/// The least rectangle around some edges.
struct Box {
  Vector low{kFar, kFar};
  Vector high{-kFar, -kFar};

  void add(Vector p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  [[nodiscard]] double distance_to(Vector p) const {
    return length(
        {std::max({low.x - p.x, 0.0, p.x - high.x}), std::max({low.y - p.y, 0.0, p.y - high.y})});
  }
};

class FeatureSize {
 public:
  explicit FeatureSize(const Polygon& polygon) {
    for (const Ring& ring : polygon.rings) add(ring);
    order_.resize(edges_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    boxes_.resize(4 * edges_.size());
    if (!edges_.empty()) build(0, 0, edges_.size());
  }

  [[nodiscard]] double integral_of_inverse() const {
    double sum = 0;
    for (std::size_t e = 0; e < edges_.size(); ++e) sum += along(e);
    return sum;
  }

 private:
  void add(const Ring& ring) {
    const std::size_t first = edges_.size();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      edges_.push_back({{a.x, a.y}, {b.x, b.y}});
      previous_.push_back(i == 0 ? first + ring.size() - 1 : edges_.size() - 2);
      next_.push_back(i + 1 == ring.size() ? first : edges_.size());
    }
  }

  /// A tree of boxes over order_[first, last), halved across its longer side; node k has its halves
  /// at 2 k + 1 and 2 k + 2.
  void build(std::size_t node, std::size_t first, std::size_t last) {
    Box& box = boxes_[node];
    for (std::size_t i = first; i < last; ++i) {
      box.add(edges_[order_[i]].from);
      box.add(edges_[order_[i]].to);
    }
    if (last - first <= kLeaf) return;
    const bool is_wide = box.high.x - box.low.x >= box.high.y - box.low.y;
    const auto place = [&](std::size_t e) {
      const Vector twice_middle = edges_[e].from + edges_[e].to;
      return is_wide ? twice_middle.x : twice_middle.y;
    };
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [this](std::size_t i) {
      return order_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(first), at(middle), at(last),
                     [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
    build(2 * node + 1, first, middle);
    build(2 * node + 2, middle, last);
  }

  [[nodiscard]] double along(std::size_t e) const {
    const Vector d = edges_[e].to - edges_[e].from;
    const double size = length(d);
    double sum = 0;
    for (double done = 0; done < size;) {
      const double first = at(e, edges_[e].from + (done / size) * d);
      const double step = std::min(first / 4, size - done);
      sum += step / at(e, edges_[e].from + ((done + step / 2) / size) * d);
      done += step;
    }
    return sum;
  }

  /// Nearest edge without a common vertex, or the two neighbours, which have none with each other.
  [[nodiscard]] double at(std::size_t e, Vector point) const {
    double least = kFar;
    if (next_[next_[e]] != previous_[e])
      least = std::max(distance(point, edges_[previous_[e]]), distance(point, edges_[next_[e]]));
    look(0, 0, edges_.size(), e, point, least);
    // A triangle has no two edges apart: a vertex and the opposite edge.
    if (std::isinf(least))
      least = std::max(length(point - edges_[e].from), length(point - edges_[e].to));
    return least;
  }

  void look(std::size_t node, std::size_t first, std::size_t last, std::size_t e, Vector point,
            double& least) const {
    if (boxes_[node].distance_to(point) >= least) return;
    if (last - first <= kLeaf) {
      for (std::size_t i = first; i < last; ++i)
        if (const std::size_t other = order_[i];
            other != e && other != previous_[e] && other != next_[e])
          least = std::min(least, distance(point, edges_[other]));
      return;
    }
    const std::size_t middle = first + (last - first) / 2;
    const bool is_left_nearer =
        boxes_[2 * node + 1].distance_to(point) <= boxes_[2 * node + 2].distance_to(point);
    if (is_left_nearer) look(2 * node + 1, first, middle, e, point, least);
    look(2 * node + 2, middle, last, e, point, least);
    if (!is_left_nearer) look(2 * node + 1, first, middle, e, point, least);
  }

  static constexpr std::size_t kLeaf = 4;  ///< edges that are looked at one by one
  std::vector<Segment> edges_;
  std::vector<std::size_t> previous_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> order_;
  std::vector<Box> boxes_;
};

}  // namespace

double inverse_feature_size_integral(const Polygon& polygon) {
  return FeatureSize(polygon).integral_of_inverse();
}

}  // namespace quadbound
