// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a mesh looks like in numbers (Section 5 of the paper, Table 2): degrees of its vertices and
// the shapes of its quads. In doubles, for readers; never for a verdict.

#include <cstdint>
#include <map>
#include <vector>

#include "model/mesh.hpp"

namespace quadbound {

/// Values counted by classes: class i from ends[i] to ends[i + 1], its lower end included. The last
/// class has no upper end, the first one no lower end.
class Distribution {
 public:
  /// Requires: two ends at least, ascending.
  explicit Distribution(std::vector<double> ends);

  void add(double value);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// Requires (all three): count() > 0.
  [[nodiscard]] double smallest() const { return smallest_; }
  [[nodiscard]] double largest() const { return largest_; }
  [[nodiscard]] double mean() const { return sum_ / static_cast<double>(count_); }

  [[nodiscard]] const std::vector<double>& ends() const { return ends_; }
  /// By class.
  [[nodiscard]] const std::vector<std::uint64_t>& counts() const { return counts_; }

 private:
  std::vector<double> ends_;
  std::vector<std::uint64_t> counts_;
  double smallest_ = 0;
  double largest_ = 0;
  double sum_ = 0;
  std::uint64_t count_ = 0;
};

struct MeshShape {
  std::map<std::uint32_t, std::uint64_t> degrees;  ///< vertices by their number of edges
  Distribution scaled_jacobian;                    ///< of quads: model/quad_shape.hpp
  Distribution aspect_ratio;
};

/// Requires: the corners of quads are vertices of the mesh. Complexity: linear.
MeshShape mesh_shape(const Mesh& mesh);

}  // namespace quadbound
