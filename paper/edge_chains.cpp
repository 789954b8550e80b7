// SPDX-License-Identifier: Apache-2.0
#include "paper/edge_chains.hpp"

#include <algorithm>
#include <array>

#include "algo/quadrangulation_chain.hpp"

namespace quadbound {
namespace {

/// A number of the line: numerator / denominator, the latter positive.
struct Fraction {
  Int128 numerator = 0;
  Int128 denominator = 1;
};
bool operator<(const Fraction& a, const Fraction& b) {
  return a.numerator * b.denominator < b.numerator * a.denominator;
}
bool operator==(const Fraction& a, const Fraction& b) { return !(a < b) && !(b < a); }

/// A quad that the line cuts, from one of its chord's ends to the other.
struct CutQuad {
  std::array<VertexId, 4> clockwise;
  Fraction from;
  Fraction to;
  /// From the end of a chord that is one point to the next vertex: the quads around it come in
  /// clockwise order.
  Framed side;
};

bool comes_before(const CutQuad& a, const CutQuad& b) {
  if (!(a.from == b.from)) return a.from < b.from;
  if (!(a.to == b.to)) return a.to < b.to;
  return cross(b.side, a.side) > 0;
}

/// Which quads a line cuts; `up` says which heights count as above.
template <class Up>
class Cutter {
 public:
  Cutter(const CutTree& tree, const CutLine& line, Up up) : tree_(tree), line_(line), up_(up) {}

  [[nodiscard]] std::optional<CutQuad> cut(const Quad& quad) const {
    std::array<Framed, 4> at;
    std::array<bool, 4> up{};
    const Quad clockwise{quad[3], quad[2], quad[1], quad[0]};
    for (unsigned k = 0; k < 4; ++k) {
      at[k] = framed(line_, tree_.at(clockwise[k]));
      up[k] = up_(at[k].h);
    }
    std::vector<Fraction> ends;
    unsigned first_up = 0;
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned m = (k + 1) & 3U;
      if (up[k] == up[m]) continue;
      ends.push_back(crossing(at[k], at[m]));
      if (up[m]) first_up = m;
    }
    if (ends.size() != 2) return std::nullopt;
    if (ends[1] < ends[0]) std::swap(ends[0], ends[1]);
    const Framed low{at[(first_up + 3) & 3U]};
    return CutQuad{clockwise, ends[0], ends[1], at[first_up] - low};
  }

  /// The edges of a quad with both ends above, clockwise.
  [[nodiscard]] std::vector<std::pair<VertexId, VertexId>> edges_above(const CutQuad& quad) const {
    std::array<bool, 4> up{};
    for (unsigned k = 0; k < 4; ++k) up[k] = up_(framed(line_, tree_.at(quad.clockwise[k])).h);
    unsigned first = 0;
    while (up[first] || !up[(first + 1) & 3U]) ++first;
    std::vector<std::pair<VertexId, VertexId>> edges;
    for (unsigned k = first + 1; up[(k + 1) & 3U]; ++k)
      edges.emplace_back(quad.clockwise[k & 3U], quad.clockwise[(k + 1) & 3U]);
    return edges;
  }

 private:
  static Fraction crossing(const Framed& a, const Framed& b) {
    const Int128 numerator = b.t * a.h - a.t * b.h;
    const Int128 denominator = a.h - b.h;
    return denominator > 0 ? Fraction{numerator, denominator} : Fraction{-numerator, -denominator};
  }

