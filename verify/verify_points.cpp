// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "verify/judge.hpp"

namespace quadbound {
namespace {

using namespace judge;

const Task kTask{"thm-1", "one-boundary", "points-kept", kTheorem1, 3, 1};

class PointsJudge final : public Judge {
 public:
  PointsJudge(const PointSet& points, const Mesh& mesh, const VerifyOptions& options)
      : Judge(kTask, mesh, options), points_(points) {
    report_.input_points = points.points.size();
  }

 private:
  void look_at_input(const CornersByVertex&) override {}

  bool look_at_boundary() override {
    contacts_ = find_contacts(plane_, links_.unpaired);
    outermost_ = find_outermost(plane_, loops_);
    return has_one_boundary();
  }
  [[nodiscard]] bool has_one_boundary() const {
    return !loops_.branching && loops_.loops.size() == 1 && !contacts_.any();
  }

  void judge_boundary() override {
    Claim& claim = add("one-boundary", has_one_boundary());
    if (loops_.branching) {
      claim.detail = fmt::format("unpaired edges branch at vertex {}", *loops_.branching);
      claim.place = place_of_vertex(*loops_.branching);
    } else if (loops_.loops.size() != 1) {
      claim.detail = fmt::format("the unpaired edges form {} closed loops", loops_.loops.size());
      if (!outermost_) return;
      const std::size_t inner = outermost_->loop == 0 ? 1 : 0;
      claim.detail +=
          fmt::format("; one that is not the outermost has {} edges", loops_.loops[inner].edges);
      claim.place = place_of_vertex(loops_.loops[inner].first);
    } else if (contacts_.any()) {
      describe_contact(claim);
    }
  }

  void describe_contact(Claim& claim) const {
    if (contacts_.coincident) {
      claim.detail = fmt::format("the boundary meets itself: vertices {} and {} are at one place",
                                 contacts_.coincident->first, contacts_.coincident->second);
      claim.place = place_of_vertex(contacts_.coincident->second);
    } else if (contacts_.hanging) {
      const DirectedEdge& edge = links_.unpaired[contacts_.hanging->edge];
      claim.detail =
          fmt::format("the boundary meets itself: vertex {} lies inside the edge {} -> {}",
                      contacts_.hanging->vertex, edge.from, edge.to);
      claim.place = place_of_vertex(contacts_.hanging->vertex);
    } else {
      describe_crossing(claim);
    }
  }

  [[nodiscard]] std::optional<Rational> doubled_enclosed_area() const override {
    if (!outermost_) return std::nullopt;
    return outermost_->doubled_area;
  }

  void judge_input(const CornersByVertex& corners) override {
    const LostPoints lost =
        find_lost_points(plane_, mesh_.vertices.exponent(), corners, points_.points, threads_);
    Claim& claim = add("points-kept", lost.count == 0);
    if (lost.count == 0) return;
    const Point& point = points_.points[lost.first];
    claim.detail = fmt::format("{} input points are no vertex; the first is point {} at ({}, {})",
                               lost.count, lost.first, point.x, point.y);
  }

  const PointSet& points_;
  std::optional<Outermost> outermost_;
};

}  // namespace

Report verify_points(const PointSet& points, const Mesh& mesh, const VerifyOptions& options) {
  return PointsJudge(points, mesh, options).judge();
}

}  // namespace quadbound
