// SPDX-License-Identifier: Apache-2.0
#include "verify/verify.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "verify/boundary.hpp"
#include "verify/links.hpp"
#include "verify/places.hpp"
#include "verify/survey.hpp"

namespace quadbound {
namespace {

using namespace judge;

/// One judgement: collects facts first, then words them as claims.
class Judge {
 public:
  Judge(const PointSet& points, const Mesh& mesh, const VerifyOptions& options)
      : points_(points),
        mesh_(mesh),
        options_(options),
        threads_(options.threads),
        plane_(mesh.vertices),
        stored_plane_(mesh.vertices) {
    if (mesh.quads.size() >= std::size_t{1} << 30)
      throw std::length_error("the judge takes fewer than 2^30 quads");
    report_.theorem = "thm-1";
    report_.quads = mesh.quads.size();
    report_.other_faces = mesh.other_faces.size();
    report_.cells = mesh.cells;
    report_.input_points = points.points.size();
  }

  Report judge() {
    if (judge_all_quad()) {
      judge_mesh();
    } else {
      for (const char* id :
           {"distinct-vertices", "conforming", "strictly-convex", "one-boundary", "no-overlap",
            "euler", "area", "points-kept", "min-angle", "max-angle"})
        add(id, Verdict::not_decided).detail = "the quads are malformed: see all-quad";
    }
    judge_size();
    judge_theorem();
    return std::move(report_);
  }

 private:
  Claim& add(std::string id, Verdict verdict) {
    Claim claim;
    claim.id = std::move(id);
    claim.exact = verdict;
    report_.claims.push_back(std::move(claim));
    return report_.claims.back();
  }
  Claim& add(std::string id, bool holds) {
    return add(std::move(id), holds ? Verdict::holds : Verdict::fails);
  }

  // --- places -----------------------------------------------------------------------------------

  [[nodiscard]] Place place_of_vertex(VertexId v) const {
    Place place;
    place.vertex = v;
    place.position = mesh_.vertices.exact(v);
    return place;
  }

  [[nodiscard]] Place place_of_quad(std::uint64_t quad) const {
    Place place;
    place.quad = quad;
    if (quad < mesh_.level.size()) place.level = mesh_.level[quad];
    if (quad < mesh_.construction.size() &&
        mesh_.construction[quad] < mesh_.construction_names.size())
      place.construction = mesh_.construction_names[mesh_.construction[quad]];
    return place;
  }

  [[nodiscard]] Place place_of_corner(CornerId id) const {
    Place place = place_of_quad(id.quad);
    const VertexId v = mesh_.quads[id.quad][static_cast<std::size_t>(id.corner)];
    place.corner = id.corner;
    place.vertex = v;
    place.position = mesh_.vertices.exact(v);
    return place;
  }

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

  // --- all-quad ---------------------------------------------------------------------------------

  /// nullopt where the quad is well-formed; otherwise what is wrong.
  [[nodiscard]] std::optional<std::string> defect(const Quad& quad) const {
    for (std::size_t i = 0; i < 4; ++i) {
      if (quad[i] >= mesh_.vertices.size())
        return fmt::format("vertex {} of quad does not exist", quad[i]);
      for (std::size_t j = 0; j < i; ++j)
        if (quad[i] == quad[j]) return fmt::format("quad has vertex {} twice", quad[i]);
    }
    return std::nullopt;
  }

  /// Returns whether there are quads and all are well-formed.
  bool judge_all_quad() {
    if (mesh_.quads.empty()) {
      add("all-quad", false).detail = "there are no quads";
      return false;
    }
    const auto size = mesh_.vertices.size();
    for (std::size_t q = 0; q < mesh_.quads.size(); ++q) {
      const auto& [a, b, c, d] = mesh_.quads[q];
      const bool differ = a != b && a != c && a != d && b != c && b != d && c != d;
      if (differ && a < size && b < size && c < size && d < size) continue;
      Claim& claim = add("all-quad", false);
      claim.detail = *defect(mesh_.quads[q]);
      claim.place = place_of_quad(q);
      return false;
    }
    Claim& claim = add("all-quad", mesh_.other_faces.empty());
    if (!mesh_.other_faces.empty())
      claim.detail = fmt::format("{} faces are no quads; the first has {} sides",
                                 mesh_.other_faces.size(), mesh_.other_faces.front().size());
    return true;
  }

