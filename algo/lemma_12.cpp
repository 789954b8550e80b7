// SPDX-License-Identifier: Apache-2.0
#include "algo/lemma_12.hpp"

#include <algorithm>
#include <array>

#include "algo/strip_pieces.hpp"

namespace quadbound {
namespace {

/// The 8 cells around v's, counter-clockwise from the east; even places are edge neighbours.
constexpr std::array<LatticePoint, 8> kRing{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
constexpr std::size_t kTurn = kRing.size();

/// The parts of a length that are tried.
constexpr int kSteps = 16;

class Grid {
 public:
  Grid(const TreeMesh& tree_mesh, EdgeId site)
      : tree_mesh_(tree_mesh),
        low_(tree_mesh.tree().corner(tree_mesh.cell_of(site))),
        side_(std::int64_t{1} << tree_mesh.tree().side_bits(tree_mesh.cell_of(site))) {}

  [[nodiscard]] std::size_t place_of(VertexId v) const {
    const LatticePoint p = tree_mesh_.at(v);
    const LatticePoint cell{cell_of(p.x - low_.x), cell_of(p.y - low_.y)};
    return static_cast<std::size_t>(
        std::find_if(kRing.begin(), kRing.end(),
                     [&](LatticePoint c) { return c.x == cell.x && c.y == cell.y; }) -
        kRing.begin());
  }
  /// kNoVertex where Q leaves it out: outside the domain.
  [[nodiscard]] VertexId centre(std::size_t place) const {
    const LatticePoint cell = kRing[place % kTurn];
    const LatticePoint p{low_.x + cell.x * side_ + side_ / 2, low_.y + cell.y * side_ + side_ / 2};
    const Cell leaf = tree_mesh_.tree().leaf_at(p);
    return tree_mesh_.has(leaf) ? tree_mesh_.centre(leaf) : kNoVertex;
  }

 private:
  [[nodiscard]] std::int64_t cell_of(std::int64_t offset) const {
    return offset < 0 ? -1 : offset / side_;
  }

  const TreeMesh& tree_mesh_;
  LatticePoint low_;
  std::int64_t side_;
};

class Lemma12 {
 public:
  Lemma12(const Domain& domain, const TreeMesh& tree_mesh, const Corner& corner)
      : domain_(domain),
        tree_mesh_(tree_mesh),
        corner_(corner),
        v_(domain.at(corner.site)),
        e_(domain.previous(corner.site)),
        f_(corner.site) {}

  [[nodiscard]] std::optional<StripPart> best(const CornerFeet& feet) const {
    if (!on_e(feet.of_u) || !on_f(feet.of_w)) return std::nullopt;
    if (edges() == 0) return no_edge(feet);
    if (edges() == 1) return one_edge(feet);
    return fan(feet);
  }

  [[nodiscard]] std::optional<StripPart> first_piece(std::int64_t foot) const {
    if (!on_e(foot)) return std::nullopt;
    return first_joined() == 1 ? first_quad(foot) : first_pentagon(foot);
  }
  [[nodiscard]] std::optional<StripPart> last_piece(std::int64_t foot) const {
    if (!on_f(foot)) return std::nullopt;
    return last_joined() + 1 == edges() ? last_quad(foot) : last_pentagon(foot);
  }

  [[nodiscard]] std::size_t edges() const { return corner_.chain.size() - 1; }
  [[nodiscard]] LatticePoint point(std::size_t k) const { return tree_mesh_.at(corner_.chain[k]); }
  /// The vertices of E that v is joined with: every other one, from the first to the last.
  [[nodiscard]] std::size_t first_joined() const {
    return edges() == 2 || !corner_.starts_beside ? 1 : 2;
  }
  [[nodiscard]] std::size_t last_joined() const {
    if (edges() == 2) return 1;
    const bool ends_beside = corner_.starts_beside == (edges() % 2 == 0);
    return ends_beside ? edges() - 2 : edges() - 1;
  }

 private:
  [[nodiscard]] FinePoint at(std::size_t k) const { return on_lattice(point(k)); }
  [[nodiscard]] StripVertex vertex(std::size_t k) const {
    return {StripVertex::Kind::kMesh, corner_.chain[k], 0};
  }
  [[nodiscard]] StripVertex site() const { return {StripVertex::Kind::kSite, corner_.site, 0}; }
  [[nodiscard]] StripVertex foot_on_e(std::int64_t foot) const {
    return {StripVertex::Kind::kFoot, e_, foot};
  }
  [[nodiscard]] StripVertex foot_on_f(std::int64_t foot) const {
    return {StripVertex::Kind::kFoot, f_, foot};
  }
  [[nodiscard]] FinePoint at_e(std::int64_t foot) const { return domain_.foot_point(e_, foot); }
  [[nodiscard]] FinePoint at_f(std::int64_t foot) const { return domain_.foot_point(f_, foot); }
  [[nodiscard]] bool on_e(std::int64_t foot) const { return domain_.on_edge(e_, foot); }
  [[nodiscard]] bool on_f(std::int64_t foot) const { return domain_.on_edge(f_, foot); }

  [[nodiscard]] StripPart no_edge(const CornerFeet& feet) const {
    StripPart part;
    part.add_quad({foot_on_e(feet.of_u), site(), foot_on_f(feet.of_w), vertex(0)},
                  {at_e(feet.of_u), v_, at_f(feet.of_w), at(0)}, StripConstruction::kCorner);
    return part;
  }

  // --- case 1, Fig. 39 ---------------------------------------------------------------------------

  /// t on the diagonal from the edge neighbour's centre to a corner of v's cell; q on the parallel
  /// to u w through t, as far as the line from v to the corner neighbour's centre.
  [[nodiscard]] std::optional<StripPart> one_edge(const CornerFeet& feet) const {
    const std::size_t beside = corner_.starts_beside ? 0 : 1;
    const Vector near = at(beside) - v_;
    const Vector far = at(1 - beside) - v_;
    const Vector chord = far - near;
    const Vector middle = on_lattice(middle_of_cell()) - v_;
    // Towards the corner of v's cell that is nearest to the corner neighbour.
    const Vector diagonal = 0.5 * chord + 0.5 * (middle - near);
    const double slope = cross(chord, far);
    std::optional<StripPart> best;
    for (int i = 1; i < kSteps && slope != 0; ++i) {
      const Vector t = near + (1.0 * i / kSteps) * diagonal;
      for (int j = 1; j <= kSteps; ++j) {
        const Vector q = t + (-cross(t, far) / slope * j / kSteps) * chord;
        const LatticePoint first = nearest_lattice_point(v_, beside == 0 ? t : q);
        const LatticePoint second = nearest_lattice_point(v_, beside == 0 ? q : t);
        keep_better(best, joined_to_first(feet, first, second));
        keep_better(best, joined_to_second(feet, first, second));
      }
    }
    return best;
  }

  [[nodiscard]] LatticePoint middle_of_cell() const {
    const Cell cell = tree_mesh_.cell_of(corner_.site);
    const LatticePoint low = tree_mesh_.tree().corner(cell);
    const std::int64_t half = std::int64_t{1} << (tree_mesh_.tree().side_bits(cell) - 1);
    return {low.x + half, low.y + half};
  }

  static void keep_better(std::optional<StripPart>& best, std::optional<StripPart> other) {
    if (other && (!best || other->slack > best->slack)) best = std::move(other);
  }

  struct Place {
    StripVertex vertex;
    FinePoint at;
  };

  /// v is joined to the Steiner point next to u, the other one has its foot on f.
  [[nodiscard]] std::optional<StripPart> joined_to_first(const CornerFeet& feet, LatticePoint first,
                                                         LatticePoint second) const {
    const std::int64_t z = domain_.foot(f_, second);
    if (!on_f(z) || domain_.along(f_, z) >= domain_.along(f_, feet.of_w)) return std::nullopt;
    return four_quads(feet, first, second, {site(), v_}, {foot_on_f(z), at_f(z)});
  }

  /// v is joined to the Steiner point next to w, the other one has its foot on e.
  [[nodiscard]] std::optional<StripPart> joined_to_second(const CornerFeet& feet,
                                                          LatticePoint first,
                                                          LatticePoint second) const {
    const std::int64_t z = domain_.foot(e_, first);
    if (!on_e(z) || domain_.along(e_, z) <= domain_.along(e_, feet.of_u)) return std::nullopt;
    return four_quads(feet, first, second, {foot_on_e(z), at_e(z)}, {site(), v_});
  }

  /// The Steiner points are joined to `below_first` and `below_second` on the boundary.
  [[nodiscard]] StripPart four_quads(const CornerFeet& feet, LatticePoint first,
                                     LatticePoint second, const Place& below_first,
                                     const Place& below_second) const {
    StripPart part = above(first, second);
    const StripVertex s = steiner(0);
    const StripVertex r = steiner(1);
    const FinePoint at_s = on_lattice(first);
    const FinePoint at_r = on_lattice(second);
    constexpr StripConstruction kHow = StripConstruction::kCorner;
    part.add_quad({foot_on_e(feet.of_u), below_first.vertex, s, vertex(0)},
                  {at_e(feet.of_u), below_first.at, at_s, at(0)}, kHow);
    part.add_quad({below_first.vertex, below_second.vertex, r, s},
                  {below_first.at, below_second.at, at_r, at_s}, kHow);
    part.add_quad({below_second.vertex, foot_on_f(feet.of_w), vertex(1), r},
                  {below_second.at, at_f(feet.of_w), at(1), at_r}, kHow);
    return part;
  }

  [[nodiscard]] StripPart above(LatticePoint first, LatticePoint second) const {
    StripPart part;
    part.add_steiner(first);
    part.add_steiner(second);
    part.add_quad({vertex(0), steiner(0), steiner(1), vertex(1)},
                  {at(0), on_lattice(first), on_lattice(second), at(1)},
                  StripConstruction::kCorner);
    return part;
  }
  [[nodiscard]] static StripVertex steiner(std::uint32_t i) {
    return {StripVertex::Kind::kSteiner, i, 0};
  }

  // --- cases 2 and 3, Fig. 40 and 41 -------------------------------------------------------------

  [[nodiscard]] std::optional<StripPart> fan(const CornerFeet& feet) const {
    std::optional<StripPart> part = first_piece(feet.of_u);
    const std::optional<StripPart> last = last_piece(feet.of_w);
    if (!part || !last) return std::nullopt;
    for (std::size_t k = first_joined(); k + 2 <= last_joined(); k += 2)
      part->add_quad({site(), vertex(k + 2), vertex(k + 1), vertex(k)},
                     {v_, at(k + 2), at(k + 1), at(k)}, StripConstruction::kFan);
    part->append(*last);
    return part;
  }

  [[nodiscard]] StripPart first_quad(std::int64_t foot) const {
    StripPart part;
    part.add_quad({foot_on_e(foot), site(), vertex(1), vertex(0)}, {at_e(foot), v_, at(1), at(0)},
                  StripConstruction::kFan);
    return part;
  }
  [[nodiscard]] StripPart last_quad(std::int64_t foot) const {
    const std::size_t w = edges();
    StripPart part;
    part.add_quad({site(), foot_on_f(foot), vertex(w), vertex(w - 1)},
                  {v_, at_f(foot), at(w), at(w - 1)}, StripConstruction::kFan);
    return part;
  }

  [[nodiscard]] std::optional<StripPart> first_pentagon(std::int64_t foot) const {
    const auto made =
        mesh_pentagon(domain_, e_, at_e(foot), v_, point(0), point(1), point(2), kAnything);
    if (!made) return std::nullopt;
    return pentagon(*made, foot_on_e(foot), site(), foot_on_e(made->foot), 0);
  }
  [[nodiscard]] std::optional<StripPart> last_pentagon(std::int64_t foot) const {
    const std::size_t w = edges();
    const auto made =
        mesh_pentagon(domain_, f_, v_, at_f(foot), point(w - 2), point(w - 1), point(w), kAnything);
    if (!made) return std::nullopt;
    return pentagon(*made, site(), foot_on_f(foot), foot_on_f(made->foot), w - 2);
  }

  [[nodiscard]] StripPart pentagon(const Pentagon& made, const StripVertex& x, const StripVertex& y,
                                   const StripVertex& z, std::size_t k) const {
    StripPart part;
    part.slack = made.slack;
    const StripVertex s = part.add_steiner(made.steiner);
    for (const std::array<StripVertex, 4>& corners :
         {std::array{x, z, s, vertex(k)}, std::array{z, y, vertex(k + 2), s},
          std::array{vertex(k), s, vertex(k + 2), vertex(k + 1)}})
      part.quads.push_back({corners, StripConstruction::kPentagon});
    return part;
  }

  static constexpr double kAnything = -1;

  const Domain& domain_;
  const TreeMesh& tree_mesh_;
  const Corner& corner_;
  FinePoint v_;
  EdgeId e_;
  EdgeId f_;
};

/// Moves a foot along its edge to where a piece is best, by parts of the height of its centre;
/// whether that changed it.
template <class Piece>
bool settle(const Domain& domain, EdgeId edge, LatticePoint centre, std::int64_t& foot,
            const Piece& piece) {
  const auto slack_at = [&](std::int64_t there) {
    const std::optional<StripPart> part = piece(there);
    return part ? part->slack : -2;  // worse than any piece
  };
  double best = slack_at(foot);
  if (best > kSmallestSlack) return false;
  bool moved = false;
  const double height = domain.height(edge, centre);
  for (int k = -2 * kSteps; k <= 2 * kSteps; ++k) {
    const std::int64_t there = domain.foot(edge, centre, height * k / kSteps);
    const double slack = slack_at(there);
    if (!(slack > best)) continue;
    best = slack;
    foot = there;
    moved = true;
  }
  return moved;
}

}  // namespace

std::optional<Corner> find_corner(const Domain& domain, const TreeMesh& tree_mesh, EdgeId site,
                                  VertexId u, VertexId w) {
  if (tree_mesh.site_near(u) != site || tree_mesh.site_near(w) != site) return std::nullopt;
  const Grid grid(tree_mesh, site);
  const std::size_t first = grid.place_of(u);
  const std::size_t last = grid.place_of(w);
  std::size_t edges = (first + kTurn - last) % kTurn;
  const bool is_convex = domain.side(domain.previous(site), domain.next(site)) > 0;
  // No corner below 180 degrees has more than five: u is beyond w.
  if (is_convex && edges > 5) return std::nullopt;
  if (!is_convex && edges == 0) edges = kTurn;
  Corner corner{site, {}, first % 2 == 0};
  for (std::size_t k = 0; k <= edges; ++k)
    corner.chain.push_back(grid.centre(first + 2 * kTurn - k));
  if (std::find(corner.chain.begin(), corner.chain.end(), kNoVertex) != corner.chain.end())
    return std::nullopt;
  return corner;
}

void align_edge_neighbours(const Domain& domain, TreeMesh& tree_mesh, const Corner& corner) {
  const Lemma12 lemma(domain, tree_mesh, corner);
  if (lemma.edges() < 3) return;
  const Grid grid(tree_mesh, corner.site);
  const LatticePoint v = domain.floor(corner.site);
  for (std::size_t k = lemma.first_joined(); k <= lemma.last_joined(); k += 2) {
    const LatticePoint p = lemma.point(k);
    const bool is_above_or_below = kRing[grid.place_of(corner.chain[k])].x == 0;
    tree_mesh.move_to(corner.chain[k],
                      is_above_or_below ? LatticePoint{v.x, p.y} : LatticePoint{p.x, v.y});
  }
}

unsigned settle_feet(const Domain& domain, const TreeMesh& tree_mesh, const Corner& corner,
                     CornerFeet& feet) {
  const Lemma12 lemma(domain, tree_mesh, corner);
  if (lemma.edges() < 2) return 0;
  unsigned moved = 0;
  if (settle(domain, domain.previous(corner.site), lemma.point(0), feet.of_u,
             [&](std::int64_t foot) { return lemma.first_piece(foot); }))
    ++moved;
  if (settle(domain, corner.site, lemma.point(lemma.edges()), feet.of_w,
             [&](std::int64_t foot) { return lemma.last_piece(foot); }))
    ++moved;
  return moved;
}

std::optional<StripPart> mesh_by_lemma_12(const Domain& domain, const TreeMesh& tree_mesh,
                                          const Corner& corner, const CornerFeet& feet) {
  return Lemma12(domain, tree_mesh, corner).best(feet);
}

}  // namespace quadbound
