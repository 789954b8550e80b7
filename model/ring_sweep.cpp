// SPDX-License-Identifier: Apache-2.0
#include "model/ring_sweep.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "model/predicates.hpp"

namespace quadbound {
namespace {

/// Edge k runs from vertex k to the vertex after it in its ring; vertices are numbered through all
/// rings.
struct Edge {
  Point left;
  Point right;
  std::size_t ring;
  std::size_t before;  ///< the edge that ends where this one starts
  bool rightward;
};

std::vector<Edge> edges_of(const std::vector<Ring>& rings) {
  std::vector<Edge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Ring& ring = rings[r];
    const std::size_t first = edges.size();
    for (std::size_t v = 0; v < ring.size(); ++v) {
      const Point& a = ring[v];
      const Point& b = ring[v + 1 == ring.size() ? 0 : v + 1];
      const bool rightward = lexicographically_before(a, b);
      const std::size_t before = first + (v == 0 ? ring.size() : v) - 1;
      edges.push_back({rightward ? a : b, rightward ? b : a, r, before, rightward});
    }
  }
  return edges;
}

/// Order of two edges that the sweep line crosses. Two edges tie where the left end of one lies on
/// the other.
class Below {
 public:
  explicit Below(const std::vector<Edge>& edges) : edges_(&edges) {}
  bool operator()(std::size_t i, std::size_t k) const {
    if (i == k) return false;
    const Edge& a = (*edges_)[i];
    const Edge& b = (*edges_)[k];
    if (a.left == b.left) return orientation(a.left, a.right, b.right) > 0;
    if (lexicographically_before(a.left, b.left)) return orientation(a.left, a.right, b.left) > 0;
    return orientation(b.left, b.right, a.left) < 0;
  }

 private:
  const std::vector<Edge>* edges_;
};

class Sweep {
 public:
  explicit Sweep(const std::vector<Ring>& rings)
      : edges_(edges_of(rings)), active_(Below(edges_)), place_(edges_.size()) {
    for (const Ring& ring : rings) counter_clockwise_.push_back(ring_orientation(ring) > 0);
    order_.resize(edges_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return lexicographically_before(start(a), start(b));
    });
  }

  [[nodiscard]] std::size_t edge_count() const { return edges_.size(); }

  /// Whether the first `count` edges are disjoint.
  bool run(std::size_t count) {
    count_ = count;
    active_.clear();
    seen_.assign(counter_clockwise_.size(), false);
    nesting_.around.assign(counter_clockwise_.size(), std::nullopt);
    return std::all_of(order_.begin(), order_.end(),
                       [&](std::size_t vertex) { return pass_vertex(vertex); });
  }

  /// After a run over all edges that found them disjoint.
  RingNesting take_nesting() { return std::move(nesting_); }

 private:
  using Active = std::set<std::size_t, Below>;

  [[nodiscard]] const Point& start(std::size_t edge) const {
    return edges_[edge].rightward ? edges_[edge].left : edges_[edge].right;
  }

  /// False where edges were found to meet.
  bool pass_vertex(std::size_t vertex) {
    const std::size_t out = vertex;
    const std::size_t in = edges_[vertex].before;
    const bool out_starts = edges_[out].rightward;
    const bool in_starts = !edges_[in].rightward;
    const bool has_out = out < count_;
    const bool has_in = in < count_;
    // First everything that ends here, so that it never ties with what starts here.
    if (has_out && !out_starts && !remove(out)) return false;
    if (has_in && !in_starts && !remove(in)) return false;
    if (has_out && out_starts && !insert(out)) return false;
    return !has_in || !in_starts || insert(in);
  }

  bool remove(std::size_t edge) {
    const auto next = active_.erase(place_[edge]);
    return next == active_.end() || next == active_.begin() || apart(*std::prev(next), *next);
  }

  bool insert(std::size_t edge) {
    const auto [at, inserted] = active_.insert(edge);
    if (!inserted) return false;
    place_[edge] = at;
    if (const std::size_t ring = edges_[edge].ring; !seen_[ring]) {
      seen_[ring] = true;
      nesting_.around[ring] = ring_below(at);
    }
    const auto next = std::next(at);
    return (next == active_.end() || apart(edge, *next)) &&
           (at == active_.begin() || apart(*std::prev(at), edge));
  }

  /// The innermost ring around a place right above the edge below `at`.
  [[nodiscard]] std::optional<std::size_t> ring_below(Active::const_iterator at) const {
    if (at == active_.begin()) return std::nullopt;
    const Edge& below = edges_[*std::prev(at)];
    // The inside of a ring lies to the left of its edges, unless the ring is clockwise.
    const bool inside = below.rightward == counter_clockwise_[below.ring];
    return inside ? below.ring : nesting_.around[below.ring];
  }

  [[nodiscard]] bool apart(std::size_t i, std::size_t k) const {
    const Edge& a = edges_[i];
    const Edge& b = edges_[k];
    if (a.before == k || b.before == i) return true;
    return meeting(a.left, a.right, b.left, b.right) == Meeting::kApart;
  }

  std::vector<Edge> edges_;
  std::vector<std::size_t> order_;  ///< the vertices from left to right
  std::size_t count_ = 0;
  Active active_;
  std::vector<Active::iterator> place_;
  std::vector<bool> counter_clockwise_;
  std::vector<bool> seen_;  ///< rings whose leftmost vertex was passed
  RingNesting nesting_;
};

}  // namespace

int ring_orientation(const Ring& ring) {
  // At the leftmost vertex the ring turns the way it runs; it cannot go straight there, since both
  // neighbours lie to one side.
  const auto at = std::min_element(ring.begin(), ring.end(), lexicographically_before);
  const Point& previous = at == ring.begin() ? ring.back() : *std::prev(at);
  const Point& next = std::next(at) == ring.end() ? ring.front() : *std::next(at);
  return orientation(previous, *at, next);
}

std::optional<RingNesting> nesting_of_disjoint_rings(const std::vector<Ring>& rings) {
  Sweep sweep(rings);
  if (!sweep.run(sweep.edge_count())) return std::nullopt;
  return sweep.take_nesting();
}

std::size_t first_edge_that_meets_an_earlier_one(const std::vector<Ring>& rings) {
  Sweep sweep(rings);
  // The first `disjoint` edges are disjoint, the first `meeting` are not.
  std::size_t disjoint = 1;
  std::size_t meeting = sweep.edge_count();
  while (meeting - disjoint > 1) {
    const std::size_t middle = disjoint + (meeting - disjoint) / 2;
    (sweep.run(middle) ? disjoint : meeting) = middle;
  }
  return meeting - 1;
}

}  // namespace quadbound