  // --- the facts --------------------------------------------------------------------------------

  void judge_mesh() {
    std::vector<std::uint8_t> passes;
    survey_ = survey_quads(plane_, mesh_.quads, options_.angles, threads_, passes);
    report_.decisions = survey_.decisions;
    const CornersByVertex corners(mesh_.quads, mesh_.vertices.size(), threads_);
    links_ = link_corners(corners, passes, threads_);
    loops_ = trace_loops(plane_, links_.unpaired);
    contacts_ = find_contacts(plane_, links_.unpaired);
    count();
    judge_stored_coordinates(corners);
    judge_distinct_vertices(corners);
    judge_conforming();
    judge_strictly_convex();
    judge_one_boundary();
    judge_no_overlap();
    judge_euler();
    judge_area();
    judge_points_kept(corners);
    judge_angles();
  }

  void count() {
    report_.used_vertices = links_.used_vertices;
    report_.unused_vertices = mesh_.vertices.size() - links_.used_vertices;
    report_.boundary_edges = links_.unpaired.size();
    report_.boundary_loops = loops_.loops.size();
    // Paired edges come in twos.
    report_.edges = (links_.directed_edges + links_.unpaired.size()) / 2;
  }

  [[nodiscard]] bool has_one_boundary() const {
    return !loops_.branching && loops_.loops.size() == 1 && !contacts_.any();
  }
  [[nodiscard]] bool is_locally_sound() const { return survey_.not_convex == 0 && !links_.doubled; }
  /// The conditions of the proof in verify/tiling.md.
  [[nodiscard]] bool is_proved_tiling() const {
    return is_locally_sound() && !links_.winding && !links_.second_fan && has_one_boundary();
  }

  void judge_stored_coordinates(const CornersByVertex& corners) {
    report_.every_vertex_is_a_double = !find_rounded(stored_plane_, corners, threads_);
    if (report_.every_vertex_is_a_double) return;
    infinite_vertex_ = find_infinite(stored_plane_, corners);
    if (infinite_vertex_) return;
    std::vector<std::uint8_t> passes;
    stored_survey_ = survey_quads(stored_plane_, mesh_.quads, options_.angles, threads_, passes);
  }

  // --- tiling -----------------------------------------------------------------------------------

  void judge_distinct_vertices(const CornersByVertex& corners) {
    std::optional<CoincidentVertices> found;
    if (!is_proved_tiling() || options_.always_compare_positions)
      found = find_coincident(plane_, corners);
    Claim& claim = add("distinct-vertices", !found);
    if (!found) return;
    claim.detail = fmt::format("vertices {} and {} are at one place", found->first, found->second);
    claim.place = place_of_vertex(found->second);
  }

  void judge_conforming() {
    Claim& claim = add("conforming", !links_.doubled && !contacts_.hanging);
    if (links_.doubled) {
      const DirectedEdge& edge = links_.doubled->edge;
      claim.detail = fmt::format("directed edge {} -> {} belongs to quads {} and {}", edge.from,
                                 edge.to, edge.corner / 4, links_.doubled->other / 4);
      claim.place = place_of_edge(edge);
    } else if (contacts_.hanging) {
      const DirectedEdge& edge = links_.unpaired[contacts_.hanging->edge];
      claim.detail = fmt::format("hanging node: vertex {} lies inside the edge {} -> {} of quad {}",
                                 contacts_.hanging->vertex, edge.from, edge.to, edge.corner / 4);
      claim.place = place_of_vertex(contacts_.hanging->vertex);
    }
  }

  void judge_strictly_convex() {
    Claim& claim = add("strictly-convex", survey_.not_convex == 0);
    if (survey_.first_not_convex) {
      claim.detail = fmt::format("{} corners do not turn left", survey_.not_convex);
      claim.worst = judged(plane_, *survey_.first_not_convex);
    }
    claim.stored.emplace();
    if (infinite_vertex_) {
      claim.stored->verdict = StoredVerdict::fails;
    } else if (stored_survey_) {
      if (stored_survey_->not_convex == 0) return;
      claim.stored->verdict = StoredVerdict::fails;
      claim.stored->worst = judged(stored_plane_, *stored_survey_->first_not_convex);
    } else if (survey_.not_convex != 0) {
      claim.stored->verdict = StoredVerdict::fails;
    }
  }

