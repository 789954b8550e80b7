// SPDX-License-Identifier: Apache-2.0
#pragma once
// applyTemplate and stitchChains (Figures 3 and 4 of the paper) as a walk over the finished tree.
//
// The walk decides which quads there are; a visitor says what to do with them. It is walked twice:
// once to learn which extra points are moved or dropped, once to emit the quads.
//
// A *facing pair* is two cells A and B with the same side length and a common side, each with the
// quadrant of its corner at the outer and at the inner end of that side. "Outer" and "inner" only
// name the two ends of a direction of travel along the side; swapping them, or A and B, is how the
// symmetric cases of the figures are handled. With A on the left of the direction of travel, all
// quads below are listed counter-clockwise; with A on the right, they are reversed.
//
// In a tree with holes (see Window) what reaches into a hole is left out.
//
// Figures 5, 6 and 8 were rebuilt from the text of the paper; paper/theorem-1.md draws them.

#include <array>

#include "algo/construction.hpp"
#include "algo/template_tree.hpp"

namespace quadbound {

/// The paper leaves a vertex with 180 degrees in its case of two leaves against two split cells
/// without extra points, and moves it afterwards (Fig. 8a); ours adds two extra points instead.
enum class TwoTwoVariant : std::uint8_t { kExact, kPaper };

/// Visitor: on_template(Template); on_stitch(StitchCase); centre(leaf), outer(leaf), inner(leaf)
/// and halves_extra(leaf, corner) -> VertexId; quad(Construction, level, counter_clockwise, a, b,
/// c, d); set_fate(leaf, ExtraFate); is_dropped(leaf); move_centre(leaf, away_from).
template <class Visitor>
class TemplateWalk {
 public:
  TemplateWalk(const TemplateTree& tree, TwoTwoVariant variant, Visitor& visitor)
      : tree_(tree), variant_(variant), visitor_(visitor) {}

  void run() { apply_template(0, 0); }

 private:
  struct Side {
    CellRef cell;
    Quadrant outer;  ///< the cell's corner at the outer end of its side
    Quadrant inner;
  };

  static bool on_left(const Side& a) { return a.inner == turned(a.outer, 1); }
  static Side reversed_side(const Side& s) { return {s.cell, s.inner, s.outer}; }

  void quad(Construction construction, std::uint8_t level, const Side& a, VertexId v0, VertexId v1,
            VertexId v2, VertexId v3) {
    visitor_.quad(construction, level, on_left(a), v0, v1, v2, v3);
  }

  // --- Figures 1 and 2: the templates -----------------------------------------------------------

  void apply_template(NodeId node, std::uint8_t level) {
    const auto child_level = static_cast<std::uint8_t>(level + 1);
    std::array<CellRef, 4> ch{};
    for (const Quadrant q : kQuadrants) {
      ch[q] = tree_.child(node, q, child_level);
      if (!ch[q].is_leaf() && !ch[q].is_hole()) apply_template(ch[q].ref, child_level);
    }
    const Template which = which_template(tree_.children(node));
    visitor_.on_template(which);
    switch (which) {
      case Template::kT4:
        visitor_.quad(Construction::kT4, child_level, true, visitor_.centre(ch[0]),
                      visitor_.centre(ch[1]), visitor_.centre(ch[2]), visitor_.centre(ch[3]));
        return;
      case Template::kT3:
        return apply_t3(ch);
      case Template::kT2a:
        return apply_t2a(ch);
      case Template::kT0:
      case Template::kT1:
      case Template::kT2b:
        // Stitches that touch a leaf come last only in the paper's order; no stitch needs another.
        for (const Quadrant q : kQuadrants) stitch_siblings(ch, q);
        return template_middle(ch);
    }
  }

  void template_middle(const std::array<CellRef, 4>& ch) {
    std::array<VertexId, 4> corner{};
    std::uint8_t level = 0;
    for (const Quadrant q : kQuadrants) {
      const bool inner = ch[q].is_leaf();  // T1, T2b: every leaf child has its inner extra
      const CellRef leaf = corner_leaf(ch[q], opposite(q));
      if (leaf.is_hole()) return;
      corner[q] = inner ? visitor_.inner(leaf) : corner_point(leaf, opposite(q));
      level = std::max(level, leaf.level);
    }
    visitor_.quad(Construction::kMiddle, level, true, corner[0], corner[1], corner[2], corner[3]);
  }

