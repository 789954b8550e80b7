// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 4: what filling the kites tries before the mesh changes. Internal to kite_filling.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "algo/construction.hpp"
#include "algo/fine_point.hpp"
#include "model/mesh.hpp"

namespace quadbound::filling {

/// A place for a vertex, for the search and exactly.
struct Place {
  FinePoint at;
  RationalPoint exact;
};

FinePoint fine_point(const RationalPoint& point, int exponent);

/// Which quads some vertices belong to.
class QuadsAt {
 public:
  QuadsAt(const Mesh& mesh, std::span<const VertexId> vertices);

  /// Requires: one of the vertices.
  [[nodiscard]] std::span<const std::uint32_t> at(VertexId vertex) const {
    return quads_[slot_[vertex]];
  }

 private:
  std::vector<std::uint32_t> slot_;
  std::vector<std::vector<std::uint32_t>> quads_;
};

/// New vertices and quads, and moves of old vertices, that are tried before the mesh changes.
class Draft {
 public:
  explicit Draft(const Mesh& mesh) : mesh_(mesh) {}

  VertexId add(Place place);
  void move(VertexId vertex, Place place, std::span<const std::uint32_t> quads);
  void add_quad(const Quad& quad, StripConstruction construction) {
    quads_.emplace_back(quad, construction);
  }

  [[nodiscard]] FinePoint at(VertexId vertex) const;
  [[nodiscard]] Vector between(VertexId from, VertexId to) const { return at(to) - at(from); }

  /// All quads that are new or have moved, but for the angle at the tip. Exact.
  [[nodiscard]] bool is_within_bounds(VertexId tip) const;
  [[nodiscard]] bool is_within(const Quad& quad, VertexId tip) const;

  void carry_out(Mesh& mesh, std::uint8_t level) &&;

 private:
  [[nodiscard]] const Place* find(VertexId vertex) const;
  [[nodiscard]] RationalPoint exact(VertexId vertex) const;

  const Mesh& mesh_;
  std::vector<Place> added_;
  std::vector<std::pair<VertexId, Place>> moved_;  ///< a few
  std::vector<std::uint32_t> changed_;
  std::vector<std::pair<Quad, StripConstruction>> quads_;
};

}  // namespace quadbound::filling