  void judge_one_boundary() {
    Claim& claim = add("one-boundary", has_one_boundary());
    if (loops_.branching) {
      claim.detail = fmt::format("unpaired edges branch at vertex {}", *loops_.branching);
      claim.place = place_of_vertex(*loops_.branching);
    } else if (loops_.loops.size() != 1) {
      claim.detail = fmt::format("the unpaired edges form {} closed loops", loops_.loops.size());
      if (loops_.loops.empty()) return;
      const std::size_t inner = loops_.outermost() == 0 ? 1 : 0;
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

  void describe_crossing(Claim& claim) const {
    const DirectedEdge& first = links_.unpaired[contacts_.crossing->first];
    const DirectedEdge& second = links_.unpaired[contacts_.crossing->second];
    claim.detail = fmt::format("the unpaired edges {} -> {} and {} -> {} cross", first.from,
                               first.to, second.from, second.to);
    claim.place = place_of_edge(first);
  }

  void judge_no_overlap() {
    if (is_proved_tiling()) {
      add("no-overlap", true);
    } else if (!is_locally_sound()) {
      add("no-overlap", Verdict::not_decided).detail =
          links_.doubled ? "edges are doubled: see conforming"
                         : "quads are not convex: see strictly-convex";
    } else if (links_.winding) {
      Claim& claim = add("no-overlap", false);
      claim.detail = fmt::format("the quads around vertex {} make {} turns", links_.winding->vertex,
                                 links_.winding->turns);
      claim.place = place_of_vertex(links_.winding->vertex);
    } else if (links_.second_fan) {
      Claim& claim = add("no-overlap", false);
      claim.detail = fmt::format("the boundary vertex {} is inside of other quads as well",
                                 *links_.second_fan);
      claim.place = place_of_vertex(*links_.second_fan);
    } else if (contacts_.crossing) {
      describe_crossing(add("no-overlap", false));
    } else {
      add("no-overlap", Verdict::not_decided).detail =
          "there is no simple boundary: see one-boundary";
    }
  }

  void judge_euler() {
    const auto vertices = static_cast<std::int64_t>(report_.used_vertices);
    const auto edges = static_cast<std::int64_t>(report_.edges);
    const std::int64_t euler = vertices - edges + static_cast<std::int64_t>(report_.quads);
    Claim& claim = add("euler", euler == 1);
    claim.values = {{"vertices - edges + quads", Rational(euler)}};
    if (euler != 1) claim.detail = fmt::format("vertices - edges + quads = {}, not 1", euler);
  }

  void judge_area() {
    if (loops_.branching || loops_.loops.empty()) {
      add("area", Verdict::not_decided).detail = "there is no outermost loop: see one-boundary";
      return;
    }
    const Rational unit = dyadic(1, mesh_.vertices.exponent());
    const Rational quads = survey_.doubled_area.value() * unit * unit / 2;
    const Rational loop = loops_.loops[loops_.outermost()].doubled_area * unit * unit / 2;
    Claim& claim = add("area", quads == loop);
    claim.values = {{"quads", quads}, {"within the boundary", loop}};
    if (quads != loop)
      claim.detail = fmt::format("quads cover {}, the boundary encloses {}", nearest_double(quads),
                                 nearest_double(loop));
  }

  // --- the theorem's own claims -----------------------------------------------------------------

  void judge_points_kept(const CornersByVertex& corners) {
    const LostPoints lost =
        find_lost_points(plane_, mesh_.vertices.exponent(), corners, points_.points, threads_);
    Claim& claim = add("points-kept", lost.count == 0);
    if (lost.count == 0) return;
    const Point& point = points_.points[lost.first];
    claim.detail = fmt::format("{} input points are no vertex; the first is point {} at ({}, {})",
                               lost.count, lost.first, point.x, point.y);
  }

  void judge_angles() {
    judge_angle("min-angle", &Survey::smallest, options_.angles.smallest, false);
    judge_angle("max-angle", &Survey::largest, options_.angles.from_straight, true);
  }

  void judge_angle(std::string id, BoundTally Survey::*end, Arctangent bound, bool is_upper) {
    const BoundTally& exact = survey_.*end;
    Claim& claim = add(std::move(id), exact.broken == 0);
    if (exact.broken != 0)
      claim.detail = fmt::format("{} corners are beyond the bound", exact.broken);
    claim.worst = judged(plane_, exact.extreme->id);
    const Rational tangent(bound.numerator, bound.denominator);
    claim.values = {{"tan of the bound", is_upper ? Rational(-tangent) : tangent}};
    claim.stored.emplace();
    if (infinite_vertex_) {
      claim.stored->verdict = StoredVerdict::fails;
    } else if (stored_survey_) {
      judge_stored_angle(*claim.stored, *stored_survey_.*end, bound, is_upper);
    } else if (exact.broken != 0) {
      // Nothing was rounded, so nothing is explained by rounding.
      measure_excess(*claim.stored, *claim.worst, bound, is_upper);
      claim.stored->verdict = StoredVerdict::fails;
    }
  }

  void judge_stored_angle(StoredBound& stored, const BoundTally& tally, Arctangent bound,
                          bool is_upper) const {
    const CornerId id = tally.extreme->id;
    stored.worst = judged(stored_plane_, id);
    if (tally.broken == 0) return;
    stored.verdict = tally.beyond_slack ? StoredVerdict::fails : StoredVerdict::within_rounding;
    measure_excess(stored, *stored.worst, bound, is_upper);
    const CornerScale scale = corner_scale(stored_plane_, mesh_.quads[id.quad], id.corner);
    if (scale.shorter_edge_squared == 0) return;
    const Rational ratio =
        scale.largest_coordinate * scale.largest_coordinate / scale.shorter_edge_squared;
    stored.slack_radians = 4 * std::sqrt(2 * nearest_double(ratio)) * 0x1p-53;
  }

  static void measure_excess(StoredBound& stored, const JudgedCorner& worst, Arctangent bound,
                             bool is_upper) {
    const Corner<Rational> corner{worst.cross, is_upper ? Rational(-worst.dot) : worst.dot};
    const auto [rise, run] = excess_tangent(corner, bound);
    const Rational larger = std::max(Rational(abs(rise)), Rational(abs(run)));
    if (larger == 0) return;
    const double excess =
        std::atan2(nearest_double(Rational(rise / larger)), nearest_double(Rational(run / larger)));
    stored.excess_radians = excess;
  }

  void judge_size() {
    const std::string id = fmt::format("size-{}N", options_.quads_per_cell);
    if (mesh_.cells == 0) {
      add(id, Verdict::not_decided).detail = "the mesh does not say how many cells there were";
      return;
    }
    const Rational limit = Rational(options_.quads_per_cell) * Rational(mesh_.cells);
    const Rational quads(report_.quads);
    Claim& claim = add(id, quads <= limit);
    claim.values = {{"quads", quads}, {"limit", limit}};
    claim.detail =
        fmt::format("{} quads, {} cells, {:.4f} quads per cell", report_.quads, mesh_.cells,
                    static_cast<double>(report_.quads) / static_cast<double>(mesh_.cells));
  }

  void judge_theorem() {
    Verdict verdict = Verdict::holds;
    std::string detail;
    for (const Claim& claim : report_.claims) {
      if (claim.exact == Verdict::holds) continue;
      if (claim.exact == Verdict::fails) verdict = Verdict::fails;
      if (verdict == Verdict::holds) verdict = Verdict::not_decided;
      detail += fmt::format("{}{} {}", detail.empty() ? "" : ", ", claim.id, name(claim.exact));
    }
    add(report_.theorem, verdict).detail = std::move(detail);
  }

  const PointSet& points_;
  const Mesh& mesh_;
  const VerifyOptions& options_;
  Threads threads_;
  ExactPlane plane_;
  StoredPlane stored_plane_;
  Survey survey_;
  std::optional<Survey> stored_survey_;  ///< only where rounding moves a vertex
  std::optional<VertexId> infinite_vertex_;
  Links links_;
  Loops loops_;
  Contacts contacts_;
  Report report_;
};

}  // namespace

Report verify_points(const PointSet& points, const Mesh& mesh, const VerifyOptions& options) {
  return Judge(points, mesh, options).judge();
}

}  // namespace quadbound
