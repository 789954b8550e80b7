// SPDX-License-Identifier: Apache-2.0
#include "algo/lemma_11.hpp"

#include <algorithm>

#include "algo/quadtree_chain.hpp"

namespace quadbound {
namespace {

constexpr std::size_t kMostEdges = 4;

bool is_better(const StripPart& a, const std::optional<StripPart>& b) {
  if (!b) return true;
  const double value = std::min(a.slack, kEnoughSlack);
  const double other = std::min(b->slack, kEnoughSlack);
  return value > other || (value == other && a.quads.size() < b->quads.size());
}

class Lemma11 {
 public:
  Lemma11(const Domain& domain, const TreeMesh& tree_mesh, const StripPolygon& polygon)
      : domain_(domain), tree_mesh_(tree_mesh), polygon_(polygon) {}

  [[nodiscard]] std::optional<StripPart> best() const { return best_from(0, polygon_.first_foot); }

 private:
  [[nodiscard]] std::size_t end() const { return polygon_.alpha.size() - 1; }
  [[nodiscard]] LatticePoint point(std::size_t k) const { return tree_mesh_.at(polygon_.alpha[k]); }
  [[nodiscard]] FinePoint on_alpha(std::size_t k) const { return on_lattice(point(k)); }
  [[nodiscard]] FinePoint at_foot(std::int64_t foot) const {
    return domain_.foot_point(polygon_.edge, foot);
  }
  [[nodiscard]] StripVertex vertex(std::size_t k) const {
    return {StripVertex::Kind::kMesh, polygon_.alpha[k], 0};
  }
  [[nodiscard]] StripVertex foot_vertex(std::int64_t foot) const {
    return {StripVertex::Kind::kFoot, polygon_.edge, foot};
  }

  /// Perpendicular and vertical.
  [[nodiscard]] std::vector<std::int64_t> feet(std::size_t k) const {
    if (k == end()) return {polygon_.last_foot};
    const Vector slope = axes_of(domain_, polygon_.edge).slope;
    const double height = domain_.height(polygon_.edge, point(k));
    return {domain_.foot(polygon_.edge, point(k)),
            domain_.foot(polygon_.edge, point(k), -height * slope.y / slope.x)};
  }
  [[nodiscard]] bool in_order(std::int64_t x, std::int64_t y) const {
    return domain_.on_edge(polygon_.edge, x) && domain_.on_edge(polygon_.edge, y) &&
           domain_.along(polygon_.edge, x) < domain_.along(polygon_.edge, y);
  }

  [[nodiscard]] std::optional<StripPart> best_from(std::size_t k, std::int64_t x) const {
    if (k == end()) return StripPart{};
    std::optional<StripPart> best;
    for (std::size_t next = k + 1; next <= end(); ++next) {
      for (const std::int64_t y : feet(next)) {
        if (!in_order(x, y)) continue;
        std::optional<StripPart> part = piece(k, next, x, y);
        if (!part) continue;
        const auto rest = best_from(next, y);
        if (!rest) continue;
        part->append(*rest);
        if (is_better(*part, best)) best = std::move(part);
      }
    }
    return best;
  }

  [[nodiscard]] std::optional<StripPart> piece(std::size_t k, std::size_t next, std::int64_t x,
                                               std::int64_t y) const {
    switch (next - k) {
      case 1:
        return one_edge(k, next, x, y);
      case 2:
        return two_edges(k, x, y);
      case 3:
        return three_edges(k, x, y);
      default:
        return four_edges(k, x, y);
    }
  }

  [[nodiscard]] StripPart one_edge(std::size_t k, std::size_t next, std::int64_t x,
                                   std::int64_t y) const {
    StripPart part;
    part.add_quad({foot_vertex(x), foot_vertex(y), vertex(next), vertex(k)},
                  {at_foot(x), at_foot(y), on_alpha(next), on_alpha(k)}, StripConstruction::kQuad);
    return part;
  }

