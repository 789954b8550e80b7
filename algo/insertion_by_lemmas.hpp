// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sections 3.1 to 3.3 as the paper has them: edge by edge along the chains beta and alpha (Lemma
// 11), corner by corner (Lemma 12). No case is repaired beyond what paper/departures.md says of the
// chains themselves; what comes out may break the bounds, and the judge says so.

#include <array>
#include <cstdint>
#include <string_view>
#include <variant>

#include "algo/cut_quads.hpp"
#include "algo/domain.hpp"
#include "algo/edge_insertion.hpp"
#include "algo/kept_quads.hpp"
#include "algo/tree_mesh.hpp"

namespace quadbound {

struct LemmaCounters {
  std::array<std::uint64_t, 5> strips{};   ///< polygons A_i, by the edges of alpha_i
  std::array<std::uint64_t, 4> corners{};  ///< polygons P_v, by the case; 0 where E has no edge
  std::uint64_t replaced_chains = 0;       ///< alpha_i ran under c_i c_(i+1)
  std::uint64_t moved_feet = 0;
  std::uint64_t strips_without_case = 0;   ///< A_i that the paper says nothing of
  std::uint64_t corners_without_case = 0;  ///< P_v likewise
  std::uint64_t strips_outside = 0;        ///< A_i that no piece keeps within the bounds
  std::uint64_t corners_outside = 0;       ///< P_v likewise
  std::uint64_t kites_outside = 0;         ///< kites, of Section 4
};

/// The first place where the paper has no case.
struct LemmaFault {
  std::string_view claim;  ///< its id
  std::string_view what;
  LatticePoint where;
};

/// Meshes the strips along all edges and the polygons around all vertices.
///
/// Guarantees: 1. quads of K below the chains that replace alpha_i are taken out of `kept`. 2. the
/// centres that Lemma 12 aligns are moved. 3. of the ways that a case leaves open one with the
/// largest slack is taken; whether it keeps the bounds is counted, and is no condition. 4. All
/// places without a case are counted, also behind the first. Complexity: n log n in the quads that
/// edges cut.
std::variant<Strip, LemmaFault> insert_by_lemmas(const Domain& domain, TreeMesh& tree_mesh,
                                                 const CutQuads& cut_quads, KeptQuads& kept,
                                                 LemmaCounters& counters);

}  // namespace quadbound
