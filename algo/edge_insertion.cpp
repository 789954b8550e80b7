// SPDX-License-Identifier: Apache-2.0
#include "algo/edge_insertion.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "algo/strip_pieces.hpp"

namespace quadbound {
namespace {

/// Widening: feet beside the perpendicular one, in parts of the height above the edge.
constexpr std::array<double, 1> kLevel0{0};
constexpr std::array<double, 5> kLevel1{0, 0.125, -0.125, 0.25, -0.25};
constexpr std::array<double, 11> kLevel2{0,    0.125, -0.125, 0.25,  -0.25, 0.5,
                                         -0.5, 0.75,  -0.75,  0.375, -0.375};
constexpr std::uint8_t kTopLevel = 2;
std::span<const double> offsets(std::uint8_t level) {
  if (level == 0) return kLevel0;
  if (level == 1) return kLevel1;
  return kLevel2;
}

/// A pentagon with bumps on both of its edges of alpha.
constexpr int kLongestPiece = 6;
/// States at a vertex that memory is set aside for, so that it need not be copied as they grow.
/// What stays untouched takes no memory.
constexpr std::size_t kUsualStates = 2;
/// How far around a dead end the search is widened.
constexpr int kWidenBefore = 3;
constexpr int kWidenAfter = 5;

/// How a state was reached.
struct Piece {
  StripConstruction construction = StripConstruction::kQuad;
  bool first_bump = false;  ///< the first (or only) link is a bump
  bool second_bump = false;
  std::uint32_t middle = 0;  ///< where it has vertices of its own: its number among the Middles
};

/// The vertices of a pentagon or hexagon that are no states.
struct Middle {
  LatticePoint steiner;
  std::int64_t foot = 0;
};

/// A vertex of alpha together with a point of the boundary that it is joined with.
struct State {
  FinePoint at;
  std::int64_t foot = 0;
  EdgeId edge = 0;
  bool at_site = false;  ///< joined with a vertex of the domain, `edge`; or with a foot on `edge`
  bool perpendicular = true;

  std::uint32_t quads = 0;  ///< of the best way here
  double slack = -1;        ///< likewise; negative where there is none
  int from = 0;             ///< index along the chain
  int from_state = 0;
  Piece piece;
};

class Insertion {
 public:
  Insertion(const Domain& domain, const TreeMesh& tree_mesh, const CutQuads& cut_quads,
            std::span<const VertexId> alpha)
      : domain_(domain),
        tree_mesh_(tree_mesh),
        cut_quads_(cut_quads),
        alpha_(alpha),
        size_(static_cast<int>(alpha.size())) {}

  std::variant<Strip, DeadEnd> run(InsertionCounters& counters) {
    constexpr int kCuts = 4;
    const std::vector<int> starts = choose_starts(kCuts);
    if (starts.empty()) return DeadEnd{{alpha_.begin(), alpha_.end()}};
    int dead = 0;
    for (const int start : starts) {
      if (start != starts.front()) ++counters.other_cuts;
      dead = search_from(start);
      if (dead != size_) continue;
      for (const std::uint8_t level : levels_) ++counters.alpha_vertices_by_level[level];
      return trace_back();
    }
    DeadEnd end;
    for (int k = -1; k <= 3; ++k) end.near.push_back(vertex(dead + k + size_));
    return end;
  }

 private:
  // --- the chain, starting anywhere --------------------------------------------------------------

  [[nodiscard]] VertexId vertex(int j) const {
    return alpha_[static_cast<std::size_t>((start_ + j) % size_)];
  }
  [[nodiscard]] LatticePoint point(int j) const { return tree_mesh_.at(vertex(j)); }
  /// Valid until states of another index are made.
  std::span<State> states(int j) {
    const auto at = static_cast<std::size_t>(j);
    return {states_.data() + first_state_[at], first_state_[at + 1] - first_state_[at]};
  }

  // --- states ------------------------------------------------------------------------------------

