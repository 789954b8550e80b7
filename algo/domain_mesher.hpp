// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sections 3 and 4 on one domain and one root square: rounds of separation and insertion on a tree
// that grows until both succeed.

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "algo/corner_alignment.hpp"
#include "algo/counters.hpp"
#include "algo/cut_quads.hpp"
#include "algo/domain.hpp"
#include "algo/domain_mesh.hpp"
#include "algo/edge_cells.hpp"
#include "algo/edge_insertion.hpp"
#include "algo/insertion_by_lemmas.hpp"
#include "algo/kept_quads.hpp"
#include "algo/kite_filling.hpp"
#include "algo/separation.hpp"
#include "algo/sizing.hpp"
#include "algo/tree_mesh.hpp"

namespace quadbound {

/// What Sections 3 and 4 did, beyond the counters of Section 2.
struct PolygonCounters {
  Counters quadtree;                    ///< of the last round
  std::uint64_t cells_before = 0;       ///< leaves before edge separation
  std::uint64_t rounds = 0;             ///< in which Q was made, of all attempts
  std::uint64_t local_rounds = 0;       ///< in which it was made around the last splits only
  std::uint64_t separation_splits = 0;  ///< leaves that edge separation named, some more than once
  std::uint64_t size_splits = 0;        ///< leaves that were too large for the sizing
  std::uint64_t dead_end_splits = 0;    ///< leaves split where no piece led on
  std::uint64_t kite_splits = 0;        ///< leaves split where a kite could not be filled
  std::uint64_t restarts = 0;           ///< attempts given up to cut more kites
  std::uint64_t other_roots = 0;        ///< root squares given up for dead ends
  std::uint64_t kites = 0;
  std::uint64_t kept_quads = 0;
  KiteCounters kite_filling;
  std::optional<LemmaCounters> lemmas;  ///< of EdgeInsertion::kLemmas
  InsertionCounters insertion;
};

/// Acute vertices that need a kite, as vertices of the input.
struct NeedsKites {
  std::vector<std::size_t> inputs;
};
/// The same dead ends come back at every level: another root square may do better.
struct NeedsOtherRoot {};

/// A leaf that was split.
struct Split {
  LatticePoint corner;
  int side_bits;
  std::optional<std::size_t> acute;  ///< for the two edges at this vertex of the input only
};

/// What attempts in one root square learnt, for the next one, which has more kites.
struct Learnt {
  explicit Learnt(std::size_t vertices) : trouble(vertices) {}
  /// Splits for which `condition` holds are undone.
  template <class Condition>
  void undo(const Condition& condition) {
    for (const Split& split : splits)
      if (condition(split)) suspects.push_back(split.corner);
    std::erase_if(splits, condition);
  }

  std::vector<Split> splits;  ///< that separated edges, in order
  /// Where the tree was at fault, and such splits do not tell: places to look at before the whole.
  std::vector<LatticePoint> suspects;
  std::vector<int> trouble;  ///< by vertex of the input: rounds in which it was blamed
};

/// By vertex of a domain the vertex of the input, where it is one.
using InputVertices = std::vector<std::optional<std::size_t>>;

/// How edges, corners and kites are meshed: by our search along the whole chain, or by the cases of
/// Lemmas 11 and 12 and Section 4 as written.
enum class EdgeInsertion : std::uint8_t { kSearch, kLemmas };

class DomainMesher {
 public:
  using Outcome = std::variant<DomainMesh, NeedsKites, NeedsOtherRoot, LemmaFault>;

  /// `is_last_root`: never ask for another one. `learnt` is what earlier attempts in the same root
  /// square learnt, and grows; no split of it is for a vertex that has a kite. All arguments but
  /// the budget must outlive it.
  DomainMesher(const Domain& domain, const InputVertices& inputs, const SizeField& sizes,
               const Budget& budget, bool is_last_root, Learnt& learnt, PolygonCounters& counters,
               EdgeInsertion insertion = EdgeInsertion::kSearch);

  /// Guarantees: 1. every quad of the mesh has thm-13's angles, but for whole input angles and the
  /// rounding that kSmallestSlack allows for; not so with kLemmas. 2. LemmaFault comes with kLemmas
  /// only, NeedsKites and NeedsOtherRoot with kSearch only. 3. NeedsKites names vertices that have
  /// no kite, one at least. Throws: TreeBudgetExceeded, with the place of the smallest cell where
  /// the cells ran out.
  Outcome run();

 private:
  Outcome run_rounds();
  /// Empty where cells were put on to_split_.
  std::optional<DomainMesh> round();
  void split_and_separate();
  std::optional<Window> split();
  void local_round(const Window& window);
  bool find_strips(TreeMesh& tree_mesh, KeptQuads& kept, std::vector<Strip>& strips);
  bool is_separated(const TreeMesh& tree_mesh, const CutQuads& cut_quads);
  bool is_fine_enough(const TreeMesh& tree_mesh, const CutQuads& cut_quads);
  bool has_one_alpha_for_each_ring(const TreeMesh& tree_mesh, const CutQuads& cut_quads,
                                   const KeptQuads& kept);
  [[nodiscard]] std::optional<std::uint32_t> ring_along(const CutQuads& cut_quads,
                                                        const std::vector<VertexId>& alpha) const;
  [[nodiscard]] std::vector<VertexId> leaps(const CutQuads& cut_quads,
                                            const std::vector<VertexId>& alpha) const;
  bool undo_alignment(TreeMesh& tree_mesh, const DeadEnd& dead);
  bool insert(TreeMesh& tree_mesh, const CutQuads& cut_quads, const KeptQuads& kept,
              std::vector<Strip>& strips);
  bool insert_lemmas(TreeMesh& tree_mesh, const CutQuads& cut_quads, KeptQuads& kept,
                     std::vector<Strip>& strips);
  bool fill(DomainMesh& made, const TreeMesh& tree_mesh);
  void split_pinched(const TreeMesh& tree_mesh, const std::vector<VertexId>& pinched,
                     bool separated);
  void split_around(const TreeMesh& tree_mesh, const std::vector<VertexId>& vertices);
  void blame_acute(const TreeMesh& tree_mesh, const CutQuads& cut_quads, VertexId vertex);
  void lose_patience();
  [[nodiscard]] bool is_hopeless(EdgeId acute) const;
  void repeat_splits();
  void separate_cells();
  void remember(Cell leaf, std::optional<EdgeId> acute);
  void check_time();

  const Domain& domain_;
  const InputVertices& inputs_;
  const SizeField& sizes_;
  Deadline deadline_;
  Separation separation_;
  bool is_last_root_;
  Learnt& learnt_;
  PolygonCounters& counters_;
  EdgeInsertion insertion_;
  std::optional<LemmaFault> fault_;
  /// Of the whole tree as it is, while they are needed.
  std::optional<EdgeCells> edge_cells_;
  std::vector<Cell> to_split_;
  std::vector<LatticePoint> suspects_;  ///< of this attempt, not looked at yet
  std::vector<AlignedCentre> aligned_;
  int dead_rounds_ = 0;
  std::vector<EdgeId> troubled_;       ///< acute vertices, this round
  std::vector<std::size_t> hopeless_;  ///< acute vertices that need a kite
};

}  // namespace quadbound
