// SPDX-License-Identifier: Apache-2.0
#pragma once
// A mesh of a domain before its kites are filled.

#include <vector>

#include "algo/domain.hpp"
#include "model/mesh.hpp"

namespace quadbound {

struct DomainMesh {
  Mesh mesh;
  std::vector<VertexId> vertex_of;             ///< by vertex of the domain
  std::vector<std::vector<VertexId>> steiner;  ///< by edge of the domain, from its start to its end
};

}  // namespace quadbound
