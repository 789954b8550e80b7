// SPDX-License-Identifier: Apache-2.0
#include "verify/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace quadbound::judge {
namespace {

/// nullopt where the quad is well-formed; otherwise what is wrong.
std::optional<std::string> defect(const Quad& quad, std::size_t vertices) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (quad[i] >= vertices) return fmt::format("vertex {} of quad does not exist", quad[i]);
    for (std::size_t j = 0; j < i; ++j)
      if (quad[i] == quad[j]) return fmt::format("quad has vertex {} twice", quad[i]);
  }
  return std::nullopt;
}

}  // namespace

Judge::Judge(const Task& task, const Mesh& mesh, const VerifyOptions& options)
    : task_(task),
      mesh_(mesh),
      angles_(options.angles.value_or(task.angles)),
      threads_(options.threads),
      plane_(mesh.vertices, threads_),
      options_(options),
      stored_plane_(mesh.vertices, plane_) {
  if (mesh.quads.size() >= std::size_t{1} << 30)
    throw std::length_error("the judge takes fewer than 2^30 quads");
  report_.theorem = task.theorem;
  report_.quads = mesh.quads.size();
  report_.other_faces = mesh.other_faces.size();
  report_.cells = mesh.cells;
}

Report Judge::judge() {
  if (judge_all_quad()) {
    judge_mesh();
  } else {
    for (const char* id :
         {"distinct-vertices", "conforming", "strictly-convex", task_.boundary_claim, "no-overlap",
          "euler", "area", task_.input_claim, "min-angle", "max-angle"})
      if (id != nullptr)
        add(id, Verdict::not_decided).detail = "the quads are malformed: see all-quad";
  }
  judge_size();
  judge_theorem();
  return std::move(report_);
}

Claim& Judge::add(std::string id, Verdict verdict) {
  Claim claim;
  claim.id = std::move(id);
  claim.exact = verdict;
  report_.claims.push_back(std::move(claim));
  return report_.claims.back();
}

Place Judge::place_of_vertex(VertexId v) const {
  Place place;
  place.vertex = v;
  place.position = mesh_.vertices.exact(v);
  return place;
}

Place Judge::place_of_quad(std::uint64_t quad) const {
  Place place;
  place.quad = quad;
  if (quad < mesh_.level.size()) place.level = mesh_.level[quad];
  if (quad < mesh_.construction.size() &&
      mesh_.construction[quad] < mesh_.construction_names.size())
    place.construction = mesh_.construction_names[mesh_.construction[quad]];
  return place;
}

Place Judge::place_of_corner(CornerId id) const {
  Place place = place_of_quad(id.quad);
  const VertexId v = mesh_.quads[id.quad][static_cast<std::size_t>(id.corner)];
  place.corner = id.corner;
  place.vertex = v;
  place.position = mesh_.vertices.exact(v);
  return place;
}

bool Judge::judge_all_quad() {
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
    claim.detail = *defect(mesh_.quads[q], mesh_.vertices.size());
    claim.place = place_of_quad(q);
    return false;
  }
  Claim& claim = add("all-quad", mesh_.other_faces.empty());
  if (!mesh_.other_faces.empty())
    claim.detail = fmt::format("{} faces are no quads; the first has {} sides",
                               mesh_.other_faces.size(), mesh_.other_faces.front().size());
  return true;
}

// --- the facts -----------------------------------------------------------------------------------

void Judge::judge_mesh() {
  const CornersByVertex corners(mesh_.quads, mesh_.vertices.size(), threads_);
  look_at_input(corners);
  std::vector<std::uint8_t> passes;
  survey(corners, passes);
  links_ = link_corners(corners, passes, threads_);
  loops_ = trace_loops(links_.unpaired);
  has_sound_boundary_ = look_at_boundary();
  count();
  judge_distinct_vertices(corners);
  judge_conforming();
  judge_strictly_convex();
  judge_boundary();
  judge_no_overlap();
  judge_euler();
  judge_area();
  judge_input(corners);
  judge_angle("min-angle", &Survey::smallest, angles_.smallest, false);
  judge_angle("max-angle", &Survey::largest, angles_.from_straight, true);
}