  void append_states_at(VertexId v, std::uint8_t level, std::vector<State>& result) const {
    const LatticePoint at = tree_mesh_.at(v);
    for (const Above& above : cut_quads_.above(v)) {
      const double height = domain_.height(above.edge, at);
      for (const double offset : offsets(level)) {
        State state;
        state.edge = above.edge;
        state.perpendicular = offset == 0;
        state.foot = domain_.foot(above.edge, at, offset * height);
        if (!domain_.on_edge(above.edge, state.foot)) continue;
        state.at = domain_.foot_point(above.edge, state.foot);
        result.push_back(state);
      }
    }
    const EdgeId site = tree_mesh_.site_near(v);
    if (site != TreeMesh::kNoSite && in_wedge(domain_, site, at) && leaves_room(site, at)) {
      State state;
      state.at_site = true;
      state.edge = site;
      state.at = domain_.at(site);
      result.push_back(state);
    }
  }
  [[nodiscard]] std::vector<State> states_at(VertexId v, std::uint8_t level) const {
    std::vector<State> result;
    append_states_at(v, level, result);
    return result;
  }

  /// At the feet of kites the angles beside a transversal must leave room for the move of v_k
  /// (Section 4): arctan(1/2) at least.
  [[nodiscard]] bool leaves_room(EdgeId site, LatticePoint point) const {
    if (!domain_.is_kite_foot(site)) return true;
    const Vector to = on_lattice(point) - domain_.at(site);
    const Vector out = domain_.direction(site);
    const Vector back = domain_.at(domain_.previous(site)) - domain_.at(site);
    return 2 * std::abs(cross(out, to)) >= dot(out, to) &&
           2 * std::abs(cross(back, to)) >= dot(back, to);
  }

  /// Where a state is on an edge, increasing along it; nullopt if it is not.
  [[nodiscard]] std::optional<std::int64_t> position(const State& state, EdgeId edge) const {
    if (!state.at_site) {
      if (state.edge != edge) return std::nullopt;
      return domain_.along(edge, state.foot);
    }
    if (state.edge == edge) return std::numeric_limits<std::int64_t>::min();
    if (state.edge == domain_.next(edge)) return std::numeric_limits<std::int64_t>::max();
    return std::nullopt;
  }

  /// Whether a piece can run along the boundary from one state to the other: both on the edge that
  /// leaves the first, in its order.
  [[nodiscard]] bool in_order(const State& x, const State& y) const {
    const auto from = position(x, x.edge);
    const auto to = position(y, x.edge);
    return from && to && *from < *to;
  }

  // --- where to cut the chain open ---------------------------------------------------------------

  /// Vertices with a single state that continues well on both sides, the first of them far apart.
  std::vector<int> choose_starts(int wanted) {
    std::vector<std::pair<double, int>> found;  // by falling slack where none is good
    std::vector<int> good;
    const int stride = std::max(1, size_ / wanted);
    for (int j = 0; j < size_ && static_cast<int>(good.size()) < wanted; ++j) {
      if (!good.empty() && j < good.back() + stride) continue;
      const double slack = slack_of_start(j);
      if (slack >= kEnoughSlack) {
        good.push_back(j);
      } else if (slack > -1) {
        found.emplace_back(-slack, j);
      }
    }
    std::sort(found.begin(), found.end());
    for (std::size_t i = 0; i < found.size() && static_cast<int>(good.size()) < wanted; ++i)
      good.push_back(found[i].second);
    return good;
  }

  double slack_of_start(int j) {
    start_ = j;
    const std::vector<State> here = states_at(vertex(0), 0);
    if (here.size() != 1 || here.front().at_site) return -1;
    const auto best = [&](int k, bool before) {
      double slack = 0;
      for (const State& there : states_at(vertex(k), 0)) {
        const State& x = before ? there : here.front();
        const State& y = before ? here.front() : there;
        if (there.at_site || !in_order(x, y)) continue;
        slack = std::max(slack, quad_piece(x, y, before ? k : 0, before ? size_ : k));
      }
      return slack;
    };
    return std::min(best(size_ - 1, true), best(1, false));
  }

  // --- the dynamic program -----------------------------------------------------------------------

  /// Returns size_ if the chain was closed, or the index of the dead end.
  int search_from(int start) {
    start_ = start;
    levels_.assign(alpha_.size(), 0);
    first_state_.assign(alpha_.size() + 2, 0);
    states_.clear();
    middles_.clear();
    states_.reserve(kUsualStates * alpha_.size());
    find_bumps();
    append_states_at(vertex(0), 0, states_);
    first_state_[1] = states_.size();
    states_.front().slack = kEnoughSlack;
    int from = 1;
    for (;;) {
      const int dead = advance(from);
      if (dead == size_) return size_;
      if (!widen(dead)) return dead;
      from = std::max(1, dead - kWidenBefore);
    }
  }