  [[nodiscard]] std::optional<StripPart> two_edges(std::size_t k, std::int64_t x,
                                                   std::int64_t y) const {
    constexpr double kAnything = -1;
    const auto made = mesh_pentagon(domain_, polygon_.edge, at_foot(x), at_foot(y), point(k),
                                    point(k + 1), point(k + 2), kAnything);
    if (!made) return std::nullopt;
    StripPart part;
    part.slack = made->slack;
    const StripVertex s = part.add_steiner(made->steiner);
    const StripVertex z = foot_vertex(made->foot);
    const StripVertex a = vertex(k);
    const StripVertex c = vertex(k + 2);
    for (const std::array<StripVertex, 4>& corners :
         {std::array{foot_vertex(x), z, s, a}, std::array{z, foot_vertex(y), c, s},
          std::array{a, s, c, vertex(k + 1)}})
      part.quads.push_back({corners, StripConstruction::kPentagon});
    return part;
  }

  [[nodiscard]] StripPart three_edges(std::size_t k, std::int64_t x, std::int64_t y) const {
    StripPart part = one_edge(k, k + 3, x, y);
    part.add_quad({vertex(k), vertex(k + 3), vertex(k + 2), vertex(k + 1)},
                  {on_alpha(k), on_alpha(k + 3), on_alpha(k + 2), on_alpha(k + 1)},
                  StripConstruction::kBump);
    return part;
  }

  /// The edges of the reflex vertex go on to s on c_i c_(i+1) and its foot (Fig. 38b).
  [[nodiscard]] std::optional<StripPart> four_edges(std::size_t k, std::int64_t x,
                                                    std::int64_t y) const {
    constexpr int kSteps = 16;
    std::optional<StripPart> best;
    const Vector chord = on_alpha(k + 4) - on_alpha(k);
    for (int i = 1; i < kSteps; ++i) {
      const LatticePoint s = nearest_lattice_point(on_alpha(k), (1.0 * i / kSteps) * chord);
      const std::int64_t z = domain_.foot(polygon_.edge, s);
      if (!in_order(x, z) || !in_order(z, y)) continue;
      StripPart part = around(k, x, y, s, z);
      if (is_better(part, best)) best = std::move(part);
    }
    return best;
  }

  [[nodiscard]] StripPart around(std::size_t k, std::int64_t x, std::int64_t y, LatticePoint s,
                                 std::int64_t z) const {
    StripPart part;
    const StripVertex middle = part.add_steiner(s);
    const FinePoint at = on_lattice(s);
    constexpr StripConstruction kHow = StripConstruction::kPentagon;
    part.add_quad({vertex(k), middle, vertex(k + 2), vertex(k + 1)},
                  {on_alpha(k), at, on_alpha(k + 2), on_alpha(k + 1)}, kHow);
    part.add_quad({middle, vertex(k + 4), vertex(k + 3), vertex(k + 2)},
                  {at, on_alpha(k + 4), on_alpha(k + 3), on_alpha(k + 2)}, kHow);
    part.add_quad({foot_vertex(x), foot_vertex(z), middle, vertex(k)},
                  {at_foot(x), at_foot(z), at, on_alpha(k)}, kHow);
    part.add_quad({foot_vertex(z), foot_vertex(y), vertex(k + 4), middle},
                  {at_foot(z), at_foot(y), on_alpha(k + 4), at}, kHow);
    return part;
  }

  const Domain& domain_;
  const TreeMesh& tree_mesh_;
  StripPolygon polygon_;
};

}  // namespace

void StripPart::append(const StripPart& other) {
  slack = std::min(slack, other.slack);
  const auto before = static_cast<std::uint32_t>(steiner.size());
  steiner.insert(steiner.end(), other.steiner.begin(), other.steiner.end());
  for (StripQuad quad : other.quads) {
    for (StripVertex& v : quad.corners)
      if (v.kind == StripVertex::Kind::kSteiner) v.id += before;
    quads.push_back(quad);
  }
}

StripVertex StripPart::add_steiner(LatticePoint point) {
  steiner.push_back(point);
  return {StripVertex::Kind::kSteiner, static_cast<std::uint32_t>(steiner.size() - 1), 0};
}

void StripPart::add_quad(const std::array<StripVertex, 4>& corners,
                         const std::array<FinePoint, 4>& at, StripConstruction construction) {
  quads.push_back({corners, construction});
  const double here = quad_slack(at);
  if (!(here >= slack)) slack = here >= -1 ? here : -1;  // not a number where vertices coincide
}

std::optional<StripPart> mesh_by_lemma_11(const Domain& domain, const TreeMesh& tree_mesh,
                                          const StripPolygon& polygon) {
  if (polygon.alpha.size() > kMostEdges + 1) return std::nullopt;
  return Lemma11(domain, tree_mesh, polygon).best();
}

}  // namespace quadbound