void Judge::count() {
  report_.used_vertices = links_.used_vertices;
  report_.unused_vertices = mesh_.vertices.size() - links_.used_vertices;
  report_.boundary_edges = links_.unpaired.size();
  report_.boundary_loops = loops_.loops.size();
  // Paired edges come in twos.
  report_.edges = (links_.directed_edges + links_.unpaired.size()) / 2;
}

/// Of the mesh as it is and, where rounding moves vertices and none away to infinity, of the mesh
/// that they make then.
void Judge::survey(const CornersByVertex& corners, std::vector<std::uint8_t>& passes) {
  const MovedVertices moved = find_moved(stored_plane_, corners, threads_);
  report_.every_vertex_is_a_double = !moved.any;
  infinite_vertex_ = moved.infinite;
  if (moved.any && !moved.infinite) {
    Surveys both = survey_both(plane_, stored_plane_, moved.is_moved, mesh_.quads, angles_, exempt_,
                               threads_, passes);
    survey_ = std::move(both.exact);
    stored_survey_ = std::move(both.stored);
  } else {
    survey_ = survey_quads(plane_, mesh_.quads, angles_, exempt_, threads_, passes);
  }
  report_.decisions = survey_.decisions;
}

// --- tiling --------------------------------------------------------------------------------------

void Judge::judge_distinct_vertices(const CornersByVertex& corners) {
  std::optional<CoincidentVertices> found;
  if (!is_proved_tiling() || options_.always_compare_positions)
    found = find_coincident(plane_, corners);
  Claim& claim = add("distinct-vertices", !found);
  if (!found) return;
  claim.detail = fmt::format("vertices {} and {} are at one place", found->first, found->second);
  claim.place = place_of_vertex(found->second);
}