  /// Fills the states from an index on. Returns size_, or the last index that was reached.
  int advance(int first) {
    int reached = first - 1;
    while (reached > 0 && !is_reached(reached)) --reached;
    for (int j = first; j <= size_; ++j) {
      if (j - reached > kLongestPiece) return reached;
      make_states(j);
      for (int s = 0; s < static_cast<int>(states(j).size()); ++s) reach(j, s);
      for (int s = 0; s < static_cast<int>(states(j).size()); ++s) reach_by_corner(j, s);
      if (is_reached(j)) reached = j;
    }
    return reached;
  }

  void make_states(int j) {
    const auto at = static_cast<std::size_t>(j);
    states_.resize(first_state_[at]);
    if (j == size_) {
      State last = states_.front();
      last.slack = -1;
      states_.push_back(last);
    } else {
      append_states_at(vertex(j), levels_[at], states_);
    }
    first_state_[at + 1] = states_.size();
  }

  bool is_reached(int j) {
    const std::span<State> here = states(j);
    return std::any_of(here.begin(), here.end(), [](const State& s) { return s.slack > 0; });
  }

  bool widen(int dead) {
    bool wider = false;
    for (int j = std::max(1, dead - kWidenBefore); j <= std::min(size_ - 1, dead + kWidenAfter);
         ++j) {
      std::uint8_t& level = levels_[static_cast<std::size_t>(j)];
      if (level == kTopLevel) continue;
      ++level;
      wider = true;
    }
    return wider;
  }

  /// An alpha edge, or three of them closed by a bump, that ends at index j: where it starts.
  struct Link {
    int start;
    bool bump;
    double slack;
  };
  template <class Visit>
  void for_links_to(int j, const Visit& visit) {
    if (j >= 1) visit(Link{j - 1, false, 1});
    if (j < 3) return;
    const double slack = bumps_[static_cast<std::size_t>(j - 3)];
    if (slack > kSmallestSlack) visit(Link{j - 3, true, slack});
  }

  /// The slack of the bump from each index.
  void find_bumps() {
    bumps_.resize(alpha_.size());
    for (int j = 0; j < size_; ++j)
      bumps_[static_cast<std::size_t>(j)] =
          quad_slack(std::array<FinePoint, 4>{on_lattice(point(j)), on_lattice(point(j + 3)),
                                              on_lattice(point(j + 2)), on_lattice(point(j + 1))});
  }

  static bool is_better(double slack, std::uint32_t quads, const State& than) {
    return slack > than.slack || (slack == than.slack && quads < than.quads);
  }

  /// Whether it is taken.
  bool offer(State& to, int from, int from_state, double slack, unsigned quads,
             const Piece& piece) {
    if (!(slack > kSmallestSlack)) return false;
    const State& before = states(from)[static_cast<std::size_t>(from_state)];
    const double value = std::min({before.slack, slack, kEnoughSlack});
    const std::uint32_t count = before.quads + quads;
    if (!is_better(value, count, to)) return false;
    to.slack = value;
    to.quads = count;
    to.from = from;
    to.from_state = from_state;
    to.piece = piece;
    return true;
  }

  [[nodiscard]] std::uint32_t next_middle() const {
    return static_cast<std::uint32_t>(middles_.size());
  }

  [[nodiscard]] double quad_piece(const State& x, const State& y, int a, int b) const {
    return quad_slack(
        std::array<FinePoint, 4>{x.at, y.at, on_lattice(point(b)), on_lattice(point(a))});
  }

  template <class Visit>
  void for_reached(int j, const Visit& visit) {
    int s = 0;
    for (const State& state : states(j)) {
      if (state.slack > 0) visit(state, s);
      ++s;
    }
  }

