// SPDX-License-Identifier: Apache-2.0
#include "algo/strip_assembly.hpp"

#include <algorithm>
#include <utility>

namespace quadbound {
namespace {

/// Of a quad of a strip.
constexpr std::size_t kMostFeet = 2;

class Assembly {
 public:
  Assembly(const Domain& domain, const Quadtree& tree, Mesh q, const KeptQuads& kept)
      : domain_(domain),
        kept_(kept),
        tree_(tree),
        leaves_(tree),
        vertices_of_q_(std::move(q.vertices)) {
    q.vertices = Vertices(domain.root().exponent);
    made_.mesh = std::move(q);
    made_.mesh.construction_names.assign(kConstructionNames.begin(), kConstructionNames.end());
    made_.mesh.construction_names.insert(made_.mesh.construction_names.end(),
                                         kStripConstructionNames.begin(),
                                         kStripConstructionNames.end());
  }

  DomainMesh run(const std::vector<Strip>& strips) {
    mark_kept_vertices(strips);
    reserve(strips);
    number_kept_vertices();
    number_kept_quads();
    for (EdgeId site = 0; site < domain_.size(); ++site) made_.vertex_of.push_back(add_site(site));
    number_feet(strips);
    for (const Strip& strip : strips) add_strip(strip);
    return std::move(made_);
  }

 private:
  /// Strips of EdgeInsertion::kLemmas have vertices of Q that no kept quad has: ends of spikes.
  void mark_kept_vertices(const std::vector<Strip>& strips) {
    number_.assign(vertices_of_q_.size(), kNoVertex);
    for (QuadId quad = 0; quad < made_.mesh.quads.size(); ++quad)
      if (kept_.is_kept[quad])
        for (const VertexId v : made_.mesh.quads[quad]) number_[v] = 0;
    for (const Strip& strip : strips)
      for (const StripQuad& quad : strip.quads)
        for (const StripVertex& v : quad.corners)
          if (v.kind == StripVertex::Kind::kMesh) number_[v.id] = 0;
  }

  void number_kept_vertices() {
    for (VertexId v = 0; v < number_.size(); ++v)
      if (number_[v] == 0) number_[v] = made_.mesh.vertices.add(vertices_of_q_.lattice(v));
    vertices_of_q_ = Vertices();
  }

  void reserve(const std::vector<Strip>& strips) {
    auto quads =
        static_cast<std::size_t>(std::count(kept_.is_kept.begin(), kept_.is_kept.end(), true));
    auto vertices =
        static_cast<std::size_t>(std::count(number_.begin(), number_.end(), 0U)) + domain_.size();
    for (const Strip& strip : strips) {
      quads += strip.quads.size();
      vertices += kMostFeet * strip.quads.size() + strip.steiner.size();
    }
    made_.mesh.vertices.reserve(vertices);
    made_.mesh.quads.reserve(quads);
    made_.mesh.construction.reserve(quads);
    made_.mesh.level.reserve(quads);
  }

  /// Moved up to where others were.
  void number_kept_quads() {
    Mesh& mesh = made_.mesh;
    QuadId count = 0;
    for (QuadId quad = 0; quad < kept_.is_kept.size(); ++quad) {
      if (!kept_.is_kept[quad]) continue;
      for (unsigned k = 0; k < 4; ++k) mesh.quads[count][k] = number_[mesh.quads[quad][k]];
      mesh.construction[count] = mesh.construction[quad];
      mesh.level[count] = mesh.level[quad];
      ++count;
    }
    mesh.quads.resize(count);
    mesh.construction.resize(count);
    mesh.level.resize(count);
  }

  void add_quad(const Quad& quad, std::uint8_t construction, std::uint8_t level) {
    made_.mesh.quads.push_back(quad);
    made_.mesh.construction.push_back(construction);
    made_.mesh.level.push_back(level);
  }

  VertexId add_site(EdgeId site) {
    const Vertices& sites = domain_.vertices();
    if (sites.on_lattice(site)) return made_.mesh.vertices.add(sites.lattice(site));
    return made_.mesh.vertices.add_exact(sites.exact(site));
  }