void Judge::judge_conforming() {
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

void Judge::judge_strictly_convex() {
  Claim& claim = add("strictly-convex", survey_.not_convex == 0);
  if (survey_.first_not_convex) {
    claim.detail = fmt::format("{} corners do not turn left", survey_.not_convex);
    claim.worst = judged(plane_, *survey_.first_not_convex);
  }
  claim.stored.emplace();
  const Survey& rounded = stored_survey_ ? *stored_survey_ : survey_;
  if (!infinite_vertex_ && rounded.not_convex == 0) return;
  claim.stored->verdict = StoredVerdict::fails;
  if (!infinite_vertex_ && stored_survey_)
    claim.stored->worst = judged(stored_plane_, *rounded.first_not_convex);
}

void Judge::describe_crossing(Claim& claim) const {
  const DirectedEdge& first = links_.unpaired[contacts_.crossing->first];
  const DirectedEdge& second = links_.unpaired[contacts_.crossing->second];
  claim.detail = fmt::format("the unpaired edges {} -> {} and {} -> {} cross", first.from, first.to,
                             second.from, second.to);
  claim.place = place_of_edge(first);
}

void Judge::judge_no_overlap() {
  if (is_proved_tiling()) {
    add("no-overlap", true);
  } else if (!is_locally_sound()) {
    add("no-overlap", Verdict::not_decided).detail =
        links_.doubled ? "edges are doubled: see conforming"
                       : "quads are not convex: see strictly-convex";
  } else if (links_.winding || links_.second_fan || contacts_.crossing) {
    refute_overlap();
  } else {
    add("no-overlap", Verdict::not_decided).detail =
        fmt::format("there is no {}: see {}",
                    task_.input_claim != nullptr ? "simple boundary" : "boundary of the polygon",
                    task_.boundary_claim);
  }
}

void Judge::refute_overlap() {
  Claim& claim = add("no-overlap", false);
  if (links_.winding) {
    claim.detail = fmt::format("the quads around vertex {} make {} turns", links_.winding->vertex,
                               links_.winding->turns);
    claim.place = place_of_vertex(links_.winding->vertex);
  } else if (links_.second_fan) {
    claim.detail =
        fmt::format("the boundary vertex {} is inside of other quads as well", *links_.second_fan);
    claim.place = place_of_vertex(*links_.second_fan);
  } else {
    describe_crossing(claim);
  }
}

void Judge::judge_euler() {
  const auto vertices = static_cast<std::int64_t>(report_.used_vertices);
  const auto edges = static_cast<std::int64_t>(report_.edges);
  const std::int64_t euler = vertices - edges + static_cast<std::int64_t>(report_.quads);
  Claim& claim = add("euler", euler == task_.euler);
  claim.values = {{"vertices - edges + quads", Rational(euler)}};
  if (euler != task_.euler)
    claim.detail = fmt::format("vertices - edges + quads = {}, not {}", euler, task_.euler);
}

/// Twice the signed areas of all quads, as sums over their edges (verify/tiling.md, Areas).
Rational Judge::doubled_quad_area(const Rational& enclosed) const {
  WideSum sum = survey_.lattice_area;
  const auto on_lattice = [&](const DirectedEdge& e) {
    return plane_.on_lattice(e.from) && plane_.on_lattice(e.to);
  };
  const auto add_if_off = [&](const DirectedEdge& e) {
    if (!on_lattice(e)) sum.add(cross_product(plane_.rational(e.from), plane_.rational(e.to)));
  };
  const auto& unpaired = links_.unpaired;
  if (!has_sound_boundary_) {
    std::for_each(unpaired.begin(), unpaired.end(), add_if_off);
  } else if (!std::all_of(unpaired.begin(), unpaired.end(), on_lattice)) {
    sum.add(enclosed);
    for (const DirectedEdge& e : unpaired)
      if (on_lattice(e)) sum.add(-cross_product(plane_.lattice(e.from), plane_.lattice(e.to)));
  }
  std::for_each(links_.surplus.begin(), links_.surplus.end(), add_if_off);
  return sum.value();
}

void Judge::judge_area() {
  const std::optional<Rational> doubled = doubled_enclosed_area();
  if (!doubled) {
    add("area", Verdict::not_decided).detail =
        fmt::format("there is no outermost loop: see {}", task_.boundary_claim);
    return;
  }
  const Rational unit = dyadic(1, mesh_.vertices.exponent());
  const Rational quads = doubled_quad_area(*doubled) * unit * unit / 2;
  const Rational enclosed = *doubled * unit * unit / 2;
  Claim& claim = add("area", quads == enclosed);
  claim.values = {{"quads", quads}, {"within the boundary", enclosed}};
  if (quads != enclosed)
    claim.detail = fmt::format("quads cover {}, the boundary encloses {}", nearest_double(quads),
                               nearest_double(enclosed));
}

// --- the theorem's numbers -----------------------------------------------------------------------

void Judge::judge_size() {
  const std::uint64_t quads_per_cell = options_.quads_per_cell.value_or(task_.quads_per_cell);
  const std::string id = fmt::format("size-{}N", quads_per_cell);
  if (mesh_.cells == 0) {
    add(id, Verdict::not_decided).detail = "the mesh does not say how many cells there were";
    return;
  }
  const Rational limit = Rational(quads_per_cell) * Rational(mesh_.cells);
  const Rational quads(report_.quads);
  Claim& claim = add(id, quads <= limit);
  claim.values = {{"quads", quads}, {"limit", limit}};
  claim.detail =
      fmt::format("{} quads, {} cells, {:.4f} quads per cell", report_.quads, mesh_.cells,
                  static_cast<double>(report_.quads) / static_cast<double>(mesh_.cells));
}

void Judge::judge_theorem() {
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

}  // namespace quadbound::judge
