// SPDX-License-Identifier: Apache-2.0
#include "algo/quadrangulation.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace quadbound {
namespace {

/// First walk: which outer extras are mirrored or dropped.
class FatePlanner {
 public:
  explicit FatePlanner(TemplateTree& tree, Counters& counters) : tree_(tree), counters_(counters) {}

  void on_template(Template which) { ++counters_.templates[static_cast<std::size_t>(which)]; }
  void on_stitch(StitchCase which) { ++counters_.stitch_cases[static_cast<std::size_t>(which)]; }
  void set_fate(const CellRef& leaf, ExtraFate fate) {
    tree_.set_fate(leaf.parent, leaf.quadrant, fate);
    ++(fate == ExtraFate::kDropped ? counters_.extras_dropped : counters_.extras_moved);
  }
  VertexId halves_extra(const CellRef& leaf, Quadrant /*corner*/) {
    ++halves_extras_;
    return centre(leaf);
  }
  [[nodiscard]] std::uint64_t halves_extras() const { return halves_extras_; }
  [[nodiscard]] std::uint64_t quads() const { return quads_; }

  // In place of a vertex, the leaf that it belongs to.
  static VertexId centre(const CellRef& leaf) { return 4 * leaf.parent + leaf.quadrant; }
  static VertexId outer(const CellRef& leaf) { return centre(leaf); }
  static VertexId inner(const CellRef& leaf) { return centre(leaf); }
  // What the second walk needs, and this one does not.
  static bool is_dropped(const CellRef& /*leaf*/) { return false; }
  static void move_centre(const CellRef& /*leaf*/, bool /*horizontal*/, Quadrant /*side*/) {}
  void quad(Construction /*construction*/, std::uint8_t /*level*/, bool /*counter_clockwise*/,
            VertexId a, VertexId b, VertexId c, VertexId d) {
    ++quads_;
    if (tree_.leaves_any_out()) bring_back({a, b, c, d});
  }

 private:
  void bring_back(const std::array<VertexId, 4>& leaves) {
    if (std::none_of(leaves.begin(), leaves.end(), [this](VertexId leaf) {
          return tree_.is_wanted(leaf / 4, static_cast<Quadrant>(leaf % 4));
        }))
      return;
    for (const VertexId leaf : leaves)
      if (const auto q = static_cast<Quadrant>(leaf % 4); tree_.is_left_out(leaf / 4, q))
        tree_.bring_back(leaf / 4, q);
  }

  TemplateTree& tree_;
  Counters& counters_;
  std::uint64_t halves_extras_ = 0;
  std::uint64_t quads_ = 0;  ///< including the few whose extras are dropped
};

/// The outer extras at the four corners of the root lie on no chain that is ever stitched.
void drop_root_corners(TemplateTree& tree, Counters& counters) {
  for (const Quadrant q : kQuadrants) {
    CellRef corner = tree.child(0, q, 1);
    while (!corner.is_leaf() && !corner.is_hole()) corner = tree.child(corner, q);
    if (corner.is_hole() || tree.is_t4(corner.parent)) continue;
    tree.set_fate(corner.parent, q, ExtraFate::kDropped);
    ++counters.extras_dropped;
  }
}

/// Gives every leaf the ids of its centre, its outer extra (the id after it, if it is kept) and its
/// inner extra (the next one), depth first.
class VertexNumbering {
 public:
  VertexNumbering(TemplateTree& tree, const RootSquare& root, Vertices& vertices,
                  Counters& counters)
      : tree_(tree), root_(root), vertices_(vertices), counters_(counters) {}

  void run() { visit(0, root_.corner, 0); }

 private:
  void visit(NodeId node, LatticePoint corner, int level) {
    const int side_bits = root_.side_bits - level - 1;  // of the children
    const std::int64_t side = std::int64_t{1} << side_bits;
    const Template which = which_template(tree_.children(node));
    for (const Quadrant q : kQuadrants) {
      const LatticePoint low{corner.x + (is_east(q) ? side : 0),
                             corner.y + (is_north(q) ? side : 0)};
      const CellRef child = tree_.child(node, q, static_cast<std::uint8_t>(level + 1));
      if (child.is_hole()) continue;
      if (!child.is_leaf()) {
        visit(child.ref, low, level + 1);
      } else {
        ++counters_.leaves_by_level[static_cast<std::size_t>(level) + 1];
        number_leaf(node, q, which, {low.x + side / 2, low.y + side / 2}, side);
      }
    }
  }

  void number_leaf(NodeId node, Quadrant q, Template which, LatticePoint centre,
                   std::int64_t side) {
    const bool is_there = !tree_.is_left_out(node, q);
    if (is_there) tree_.set_centre(node, q, vertices_.add(centre));
    if (which == Template::kT4) return;
    ++counters_.extras_made;
    if (is_there && tree_.fate(node, q) != ExtraFate::kDropped)
      add_extra(extra_at(centre, side, q, tree_.fate(node, q)));
    if (which != Template::kT1 && which != Template::kT2b) return;
    ++counters_.extras_made;
    if (is_there) add_extra(extra_at(centre, side, opposite(q), ExtraFate::kKept));
  }

  void add_extra(LatticePoint at) { tree_.mark_extra(vertices_.add(at)); }

