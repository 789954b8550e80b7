// SPDX-License-Identifier: Apache-2.0
#include "algo/domain_mesher.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "algo/corner_alignment.hpp"
#include "algo/edge_separation.hpp"
#include "algo/strip_assembly.hpp"

namespace quadbound {
namespace {

/// How often the cells at an acute vertex are split before it is given a kite: refinement there
/// only scales what is seen from the vertex.
constexpr int kPatience = 3;

/// Rounds with dead ends before another root square is tried: if the place of a vertex in its cell
/// repeats from level to level, so does the dead end.
constexpr int kDeadRounds = 10;

/// Of the nodes of a tree, one in so many: with more splits the window around them is large, and
/// the whole is looked at again. (On Lake Superior, one in 11, it has two thirds of the tree; on a
/// coast of 10,000 vertices, one in 45, an eighth.)
constexpr std::size_t kManySplits = 16;

/// The vertex that two edges share, if it is acute.
std::optional<EdgeId> acute_between(const Domain& domain, EdgeId e, EdgeId f) {
  if (domain.next(e) == f && domain.is_acute(f)) return f;
  if (domain.next(f) == e && domain.is_acute(e)) return e;
  return std::nullopt;
}

/// One of the smallest leaves: what asked for so many cells is there.
TreeBudgetExceeded at_smallest_cell(const Quadtree& tree, RefusalKind kind) {
  const auto deepest =
      std::max_element(tree.blocks().begin(), tree.blocks().end(),
                       [](const auto& a, const auto& b) { return a.level < b.level; });
  return {kind, deepest->corner, deepest->level + 1};
}

}  // namespace

DomainMesher::DomainMesher(const Domain& domain, const InputVertices& inputs,
                           const SizeField& sizes, const Budget& budget, bool is_last_root,
                           Learnt& learnt, PolygonCounters& counters, EdgeInsertion insertion)
    : domain_(domain),
      inputs_(inputs),
      sizes_(sizes),
      deadline_(budget.max_seconds),
      separation_(placed_vertices(domain), budget),
      is_last_root_(is_last_root),
      learnt_(learnt),
      counters_(counters),
      insertion_(insertion),
      suspects_(std::exchange(learnt.suspects, {})) {}

DomainMesher::Outcome DomainMesher::run() {
  try {
    return run_rounds();
  } catch (const TreeBudgetExceeded& exceeded) {
    if (exceeded.kind == RefusalKind::kTooDeep) throw;
    throw at_smallest_cell(separation_.tree(), exceeded.kind);
  }
}

DomainMesher::Outcome DomainMesher::run_rounds() {
  separation_.apply_conditions();
  separation_.refine_five_by_five();
  counters_.cells_before = separation_.tree().leaf_count();
  repeat_splits();
  split_and_separate();
  if (!hopeless_.empty()) return NeedsKites{hopeless_};
  separate_cells();
  for (;;) {
    ++counters_.rounds;
    counters_.quadtree = {};
    counters_.insertion = {};
    std::optional<DomainMesh> made = round();
    if (made) return std::move(*made);
    if (fault_) return *fault_;
    split_and_separate();
    if (!hopeless_.empty()) return NeedsKites{hopeless_};
    if (dead_rounds_ > kDeadRounds && !is_last_root_) return NeedsOtherRoot{};
  }
}

/// Splits what a round asked for, and goes on around that and the suspects until the edges are
/// separated there, but for those at hopeless vertices: the more of these are found, the fewer
/// attempts are given up.
void DomainMesher::split_and_separate() {
  while (!to_split_.empty() || !suspects_.empty()) {
    const std::optional<Window> window = split();
    if (!window) return;
    local_round(*window);
  }
}

/// The window around the splits and the suspects; nullopt where it is large, no smaller than half
/// of the tree, which may as well be looked at as a whole.
std::optional<Window> DomainMesher::split() {
  const Quadtree& tree = separation_.tree();
  const auto known = static_cast<BlockId>(tree.blocks().size());
  if (!to_split_.empty()) edge_cells_.reset();
  separation_.refine(to_split_);
  to_split_.clear();
  std::vector<Cell> leaves;
  for (const LatticePoint place : suspects_) leaves.push_back(tree.leaf_at(place));
  suspects_.clear();
  const std::size_t half = tree.blocks().size() / 2;
  // With a quarter of the nodes new, no window was smaller: 160 polygons have the same meshes with
  // and without this, and a comb of 10,000 vertices takes 3 % less time.
  if (tree.blocks().size() - known > half / 2) return std::nullopt;
  Window window(tree, known, leaves);
  if (window.size() > half) return std::nullopt;
  return window;
}

void DomainMesher::local_round(const Window& window) {
  check_time();
  ++counters_.local_rounds;
  Counters uncounted;
  const EdgeCells edge_cells(domain_, separation_.tree(), window);
  const TreeMesh tree_mesh(domain_, separation_, edge_cells, uncounted, window);
  const CutQuads cut_quads(domain_, tree_mesh, edge_cells);
  const bool separated = is_separated(tree_mesh, cut_quads);
  split_pinched(tree_mesh, pinched_vertices(tree_mesh, cut_quads), separated);
}

/// While the edges are not separated, which may pinch K, it is looked at again.
void DomainMesher::split_pinched(const TreeMesh& tree_mesh, const std::vector<VertexId>& pinched,
                                 bool separated) {
  for (const VertexId v : pinched) {
    learnt_.suspects.push_back(tree_mesh.at(v));
    if (!to_split_.empty()) suspects_.push_back(tree_mesh.at(v));
  }
  if (!separated) return;
  for (const VertexId v : pinched) split_around(tree_mesh, {v});
}

void DomainMesher::repeat_splits() {
  LeafFinder leaves(separation_.tree());
  for (const Split& split : learnt_.splits) {
    const Cell leaf = leaves.leaf_at(split.corner);
    if (separation_.tree().side_bits(leaf) == split.side_bits) separation_.refine({leaf});
  }
}

/// Separation as far as the tree alone tells.
void DomainMesher::separate_cells() {
  Window window;
  for (;;) {
    check_time();
    edge_cells_.emplace(domain_, separation_.tree(), window);
    const std::vector<Cell> large = leaves_too_large(domain_, separation_.tree(), *edge_cells_);
    if (large.empty()) break;
    counters_.separation_splits += large.size();
    for (const Cell leaf : large) remember(leaf, std::nullopt);
    const auto known = static_cast<BlockId>(separation_.tree().blocks().size());
    separation_.refine(large);
    window = Window(separation_.tree(), known);
  }
  if (!window.is_whole()) edge_cells_.reset();
}

std::optional<DomainMesh> DomainMesher::round() {
  to_split_.clear();
  check_time();
  if (!edge_cells_) edge_cells_.emplace(domain_, separation_.tree());
  TreeMesh tree_mesh(domain_, separation_, *edge_cells_, counters_.quadtree);
  check_time();
  KeptQuads kept;
  std::vector<Strip> strips;
  if (!find_strips(tree_mesh, kept, strips)) return std::nullopt;
  tree_mesh.forget_sites();
  counters_.kept_quads =
      static_cast<std::uint64_t>(std::count(kept.is_kept.begin(), kept.is_kept.end(), true));
  DomainMesh made = assemble(domain_, tree_mesh.tree(), tree_mesh.take_mesh(), kept, strips);
  if (!fill(made, tree_mesh)) return std::nullopt;
  return made;
}

/// What is left of Q, and the strips around it; false where something is to be split first.
bool DomainMesher::find_strips(TreeMesh& tree_mesh, KeptQuads& kept, std::vector<Strip>& strips) {
  CutQuads cut_quads(domain_, tree_mesh, *edge_cells_);
  edge_cells_.reset();
  if (!is_separated(tree_mesh, cut_quads)) {
    if (kManySplits * to_split_.size() < separation_.tree().blocks().size())
      split_pinched(tree_mesh, pinched_vertices(tree_mesh, cut_quads), false);
    return false;
  }
  if (!is_fine_enough(tree_mesh, cut_quads)) return false;
  kept = keep_quads(tree_mesh, cut_quads);
  check_time();
  if (!kept.pinched.empty()) {
    split_pinched(tree_mesh, kept.pinched, true);
    return false;
  }
  if (!has_one_alpha_for_each_ring(tree_mesh, cut_quads, kept)) return false;
  if (insertion_ == EdgeInsertion::kLemmas)
    return insert_lemmas(tree_mesh, cut_quads, kept, strips);
  aligned_ = align_with_corners(domain_, tree_mesh, cut_quads, kept, counters_.insertion);
  tree_mesh.forget_links();
  cut_quads.forget_cuts();
  return insert(tree_mesh, cut_quads, kept, strips);
}

bool DomainMesher::is_separated(const TreeMesh& tree_mesh, const CutQuads& cut_quads) {
  const std::vector<SeparationFault> faults = separation_faults(domain_, tree_mesh, cut_quads);
  if (faults.empty()) return true;
  for (const SeparationFault& fault : faults)
    if (const auto acute = acute_between(domain_, fault.edge, fault.other))
      troubled_.push_back(*acute);
  lose_patience();
  for (const SeparationFault& fault : faults) {
    const auto acute = acute_between(domain_, fault.edge, fault.other);
    const bool hopeless = acute && is_hopeless(*acute);
    if (hopeless) {
      learnt_.suspects.push_back(separation_.tree().corner(fault.split));
    } else {
      remember(fault.split, acute);
      to_split_.push_back(fault.split);
    }
  }
  for (const Cell leaf : leaves_along_gaps(domain_, separation_.tree(), faults)) {
    to_split_.push_back(leaf);
    remember(leaf, std::nullopt);
  }
  counters_.separation_splits += to_split_.size();
  return false;
}

/// Leaves with their centre inside the domain are no wider than the sizing says.
bool DomainMesher::is_fine_enough(const TreeMesh& tree_mesh, const CutQuads& cut_quads) {
  if (sizes_.is_free()) return true;
  const Quadtree& tree = separation_.tree();
  const double unit = std::ldexp(1.0, domain_.root().exponent);
  for (BlockId block = 0; block < tree.blocks().size(); ++block) {
    for (const Quadrant q : kQuadrants) {
      const Cell leaf{block, q};
      if (!tree.is_leaf(leaf) || !tree_mesh.has(leaf)) continue;
      const VertexId centre = tree_mesh.centre(leaf);
      if (cut_quads.where(centre) == Where::kOutside) continue;
      const LatticePoint at = tree_mesh.at(centre);
      const Point place{static_cast<double>(at.x) * unit, static_cast<double>(at.y) * unit};
      if (std::ldexp(unit, tree.side_bits(leaf)) > sizes_.size_at(place)) to_split_.push_back(leaf);
    }
  }
  counters_.size_splits += to_split_.size();
  return to_split_.empty();
}

/// Where K has no part at a ring, the leaves of its vertices are split. Where it has two, they are
/// parted by a narrow place where alpha goes over from one edge to another that does not follow it.
bool DomainMesher::has_one_alpha_for_each_ring(const TreeMesh& tree_mesh, const CutQuads& cut_quads,
                                               const KeptQuads& kept) {
  std::vector<std::size_t> alphas(domain_.ring_count());
  for (const std::vector<VertexId>& alpha : kept.alphas)
    if (const auto ring = ring_along(cut_quads, alpha)) ++alphas[*ring];
  for (const std::vector<VertexId>& alpha : kept.alphas) {
    const auto ring = ring_along(cut_quads, alpha);
    if (ring && alphas[*ring] > 1) split_around(tree_mesh, leaps(cut_quads, alpha));
  }
  if (!to_split_.empty()) return false;
  for (EdgeId site = 0; site < domain_.size(); ++site)
    if (alphas[domain_.ring(site)] != 1) to_split_.push_back(tree_mesh.cell_of(site));
  return to_split_.empty();
}

std::optional<std::uint32_t> DomainMesher::ring_along(const CutQuads& cut_quads,
                                                      const std::vector<VertexId>& alpha) const {
  for (const VertexId v : alpha)
    if (const auto above = cut_quads.above(v); !above.empty())
      return domain_.ring(above.front().edge);
  return std::nullopt;
}

/// Vertices of alpha that come next to each other, of those above edges, and whose edges do not
/// follow each other.
std::vector<VertexId> DomainMesher::leaps(const CutQuads& cut_quads,
                                          const std::vector<VertexId>& alpha) const {
  const auto has = [](std::span<const Above> edges, EdgeId e) {
    return std::any_of(edges.begin(), edges.end(), [e](const Above& a) { return a.edge == e; });
  };
  // An edge further on is above both vertices, or follows one that is; none goes back.
  const auto follow = [&](std::span<const Above> from, std::span<const Above> to) {
    return std::all_of(to.begin(), to.end(), [&](const Above& there) {
      return has(from, there.edge) || has(from, domain_.previous(there.edge));
    });
  };
  std::vector<VertexId> chain;
  std::copy_if(alpha.begin(), alpha.end(), std::back_inserter(chain),
               [&](VertexId v) { return !cut_quads.above(v).empty(); });
  std::vector<VertexId> found;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const VertexId here = chain[i];
    const VertexId there = chain[(i + 1) % chain.size()];
    if (!follow(cut_quads.above(here), cut_quads.above(there)))
      found.insert(found.end(), {here, there});
  }
  return found;
}