  /// T3: the one non-leaf child is `split`; the frame of paper/theorem-1.md has it at the lower
  /// left.
  void apply_t3(const std::array<CellRef, 4>& ch) {
    Quadrant m = kNorthEast;
    while (ch[m].is_leaf()) m = turned(m, 1);
    const CellRef& split = ch[m];
    if (split.is_hole()) return;
    const VertexId a = visitor_.centre(ch[turned(m, 1)]);
    const VertexId d = visitor_.centre(ch[turned(m, 2)]);
    const VertexId b = visitor_.centre(ch[turned(m, 3)]);
    // By balance the three outer children of the split child are leaves.
    const CellRef i1 = tree_.child(split, turned(m, 1));
    const CellRef i2 = tree_.child(split, turned(m, 2));
    const CellRef i3 = tree_.child(split, turned(m, 3));
    const VertexId c1 = visitor_.centre(i1);
    const VertexId c2 = visitor_.centre(i2);
    const VertexId c3 = visitor_.centre(i3);
    if (tree_.is_t4(split.ref)) {
      visitor_.quad(Construction::kT3Two, i2.level, true, a, d, c2, c1);
      visitor_.quad(Construction::kT3Two, i2.level, true, d, b, c3, c2);
      return;
    }
    visitor_.set_fate(i2, ExtraFate::kDropped);
    visitor_.quad(Construction::kT3Four, i2.level, true, a, c2, c1, visitor_.outer(i1));
    visitor_.quad(Construction::kT3Four, i2.level, true, b, visitor_.outer(i3), c3, c2);
    visitor_.quad(Construction::kT3Four, i2.level, true, a, d, b, c2);
  }

  /// T2a: the two leaves k and k + 1 together against the two other children.
  void apply_t2a(const std::array<CellRef, 4>& ch) {
    Quadrant k = kNorthEast;
    while (!ch[k].is_leaf() || !ch[turned(k, 1)].is_leaf()) k = turned(k, 1);
    stitch_siblings(ch, turned(k, 2));
    const Quadrant near_outer = turned(k, 3);
    const Quadrant near_inner = turned(k, 2);
    const Quadrant far_outer = k;
    const Quadrant far_inner = turned(k, 1);
    two_leaf_case({ch[k], near_outer, near_inner}, {ch[turned(k, 1)], near_outer, near_inner},
                  {ch[turned(k, 3)], far_outer, far_inner},
                  {ch[turned(k, 2)], far_outer, far_inner});
  }

  /// Stitches child k with child k + 1; the side runs from the node's border to its centre.
  void stitch_siblings(const std::array<CellRef, 4>& ch, Quadrant k) {
    stitch({ch[k], turned(k, 1), turned(k, 2)}, {ch[turned(k, 1)], k, turned(k, 3)});
  }

  // --- Figures 4, 5 and 6: stitchChains ---------------------------------------------------------

