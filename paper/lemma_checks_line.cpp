// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "paper/lemma_checks.hpp"
#include "paper/strip_audit.hpp"

namespace quadbound {
namespace {

using Chain = std::vector<VertexId>;

/// The directions of Lemma 7, from -90 to 90 degrees; `rise` / `run`.
struct Slope {
  std::int64_t run;
  std::int64_t rise;
};
constexpr std::array<Slope, 9> kSlopes{
    {{0, -1}, {1, -3}, {1, -1}, {3, -1}, {1, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 1}}};

std::optional<std::size_t> slope_of(LatticePoint from, LatticePoint to) {
  const std::int64_t x = to.x - from.x;
  const std::int64_t y = to.y - from.y;
  for (std::size_t i = 0; i < kSlopes.size(); ++i)
    if (x * kSlopes[i].rise == y * kSlopes[i].run && x * kSlopes[i].run + y * kSlopes[i].rise > 0)
      return i;
  return std::nullopt;
}

/// Of Table 1, by the range of theta.
std::size_t row_of(const CutLine& line) {
  if (3 * line.dy >= line.dx) return 0;
  if (line.dy > 0) return 1;
  if (line.dy == 0) return 2;
  return 3 * line.dy > -line.dx ? 3 : 4;
}
/// Its smallest and largest delta as indices into kSlopes.
constexpr std::array<std::array<std::size_t, 2>, 5> kTable1{
    {{3, 8}, {2, 7}, {2, 6}, {1, 6}, {1, 5}}};
/// By symmetry with its first row, the last one must go down to -90 degrees.
constexpr std::array<std::array<std::size_t, 2>, 5> kTable1Repaired{
    {{3, 8}, {2, 7}, {2, 6}, {1, 6}, {0, 5}}};

int sign(Int128 value) { return value > 0 ? 1 : (value < 0 ? -1 : 0); }

int turn(const Framed& a, const Framed& b, const Framed& c) { return sign(cross(b - a, c - a)); }

bool is_between(const Framed& a, const Framed& p, const Framed& b) {
  return dot(p - a, p - b) <= 0;
}

/// Whether two closed segments have a point in common.
bool meet(const Framed& a, const Framed& b, const Framed& c, const Framed& d) {
  const int abc = turn(a, b, c);
  const int abd = turn(a, b, d);
  const int cda = turn(c, d, a);
  const int cdb = turn(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && is_between(a, c, b)) || (abd == 0 && is_between(a, d, b)) ||
         (cda == 0 && is_between(c, a, d)) || (cdb == 0 && is_between(c, b, d));
}

/// A_i, by its chain in the frame of the edge, is a simple polygon.
bool is_simple(const std::vector<Framed>& v) {
  const Framed p{v.front().t, 0};
  const Framed q{v.back().t, 0};
  const std::size_t m = v.size() - 1;
  const auto runs_back = [](const Framed& a, const Framed& b) {
    return cross(a, b) == 0 && dot(a, b) > 0;
  };
  if (runs_back(p - v[0], v[1] - v[0]) || runs_back(q - v[m], v[m - 1] - v[m])) return false;
  for (std::size_t k = 0; k < m; ++k) {
    if (k > 0 && meet(p, v[0], v[k], v[k + 1])) return false;
    if (k + 1 < m && meet(q, v[m], v[k], v[k + 1])) return false;
    for (std::size_t other = k + 1; other < m; ++other)
      if (v[k] == v[other + 1]) return false;  // edges of Q do not cross
  }
  return p.t < q.t;
}

class LineChecks {
 public:
  LineChecks(const CutTree& tree, const CutLine& line, CheckLedger& ledger)
      : tree_(tree), line_(line), ledger_(ledger), chains_(edge_chains(tree, line)) {}

  void run() {
    if (!check_alpha()) return;
    check_beta();
    std::vector<VertexId> centres = beta_in_window();
    for (std::size_t i = 0; i + 1 < centres.size(); ++i)
      ledger_.count(Check::kOrderAsWritten, follows(centres[i], centres[i + 1]),
                    {centres[i], centres[i + 1]});
    sort_downwards(centres);
    for (const VertexId c : centres) check_vertical(c);
    for (std::size_t i = 0; i + 1 < centres.size(); ++i) check_pair(centres[i], centres[i + 1]);
  }

 private:
  [[nodiscard]] bool in_window(VertexId v) const {
    const std::int64_t x = tree_.at(v).x;
    const auto [low, side] = tree_.square(tree_.leaf_of(v));
    const bool inside = 0 < low.y && low.y + side < kCutTreeSide;
    return inside && 5 * (kCutTreeSide / 16) < x && x < 11 * (kCutTreeSide / 16);
  }
  [[nodiscard]] Framed frame(VertexId v) const { return framed(line_, tree_.at(v)); }

  bool check_alpha() {
    ledger_.count(Check::kAlphaEdges, chains_.most_edges <= 2, {});
    bool connected = true;
    for (const auto& [end, start] : chains_.broken)
      if (in_window(end) || in_window(start)) connected = false;
    ledger_.count(Check::kAlphaConnected, connected, {});
    return connected;
  }