/// Moves the centres beside a dead end back to where they were; whether there were any.
bool DomainMesher::undo_alignment(TreeMesh& tree_mesh, const DeadEnd& dead) {
  bool undone = false;
  for (const VertexId v : dead.near) {
    const EdgeId site = tree_mesh.site_near(v);
    if (site == TreeMesh::kNoSite) continue;
    for (AlignedCentre& aligned : aligned_) {
      if (aligned.site != site || tree_mesh.at(aligned.centre) == aligned.before) continue;
      tree_mesh.move_to(aligned.centre, aligned.before);
      ++counters_.insertion.moves_undone;
      undone = true;
    }
  }
  return undone;
}

bool DomainMesher::insert(TreeMesh& tree_mesh, const CutQuads& cut_quads, const KeptQuads& kept,
                          std::vector<Strip>& strips) {
  for (const std::vector<VertexId>& alpha : kept.alphas) {
    check_time();
    auto made = insert_edges(domain_, tree_mesh, cut_quads, alpha, counters_.insertion);
    // As often as there are corners along alpha at most: each time some are undone for good.
    while (const auto* dead = std::get_if<DeadEnd>(&made)) {
      if (!undo_alignment(tree_mesh, *dead)) break;
      made = insert_edges(domain_, tree_mesh, cut_quads, alpha, counters_.insertion);
    }
    if (auto* strip = std::get_if<Strip>(&made)) {
      strips.push_back(std::move(*strip));
      continue;
    }
    const DeadEnd& dead = std::get<DeadEnd>(made);
    split_around(tree_mesh, dead.near);
    for (const VertexId v : dead.near) blame_acute(tree_mesh, cut_quads, v);
  }
  lose_patience();
  if (to_split_.empty()) return true;
  ++dead_rounds_;
  return false;
}

