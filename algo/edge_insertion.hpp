// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 3.2: the strip between a chain alpha and the edges of the domain, by a dynamic program
// along the whole chain: pieces that each keep the bounds are joined at feet.
//
// The paper goes edge by edge and corner by corner (Lemmas 11 and 12); paper/departures.md says
// where that fails.

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "algo/construction.hpp"
#include "algo/cut_quads.hpp"
#include "algo/domain.hpp"
#include "algo/tree_mesh.hpp"

namespace quadbound {

/// A corner of a quad of the strip.
struct StripVertex {
  enum class Kind : std::uint8_t { kMesh, kSite, kFoot, kSteiner };
  Kind kind = Kind::kMesh;
  std::uint32_t id = 0;   ///< vertex of Q; of the domain; edge of the domain; index into steiner
  std::int64_t foot = 0;  ///< of kFoot
};

struct StripQuad {
  std::array<StripVertex, 4> corners;
  StripConstruction construction;
};

struct InsertionCounters {
  std::array<std::uint64_t, 4> alpha_vertices_by_level{};  ///< widening level they ended at
  std::uint64_t other_cuts = 0;  ///< chains that were cut open at another place than the first
  std::uint64_t moves = 0;       ///< centres aligned with a corner (Lemma 12, Case 3)
  std::uint64_t moves_refused = 0;
  std::uint64_t moves_undone = 0;  ///< as they led to a dead end
};

struct Strip {
  std::vector<StripQuad> quads;
  std::vector<LatticePoint> steiner;
};

/// Vertices of alpha where no piece leads on.
struct DeadEnd {
  std::vector<VertexId> near;
};

/// Meshes the strip along one chain.
///
/// Guarantees: 1. every quad has a slack above kSmallestSlack. 2. feet on an edge and quads along
/// it are in its order. 3. of all ways to put the candidates together one with the largest smallest
/// slack (as far as three degrees) and the fewest quads is taken.
/// Complexity: linear in the chain.
std::variant<Strip, DeadEnd> insert_edges(const Domain& domain, const TreeMesh& tree_mesh,
                                          const CutQuads& cut_quads,
                                          std::span<const VertexId> alpha,
                                          InsertionCounters& counters);

/// Whether a point lies strictly between the two edges at a vertex of the domain, on the inside.
bool in_wedge(const Domain& domain, EdgeId site, LatticePoint point);

}  // namespace quadbound