  [[nodiscard]] bool is_on_alpha(VertexId v) const {
    return std::find(chains_.alpha.begin(), chains_.alpha.end(), v) != chains_.alpha.end();
  }

  void check_beta() {
    for (const auto& [c, north] : chains_.north_of) {
      const VertexId n = tree_.centre(north);
      if (in_window(tree_.centre(c)))
        ledger_.count(Check::kNorthAbove, is_above(line_, tree_.at(n)), {tree_.centre(c), n});
    }
  }

  std::vector<VertexId> beta_in_window() {
    std::vector<VertexId> centres;
    for (const Cell c : chains_.beta) {
      const VertexId v = tree_.centre(c);
      if (!in_window(v)) continue;
      ledger_.count(Check::kBetaOnAlpha, is_on_alpha(v), {v});
      centres.push_back(v);
    }
    return centres;
  }

  [[nodiscard]] bool follows(VertexId c, VertexId next) const {
    return !is_on_alpha(c) || !is_on_alpha(next) || part_of(chains_.alpha, c, next).has_value();
  }

  /// The repair of the order for theta < 0: by x, and then y falling.
  void sort_downwards(std::vector<VertexId>& centres) const {
    if (line_.dy >= 0) return;
    std::stable_sort(centres.begin(), centres.end(), [this](VertexId a, VertexId b) {
      const LatticePoint p = tree_.at(a);
      const LatticePoint q = tree_.at(b);
      return p.x != q.x ? p.x < q.x : p.y > q.y;
    });
  }

  /// Lemma 5. An edge of alpha that goes straight down is the special case of Fig. 16, and the
  /// lemma is about its lower end.
  void check_vertical(VertexId c) {
    const VertexId low = straight_down(c);
    const LatticePoint from = tree_.at(low);
    bool holds = true;
    for (std::size_t k = 0; k + 1 < chains_.alpha.size() && holds; ++k)
      holds = !passes_under(tree_.at(chains_.alpha[k]), tree_.at(chains_.alpha[k + 1]), from);
    ledger_.count(Check::kVertical, holds, {c});
    ledger_.count(Check::kVerticalCrossed, !crosses_under(from), {c});
  }

  [[nodiscard]] VertexId straight_down(VertexId c) const {
    const auto is_below = [&](VertexId v) {
      return tree_.at(v).x == tree_.at(c).x && tree_.at(v).y < tree_.at(c).y;
    };
    for (std::size_t k = 0; k + 1 < chains_.alpha.size(); ++k) {
      const VertexId u = chains_.alpha[k];
      const VertexId v = chains_.alpha[k + 1];
      if (u == c && is_below(v)) return straight_down(v);
      if (v == c && is_below(u)) return straight_down(u);
    }
    return c;
  }

  /// Whether alpha goes from one side of the vertical below a point to the other.
  [[nodiscard]] bool crosses_under(LatticePoint p) const {
    int side_before = 0;
    bool under = false;  // all that alpha did on the vertical since
    for (std::size_t k = 0; k < chains_.alpha.size(); ++k) {
      const LatticePoint at = tree_.at(chains_.alpha[k]);
      if (at.x == p.x) {
        under = under || at.y < p.y;
        continue;
      }
      const int side = at.x < p.x ? -1 : 1;
      if (side_before * side < 0) {
        const LatticePoint last = tree_.at(chains_.alpha[k - 1]);
        if (last.x == p.x ? under : passes_under(last, at, p)) return true;
      }
      side_before = side;
      under = false;
    }
    return false;
  }

  static bool passes_under(LatticePoint u, LatticePoint v, LatticePoint p) {
    if (v.x < u.x) std::swap(u, v);
    if (p.x < u.x || v.x < p.x) return false;
    if (u.x == v.x) return std::min(u.y, v.y) < p.y;
    return Int128{v.y - u.y} * (p.x - u.x) < Int128{p.y - u.y} * (v.x - u.x);
  }

  void check_pair(VertexId c, VertexId next) {
    const Touch touching = touch(tree_.square(tree_.leaf_of(c)), tree_.square(tree_.leaf_of(next)));
    ledger_.count(Check::kNeighbours, touching != Touch::kNot, {c, next});
    check_slope(c, next);
    check_projections(c, next);
    if (!is_on_alpha(c) || !is_on_alpha(next)) return;
    const auto part = part_of(chains_.alpha, c, next);
    ledger_.count(Check::kOrder, part.has_value(), {c, next});
    if (part) check_part(*part);
  }

  void check_slope(VertexId c, VertexId next) {
    const auto slope = slope_of(tree_.at(c), tree_.at(next));
    ledger_.count(Check::kSlopes, slope.has_value(), {c, next});
    if (!slope) return;
    const std::size_t row = row_of(line_);
    ++ledger_.audit().slopes[row][*slope];
    const auto is_listed = [&](const std::array<std::size_t, 2>& range) {
      return range[0] <= *slope && *slope <= range[1];
    };
    ledger_.count(Check::kTable1, is_listed(kTable1[row]), {c, next});
    ledger_.count(Check::kTable1Repaired, is_listed(kTable1Repaired[row]), {c, next});
  }

