// SPDX-License-Identifier: Apache-2.0
#include "generators/edge_grid.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace quadbound::generators {
namespace {

std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
  const std::int64_t quotient = a / b;
  return quotient - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0);
}

/// y of the line through a and b at x, rounded down. Requires: a.x != b.x.
std::int64_t height_at(LatticePoint a, LatticePoint b, std::int64_t x) {
  return a.y + floor_divide((b.y - a.y) * (x - a.x), b.x - a.x);
}

int sign(std::int64_t value) { return (value > 0) - (value < 0); }

/// Whether p, on the line through a and b, lies between them or on one of them.
bool between(LatticePoint a, LatticePoint b, LatticePoint p) { return dot(p, a, b) <= 0; }

/// Whether two closed segments have a point in common.
bool meet(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const int ca = sign(turn(c, d, a));
  const int cb = sign(turn(c, d, b));
  const int ac = sign(turn(a, b, c));
  const int ad = sign(turn(a, b, d));
  if (ca * cb < 0 && ac * ad < 0) return true;
  return (ca == 0 && between(c, d, a)) || (cb == 0 && between(c, d, b)) ||
         (ac == 0 && between(a, b, c)) || (ad == 0 && between(a, b, d));
}

double squared_distance(LatticePoint p, LatticePoint a, LatticePoint b) {
  const auto length = static_cast<double>(dot(a, b, b));
  const auto along = static_cast<double>(dot(a, b, p));
  if (along <= 0) return static_cast<double>(dot(a, p, p));
  if (along >= length) return static_cast<double>(dot(b, p, p));
  const auto area = static_cast<double>(turn(a, b, p));
  return area * area / length;
}

}  // namespace

LatticeBox box_around(const std::vector<LatticePoint>& points) {
  LatticeBox box{points.front(), points.front()};
  for (const LatticePoint p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

EdgeGrid::EdgeGrid(const std::vector<LatticePoint>& points, LatticeBox box, std::size_t edges)
    : points_(points), low_(box.low) {
  const std::int64_t width = box.high.x - box.low.x;
  const std::int64_t height = box.high.y - box.low.y;
  const auto most = static_cast<std::int64_t>(edges) + 1;
  while (((width >> shift_) + 1) * ((height >> shift_) + 1) > most) ++shift_;
  columns_ = (width >> shift_) + 1;
  rows_ = (height >> shift_) + 1;
  buckets_.resize(static_cast<std::size_t>(columns_ * rows_));
}

template <class Visit>
bool EdgeGrid::any_bucket(VertexEdge edge, Visit visit) const {
  LatticePoint a = points_[edge.from];
  LatticePoint b = points_[edge.to];
  if (a.x > b.x) std::swap(a, b);
  const std::int64_t last = column(b.x);
  for (std::int64_t c = column(a.x); c <= last; ++c) {
    // The part of the edge over this column; the first and the last reach as far as they must.
    const std::int64_t left = c == column(a.x) ? a.x : low_.x + (c << shift_);
    const std::int64_t right = c == last ? b.x : low_.x + ((c + 1) << shift_);
    const bool upright = a.x == b.x;
    const std::int64_t from = upright ? a.y : height_at(a, b, left);
    const std::int64_t to = upright ? b.y : height_at(a, b, right);
    // Heights were rounded down.
    for (std::int64_t r = row(std::min(from, to)); r <= row(std::max(from, to) + 1); ++r)
      if (visit(index(c, r))) return true;
  }
  return false;
}

template <class Visit>
void EdgeGrid::buckets_around(LatticePoint place, std::int64_t distance, Visit visit) const {
  const std::int64_t c = column(place.x);
  const std::int64_t r = row(place.y);
  for (std::int64_t y = std::max<std::int64_t>(0, r - distance);
       y <= std::min(rows_ - 1, r + distance); ++y) {
    const bool whole = y == r - distance || y == r + distance;
    const std::int64_t step = whole || distance == 0 ? 1 : 2 * distance;
    for (std::int64_t x = c - distance; x <= c + distance; x += step)
      if (x >= 0 && x < columns_) visit(index(x, y));
  }
}

void EdgeGrid::insert(VertexEdge edge) {
  any_bucket(edge, [&](std::size_t bucket) {
    buckets_[bucket].push_back(edge);
    return false;
  });
}

void EdgeGrid::remove(VertexEdge edge) {
  any_bucket(edge, [&](std::size_t bucket) {
    Bucket& edges = buckets_[bucket];
    *std::find(edges.begin(), edges.end(), edge) = edges.back();
    edges.pop_back();
    return false;
  });
}

void EdgeGrid::insert_ring(std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i)
    insert(
        {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 1 < end ? i + 1 : first)});
}

bool EdgeGrid::in_conflict(VertexEdge a, VertexEdge b) const {
  if (a.from == b.to || a.to == b.from) std::swap(b.from, b.to);
  if (a.to == b.to) {
    std::swap(a.from, a.to);
    std::swap(b.from, b.to);
  }
  const LatticePoint start = points_[a.from];
  if (a.from != b.from) return meet(start, points_[a.to], points_[b.from], points_[b.to]);
  // A common end: they meet elsewhere too where one lies on the other.
  return turn(start, points_[a.to], points_[b.to]) == 0 &&
         dot(start, points_[a.to], points_[b.to]) > 0;
}

std::optional<VertexEdge> EdgeGrid::conflict(VertexEdge edge) const {
  std::optional<VertexEdge> found;
  any_bucket(edge, [&](std::size_t bucket) {
    for (const VertexEdge other : buckets_[bucket]) {
      if (!in_conflict(edge, other)) continue;
      found = other;
      return true;
    }
    return false;
  });
  return found;
}

std::vector<VertexEdge> EdgeGrid::edges_around(LatticePoint place, std::int64_t distance) const {
  std::vector<VertexEdge> edges;
  buckets_around(place, distance, [&](std::size_t bucket) {
    edges.insert(edges.end(), buckets_[bucket].begin(), buckets_[bucket].end());
  });
  const auto key = [](VertexEdge e) { return std::pair(e.from, e.to); };
  std::ranges::sort(edges, {}, key);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

double EdgeGrid::clearance(LatticePoint place) const {
  double best = std::numeric_limits<double>::infinity();
  for (std::int64_t distance = 0; distance <= farthest(); ++distance) {
    // Whatever was not looked at yet is farther than the buckets that were, but for one.
    const double seen = std::ldexp(static_cast<double>(distance - 1), shift_);
    if (distance > 1 && best <= seen * seen) break;
    buckets_around(place, distance, [&](std::size_t bucket) {
      for (const VertexEdge edge : buckets_[bucket])
        best = std::min(best, squared_distance(place, points_[edge.from], points_[edge.to]));
    });
  }
  return std::sqrt(best);
}

bool EdgeGrid::inside(LatticePoint place) const {
  bool result = false;
  const std::int64_t r = row(place.y);
  for (std::int64_t c = 0; c <= column(place.x); ++c) {
    for (const VertexEdge edge : buckets_[index(c, r)]) {
      const LatticePoint a = points_[edge.from];
      const LatticePoint b = points_[edge.to];
      if ((a.y > place.y) == (b.y > place.y)) continue;
      // An edge lies in several buckets; it counts in the one where it crosses this height.
      const std::int64_t x = a.x + floor_divide((place.y - a.y) * (b.x - a.x), b.y - a.y);
      if (x < place.x && column(x) == c) result = !result;
    }
  }
  return result;
}

}  // namespace quadbound::generators
