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

Rational doubled_area(const Ring& ring) {
  Rational sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const RationalPoint a = exact_value(ring[i]);
    const RationalPoint b = exact_value(ring[(i + 1) % ring.size()]);
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

bool is_smaller_angle(const JudgedCorner& a, const JudgedCorner& b) {
  return is_smaller(Corner<Rational>{a.cross, a.dot}, Corner<Rational>{b.cross, b.dot});
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
    for (const CornerId id : exempt_) {
      JudgedCorner corner = judged(plane_, id);
      if (!within(Corner<Rational>{corner.cross, corner.dot}, angles_)) ++facts.whole_beyond_bounds;
      if (!facts.largest_whole || is_smaller_angle(*facts.largest_whole, corner))
        facts.largest_whole = corner;
      if (!facts.smallest_whole || is_smaller_angle(corner, *facts.smallest_whole))
        facts.smallest_whole = std::move(corner);
    }
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

  [[nodiscard]] std::optional<Rational> enclosed_area() const override {
    Rational sum = 0;
    for (const Ring& ring : polygon_.rings) sum += doubled_area(ring);
    return Rational(sum / 2);
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
