// SPDX-License-Identifier: Apache-2.0
#include "algo/kite_draft.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "model/angle.hpp"

namespace quadbound::filling {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

}  // namespace

FinePoint fine_point(const RationalPoint& point, int exponent) {
  const Rational unit = dyadic(1, exponent);
  const auto split = [&](const Rational& value) {
    const LatticeFloor floor = *lattice_floor(value, exponent);
    const double fraction =
        floor.exact ? 0.0 : nearest_double(Rational(value / unit - Rational(floor.floor)));
    return std::pair(floor.floor, fraction);
  };
  const auto [x, x_fraction] = split(point.x);
  const auto [y, y_fraction] = split(point.y);
  return {{x, y}, {x_fraction, y_fraction}};
}

QuadsAt::QuadsAt(const Mesh& mesh, std::span<const VertexId> vertices)
    : slot_(mesh.vertices.size(), kNone) {
  for (const VertexId v : vertices) {
    if (slot_[v] != kNone) continue;
    slot_[v] = static_cast<std::uint32_t>(quads_.size());
    quads_.emplace_back();
  }
  for (std::uint32_t id = 0; id < mesh.quads.size(); ++id) {
    for (const VertexId v : mesh.quads[id])
      if (slot_[v] != kNone) quads_[slot_[v]].push_back(id);
  }
}

VertexId Draft::add(Place place) {
  added_.push_back(std::move(place));
  return static_cast<VertexId>(mesh_.vertices.size() + added_.size() - 1);
}

void Draft::move(VertexId vertex, Place place, std::span<const std::uint32_t> quads) {
  moved_.emplace_back(vertex, std::move(place));
  for (const std::uint32_t id : quads)
    if (std::find(changed_.begin(), changed_.end(), id) == changed_.end()) changed_.push_back(id);
}

FinePoint Draft::at(VertexId vertex) const {
  if (const Place* place = find(vertex)) return place->at;
  if (mesh_.vertices.on_lattice(vertex)) return on_lattice(mesh_.vertices.lattice(vertex));
  return fine_point(mesh_.vertices.exact(vertex), mesh_.vertices.exponent());
}

bool Draft::is_within_bounds(VertexId tip) const {
  return std::all_of(quads_.begin(), quads_.end(),
                     [&](const auto& quad) { return is_within(quad.first, tip); }) &&
         std::all_of(changed_.begin(), changed_.end(),
                     [&](std::uint32_t id) { return is_within(mesh_.quads[id], tip); });
}

bool Draft::is_within(const Quad& quad, VertexId tip) const {
  std::array<RationalPoint, 4> at;
  for (unsigned k = 0; k < 4; ++k) at[k] = exact(quad[k]);
  for (unsigned k = 0; k < 4; ++k) {
    if (quad[k] == tip) continue;
    if (!within(corner_at<Rational>(at[k], at[(k + 1) & 3U], at[(k + 3) & 3U]), kTheorem13))
      return false;
  }
  return true;
}

void Draft::carry_out(Mesh& mesh, std::uint8_t level) && {
  for (const Place& place : added_) mesh.vertices.add_exact(place.exact);
  for (const auto& [vertex, place] : moved_) mesh.vertices.move_to_exact(vertex, place.exact);
  const bool has_construction = !mesh.construction.empty();
  const bool has_level = !mesh.level.empty();
  for (const auto& [quad, construction] : quads_) {
    mesh.quads.push_back(quad);
    if (has_construction) mesh.construction.push_back(number_of(construction));
    if (has_level) mesh.level.push_back(level);
  }
}

const Place* Draft::find(VertexId vertex) const {
  if (vertex >= mesh_.vertices.size()) return &added_[vertex - mesh_.vertices.size()];
  const auto found = std::find_if(moved_.begin(), moved_.end(),
                                  [&](const auto& move) { return move.first == vertex; });
  return found == moved_.end() ? nullptr : &found->second;
}

RationalPoint Draft::exact(VertexId vertex) const {
  const Place* place = find(vertex);
  return place != nullptr ? place->exact : mesh_.vertices.exact(vertex);
}

}  // namespace quadbound::filling