  void stitch(const Side& a, const Side& b) {
    if (a.cell.is_hole() || b.cell.is_hole()) return;
    if (a.cell.is_leaf() && b.cell.is_leaf()) return stitch_one_one(a, b);
    if (a.cell.is_leaf()) return stitch_one_two(a, b);
    if (b.cell.is_leaf()) return stitch_one_two(b, a);
    const Side a1{tree_.child(a.cell, a.outer), a.outer, a.inner};
    const Side a2{tree_.child(a.cell, a.inner), a.outer, a.inner};
    const Side b1{tree_.child(b.cell, b.outer), b.outer, b.inner};
    const Side b2{tree_.child(b.cell, b.inner), b.outer, b.inner};
    const bool a_plain = two_plain_leaves(a, a1, a2);
    const bool b_plain = two_plain_leaves(b, b1, b2);
    if (a_plain && b_plain) {
      visitor_.on_stitch(StitchCase::kTwoTwo);
      return quad(Construction::kTwoTwo, a1.cell.level, a, visitor_.centre(a1.cell),
                  visitor_.centre(b1.cell), visitor_.centre(b2.cell), visitor_.centre(a2.cell));
    }
    if (a_plain) return two_leaf_case(a1, a2, b1, b2);
    if (b_plain) return two_leaf_case(b1, b2, a1, a2);
    visitor_.on_stitch(StitchCase::kHalved);
    stitch(a1, b1);
    stitch(a2, b2);
    const CellRef la1 = corner_leaf(a1.cell, a.inner);
    const CellRef la2 = corner_leaf(a2.cell, a.outer);
    const CellRef lb1 = corner_leaf(b1.cell, b.inner);
    const CellRef lb2 = corner_leaf(b2.cell, b.outer);
    if (la1.is_hole() || la2.is_hole() || lb1.is_hole() || lb2.is_hole()) return;
    const std::uint8_t level =
        std::max(std::max(la1.level, la2.level), std::max(lb1.level, lb2.level));
    quad(Construction::kMiddle, level, a, corner_point(la1, a.inner), corner_point(lb1, b.inner),
         corner_point(lb2, b.outer), corner_point(la2, a.outer));
  }

  /// Two leaves without extra points on the side: leaves of a T4 node.
  bool two_plain_leaves(const Side& a, const Side& a1, const Side& a2) const {
    return a1.cell.is_leaf() && a2.cell.is_leaf() && tree_.is_t4(a.cell.ref);
  }

  /// At which end of its side a single leaf has its extra point: the outer extra lies at the corner
  /// that the leaf shares with its parent, the inner one at the opposite corner, and any side has
  /// exactly one of these two corners.
  static bool extra_at_inner_end(const Side& leaf) {
    return leaf.inner == leaf.cell.quadrant || leaf.inner == opposite(leaf.cell.quadrant);
  }

  VertexId extra_of(const Side& leaf) {
    const Quadrant corner = extra_at_inner_end(leaf) ? leaf.inner : leaf.outer;
    return corner == leaf.cell.quadrant ? visitor_.outer(leaf.cell) : visitor_.inner(leaf.cell);
  }

  void stitch_one_one(const Side& a, const Side& b) {
    if (extra_at_inner_end(a)) return stitch_one_one(reversed_side(a), reversed_side(b));
    visitor_.on_stitch(StitchCase::kOneOne);
    // The pair of middle extras of the two-leaf case 4,4 takes this quad with it.
    if (visitor_.is_dropped(a.cell)) return;
    quad(Construction::kOneOne, a.cell.level, a, visitor_.centre(a.cell), extra_of(a), extra_of(b),
         visitor_.centre(b.cell));
  }

  void stitch_one_two(const Side& a, const Side& b) {
    if (!extra_at_inner_end(a)) return stitch_one_two(reversed_side(a), reversed_side(b));
    const CellRef far_leaf = tree_.child(b.cell, b.outer);
    const CellRef near_leaf = tree_.child(b.cell, b.inner);
    const VertexId c = visitor_.centre(a.cell);
    const VertexId e = extra_of(a);
    const VertexId s1 = visitor_.centre(far_leaf);
    const VertexId s2 = visitor_.centre(near_leaf);
    if (tree_.is_t4(b.cell.ref)) {
      visitor_.on_stitch(StitchCase::kOneTwo);
      return quad(Construction::kOneTwo, far_leaf.level, a, c, s1, s2, e);
    }
    visitor_.on_stitch(StitchCase::kOneFour);
    quad(Construction::kOneFour, far_leaf.level, a, c, visitor_.outer(far_leaf), s1, s2);
    quad(Construction::kOneFour, far_leaf.level, a, c, s2, visitor_.outer(near_leaf), e);
  }

  // --- Figure 6 and T2a: the two-leaf cases ------------------------------------------------------