  const CutTree& tree_;
  const CutLine& line_;
  Up up_;
};

template <class Up>
std::vector<CutQuad> in_order(const CutTree& tree, const Cutter<Up>& quads) {
  std::vector<CutQuad> found;
  for (const Quad& quad : tree.mesh().quads)
    if (const auto cut = quads.cut(quad)) found.push_back(*cut);
  std::sort(found.begin(), found.end(), comes_before);
  return found;
}

bool strictly_above(Int128 height) { return height > 0; }
bool not_below(Int128 height) { return height >= 0; }

void make_alpha(const CutTree& tree, const CutLine& line, EdgeChains& chains) {
  const Cutter quads(tree, line, strictly_above);
  for (const CutQuad& quad : in_order(tree, quads)) {
    const auto edges = quads.edges_above(quad);
    chains.most_edges = std::max(chains.most_edges, edges.size());
    for (const auto& [from, to] : edges) {
      if (chains.alpha.empty() || chains.alpha.back() != from) {
        if (!chains.alpha.empty()) chains.broken.emplace_back(chains.alpha.back(), from);
        chains.alpha.push_back(from);
      }
      chains.alpha.push_back(to);
    }
  }
}

bool is_crossed(const CutLine& line, const CellSquare& c) {
  bool above = false;
  bool not_above = false;
  for (const std::int64_t x : {c.low.x, c.low.x + c.side})
    for (const std::int64_t y : {c.low.y, c.low.y + c.side})
      (is_above(line, {x, y}) ? above : not_above) = true;
  return above && not_above;
}

void make_beta(const CutTree& tree, const CutLine& line, EdgeChains& chains) {
  const auto above = [&](Cell c) { return is_above(line, tree.at(tree.centre(c))); };
  for (const Cell c : tree.leaves())
    if (is_crossed(line, tree.square(c))) chains.crossed.push_back(c);
  for (const Cell c : chains.crossed) {
    if (above(c)) {
      chains.beta.push_back(c);
      continue;
    }
    for (const Cell north : tree.neighbours(c, kNorth)) {
      chains.north_of.emplace_back(c, north);
      if (above(north)) chains.beta.push_back(north);
    }
    for (const Cell beside : tree.neighbours(c, line.dy >= 0 ? kWest : kEast))
      if (above(beside)) chains.beta.push_back(beside);
  }
  const auto place = [&](Cell c) {
    const LatticePoint p = tree.at(tree.centre(c));
    return std::pair{p.x, p.y};
  };
  std::sort(chains.beta.begin(), chains.beta.end(),
            [&](Cell a, Cell b) { return place(a) < place(b); });
  chains.beta.erase(std::unique(chains.beta.begin(), chains.beta.end()), chains.beta.end());
}

}  // namespace

EdgeChains edge_chains(const CutTree& tree, const CutLine& line) {
  EdgeChains chains;
  make_alpha(tree, line, chains);
  make_beta(tree, line, chains);
  return chains;
}

std::optional<std::vector<VertexId>> part_of(const std::vector<VertexId>& alpha, VertexId from,
                                             VertexId to) {
  std::optional<std::vector<VertexId>> best;
  std::optional<std::size_t> last;
  for (std::size_t k = 0; k < alpha.size(); ++k) {
    if (alpha[k] == from) last = k;
    if (alpha[k] != to || !last) continue;
    if (!best || k - *last + 1 < best->size())
      best.emplace(alpha.begin() + static_cast<std::ptrdiff_t>(*last),
                   alpha.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  }
  return best;
}

std::optional<std::vector<VertexId>> chain_above(const CutTree& tree, VertexId from, VertexId to) {
  if (tree.are_joined(from, to)) return std::vector{from, to};
  const LatticePoint a = tree.at(from);
  const LatticePoint b = tree.at(to);
  const CutLine segment{a, b.x - a.x, b.y - a.y};
  const Fraction start{0, 1};
  const Fraction end{framed(segment, b).t, 1};
  const Cutter quads(tree, segment, not_below);
  std::vector<VertexId> chain{from};
  for (const CutQuad& quad : in_order(tree, quads)) {
    if (!(quad.from < quad.to && start < quad.to && quad.from < end)) continue;
    for (const auto& [u, v] : quads.edges_above(quad)) {
      if (chain.back() != u) return std::nullopt;
      chain.push_back(v);
    }
  }
  if (chain.back() != to) return std::nullopt;
  return without_repeated(chain);
}

bool in_general_position(const CutTree& tree, const CutLine& line) {
  const auto off = [&](LatticePoint p) { return framed(line, p).h != 0; };
  for (VertexId v = 0; v < tree.vertex_count(); ++v)
    if (!off(tree.at(v))) return false;
  for (const Cell leaf : tree.leaves()) {
    const auto [low, side] = tree.square(leaf);
    for (const std::int64_t x : {low.x, low.x + side})
      for (const std::int64_t y : {low.y, low.y + side})
        if (!off({x, y})) return false;
  }
  return true;
}

}  // namespace quadbound
