// SPDX-License-Identifier: Apache-2.0
#pragma once
// The edges and the boundary of a mesh, for writers and pictures. Plain counting: no geometry but
// the order of the rings.

#include <cstdint>
#include <functional>
#include <vector>

#include "model/mesh.hpp"

namespace quadbound {

/// How often the faces run along an edge, from its lower vertex id to its higher one and back.
struct EdgeUse {
  VertexId low = kNoVertex;
  VertexId high = kNoVertex;
  std::uint32_t forward = 0;
  std::uint32_t backward = 0;
};

/// Calls visit once for each edge of the quads and the other faces.
///
/// Guarantees: 1. the calls come in the order of (low, high).
/// Requires: all ids are vertices of the mesh.
/// Complexity: linear in the corners of the faces while vertex degrees are bounded; 8 bytes for
/// each corner and for each vertex.
void for_each_edge(const Mesh& mesh, const std::function<void(const EdgeUse&)>& visit);

/// The boundary of the mesh: the closed walks along directed edges that no face runs back along,
/// with the mesh on the left.
///
/// Guarantees: 1. every unpaired directed edge lies in exactly one ring (as many times as it is
/// unpaired). 2. No ring visits a vertex twice: where rings touch at a vertex they are separated.
/// 3. A ring starts at its smallest vertex id. 4. The ring with the largest area (in doubles,
/// sign dropped) comes first; then by falling area, ties by the first vertex.
/// Complexity: that of for_each_edge, and sorting the boundary edges.
std::vector<std::vector<VertexId>> boundary_rings(const Mesh& mesh);

}  // namespace quadbound
