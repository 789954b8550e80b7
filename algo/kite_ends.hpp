// SPDX-License-Identifier: Apache-2.0
#pragma once
// Section 4: where v_k, which would have an angle of 180 degrees, and p go at the end of one side
// of a kite. Internal to kite_filling.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algo/domain.hpp"
#include "algo/kite_draft.hpp"

namespace quadbound::filling {

/// What the search asks of a quad: far above the rounding of quad_slack (about 2^-46), so that the
/// exact test that follows agrees, and too little to be seen.
inline constexpr double kSmallestSlack = 1e-9;
/// Where the search for v_k stops: the sine of one degree. In the tightest corner that B may have
/// at p, arctan(1/2) beside the side, the best place leaves about two.
inline constexpr double kGoodSlack = 0.01745;

/// An edge of the polygon at the tip, as an edge of the domain on the same line.
class EdgeLine {
 public:
  EdgeLine(const Domain& domain, EdgeId e) : domain_(&domain), edge_(e) {}

  /// Number of the point of the line near origin + offset, see Domain::foot.
  [[nodiscard]] std::int64_t foot_near(const FinePoint& origin, Vector offset) const {
    const LatticePoint near = nearest_lattice_point(origin, offset);
    return domain_->runs_in_x(edge_) ? near.x : near.y;
  }
  /// From a point of the line to a foot. `along` is any direction along the line.
  [[nodiscard]] Vector offset_to(std::int64_t foot, const FinePoint& origin, Vector along) const {
    const bool x = domain_->runs_in_x(edge_);
    const double distance = x ? static_cast<double>(foot - origin.floor.x) - origin.fraction.x
                              : static_cast<double>(foot - origin.floor.y) - origin.fraction.y;
    return distance / (x ? along.x : along.y) * along;
  }
  [[nodiscard]] Place place(std::int64_t foot) const {
    return {domain_->foot_point(edge_, foot), domain_->foot_exact(edge_, foot)};
  }

 private:
  const Domain* domain_;
  EdgeId edge_;
};

/// One half of a kite, named as the half at p.
struct Side {
  EdgeLine line;
  std::vector<VertexId> chain;  ///< v, v_1, ..., v_k, p
  bool mirrored;                ///< the half at q
  VertexId first_step;          ///< p_1; p where nothing is between v and p
  FinePoint foot;               ///< p where it was

  [[nodiscard]] std::size_t steps() const { return chain.size() - 2; }
  [[nodiscard]] VertexId end() const { return chain.back(); }
};

/// Searches a place for v_k, which would have an angle of 180 degrees, and for p.
class EndSearch {
 public:
  EndSearch(const Draft& draft, const Mesh& mesh, const QuadsAt& quads, const Side& side,
            const Quad& last, VertexId tip);

  struct Result {
    double slack = -1;
    LatticePoint moving;
    std::optional<std::int64_t> foot;  ///< where p goes; nullopt where it stays
  };

  [[nodiscard]] Result along_edges() const;
  /// A pattern search from several places; `best` is where to begin.
  [[nodiscard]] Result in_plane(Result best) const;

 private:
  struct LocalQuad {
    std::array<Vector, 4> at;  ///< from v_k where it is now
    int moving = -1;           ///< the corner that is v_k, that is p
    int end = -1;
  };
  /// From where they are: v_k in the plane, p towards the tip.
  struct Move {
    Vector moving;
    double slide;
  };

  void add(const Draft& draft, const Quad& quad);
  [[nodiscard]] bool is_on_side(Vector neighbour) const;
  [[nodiscard]] Result evaluate(const Move& move) const;
  [[nodiscard]] Result climb(Move here, double scale) const;
  bool climb_once(Move& here, double step, Result& best) const;

  EdgeLine line_;
  VertexId moving_;
  VertexId end_;
  FinePoint origin_;
  FinePoint end_at_;
  Vector to_tip_;    ///< unit vector from p to the tip
  Vector previous_;  ///< from v_k to v_{k-1}
  std::vector<LocalQuad> quads_;
};

/// Moves v_k, p and the vertices of the inside around them in turn, each to where the worst of its
/// own quads is best. Needed where a vertex of B lies so close to v_k that v_k cannot move alone.
class Relaxation {
 public:
  Relaxation(const Draft& draft, const Mesh& mesh, const QuadsAt& quads,
             const std::vector<bool>& on_boundary, const Side& side, const Quad& last,
             VertexId tip);

  /// Whether it comes to an end with all quads within the bounds.
  bool run();

  [[nodiscard]] std::span<const VertexId> free() const { return free_; }
  [[nodiscard]] Vector offset(VertexId vertex) const { return at_[index(vertex)]; }
  [[nodiscard]] const FinePoint& origin() const { return origin_; }

 private:
  void add(const Draft& draft, const Quad& quad);
  [[nodiscard]] std::size_t index(VertexId vertex) const;
  Vector& position(VertexId vertex) { return at_[index(vertex)]; }
  [[nodiscard]] double slack(const std::array<std::size_t, 4>& quad) const;
  [[nodiscard]] double worst() const;
  [[nodiscard]] double worst_at(std::size_t local) const;
  [[nodiscard]] double reach(std::size_t local) const;
  void improve(VertexId vertex);
  bool step_once(std::size_t local, bool on_line, double step, double& best);

  FinePoint origin_;
  VertexId end_;
  Vector to_tip_;
  double scale_ = 0;
  std::vector<VertexId> free_;  ///< v_k, p, and others
  std::vector<VertexId> ids_;
  std::vector<Vector> at_;
  std::vector<std::array<std::size_t, 4>> quads_;
};

}  // namespace quadbound::filling
