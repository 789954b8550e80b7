// SPDX-License-Identifier: Apache-2.0
#include "verify/places.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <map>
#include <utility>

namespace quadbound::judge {
namespace {

struct Lexicographic {
  bool operator()(const RationalPoint& a, const RationalPoint& b) const {
    const int by_x = a.x.compare(b.x);
    return by_x != 0 ? by_x < 0 : a.y < b.y;
  }
};

/// Vertices by their positions, without rationals where fixed point tells.
class ByPosition {
 public:
  explicit ByPosition(const ExactPlane& plane) : plane_(plane) {}
  bool operator()(VertexId a, VertexId b) const {
    const auto p = plane_.fixed(a);
    const auto q = plane_.fixed(b);
    if (p && q) {
      const auto by_x = sign_of_difference(p->x, q->x);
      if (by_x && *by_x != 0) return *by_x > 0;
      const auto by_y = sign_of_difference(p->y, q->y);
      if (by_x && by_y) return *by_y > 0;
    }
    return Lexicographic{}(plane_.rational(a), plane_.rational(b));
  }

 private:
  const ExactPlane& plane_;
};

std::uint64_t hash(LatticePoint p) {
  std::uint64_t h = static_cast<std::uint64_t>(p.x) * 0x9e3779b97f4a7c15U;
  h ^= std::rotl(static_cast<std::uint64_t>(p.y) * 0xc2b2ae3d27d4eb4fU, 32);
  return (h ^ (h >> 29)) * 0xff51afd7ed558ccdU;
}

/// A hash table of numbers of lattice points that are kept elsewhere; linear probing.
class LatticeTable {
 public:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// At least `room` slots per entry.
  LatticeTable(std::size_t entries, std::size_t room)
      : slots_(std::bit_ceil(room * entries + 2), kNone),
        shift_(64 - std::countr_zero(slots_.size())) {}

  /// The number stored for the point; stores `number` and returns kNone where there is none.
  template <class PointOf>
  std::uint32_t insert(LatticePoint point, std::uint32_t number, const PointOf& point_of) {
    const std::size_t slot = slot_of(point, point_of);
    if (slots_[slot] != kNone) return slots_[slot];
    slots_[slot] = number;
    return kNone;
  }
  template <class PointOf>
  [[nodiscard]] std::uint32_t find(LatticePoint point, const PointOf& point_of) const {
    return slots_[slot_of(point, point_of)];
  }

 private:
  template <class PointOf>
  [[nodiscard]] std::size_t slot_of(LatticePoint point, const PointOf& point_of) const {
    std::size_t slot = hash(point) >> shift_;
    while (slots_[slot] != kNone && point_of(slots_[slot]) != point)
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  std::vector<std::uint32_t> slots_;
  int shift_;
};

/// Input points by position; a mark for each that some vertex has found.
class PointIndex {
 public:
  PointIndex(const std::vector<Point>& points, int exponent)
      : table_(points.size(), 4),
        hints_(std::bit_ceil(points.size() + 2)),
        hint_shift_(64 - 5 - std::countr_zero(hints_.size())),
        found_(points.size()),
        same_as_(points.size()) {
    const Rational unit = dyadic(1, -exponent);
    lattice_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) insert(i, points[i], exponent, unit);
  }

  /// The first input point at a place.
  [[nodiscard]] std::optional<std::uint32_t> find(LatticePoint point) const {
    if (!may_hold(point)) return std::nullopt;
    const std::uint32_t i = table_.find(point, [&](std::uint32_t k) { return lattice_[k]; });
    if (i == LatticeTable::kNone) return std::nullopt;
    return i;
  }
  [[nodiscard]] std::optional<std::uint32_t> find(const RationalPoint& point) const {
    const auto it = others_.find(point);
    if (it == others_.end()) return std::nullopt;
    return it->second;
  }
  [[nodiscard]] std::optional<std::uint32_t> find(const ExactPlane& plane, VertexId v) const {
    if (plane.on_lattice(v)) return find(plane.lattice(v));
    if (others_.empty()) return std::nullopt;
    return find(plane.rational(v));
  }

  void mark(std::uint32_t point) { found_[point].store(true, std::memory_order_relaxed); }

  [[nodiscard]] LostPoints lost() const {
    LostPoints lost;
    for (std::size_t i = 0; i < found_.size(); ++i)
      if (!found_[same_as_[i]].load(std::memory_order_relaxed) && lost.count++ == 0) lost.first = i;
    return lost;
  }

 private:
  void insert(std::size_t i, const Point& point, int exponent, const Rational& unit) {
    same_as_[i] = static_cast<std::uint32_t>(i);
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) return;
    const auto x = lattice_floor(point.x, exponent);
    const auto y = lattice_floor(point.y, exponent);
    if (x && y && x->exact && y->exact) {
      lattice_[i] = {x->floor, y->floor};
      const std::uint64_t hint = hash(lattice_[i]) >> hint_shift_;
      hints_[hint / 32] |= 1U << (hint % 32);
      const std::uint32_t same =
          table_.insert(lattice_[i], same_as_[i], [&](std::uint32_t k) { return lattice_[k]; });
      if (same != LatticeTable::kNone) same_as_[i] = same;
    } else {
      const RationalPoint exact = exact_value(point);
      same_as_[i] =
          others_.emplace(RationalPoint{exact.x * unit, exact.y * unit}, same_as_[i]).first->second;
    }
  }