  /// Lemmas 8 and 9.
  void check_projections(VertexId c, VertexId next) {
    const Framed from = frame(c);
    const Framed d = frame(next) - from;
    // Down from c, t changes by -dy / dx of the change of h.
    const Int128 beside = d.t * line_.dx;
    const Int128 vertical = d.h * line_.dy;
    const bool inside = d.h <= 0 && std::min<Int128>(0, vertical) <= beside &&
                        beside <= std::max<Int128>(0, vertical);
    ledger_.count(Check::kOutsideTriangle, !inside, {c, next});
    ledger_.count(Check::kFeetInOrder, d.t > 0, {c, next});
    const Int128 height = d.h < 0 ? -d.h : d.h;
    ledger_.count(Check::kAnglesAtCentres, d.t > 0 && height <= 3 * d.t, {c, next});
  }

  void check_part(const Chain& alpha_i) {
    const VertexId c = alpha_i.front();
    const VertexId next = alpha_i.back();
    ledger_.count(Check::kFourEdgesOfAlpha, alpha_i.size() <= 5, {c, next});
    Chain chain;
    bool spiked = false;
    for (const VertexId v : alpha_i) {
      chain.push_back(v);
      while (chain.size() > 2 && chain[chain.size() - 3] == v) {
        chain.resize(chain.size() - 2);
        spiked = true;
      }
    }
    if (spiked) ++ledger_.audit().spikes;
    ledger_.count(Check::kFourEdgesOfAlphaWithoutSpikes, chain.size() <= 5, {c, next});
    if (has_vertex_under(chain)) {
      ++ledger_.audit().under;
      const auto above = chain_above(tree_, c, next);
      ledger_.count(Check::kChainAbove, above.has_value(), {c, next});
      if (!above) return;
      chain = *above;
    }
    ledger_.count(Check::kFourEdges, chain.size() <= 5, {c, next});
    check_polygon(chain);
  }

  [[nodiscard]] bool has_vertex_under(const Chain& chain) const {
    const Framed c = frame(chain.front());
    const Framed d = frame(chain.back()) - c;
    return std::any_of(chain.begin(), chain.end(),
                       [&](VertexId v) { return cross(d, frame(v) - c) < 0; });
  }

  void check_polygon(const Chain& chain) {
    const VertexId c = chain.front();
    const VertexId next = chain.back();
    std::vector<Framed> framed_chain;
    framed_chain.reserve(chain.size());
    for (const VertexId v : chain) framed_chain.push_back(frame(v));
    const bool simple = is_simple(framed_chain);
    ledger_.count(Check::kSimplePolygon, simple, {c, next});
    if (chain.size() == 3) check_two_edges(framed_chain, chain);
    if (!simple || chain.size() > 5) return;
    StripTally& tally = ledger_.audit().strips[turns_of(framed_chain)];
    ++tally.looked_at;
    const auto mesh = mesh_strip_by_lemma_11(framed_chain, line_.dy, line_.dx);
    if (mesh) {
      ++(mesh->moved_feet ? tally.moved_feet : tally.as_written);
      tally.most_quads = std::max<std::uint64_t>(tally.most_quads, mesh->quads);
    }
    const bool five = mesh && mesh->quads <= 5;
    ledger_.count(Check::kAtMostFiveQuads, five && !mesh->moved_feet, {c, next});
    ledger_.count(Check::kAtMostFiveQuadsMoved, five, {c, next});
  }

  /// Lemma 10.
  void check_two_edges(const std::vector<Framed>& v, const Chain& chain) {
    const Framed d = v[2] - v[0];
    const Int128 height = d.h < 0 ? -d.h : d.h;
    ledger_.count(Check::kTwoEdgesStrict, height < 3 * d.t, {chain[0], chain[1], chain[2]});
    // 2 arctan(1/3) = arctan(3/4), from the edge down to the foot.
    const auto is_double = [](Int128 t, Int128 h) { return h >= 0 || 4 * t >= -3 * h; };
    const Framed left = v[1] - v[0];
    const Framed right = v[1] - v[2];
    ledger_.count(Check::kTwoEdgesDouble, is_double(left.t, left.h) && is_double(-right.t, right.h),
                  {chain[0], chain[1], chain[2]});
    // Below arctan(1/3), only 12.53 = arctan(2/9) and 14.04 = arctan(1/4).
    const auto is_listed = [](const Framed& u, const Framed& w) {
      const Int128 x = cross(u, w);
      const Int128 y = dot(u, w);
      return y <= 0 || 3 * x >= y || 9 * x == 2 * y || 4 * x == y;
    };
    ledger_.count(Check::kTwoEdgesSmall, is_listed(d, left) && is_listed(right, v[0] - v[2]),
                  {chain[0], chain[1], chain[2]});
  }

  const CutTree& tree_;
  const CutLine& line_;
  CheckLedger& ledger_;
  EdgeChains chains_;
};

}  // namespace

void check_line(const CutTree& tree, const CutLine& line, CheckLedger& ledger) {
  LineChecks(tree, line, ledger).run();
}

}  // namespace quadbound