bool DomainMesher::insert_lemmas(TreeMesh& tree_mesh, const CutQuads& cut_quads, KeptQuads& kept,
                                 std::vector<Strip>& strips) {
  counters_.lemmas.emplace();
  auto made = insert_by_lemmas(domain_, tree_mesh, cut_quads, kept, *counters_.lemmas);
  if (const auto* fault = std::get_if<LemmaFault>(&made)) {
    fault_ = *fault;
    return false;
  }
  strips.push_back(std::get<Strip>(std::move(made)));
  return true;
}

/// Section 4. Where a kite cannot be filled, the cells at its corners are split.
bool DomainMesher::fill(DomainMesh& made, const TreeMesh& tree_mesh) {
  const bool as_written = insertion_ == EdgeInsertion::kLemmas;
  const KiteFilling filling =
      fill_kites(domain_, made, as_written ? KiteShape::kPaper : KiteShape::kOurs);
  if (counters_.lemmas) counters_.lemmas->kites_outside = filling.outside;
  counters_.kite_filling = filling.counters;
  for (const std::size_t failed : filling.failed) {
    const Kite& kite = domain_.kites[failed];
    for (const EdgeId site : {kite.p, kite.v, kite.q}) {
      to_split_.push_back(tree_mesh.cell_of(site));
      ++counters_.kite_splits;
    }
  }
  if (to_split_.empty()) return true;
  ++dead_rounds_;
  return false;
}