  /// Most vertices are no input point, and 32 bits per point rule out nearly all of those.
  [[nodiscard]] bool may_hold(LatticePoint point) const {
    const std::uint64_t hint = hash(point) >> hint_shift_;
    return ((hints_[hint / 32] >> (hint % 32)) & 1U) != 0;
  }

  LatticeTable table_;
  std::vector<std::uint32_t> hints_;
  int hint_shift_;
  std::vector<LatticePoint> lattice_;
  std::map<RationalPoint, std::uint32_t, Lexicographic> others_;
  std::vector<std::atomic<bool>> found_;
  std::vector<std::uint32_t> same_as_;  ///< the first point at the same position
};

/// The same among vertices off the lattice, which are ascending.
std::optional<CoincidentVertices> find_coincident(const ByPosition& less,
                                                  std::vector<VertexId> vertices) {
  std::stable_sort(vertices.begin(), vertices.end(), less);
  std::optional<CoincidentVertices> found;
  for (std::size_t i = 1, first = 0; i < vertices.size(); ++i) {
    if (less(vertices[first], vertices[i])) {
      first = i;
    } else if (!found || vertices[i] < found->second) {
      found = {vertices[first], vertices[i]};
    }
  }
  return found;
}

}  // namespace

std::optional<CoincidentVertices> find_coincident(const ExactPlane& plane,
                                                  const CornersByVertex& corners) {
  LatticeTable table(corners.vertices(), 2);
  std::vector<VertexId> others;
  std::optional<CoincidentVertices> on_lattice;
  for (VertexId v = 0; v < corners.vertices() && !on_lattice; ++v) {
    if (!corners.is_used(v)) continue;
    if (!plane.on_lattice(v)) {
      others.push_back(v);
      continue;
    }
    const auto earlier =
        table.insert(plane.lattice(v), v, [&](VertexId w) { return plane.lattice(w); });
    if (earlier != LatticeTable::kNone) on_lattice = {earlier, v};
  }
  // All those before the one that was found, if any.
  const auto off_lattice = find_coincident(ByPosition(plane), std::move(others));
  return off_lattice ? off_lattice : on_lattice;
}

LostPoints find_lost_points(const ExactPlane& plane, int exponent, const CornersByVertex& corners,
                            const std::vector<Point>& points, const Threads& threads) {
  PointIndex index(points, exponent);
  const std::size_t chunks = (corners.vertices() + kChunk - 1) / kChunk;
  threads.for_each(chunks, [&](std::size_t chunk) {
    const std::size_t end = std::min(corners.vertices(), (chunk + 1) * kChunk);
    for (auto v = static_cast<VertexId>(chunk * kChunk); v < end; ++v) {
      if (!corners.is_used(v)) continue;
      if (const auto point = index.find(plane, v)) index.mark(*point);
    }
  });
  return index.lost();
}

std::vector<PlacedVertex> find_placed_vertices(const ExactPlane& plane, int exponent,
                                               const CornersByVertex& corners,
                                               const std::vector<Point>& points,
                                               const Threads& threads) {
  const PointIndex index(points, exponent);
  using Part = std::vector<PlacedVertex>;
  const auto parts =
      for_chunks<Part>(threads, corners.vertices(), [&](std::size_t begin, std::size_t end) {
        Part part;
        for (auto v = static_cast<VertexId>(begin); v < end; ++v) {
          if (!corners.is_used(v)) continue;
          if (const auto point = index.find(plane, v)) part.push_back({v, *point});
        }
        return part;
      });
  Part all;
  for (const Part& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

MovedVertices find_moved(const StoredPlane& plane, const CornersByVertex& corners,
                         const Threads& threads) {
  MovedVertices moved;
  moved.is_moved.resize(corners.vertices());
  struct Part {
    bool any = false;
    std::optional<VertexId> infinite;
  };
  const auto parts =
      for_chunks<Part>(threads, corners.vertices(), [&](std::size_t begin, std::size_t end) {
        Part part;
        for (auto v = static_cast<VertexId>(begin); v < end; ++v) {
          if (!corners.is_used(v) || !plane.changes(v)) continue;
          part.any = true;
          moved.is_moved[v] = 1;
          if (!part.infinite && !plane.is_finite(v)) part.infinite = v;
        }
        return part;
      });
  for (const Part& part : parts) {
    moved.any = moved.any || part.any;
    if (!moved.infinite) moved.infinite = part.infinite;
  }
  return moved;
}

}  // namespace quadbound::judge