  /// All pieces into a state but corner quads. Pentagons and hexagons cost a search and more quads,
  /// so they are tried only where the rest gives too little.
  void reach(int j, int s) {
    State& to = states(j)[static_cast<std::size_t>(s)];
    for_links_to(j, [&](const Link& link) {
      for_reached(link.start, [&](const State& from, int from_state) {
        if (!in_order(from, to)) return;
        const double slack = std::min(link.slack, quad_piece(from, to, link.start, j));
        offer(to, link.start, from_state, slack, link.bump ? 2 : 1,
              {StripConstruction::kQuad, link.bump, false});
      });
    });
    if (to.at_site)
      for_link_pairs_to(j, [&](const Link& l1, const Link& l2) { fan(to, j, l1, l2); });
    if (to.slack >= kEnoughSlack) return;
    for_link_pairs_to(j, [&](const Link& l1, const Link& l2) { pentagon(to, j, l1, l2); });
    if (to.slack > 0 || to.at_site || level(j) == 0 || j < 2) return;
    hexagon(to, j);
  }

  [[nodiscard]] std::uint8_t level(int j) const {
    return levels_[static_cast<std::size_t>(j % size_)];
  }

  template <class Visit>
  void for_link_pairs_to(int j, const Visit& visit) {
    for_links_to(j, [&](const Link& second) {
      for_links_to(second.start, [&](const Link& first) { visit(first, second); });
    });
  }

  void fan(State& to, int j, const Link& first, const Link& second) {
    for_reached(first.start, [&](const State& from, int from_state) {
      if (!from.at_site || from.edge != to.edge) return;
      const double slack =
          std::min({first.slack, second.slack,
                    quad_slack(std::array<FinePoint, 4>{to.at, on_lattice(point(j)),
                                                        on_lattice(point(second.start)),
                                                        on_lattice(point(first.start))})});
      offer(to, first.start, from_state, slack, 1U + first.bump + second.bump,
            {StripConstruction::kFan, first.bump, second.bump});
    });
  }

  void pentagon(State& to, int j, const Link& first, const Link& second) {
    for_reached(first.start, [&](const State& from, int from_state) {
      if (!in_order(from, to) || (from.at_site && to.at_site)) return;
      if (!from.perpendicular && !to.perpendicular) return;
      const double bumps = std::min(first.slack, second.slack);
      const double least = std::max(to.slack, kSmallestSlack);
      if (std::min({bumps, from.slack, kEnoughSlack}) <= to.slack) return;  // cannot be better
      const auto made = mesh_pentagon(domain_, from.edge, from.at, to.at, point(first.start),
                                      point(second.start), point(j), least);
      if (!made) return;
      if (offer(to, first.start, from_state, std::min(made->slack, bumps),
                3U + first.bump + second.bump,
                {StripConstruction::kPentagon, first.bump, second.bump, next_middle()}))
        middles_.push_back({made->steiner, made->foot});
    });
  }

  void hexagon(State& to, int j) {
    const EdgeId corner = to.edge;
    const EdgeId before = domain_.previous(corner);
    for_reached(j - 2, [&](const State& from, int from_state) {
      if (from.at_site || from.edge != before) return;
      if (!is_better(std::min(from.slack, kEnoughSlack), from.quads + 3, to)) return;
      const auto made =
          mesh_hexagon(from.at, domain_.at(corner), to.at, point(j - 2), point(j - 1), point(j));
      if (!made) return;
      if (offer(to, j - 2, from_state, made->slack, 3,
                {StripConstruction::kCornerHexagon, false, false, next_middle()}))
        middles_.push_back({made->steiner});
    });
  }

  /// From the foot on one edge to the foot of the same vertex on the next one.
  void reach_by_corner(int j, int s) {
    State& to = states(j)[static_cast<std::size_t>(s)];
    if (to.at_site) return;
    for_reached(j, [&](const State& from, int from_state) {
      if (from.at_site || domain_.next(from.edge) != to.edge) return;
      if (from.from == j) return;  // itself reached by a corner
      const double slack = quad_slack(
          std::array<FinePoint, 4>{from.at, domain_.at(to.edge), to.at, on_lattice(point(j))});
      offer(to, j, from_state, slack, 1, {StripConstruction::kCorner});
    });
  }

  // --- the way back ------------------------------------------------------------------------------

