// SPDX-License-Identifier: Apache-2.0
#include "algo/insertion_by_lemmas.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "algo/lemma_11.hpp"
#include "algo/lemma_12.hpp"
#include "algo/quadrangulation_chain.hpp"
#include "algo/quadtree_chain.hpp"

namespace quadbound {
namespace {

using Chain = std::vector<VertexId>;

/// One edge: c_1, ..., c_m, their feet, and the chains between them; empty where there is none.
struct EdgeStrip {
  Chain centres;
  std::vector<std::int64_t> feet;
  std::vector<Chain> alphas;
};

class InsertionByLemmas {
 public:
  InsertionByLemmas(const Domain& domain, TreeMesh& tree_mesh, const CutQuads& cut_quads,
                    KeptQuads& kept, LemmaCounters& counters)
      : domain_(domain),
        tree_mesh_(tree_mesh),
        cut_quads_(cut_quads),
        kept_(kept),
        counters_(counters),
        strips_(domain.size()) {}

  std::variant<Strip, LemmaFault> run() && {
    find_chains();
    find_corners();
    settle_corners();
    settle_strips();
    mesh_corners();
    mesh_strips();
    if (fault_) return *fault_;
    return Strip{std::move(made_.quads), std::move(made_.steiner)};
  }

 private:
  void no_strip(std::string_view claim, std::string_view what, VertexId near) {
    ++counters_.strips_without_case;
    if (!fault_) fault_ = {claim, what, tree_mesh_.at(near)};
  }
  void no_corner(EdgeId site, std::string_view what) {
    ++counters_.corners_without_case;
    if (!fault_) fault_ = {"lemma-12", what, domain_.floor(site)};
  }

  // --- chains ------------------------------------------------------------------------------------

  void find_chains() {
    std::vector<Chain> betas = quadtree_chains(domain_, tree_mesh_);
    const std::vector<std::vector<Cut>> cuts = cuts_by_edge(domain_, cut_quads_);
    for (EdgeId e = 0; e < domain_.size(); ++e) {
      EdgeStrip& strip = strips_[e];
      strip.centres = std::move(betas[e]);
      for (const VertexId c : strip.centres)
        strip.feet.push_back(domain_.foot(e, tree_mesh_.at(c)));
      const QuadrangulationChain alpha(domain_, tree_mesh_, cuts[e]);
      for (std::size_t i = 0; i + 1 < strip.centres.size(); ++i)
        strip.alphas.push_back(find_alpha(alpha, strip.centres[i], strip.centres[i + 1]));
    }
  }

  Chain find_alpha(const QuadrangulationChain& alpha, VertexId c, VertexId next) {
    auto part = alpha.part(c, next);
    if (!part) {
      no_strip("lemma-3", "alpha does not run from one centre of beta to the next", c);
      return {};
    }
    if (!runs_under(tree_mesh_, *part)) return *part;
    ++counters_.replaced_chains;
    part = chain_above(tree_mesh_, c, next);
    if (part && drop_quads_below(*part)) return *part;
    no_strip("lemma-11", "alpha runs under c_i c_(i+1), and no chain above", c);
    return {};
  }

  /// Takes the quads of K on the right of a chain out of it, as far as others are beyond them.
  bool drop_quads_below(const Chain& chain) {
    constexpr std::size_t kMost = 64;  // far more than the cells around a segment hold
    std::vector<QuadId> below;
    const auto drop = [&](QuadId quad) {
      if (quad == kNoQuad || !kept_.is_kept[quad]) return;
      kept_.is_kept[quad] = false;
      below.push_back(quad);
    };
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) drop(quad_left_of(chain[i + 1], chain[i]));
    for (std::size_t done = 0; done < below.size(); ++done) {
      if (below.size() > kMost) return false;
      const Quad& quad = tree_mesh_.mesh().quads[below[done]];
      for (unsigned k = 0; k < 4; ++k)
        if (const VertexId a = quad[k], b = quad[(k + 1) & 3U]; !is_edge_of(chain, a, b))
          drop(quad_left_of(b, a));
    }
    return true;
  }

  static constexpr QuadId kNoQuad = 0xFFFF'FFFFU;
  [[nodiscard]] QuadId quad_left_of(VertexId from, VertexId to) const {
    for (const QuadId q : tree_mesh_.quads_at(from)) {
      const Quad& quad = tree_mesh_.mesh().quads[q];
      for (unsigned k = 0; k < 4; ++k)
        if (quad[k] == from && quad[(k + 1) & 3U] == to) return q;
    }
    return kNoQuad;
  }
  static bool is_edge_of(const Chain& chain, VertexId a, VertexId b) {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      if ((chain[i] == a && chain[i + 1] == b) || (chain[i] == b && chain[i + 1] == a)) return true;
    return false;
  }