  /// What faces one of the two leaves: a leaf with its outer extra, or two leaves without or with
  /// extras. `s_outer` and `s_inner` are the centres, `middle` the leaf at the inner end.
  struct Half {
    enum Kind : std::uint8_t { kLeaf, kTwo, kFour } kind;
    CellRef outer_leaf;
    CellRef middle;
  };

  /// `towards_middle` is the end of the half's side that touches the other half.
  Half half(const Side& side, Quadrant away, Quadrant towards_middle) const {
    if (side.cell.is_leaf()) return {Half::kLeaf, side.cell, side.cell};
    const CellRef outer_leaf = tree_.child(side.cell, away);
    const CellRef middle = tree_.child(side.cell, towards_middle);
    return {tree_.is_t4(side.cell.ref) ? Half::kTwo : Half::kFour, outer_leaf, middle};
  }

  /// Leaves c (outer) and d (inner) without extras on their side against A (across from c) and B
  /// (across from d), which are stitched to each other already.
  void two_leaf_case(const Side& c, const Side& d, const Side& a, const Side& b) {
    if (a.cell.is_hole() || b.cell.is_hole()) return;
    const Half ha = half(a, a.outer, a.inner);
    const Half hb = half(b, b.inner, b.outer);
    // Cases are listed with the leaf, or else the half with more extras, at A: rank L < 4 < 2.
    constexpr std::array<int, 3> rank{0, 2, 1};
    if (rank[hb.kind] < rank[ha.kind])
      return two_leaf_case(reversed_side(d), reversed_side(c), reversed_side(b), reversed_side(a));
    const VertexId vc = visitor_.centre(c.cell);
    const VertexId vd = visitor_.centre(d.cell);
    if (ha.kind == Half::kLeaf && hb.kind == Half::kLeaf) return two_leaf_ll(c, vc, vd, ha, hb);
    if (ha.kind == Half::kLeaf && hb.kind == Half::kTwo) return two_leaf_l2(c, vc, vd, ha, hb);
    if (ha.kind == Half::kLeaf) return two_leaf_l4(c, vc, vd, ha, hb);
    if (ha.kind == Half::kTwo) return two_leaf_22(c, d, vc, vd, ha, hb);
    if (hb.kind == Half::kTwo) return two_leaf_42(c, vc, vd, ha, hb);
    two_leaf_44(c, vc, vd, ha, hb);
  }

  void two_leaf_ll(const Side& c, VertexId vc, VertexId vd, const Half& a, const Half& b) {
    visitor_.on_stitch(StitchCase::kLeafLeaf);
    const VertexId va = visitor_.centre(a.middle);
    const VertexId vb = visitor_.centre(b.middle);
    quad(Construction::kLeafLeaf, c.cell.level, c, vc, visitor_.outer(a.middle), va, vd);
    quad(Construction::kLeafLeaf, c.cell.level, c, vd, va, vb, visitor_.outer(b.middle));
  }

  void two_leaf_l2(const Side& c, VertexId vc, VertexId vd, const Half& a, const Half& b) {
    visitor_.on_stitch(StitchCase::kLeafTwo);
    const VertexId s3 = visitor_.centre(b.middle);
    quad(Construction::kLeafTwo, b.middle.level, c, vc, visitor_.outer(a.middle),
         visitor_.centre(a.middle), s3);
    quad(Construction::kLeafTwo, b.middle.level, c, vc, s3, visitor_.centre(b.outer_leaf), vd);
  }

  void two_leaf_22(const Side& c, const Side& d, VertexId vc, VertexId vd, const Half& a,
                   const Half& b) {
    visitor_.on_stitch(StitchCase::kTwoTwoHalves);
    const VertexId s1 = visitor_.centre(a.outer_leaf);
    const VertexId s2 = visitor_.centre(a.middle);
    const VertexId s3 = visitor_.centre(b.middle);
    const VertexId s4 = visitor_.centre(b.outer_leaf);
    constexpr Construction name = Construction::kTwoTwoHalves;
    if (variant_ == TwoTwoVariant::kPaper) {
      quad(name, a.middle.level, c, vc, s1, s2, s3);
      quad(name, a.middle.level, c, vc, s3, s4, vd);
      visitor_.move_centre(a.middle, travels_north_south(c), c.outer);
      return;
    }
    const VertexId mc = visitor_.halves_extra(c.cell, c.inner);
    const VertexId md = visitor_.halves_extra(d.cell, d.outer);
    quad(name, a.middle.level, c, vc, s1, s2, mc);
    quad(name, a.middle.level, c, mc, s2, s3, md);
    quad(name, a.middle.level, c, md, s3, s4, vd);
    quad(name, a.middle.level, c, vc, mc, md, vd);
  }