  [[nodiscard]] StripVertex mesh_corner(int j) const {
    return {StripVertex::Kind::kMesh, vertex(j), 0};
  }
  [[nodiscard]] static StripVertex boundary_corner(const State& state) {
    if (state.at_site) return {StripVertex::Kind::kSite, state.edge, 0};
    return {StripVertex::Kind::kFoot, state.edge, state.foot};
  }

  Strip trace_back() {
    Strip strip;
    strip.quads.reserve(states(size_).front().quads);
    int j = size_;
    int s = 0;
    do {
      const State& to = states(j)[static_cast<std::size_t>(s)];
      const State& from = states(to.from)[static_cast<std::size_t>(to.from_state)];
      emit(strip, from, to, j);
      j = to.from;
      s = to.from_state;
    } while (j != 0);
    std::reverse(strip.quads.begin(), strip.quads.end());
    return strip;
  }

  void emit_bump(Strip& strip, int j) const {
    strip.quads.push_back(
        {{mesh_corner(j), mesh_corner(j + 3), mesh_corner(j + 2), mesh_corner(j + 1)},
         StripConstruction::kBump});
  }

  void emit(Strip& strip, const State& from, const State& to, int j) const {
    using Kind = StripVertex::Kind;
    const StripVertex x = boundary_corner(from);
    const StripVertex y = boundary_corner(to);
    const Piece& piece = to.piece;
    const StripVertex a = mesh_corner(to.from);
    const StripVertex c = mesh_corner(j);
    const int middle = piece.construction == StripConstruction::kQuad
                           ? to.from
                           : to.from + (piece.first_bump ? 3 : 1);
    const StripVertex b = mesh_corner(middle);
    const auto add = [&](const StripVertex& v0, const StripVertex& v1, const StripVertex& v2,
                         const StripVertex& v3) {
      strip.quads.push_back({{v0, v1, v2, v3}, piece.construction});
    };
    const auto steiner = [&] {
      strip.steiner.push_back(middles_[piece.middle].steiner);
      return StripVertex{Kind::kSteiner, static_cast<std::uint32_t>(strip.steiner.size() - 1), 0};
    };
    if (piece.first_bump) emit_bump(strip, to.from);
    if (piece.second_bump) emit_bump(strip, middle);
    switch (piece.construction) {
      case StripConstruction::kQuad:
        return add(x, y, c, a);
      case StripConstruction::kFan:
        return add(x, c, b, a);
      case StripConstruction::kCorner:
        return add(x, {Kind::kSite, to.edge, 0}, y, c);
      case StripConstruction::kPentagon: {
        const StripVertex s = steiner();
        const StripVertex z{Kind::kFoot, from.edge, middles_[piece.middle].foot};
        add(x, z, s, a);
        add(z, y, c, s);
        return add(a, s, c, b);
      }
      default: {  // kCornerHexagon
        const StripVertex s = steiner();
        const StripVertex v{Kind::kSite, to.edge, 0};
        add(x, v, s, a);
        add(v, y, c, s);
        return add(s, c, b, a);
      }
    }
  }

  const Domain& domain_;
  const TreeMesh& tree_mesh_;
  const CutQuads& cut_quads_;
  std::span<const VertexId> alpha_;
  int size_;
  int start_ = 0;
  std::vector<std::uint8_t> levels_;
  std::vector<double> bumps_;  ///< by index, see find_bumps
  std::vector<State> states_;  ///< by index
  std::vector<std::size_t> first_state_;
  std::vector<Middle> middles_;  ///< of all pieces that were taken, though better ones came after
};

}  // namespace

bool in_wedge(const Domain& domain, EdgeId site, LatticePoint point) {
  const EdgeId before = domain.previous(site);
  const bool left_of_out = domain.side(site, point) > 0;
  const bool left_of_in = domain.side(before, point) > 0;
  const bool convex = domain.side(before, domain.next(site)) > 0;
  return convex ? left_of_out && left_of_in : left_of_out || left_of_in;
}

std::variant<Strip, DeadEnd> insert_edges(const Domain& domain, const TreeMesh& tree_mesh,
                                          const CutQuads& cut_quads,
                                          std::span<const VertexId> alpha,
                                          InsertionCounters& counters) {
  return Insertion(domain, tree_mesh, cut_quads, alpha).run(counters);
}

}  // namespace quadbound