  /// Half of the way from the centre to a corner; reflected across the cell's side if mirrored.
  static LatticePoint extra_at(LatticePoint centre, std::int64_t side, Quadrant corner,
                               ExtraFate fate) {
    const std::int64_t dx = fate == ExtraFate::kMirroredX ? 3 * (side / 4) : side / 4;
    const std::int64_t dy = fate == ExtraFate::kMirroredY ? 3 * (side / 4) : side / 4;
    return {centre.x + (is_east(corner) ? dx : -dx), centre.y + (is_north(corner) ? dy : -dy)};
  }

  TemplateTree& tree_;
  RootSquare root_;
  Vertices& vertices_;
  Counters& counters_;
};

/// Second walk: emits the quads.
class QuadEmitter {
 public:
  QuadEmitter(TemplateTree& tree, const RootSquare& root, Mesh& mesh, Counters& counters)
      : tree_(tree), root_(root), mesh_(mesh), counters_(counters) {}

  static void on_template(Template /*which*/) {}
  static void on_stitch(StitchCase /*which*/) {}
  static void set_fate(const CellRef& /*leaf*/, ExtraFate /*fate*/) {}

  static VertexId centre(const CellRef& leaf) { return leaf.ref & ~Quadtree::kLeaf; }
  /// Requires: the extra is not dropped.
  static VertexId outer(const CellRef& leaf) { return centre(leaf) + 1; }
  [[nodiscard]] VertexId inner(const CellRef& leaf) const {
    return centre(leaf) + (is_dropped(leaf) ? 1 : 2);
  }
  [[nodiscard]] bool is_dropped(const CellRef& leaf) const {
    return tree_.fate(leaf.parent, leaf.quadrant) == ExtraFate::kDropped;
  }

  VertexId halves_extra(const CellRef& leaf, Quadrant corner) {
    ++counters_.extras_made;
    if (centre(leaf) == TemplateTree::kLeftOut) return TemplateTree::kLeftOut;
    const LatticePoint at = mesh_.vertices.lattice(centre(leaf));
    const std::int64_t quarter = std::int64_t{1} << (root_.side_bits - leaf.level - 2);
    const VertexId extra = mesh_.vertices.add({at.x + (is_east(corner) ? quarter : -quarter),
                                               at.y + (is_north(corner) ? quarter : -quarter)});
    tree_.add_halves_extra(centre(leaf), extra);
    return extra;
  }

  /// The paper's variant of 2,2: half of the way to the vertex beyond, which is one cell away.
  void move_centre(const CellRef& leaf, bool horizontal, Quadrant side) {
    LatticePoint at = mesh_.vertices.lattice(centre(leaf));
    const std::int64_t half = std::int64_t{1} << (root_.side_bits - leaf.level - 1);
    if (horizontal) {
      at.x += is_east(side) ? half : -half;
    } else {
      at.y += is_north(side) ? half : -half;
    }
    mesh_.vertices.move_to(centre(leaf), at);
  }

  void quad(Construction construction, std::uint8_t level, bool counter_clockwise, VertexId a,
            VertexId b, VertexId c, VertexId d) {
    ++counters_.quads[static_cast<std::size_t>(construction)];
    if (std::max({a, b, c, d}) >= TemplateTree::kLeftOut) return;
    mesh_.quads.push_back(counter_clockwise ? Quad{a, b, c, d} : Quad{d, c, b, a});
    mesh_.construction.push_back(static_cast<std::uint8_t>(construction));
    mesh_.level.push_back(level);
  }

 private:
  TemplateTree& tree_;
  RootSquare root_;
  Mesh& mesh_;
  Counters& counters_;
};

/// Centres, outer and inner extras by template, and the extras of the 2,2 case, less the dropped.
std::uint64_t vertex_count(const TemplateTree& tree, const FatePlanner& planner,
                           const Counters& counters) {
  const auto nodes = [&counters](Template t) {
    return counters.templates[static_cast<std::size_t>(t)];
  };
  const std::uint64_t outer = nodes(Template::kT1) + 2 * nodes(Template::kT2a) +
                              2 * nodes(Template::kT2b) + 3 * nodes(Template::kT3);
  const std::uint64_t inner = nodes(Template::kT1) + 2 * nodes(Template::kT2b);
  return tree.leaf_count() + outer + inner + planner.halves_extras() - counters.extras_dropped;
}

}  // namespace

Mesh quadrangulate(TemplateTree& tree, const RootSquare& root, TwoTwoVariant variant,
                   Counters& counters) {
  FatePlanner planner(tree, counters);
  TemplateWalk<FatePlanner>(tree, variant, planner).run();
  drop_root_corners(tree, counters);

  Mesh mesh;
  mesh.vertices = Vertices(root.exponent);
  mesh.cells = tree.leaf_count();
  mesh.construction_names.assign(kConstructionNames.begin(), kConstructionNames.end());
  const std::uint64_t most_vertices = vertex_count(tree, planner, counters);
  tree.set_most_vertices(most_vertices);
  mesh.vertices.reserve(most_vertices);
  mesh.quads.reserve(planner.quads());
  mesh.construction.reserve(planner.quads());
  mesh.level.reserve(planner.quads());
  VertexNumbering(tree, root, mesh.vertices, counters).run();
  tree.set_vertices_of_leaves(static_cast<VertexId>(mesh.vertices.size()));

  QuadEmitter emitter(tree, root, mesh, counters);
  TemplateWalk<QuadEmitter>(tree, variant, emitter).run();
  tree.sort_halves_extras();
  return mesh;
}

}  // namespace quadbound
