// SPDX-License-Identifier: Apache-2.0
#include "cli/shrink_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "model/errors.hpp"
#include "model/validate.hpp"

namespace quadbound::cli {
namespace {

class Shrinker {
 public:
  Shrinker(Polygon polygon, const std::function<bool(const Polygon&)>& still_fails,
           std::size_t most_tries)
      : polygon_(std::move(polygon)), still_fails_(still_fails), tries_left_(most_tries) {}

  Polygon run() {
    // Where vertices have gone, holes may be able to go that could not before.
    while (drop_holes() || drop_vertices()) {
    }
    snap();
    return std::move(polygon_);
  }

 private:
  bool drop_holes() {
    return drop_in_chunks(polygon_.rings.size() - 1, [this](std::size_t first, std::size_t count) {
      Polygon smaller = polygon_;
      const auto begin = smaller.rings.begin() + 1 + static_cast<std::ptrdiff_t>(first);
      smaller.rings.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
      return accept(std::move(smaller));
    });
  }

  bool drop_vertices() {
    bool dropped = false;
    for (std::size_t ring = 0; ring < polygon_.rings.size(); ++ring) {
      const auto try_to = [this, ring](std::size_t first, std::size_t count) {
        Polygon smaller = polygon_;
        Ring& vertices = smaller.rings[ring];
        if (vertices.size() < count + 3) return false;
        const auto begin = vertices.begin() + static_cast<std::ptrdiff_t>(first);
        vertices.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
        return accept(std::move(smaller));
      };
      dropped = drop_in_chunks(polygon_.rings[ring].size(), try_to) || dropped;
    }
    return dropped;
  }

  /// Tries to drop halves of `size` things, then quarters and so on; whether any went.
  template <class Drop>
  bool drop_in_chunks(std::size_t size, const Drop& drop) {
    bool dropped = false;
    for (std::size_t chunk = (size + 1) / 2; chunk > 0 && size > 0; chunk /= 2) {
      for (std::size_t first = 0; first < size;) {
        const std::size_t count = std::min(chunk, size - first);
        if (drop(first, count)) {
          dropped = true;
          size -= count;
        } else {
          first += count;
        }
      }
    }
    return dropped;
  }

  void snap() {
    constexpr int kCoarsest = 4;
    constexpr int kFinest = -20;
    for (int exponent = kCoarsest; exponent > kFinest; --exponent) {
      Polygon coarser = polygon_;
      for (Ring& ring : coarser.rings)
        for (Point& p : ring) p = {on_grid(p.x, exponent), on_grid(p.y, exponent)};
      if (coarser.rings == polygon_.rings || accept(std::move(coarser))) return;
    }
  }

  static double on_grid(double value, int exponent) {
    return std::ldexp(std::round(std::ldexp(value, -exponent)), exponent);
  }

  bool accept(Polygon candidate) {
    if (tries_left_ == 0) return false;
    try {
      candidate = normalised(std::move(candidate));
    } catch (const InputError&) {
      return false;
    }
    --tries_left_;
    if (!still_fails_(candidate)) return false;
    polygon_ = std::move(candidate);
    return true;
  }

  Polygon polygon_;
  const std::function<bool(const Polygon&)>& still_fails_;
  std::size_t tries_left_;
};

}  // namespace

Polygon shrunk(Polygon polygon, const std::function<bool(const Polygon&)>& still_fails,
               std::size_t most_tries) {
  return Shrinker(std::move(polygon), still_fails, most_tries).run();
}

}  // namespace quadbound::cli
