// SPDX-License-Identifier: Apache-2.0
#include "algo/quadrangulation_chain.hpp"

#include <algorithm>
#include <array>

namespace quadbound {
namespace {

/// How far ahead the next part of a chain is looked for where quads begin at the same place of
/// their edge: those around one vertex.
constexpr std::size_t kLookAhead = 8;

/// The edges of a quad between vertices that are up, clockwise: a path.
template <class Up>
std::vector<VertexId> path_above(const Quad& quad, const Up& up) {
  std::array<bool, 4> is_up{};
  unsigned count = 0;
  for (unsigned k = 0; k < 4; ++k) {
    is_up[k] = up(quad[k]);
    if (is_up[k]) ++count;
  }
  if (count < 2 || count > 3) return {};
  unsigned first = 0;  // clockwise is backwards
  while (!is_up[first] || is_up[(first + 1) & 3U]) ++first;
  std::vector<VertexId> path;
  for (unsigned k = 0; k < count; ++k) path.push_back(quad[(first + 4 - k) & 3U]);
  return path;
}

Int128 cross(LatticePoint origin, LatticePoint a, LatticePoint b) {
  return Int128{a.x - origin.x} * (b.y - origin.y) - Int128{a.y - origin.y} * (b.x - origin.x);
}

/// A quad that a segment cuts, and where its chord begins and ends, as parts of the segment.
struct Chord {
  QuadId quad;
  double from;
  double to;
};

class SegmentCutter {
 public:
  SegmentCutter(const TreeMesh& tree_mesh, VertexId from, VertexId to)
      : tree_mesh_(tree_mesh), from_(tree_mesh.at(from)), to_(tree_mesh.at(to)) {}

  [[nodiscard]] bool is_up(VertexId v) const { return cross(from_, to_, tree_mesh_.at(v)) >= 0; }

