// SPDX-License-Identifier: Apache-2.0
#include "model/mesh_edges.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace quadbound {
namespace {

using Ring = std::vector<VertexId>;
using DirectedEdge = std::pair<VertexId, VertexId>;

template <class Face, class Visit>
void for_each_side(const Face& face, const Visit& visit) {
  for (std::size_t i = 0; i < face.size(); ++i) visit(face[i], face[(i + 1) % face.size()]);
}

template <class Visit>
void for_each_side_of_mesh(const Mesh& mesh, const Visit& visit) {
  for (const Quad& quad : mesh.quads) for_each_side(quad, visit);
  for (const std::vector<VertexId>& face : mesh.other_faces) for_each_side(face, visit);
}

/// The sides of all faces, counted into one bucket for each lower vertex.
class SideBuckets {
 public:
  explicit SideBuckets(const Mesh& mesh) : ends_(mesh.vertices.size() + 1, 0) {
    for_each_side_of_mesh(mesh, [&](VertexId a, VertexId b) { ++ends_[std::min(a, b) + 1]; });
    std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
    sides_.resize(ends_.back());
    // Each start moves to the end of its bucket while the bucket fills; hence the name.
    for_each_side_of_mesh(mesh, [&](VertexId a, VertexId b) {
      sides_[ends_[std::min(a, b)]++] = {std::max(a, b), a < b};
    });
  }

  void visit_bucket(VertexId low, const std::function<void(const EdgeUse&)>& visit) {
    const auto at = [&](std::size_t i) { return sides_.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto end = at(ends_[low]);
    auto side = at(low == 0 ? 0 : ends_[low - 1]);
    std::sort(side, end, [](const Side& a, const Side& b) { return a.high < b.high; });
    while (side != end) {
      EdgeUse use{low, side->high, 0, 0};
      for (; side != end && side->high == use.high; ++side)
        ++(side->forward ? use.forward : use.backward);
      visit(use);
    }
  }

 private:
  struct Side {
    VertexId high;
    bool forward;
  };
  std::vector<std::size_t> ends_;
  std::vector<Side> sides_;
};

std::vector<DirectedEdge> unpaired_edges(const Mesh& mesh) {
  std::vector<DirectedEdge> edges;
  for_each_edge(mesh, [&](const EdgeUse& use) {
    for (std::uint32_t i = use.backward; i < use.forward; ++i)
      edges.emplace_back(use.low, use.high);
    for (std::uint32_t i = use.forward; i < use.backward; ++i)
      edges.emplace_back(use.high, use.low);
  });
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Walks along unused edges. At every vertex as many unpaired edges arrive as leave, since each
/// face corner adds one of either kind and each pairing removes one of either kind at both ends:
/// a walk can only end where it began.
class RingWalk {
 public:
  explicit RingWalk(std::vector<DirectedEdge> edges)
      : edges_(std::move(edges)), used_(edges_.size(), false) {}

  std::vector<Ring> rings() {
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (!used_[i]) walk_from(edges_[i].first);
    return std::move(rings_);
  }

 private:
  void walk_from(VertexId start) {
    path_ = {start};
    place_ = {{start, 0}};
    while (!path_.empty()) {
      const std::size_t edge = take_edge(path_.back());
      if (edge == edges_.size()) return;
      step_to(edges_[edge].second);
    }
  }

  /// The unused edge with the smallest head that leaves a vertex, or edges_.size().
  std::size_t take_edge(VertexId from) {
    auto edge = std::lower_bound(edges_.begin(), edges_.end(), DirectedEdge{from, 0});
    for (; edge != edges_.end() && edge->first == from; ++edge) {
      const auto index = static_cast<std::size_t>(edge - edges_.begin());
      if (used_[index]) continue;
      used_[index] = true;
      return index;
    }
    return edges_.size();
  }

  void step_to(VertexId vertex) {
    const auto [found, is_new] = place_.try_emplace(vertex, path_.size());
    if (is_new) {
      path_.push_back(vertex);
      return;
    }
    const auto first = path_.begin() + static_cast<std::ptrdiff_t>(found->second);
    rings_.emplace_back(first, path_.end());
    for (auto it = first + 1; it != path_.end(); ++it) place_.erase(*it);
    path_.erase(first + 1, path_.end());
  }

  std::vector<DirectedEdge> edges_;
  std::vector<bool> used_;
  std::vector<Ring> rings_;
  std::vector<VertexId> path_;
  std::unordered_map<VertexId, std::size_t> place_;  ///< of each vertex in path_
};

double area(const Vertices& vertices, const Ring& ring) {
  // Relative to a vertex of the ring, so that small rings far from the origin keep their digits.
  const Point origin = vertices.rounded(ring.front());
  double twice = 0;
  for_each_side(ring, [&](VertexId from, VertexId to) {
    const Point a = vertices.rounded(from);
    const Point b = vertices.rounded(to);
    twice += (a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x);
  });
  return std::abs(twice) / 2;
}

}  // namespace

void for_each_edge(const Mesh& mesh, const std::function<void(const EdgeUse&)>& visit) {
  SideBuckets buckets(mesh);
  for (VertexId low = 0; low < mesh.vertices.size(); ++low) buckets.visit_bucket(low, visit);
}

std::vector<std::vector<VertexId>> boundary_rings(const Mesh& mesh) {
  std::vector<std::pair<double, Ring>> rings;
  for (Ring& ring : RingWalk(unpaired_edges(mesh)).rings()) {
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    const double size = area(mesh.vertices, ring);
    rings.emplace_back(size, std::move(ring));
  }
  std::sort(rings.begin(), rings.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  std::vector<Ring> sorted;
  sorted.reserve(rings.size());
  for (auto& [size, ring] : rings) sorted.push_back(std::move(ring));
  return sorted;
}

}  // namespace quadbound