  void find_corners() {
    for (EdgeId v = 0; v < domain_.size(); ++v) {
      const Chain& before = strips_[domain_.previous(v)].centres;
      const Chain& after = strips_[v].centres;
      if (before.empty() || after.empty()) {
        no_corner(v, "a chain beta is empty");
        continue;
      }
      const auto corner = find_corner(domain_, tree_mesh_, v, before.back(), after.front());
      if (corner) {
        corners_.push_back(*corner);
      } else {
        no_corner(v, "the chains do not end in the 3x3 cells in their order");
      }
    }
    for (const Corner& corner : corners_) align_edge_neighbours(domain_, tree_mesh_, corner);
  }

  // --- feet --------------------------------------------------------------------------------------

  [[nodiscard]] CornerFeet feet_at(EdgeId v) const {
    return {strips_[domain_.previous(v)].feet.back(), strips_[v].feet.front()};
  }

  void settle_corners() {
    for (const Corner& corner : corners_) {
      CornerFeet feet = feet_at(corner.site);
      counters_.moved_feet += settle_feet(domain_, tree_mesh_, corner, feet);
      strips_[domain_.previous(corner.site)].feet.back() = feet.of_u;
      strips_[corner.site].feet.front() = feet.of_w;
    }
  }

  /// Lemma 11: "the point p_i can be moved so that the edge c_i p_i swings outward". Feet of u and
  /// w stay where Lemma 12 has put them.
  void settle_strips() {
    for (EdgeId e = 0; e < domain_.size(); ++e) {
      for (std::size_t i = 0; i < strips_[e].alphas.size(); ++i) {
        const auto made = mesh_strip(e, i);
        if (!made || made->is_within_bounds()) continue;
        if (i > 0) swing_foot(e, i, i, -1);
        if (i + 2 < strips_[e].centres.size()) swing_foot(e, i, i + 1, +1);
      }
    }
  }

  /// Moves a foot of A_i outward if that brings A_i within the bounds.
  void swing_foot(EdgeId e, std::size_t i, std::size_t which, int direction) {
    EdgeStrip& strip = strips_[e];
    const std::int64_t before = strip.feet[which];
    const LatticePoint centre = tree_mesh_.at(strip.centres[which]);
    const double height = domain_.height(e, centre);
    if (const auto made = mesh_strip(e, i); made && made->is_within_bounds()) return;
    for (const int sixteenths : {1, 2, 3, 4, 6, 8}) {
      strip.feet[which] = domain_.foot(e, centre, direction * height * sixteenths / 16);
      const auto made = mesh_strip(e, i);
      if (!made || !made->is_within_bounds()) continue;
      ++counters_.moved_feet;
      return;
    }
    strip.feet[which] = before;
  }

  // --- quads -------------------------------------------------------------------------------------

  [[nodiscard]] std::optional<StripPart> mesh_strip(EdgeId e, std::size_t i) const {
    const EdgeStrip& strip = strips_[e];
    if (strip.alphas[i].empty()) return std::nullopt;
    return mesh_by_lemma_11(domain_, tree_mesh_,
                            {e, strip.alphas[i], strip.feet[i], strip.feet[i + 1]});
  }

  void mesh_strips() {
    for (EdgeId e = 0; e < domain_.size(); ++e) {
      for (std::size_t i = 0; i < strips_[e].alphas.size(); ++i) {
        const auto part = mesh_strip(e, i);
        if (!part && strips_[e].alphas[i].empty()) continue;  // counted already
        if (!part) {
          no_strip("lemma-11", "A_i has more than four edges of alpha, or feet out of order",
                   strips_[e].centres[i]);
          continue;
        }
        ++counters_.strips[strips_[e].alphas[i].size() - 1];
        if (!part->is_within_bounds()) ++counters_.strips_outside;
        made_.append(*part);
      }
    }
  }

  void mesh_corners() {
    for (const Corner& corner : corners_) {
      const auto part = mesh_by_lemma_12(domain_, tree_mesh_, corner, feet_at(corner.site));
      if (!part) {
        no_corner(corner.site, "a foot lies beyond v");
        continue;
      }
      ++counters_.corners[std::min<std::size_t>(corner.chain.size() - 1, 3)];
      if (!part->is_within_bounds()) ++counters_.corners_outside;
      made_.append(*part);
    }
  }

  const Domain& domain_;
  TreeMesh& tree_mesh_;
  const CutQuads& cut_quads_;
  KeptQuads& kept_;
  LemmaCounters& counters_;
  std::vector<EdgeStrip> strips_;  ///< by edge
  std::vector<Corner> corners_;    ///< by vertex
  StripPart made_;
  std::optional<LemmaFault> fault_;
};

}  // namespace

std::variant<Strip, LemmaFault> insert_by_lemmas(const Domain& domain, TreeMesh& tree_mesh,
                                                 const CutQuads& cut_quads, KeptQuads& kept,
                                                 LemmaCounters& counters) {
  return InsertionByLemmas(domain, tree_mesh, cut_quads, kept, counters).run();
}

}  // namespace quadbound
