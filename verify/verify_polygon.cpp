// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "verify/judge.hpp"
#include "verify/polygon_boundary.hpp"

namespace quadbound {
namespace {

using namespace judge;

Task task_for(const Polygon& polygon) {
  return {"thm-13", "boundary-kept",
          nullptr,  kTheorem13,
          5,        2 - static_cast<std::int64_t>(polygon.rings.size())};
}

/// The vertices of a ring where they are on a lattice of that exponent.
std::optional<std::vector<LatticePoint>> on_lattice(const Ring& ring, int exponent) {
  std::vector<LatticePoint> points;
  for (const Point& point : ring) {
    const auto x = lattice_floor(point.x, exponent);
    const auto y = lattice_floor(point.y, exponent);
    if (!x || !y || !x->exact || !y->exact) return std::nullopt;
    points.push_back({x->floor, y->floor});
  }
  return points;
}

template <class PointType>
void add_doubled_area(const std::vector<PointType>& ring, WideSum& sum) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum.add(cross_product(ring[i], ring[(i + 1) % ring.size()]));
}

class PolygonJudge final : public Judge {
 public:
  PolygonJudge(const Polygon& polygon, const Mesh& mesh, const VerifyOptions& options)
      : Judge(task_for(polygon), mesh, options), polygon_(polygon), rings_(polygon) {
    report_.input_points = rings_.points.size();
    report_.polygon.emplace().rings = polygon.rings.size();
  }

 private:
  void look_at_input(const CornersByVertex& corners) override {
    placed_ =
        find_placed_vertices(plane_, mesh_.vertices.exponent(), corners, rings_.points, threads_);
    for (const PlacedVertex& placed : placed_) {
      const auto at = corners.at(placed.vertex);
      if (at.size() == 1) {
        exempt_.push_back({at[0] / 4, static_cast<int>(at[0] % 4)});
      } else {
        report_.polygon->split_corners += at.size();
      }
    }
    std::sort(exempt_.begin(), exempt_.end());
    list_whole_corners();
  }

  void list_whole_corners() {
    PolygonFacts& facts = *report_.polygon;
    facts.whole_corners = exempt_.size();
    const Survey survey = survey_corners(plane_, mesh_.quads, angles_, exempt_);
    facts.whole_beyond_bounds = survey.smallest.broken + survey.largest.broken;
    const auto& smallest = survey.smallest.extreme;
    const auto& largest = survey.largest.extreme;
    if (smallest) facts.smallest_whole = judged(plane_, smallest->id);
    if (largest) facts.largest_whole = judged(plane_, largest->id);
  }

  /// The rings of a valid polygon neither meet nor cross, so that only a boundary that departs from
  /// them needs the search for contacts.
  bool look_at_boundary() override {
    RingWalk walk = walk_rings(plane_, links_.unpaired, rings_, placed_);
    departure_ = walk.departure;
    if (departure_) {
      contacts_ = find_contacts(plane_, links_.unpaired);
    } else {
      report_.polygon->steiner = walk.steiner;
    }
    return !departure_;
  }

  void judge_boundary() override {
    Claim& claim = add("boundary-kept", !departure_);
    if (!departure_) return;
    claim.detail = describe(*departure_);
    if (departure_->vertex != kNoVertex) claim.place = place_of_vertex(departure_->vertex);
  }

  [[nodiscard]] std::string describe(const Departure& departure) const {
    switch (departure.kind) {
      case Departure::Kind::branching:
        return fmt::format("unpaired edges branch at vertex {}", departure.vertex);
      case Departure::Kind::ring_lost:
        return fmt::format("ring {} has no loop{}", departure.ring,
                           departure.ring == 0 ? "" : ": the hole is filled");
      case Departure::Kind::vertex_lost:
        return fmt::format("vertex {} of ring {} is no boundary vertex of the mesh: {}",
                           departure.ring_vertex, departure.ring,
                           text_of_ring_vertex(departure.ring, departure.ring_vertex));
      case Departure::Kind::off_edge:
        return fmt::format("vertex {} is off {}", departure.vertex, text_of_edge(departure));
      case Departure::Kind::passed:
        return fmt::format("vertex {} is not between its neighbours on {}", departure.vertex,
                           text_of_edge(departure));
      case Departure::Kind::stray_loop:
        break;
    }
    return fmt::format("the loop through vertex {} belongs to no ring", departure.vertex);
  }

  [[nodiscard]] std::string text_of_ring_vertex(std::size_t ring, std::size_t vertex) const {
    const Point& point = polygon_.rings[ring][vertex % polygon_.rings[ring].size()];
    return fmt::format("({}, {})", point.x, point.y);
  }
  [[nodiscard]] std::string text_of_edge(const Departure& departure) const {
    return fmt::format("edge {} of ring {}, {} to {}", departure.ring_vertex, departure.ring,
                       text_of_ring_vertex(departure.ring, departure.ring_vertex),
                       text_of_ring_vertex(departure.ring, departure.ring_vertex + 1));
  }

  [[nodiscard]] std::optional<Rational> doubled_enclosed_area() const override {
    const int exponent = mesh_.vertices.exponent();
    const Rational unit = dyadic(1, -exponent);
    WideSum sum;
    for (const Ring& ring : polygon_.rings) {
      if (const auto lattice = on_lattice(ring, exponent)) {
        add_doubled_area(*lattice, sum);
      } else {
        std::vector<RationalPoint> exact;
        for (const Point& p : ring)
          exact.push_back({exact_value(p.x) * unit, exact_value(p.y) * unit});
        add_doubled_area(exact, sum);
      }
    }
    return sum.value();
  }

  void judge_input(const CornersByVertex&) override {}

  const Polygon& polygon_;
  const RingVertices rings_;
  std::vector<PlacedVertex> placed_;
  std::optional<Departure> departure_;
};

}  // namespace

Report verify_polygon(const Polygon& polygon, const Mesh& mesh, const VerifyOptions& options) {
  return PolygonJudge(polygon, mesh, options).judge();
}

}  // namespace quadbound