  void two_leaf_l4(const Side& c, VertexId vc, VertexId vd, const Half& a, const Half& b) {
    visitor_.on_stitch(StitchCase::kLeafFour);
    mirror_along(c, b.middle);
    const VertexId e3 = visitor_.outer(b.middle);
    const VertexId s3 = visitor_.centre(b.middle);
    constexpr Construction name = Construction::kLeafFour;
    quad(name, b.middle.level, c, vc, visitor_.outer(a.middle), visitor_.centre(a.middle), e3);
    quad(name, b.middle.level, c, vc, e3, s3, vd);
    quad(name, b.middle.level, c, vd, s3, visitor_.centre(b.outer_leaf),
         visitor_.outer(b.outer_leaf));
  }

  void two_leaf_42(const Side& c, VertexId vc, VertexId vd, const Half& a, const Half& b) {
    visitor_.on_stitch(StitchCase::kFourTwo);
    mirror_along(c, a.middle);
    const VertexId e2 = visitor_.outer(a.middle);
    const VertexId s2 = visitor_.centre(a.middle);
    constexpr Construction name = Construction::kFourTwo;
    quad(name, a.middle.level, c, vc, visitor_.outer(a.outer_leaf), visitor_.centre(a.outer_leaf),
         s2);
    quad(name, a.middle.level, c, vc, s2, e2, vd);
    quad(name, a.middle.level, c, vd, e2, visitor_.centre(b.middle), visitor_.centre(b.outer_leaf));
  }

  void two_leaf_44(const Side& c, VertexId vc, VertexId vd, const Half& a, const Half& b) {
    visitor_.on_stitch(StitchCase::kFourFour);
    visitor_.set_fate(a.middle, ExtraFate::kDropped);
    visitor_.set_fate(b.middle, ExtraFate::kDropped);
    const VertexId s2 = visitor_.centre(a.middle);
    const VertexId s3 = visitor_.centre(b.middle);
    constexpr Construction name = Construction::kFourFour;
    quad(name, a.middle.level, c, vc, visitor_.outer(a.outer_leaf), visitor_.centre(a.outer_leaf),
         s2);
    quad(name, a.middle.level, c, vc, s2, s3, vd);
    quad(name, a.middle.level, c, vd, s3, visitor_.centre(b.outer_leaf),
         visitor_.outer(b.outer_leaf));
  }

  static bool travels_north_south(const Side& c) { return is_north(c.outer) != is_north(c.inner); }

  /// Reflects the outer extra of a leaf across the line between A and B, which crosses the
  /// direction of travel.
  void mirror_along(const Side& c, const CellRef& leaf) {
    visitor_.set_fate(leaf, travels_north_south(c) ? ExtraFate::kMirroredY : ExtraFate::kMirroredX);
  }

  // --- corner points -----------------------------------------------------------------------------

  /// Or the hole that it is in.
  CellRef corner_leaf(CellRef cell, Quadrant corner) const {
    while (!cell.is_leaf() && !cell.is_hole()) cell = tree_.child(cell, corner);
    return cell;
  }

  /// The mesh point of a leaf nearest to a corner: its outer extra if it has one there, or its
  /// centre.
  VertexId corner_point(const CellRef& leaf, Quadrant corner) {
    const bool extra = corner == leaf.quadrant && tree_.has_outer_extra(leaf);
    return extra ? visitor_.outer(leaf) : visitor_.centre(leaf);
  }

  const TemplateTree& tree_;
  TwoTwoVariant variant_;
  Visitor& visitor_;
};

}  // namespace quadbound