/// Acute vertices whose edges run below a vertex of a dead end.
void DomainMesher::blame_acute(const TreeMesh& tree_mesh, const CutQuads& cut_quads,
                               VertexId vertex) {
  const EdgeId site = tree_mesh.site_near(vertex);
  if (site != TreeMesh::kNoSite && domain_.is_acute(site)) troubled_.push_back(site);
  for (const Above& above : cut_quads.above(vertex)) {
    for (const Above& other : cut_quads.above(vertex)) {
      const auto acute = acute_between(domain_, above.edge, other.edge);
      if (acute) troubled_.push_back(*acute);
    }
  }
}

/// Counts the rounds in which each acute vertex made trouble. Corners of kites are never acute.
void DomainMesher::lose_patience() {
  std::sort(troubled_.begin(), troubled_.end());
  troubled_.erase(std::unique(troubled_.begin(), troubled_.end()), troubled_.end());
  for (const EdgeId site : troubled_) {
    const std::size_t input = inputs_[site].value();
    if (++learnt_.trouble[input] == kPatience) hopeless_.push_back(input);
  }
  troubled_.clear();
}

/// Its cells are not split for its two edges any more.
bool DomainMesher::is_hopeless(EdgeId acute) const {
  return learnt_.trouble[inputs_[acute].value()] >= kPatience;
}

/// Splits the largest of the leaves of some vertices.
void DomainMesher::split_around(const TreeMesh& tree_mesh, const std::vector<VertexId>& vertices) {
  int largest = 0;
  for (const VertexId v : vertices)
    largest = std::max(largest, tree_mesh.tree().side_bits(tree_mesh.leaf_of(v)));
  for (const VertexId v : vertices) {
    const Cell leaf = tree_mesh.leaf_of(v);
    if (tree_mesh.tree().side_bits(leaf) != largest) continue;
    to_split_.push_back(leaf);
    ++counters_.dead_end_splits;
  }
}

void DomainMesher::remember(Cell leaf, std::optional<EdgeId> acute) {
  const Quadtree& tree = separation_.tree();
  learnt_.splits.push_back(
      {tree.corner(leaf), tree.side_bits(leaf), acute ? inputs_[*acute] : std::nullopt});
}

void DomainMesher::check_time() { deadline_.check_now(domain_.root().corner, 0); }

}  // namespace quadbound
