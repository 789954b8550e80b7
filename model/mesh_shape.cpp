// SPDX-License-Identifier: Apache-2.0
#include "model/mesh_shape.hpp"

#include <algorithm>
#include <utility>

#include "model/mesh_edges.hpp"
#include "model/quad_shape.hpp"

namespace quadbound {

Distribution::Distribution(std::vector<double> ends)
    : ends_(std::move(ends)), counts_(ends_.size() - 1) {}

void Distribution::add(double value) {
  smallest_ = count_ == 0 ? value : std::min(smallest_, value);
  largest_ = count_ == 0 ? value : std::max(largest_, value);
  sum_ += value;
  ++count_;
  const auto beyond = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, value);
  ++counts_[static_cast<std::size_t>(beyond - ends_.begin()) - 1];
}

MeshShape mesh_shape(const Mesh& mesh) {
  MeshShape shape{{},
                  Distribution({0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1}),
                  Distribution({1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 7, 10, 20})};
  std::vector<std::uint32_t> degrees(mesh.vertices.size());
  for_each_edge(mesh, [&degrees](const EdgeUse& edge) {
    ++degrees[edge.low];
    ++degrees[edge.high];
  });
  for (const std::uint32_t degree : degrees) ++shape.degrees[degree];
  for (const Quad& quad : mesh.quads) {
    const QuadShape of_quad = quad_shape(mesh.vertices, quad);
    shape.scaled_jacobian.add(of_quad.scaled_jacobian);
    shape.aspect_ratio.add(of_quad.aspect_ratio);
  }
  return shape;
}

}  // namespace quadbound