  void number_feet(const std::vector<Strip>& strips) {
    for (const Strip& strip : strips)
      for (const StripQuad& quad : strip.quads)
        for (const StripVertex& v : quad.corners)
          if (v.kind == StripVertex::Kind::kFoot) add_foot({v.id, domain_.along(v.id, v.foot)});
    std::sort(feet_.begin(), feet_.end());
    feet_.erase(std::unique(feet_.begin(), feet_.end()), feet_.end());
    made_.steiner.resize(domain_.size());
    first_foot_ = static_cast<VertexId>(made_.mesh.vertices.size());
    for (const auto& [edge, along] : feet_)
      made_.steiner[edge].push_back(
          domain_.add_foot(made_.mesh.vertices, edge, domain_.along(edge, along)));
  }

  /// The next quad of a strip begins with the foot that the last one ended with.
  void add_foot(const std::pair<EdgeId, std::int64_t>& foot) {
    const std::size_t size = feet_.size();
    if (size >= 1 && feet_[size - 1] == foot) return;
    if (size >= 2 && feet_[size - 2] == foot) return;
    feet_.push_back(foot);
  }

  [[nodiscard]] VertexId foot_vertex(const StripVertex& v) const {
    // The feet of an edge follow each other.
    const std::vector<VertexId>& of_edge = made_.steiner[v.id];
    const auto first = feet_.begin() + (of_edge.front() - first_foot_);
    const auto at = std::lower_bound(first, first + static_cast<std::ptrdiff_t>(of_edge.size()),
                                     std::pair{v.id, domain_.along(v.id, v.foot)});
    return first_foot_ + static_cast<VertexId>(at - feet_.begin());
  }

  void add_strip(const Strip& strip) {
    std::vector<VertexId> steiner;
    for (const LatticePoint point : strip.steiner)
      steiner.push_back(made_.mesh.vertices.add(point));
    for (const StripQuad& quad : strip.quads) {
      Quad numbered{};
      std::uint8_t level = 0;
      for (unsigned k = 0; k < 4; ++k) {
        const StripVertex& v = quad.corners[k];
        numbered[k] = vertex(v, steiner);
        if (v.kind == StripVertex::Kind::kMesh) level = std::max(level, level_of(numbered[k]));
      }
      add_quad(numbered, number_of(quad.construction), level);
    }
  }

  [[nodiscard]] VertexId vertex(const StripVertex& v, const std::vector<VertexId>& steiner) const {
    switch (v.kind) {
      case StripVertex::Kind::kMesh:
        return number_[v.id];
      case StripVertex::Kind::kSite:
        return made_.vertex_of[v.id];
      case StripVertex::Kind::kFoot:
        return foot_vertex(v);
      case StripVertex::Kind::kSteiner:
        return steiner[v.id];
    }
    return kNoVertex;
  }

  [[nodiscard]] std::uint8_t level_of(VertexId v) {
    const Cell leaf = leaves_.leaf_at(made_.mesh.vertices.lattice(v));
    return static_cast<std::uint8_t>(tree_.root().side_bits - tree_.side_bits(leaf));
  }

  const Domain& domain_;
  const KeptQuads& kept_;
  const Quadtree& tree_;
  LeafFinder leaves_;
  Vertices vertices_of_q_;
  DomainMesh made_;
  std::vector<VertexId> number_;                       ///< of a vertex of Q in the mesh
  std::vector<std::pair<EdgeId, std::int64_t>> feet_;  ///< edge, place along it
  VertexId first_foot_ = 0;  ///< the vertices of feet_ are this one and those after it
};

}  // namespace

DomainMesh assemble(const Domain& domain, const Quadtree& tree, Mesh q, const KeptQuads& kept,
                    const std::vector<Strip>& strips) {
  return Assembly(domain, tree, std::move(q), kept).run(strips);
}

}  // namespace quadbound
