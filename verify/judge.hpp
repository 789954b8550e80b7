// SPDX-License-Identifier: Apache-2.0
#pragma once
// One judgement: collects facts first, then words them as claims. The claims that all theorems
// share are judged here; a theorem adds what it says of the boundary and of its input.

#include <optional>
#include <string>
#include <vector>

#include "verify/boundary.hpp"
#include "verify/links.hpp"
#include "verify/places.hpp"
#include "verify/survey.hpp"
#include "verify/verify.hpp"

namespace quadbound::judge {

/// What a theorem says in numbers and names.
struct Task {
  const char* theorem;
  const char* boundary_claim;  ///< one-boundary, boundary-kept
  const char* input_claim;     ///< points-kept; nullptr where the boundary is all of the input
  AngleInterval angles;
  std::uint64_t quads_per_cell;
  std::int64_t euler;  ///< vertices - edges + quads
};

/// Requires: fewer than 2^30 quads. Errors: std::length_error otherwise. References are kept.
class Judge {
 public:
  Judge(const Task& task, const Mesh& mesh, const VerifyOptions& options);
  virtual ~Judge() = default;
  Judge(const Judge&) = delete;
  Judge& operator=(const Judge&) = delete;

  /// Call it once.
  Report judge();

 protected:
  /// Where the corners are known: finds the input's vertices, and fills exempt_ in ascending order.
  virtual void look_at_input(const CornersByVertex& corners) = 0;
  /// Fills contacts_ if need be. Returns whether the boundary is as the proof in verify/tiling.md
  /// wants it.
  virtual bool look_at_boundary() = 0;
  virtual void judge_boundary() = 0;
  /// Twice the area that the quads should cover, in units of the lattice; nullopt where the mesh
  /// cannot tell. Where look_at_boundary said yes, that within the unpaired edges.
  [[nodiscard]] virtual std::optional<Rational> doubled_enclosed_area() const = 0;
  virtual void judge_input(const CornersByVertex& corners) = 0;

  Claim& add(std::string id, Verdict verdict);
  Claim& add(std::string id, bool holds) {
    return add(std::move(id), holds ? Verdict::holds : Verdict::fails);
  }
  [[nodiscard]] Place place_of_vertex(VertexId v) const;
  [[nodiscard]] Place place_of_quad(std::uint64_t quad) const;
  [[nodiscard]] Place place_of_corner(CornerId id) const;
  [[nodiscard]] Place place_of_edge(const DirectedEdge& edge) const {
    return place_of_corner({edge.corner / 4, static_cast<int>(edge.corner % 4)});
  }
  /// The corner in the input's units.
  template <class Plane>
  [[nodiscard]] JudgedCorner judged(const Plane& plane, CornerId id) const {
    const Quad& quad = mesh_.quads[id.quad];
    const auto i = static_cast<std::size_t>(id.corner);
    const auto corner =
        corner_at<Rational>(plane.rational(quad[i]), plane.rational(quad[(i + 1) % 4]),
                            plane.rational(quad[(i + 3) % 4]));
    const Rational unit = dyadic(1, mesh_.vertices.exponent());
    return {place_of_corner(id), corner.cross * unit * unit, corner.dot * unit * unit};
  }
  void describe_crossing(Claim& claim) const;

  const Task task_;
  const Mesh& mesh_;
  const AngleInterval angles_;
  const Threads threads_;
  const ExactPlane plane_;
  std::vector<CornerId> exempt_;
  Links links_;
  Loops loops_;
  Contacts contacts_;
  Report report_;

 private:
  bool judge_all_quad();
  void judge_mesh();
  void count();
  [[nodiscard]] bool is_locally_sound() const { return survey_.not_convex == 0 && !links_.doubled; }
  /// The conditions of the proof in verify/tiling.md.
  [[nodiscard]] bool is_proved_tiling() const {
    return is_locally_sound() && !links_.winding && !links_.second_fan && has_sound_boundary_;
  }
  void survey(const CornersByVertex& corners, std::vector<std::uint8_t>& passes);
  void judge_distinct_vertices(const CornersByVertex& corners);
  void judge_conforming();
  void judge_strictly_convex();
  void judge_no_overlap();
  void refute_overlap();
  void judge_euler();
  void judge_area();
  [[nodiscard]] Rational doubled_quad_area(const Rational& enclosed) const;
  void judge_angle(std::string id, BoundTally Survey::*end, Arctangent bound, bool is_upper);
  void judge_stored_angle(StoredBound& stored, const BoundTally& tally, Arctangent bound,
                          bool is_upper) const;
  void judge_size();
  void judge_theorem();

  const VerifyOptions& options_;
  const StoredPlane stored_plane_;
  Survey survey_;
  std::optional<Survey> stored_survey_;  ///< only where rounding moves a vertex
  std::optional<VertexId> infinite_vertex_;
  bool has_sound_boundary_ = false;
};

}  // namespace quadbound::judge