  [[nodiscard]] std::optional<Chord> chord(QuadId quad) const {
    const Quad& q = tree_mesh_.mesh().quads[quad];
    std::vector<double> ends;
    for (unsigned k = 0; k < 4; ++k)
      if (is_up(q[k]) != is_up(q[(k + 1) & 3U])) ends.push_back(crossing(q[k], q[(k + 1) & 3U]));
    if (ends.size() != 2) return std::nullopt;
    const Chord found{quad, std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
    // Chords are no shorter than a fixed part of the segment; this is far above rounding.
    constexpr double kTouching = 1e-6;
    if (found.to - found.from < kTouching || found.to < kTouching || found.from > 1 - kTouching)
      return std::nullopt;
    return found;
  }

 private:
  [[nodiscard]] double crossing(VertexId u, VertexId v) const {
    const Vector d = on_lattice(to_) - on_lattice(from_);
    const Vector a = on_lattice(tree_mesh_.at(u)) - on_lattice(from_);
    const Vector b = on_lattice(tree_mesh_.at(v)) - on_lattice(from_);
    const double high = quadbound::cross(d, a);
    const double low = quadbound::cross(d, b);
    const Vector at = a + high / (high - low) * (b - a);
    return dot(d, at) / dot(d, d);
  }

  const TreeMesh& tree_mesh_;
  LatticePoint from_;
  LatticePoint to_;
};

/// Quads at two vertices and at all vertices of those.
std::vector<QuadId> quads_near(const TreeMesh& tree_mesh, VertexId a, VertexId b) {
  std::vector<QuadId> quads;
  for (const VertexId v : {a, b})
    for (const QuadId q : tree_mesh.quads_at(v))
      for (const VertexId w : tree_mesh.mesh().quads[q])
        quads.insert(quads.end(), tree_mesh.quads_at(w).begin(), tree_mesh.quads_at(w).end());
  std::sort(quads.begin(), quads.end());
  quads.erase(std::unique(quads.begin(), quads.end()), quads.end());
  return quads;
}

bool are_joined(const TreeMesh& tree_mesh, VertexId a, VertexId b) {
  for (const QuadId q : tree_mesh.quads_at(a)) {
    const Quad& quad = tree_mesh.mesh().quads[q];
    for (unsigned k = 0; k < 4; ++k)
      if (quad[k] == a && (quad[(k + 1) & 3U] == b || quad[(k + 3) & 3U] == b)) return true;
  }
  return false;
}

}  // namespace

QuadrangulationChain::QuadrangulationChain(const Domain& domain, const TreeMesh& tree_mesh,
                                           const std::vector<Cut>& in_order) {
  std::vector<std::vector<VertexId>> parts;
  for (const Cut& cut : in_order) {
    std::vector<VertexId> path = path_above(tree_mesh.mesh().quads[cut.quad], [&](VertexId v) {
      return domain.side(cut.edge, tree_mesh.at(v)) > 0;
    });
    if (!path.empty()) parts.push_back(std::move(path));
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!vertices_.empty()) {
      const VertexId end = vertices_.back();
      const auto here = parts.begin() + static_cast<std::ptrdiff_t>(i);
      const auto last = here + static_cast<std::ptrdiff_t>(std::min(kLookAhead, parts.size() - i));
      const auto next =
          std::find_if(here, last, [end](const auto& part) { return part.front() == end; });
      if (next == last) {
        vertices_.push_back(kNoVertex);
      } else {
        std::rotate(here, next, next + 1);
        vertices_.pop_back();
      }
    }
    vertices_.insert(vertices_.end(), parts[i].begin(), parts[i].end());
  }
  for (std::size_t i = 0; i < vertices_.size(); ++i) places_.emplace_back(vertices_[i], i);
  std::sort(places_.begin(), places_.end());
}

std::optional<std::vector<VertexId>> QuadrangulationChain::part(VertexId from, VertexId to) const {
  std::optional<std::pair<std::size_t, std::size_t>> best;
  const auto first_of = [this](VertexId v) {
    return std::lower_bound(places_.begin(), places_.end(), std::pair{v, std::size_t{0}});
  };
  for (auto start = first_of(from); start != places_.end() && start->first == from; ++start)
    for (auto end = first_of(to); end != places_.end() && end->first == to; ++end)
      if (start->second < end->second &&
          (!best || end->second - start->second < best->second - best->first))
        best = {start->second, end->second};
  if (!best) return std::nullopt;
  const std::vector<VertexId> part(
      vertices_.begin() + static_cast<std::ptrdiff_t>(best->first),
      vertices_.begin() + static_cast<std::ptrdiff_t>(best->second) + 1);
  if (std::find(part.begin(), part.end(), kNoVertex) != part.end()) return std::nullopt;
  return without_repeated(part);
}

std::vector<std::vector<Cut>> cuts_by_edge(const Domain& domain, const CutQuads& cut_quads) {
  std::vector<std::pair<Passage, Cut>> cuts;
  for (const Cut& cut : cut_quads.cuts()) cuts.emplace_back(cut_quads.passage(cut), cut);
  std::stable_sort(cuts.begin(), cuts.end(), [](const auto& a, const auto& b) {
    return std::pair{a.first.from, a.first.to} < std::pair{b.first.from, b.first.to};
  });
  std::vector<std::vector<Cut>> by_edge(domain.size());
  for (const auto& [passage, cut] : cuts) by_edge[cut.edge].push_back(cut);
  return by_edge;
}

std::optional<std::vector<VertexId>> chain_above(const TreeMesh& tree_mesh, VertexId from,
                                                 VertexId to) {
  if (are_joined(tree_mesh, from, to)) return std::vector{from, to};
  const SegmentCutter cutter(tree_mesh, from, to);
  std::vector<Chord> chords;
  for (const QuadId q : quads_near(tree_mesh, from, to))
    if (const auto chord = cutter.chord(q)) chords.push_back(*chord);
  std::sort(chords.begin(), chords.end(),
            [](const Chord& a, const Chord& b) { return a.from + a.to < b.from + b.to; });
  std::vector<VertexId> chain{from};
  for (const Chord& chord : chords) {
    const std::vector<VertexId> path =
        path_above(tree_mesh.mesh().quads[chord.quad], [&](VertexId v) { return cutter.is_up(v); });
    if (path.empty()) continue;
    if (chain.back() != path.front()) return std::nullopt;
    chain.insert(chain.end(), path.begin() + 1, path.end());
  }
  if (chain.back() != to) return std::nullopt;
  return without_repeated(chain);
}

std::vector<VertexId> without_repeated(const std::vector<VertexId>& chain) {
  std::vector<VertexId> result;
  for (const VertexId v : chain) {
    result.push_back(v);
    while (result.size() > 2 && result[result.size() - 3] == v) result.resize(result.size() - 2);
  }
  return result;
}

bool runs_under(const TreeMesh& tree_mesh, const std::vector<VertexId>& chain) {
  const LatticePoint from = tree_mesh.at(chain.front());
  const LatticePoint to = tree_mesh.at(chain.back());
  return std::any_of(chain.begin(), chain.end(),
                     [&](VertexId v) { return cross(from, to, tree_mesh.at(v)) < 0; });
}

}  // namespace quadbound
