// SPDX-License-Identifier: Apache-2.0
#include "verify/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace quadbound {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const RationalPoint& point) { return {to_text(point.x), to_text(point.y)}; }

Json json_of(const Place& place) {
  Json json = Json::object();
  if (place.quad) json["quad"] = *place.quad;
  if (place.corner) json["corner"] = *place.corner;
  if (place.vertex) json["vertex"] = *place.vertex;
  if (place.position) json["at"] = json_of(*place.position);
  if (!place.construction.empty()) json["construction"] = place.construction;
  if (place.level) json["level"] = *place.level;
  return json;
}

Json json_of(const JudgedCorner& corner) {
  const auto tangent = corner.tangent();
  return {{"cross", to_text(corner.cross)},
          {"dot", to_text(corner.dot)},
          {"tan", tangent ? Json(to_text(*tangent)) : Json(nullptr)},
          {"degrees", corner.degrees()},
          {"place", json_of(corner.place)}};
}

Json json_of(const StoredBound& stored) {
  Json json{{"verdict", name(stored.verdict)}};
  if (stored.worst) json["worst"] = json_of(*stored.worst);
  json["excess_radians"] = stored.excess_radians;
  json["slack_radians"] = stored.slack_radians;
  return json;
}

Json json_of(const Claim& claim) {
  Json json{{"id", claim.id}, {"exact", name(claim.exact)}};
  if (claim.stored) json["stored"] = json_of(*claim.stored);
  if (!claim.detail.empty()) json["detail"] = claim.detail;
  if (claim.place) json["place"] = json_of(*claim.place);
  if (claim.worst) json["worst"] = json_of(*claim.worst);
  for (const auto& [key, value] : claim.values) json["values"][key] = to_text(value);
  return json;
}

Json json_of(const PolygonFacts& facts) {
  Json json{{"rings", facts.rings}};
  if (facts.steiner)
    json["steiner_points"] = {{"edges", facts.steiner->edges},
                              {"fewest_on_an_edge", facts.steiner->fewest},
                              {"most_on_an_edge", facts.steiner->most},
                              {"mean_on_an_edge", to_text(facts.steiner->mean())},
                              {"total", facts.steiner->total}};
  json["split_input_corners"] = facts.split_corners;
  json["whole_input_corners"] = {{"count", facts.whole_corners},
                                 {"beyond_bounds", facts.whole_beyond_bounds}};
  if (facts.smallest_whole) {
    json["whole_input_corners"]["smallest"] = json_of(*facts.smallest_whole);
    json["whole_input_corners"]["largest"] = json_of(*facts.largest_whole);
  }
  return json;
}

std::string text_of(const Place& place) {
  std::string text;
  if (place.quad) text += fmt::format(" quad {}", *place.quad);
  if (place.corner) text += fmt::format(" corner {}", *place.corner);
  if (place.vertex) text += fmt::format(" vertex {}", *place.vertex);
  if (place.position)
    text += fmt::format(" at ({}, {})", nearest_double(place.position->x),
                        nearest_double(place.position->y));
  if (!place.construction.empty()) text += fmt::format(" made by {}", place.construction);
  return text.empty() ? text : text.substr(1);
}

std::string text_of(const Claim& claim) {
  std::string text = fmt::format("{:<18}{:<13}", claim.id, name(claim.exact));
  if (claim.stored) text += fmt::format("stored: {:<17}", name(claim.stored->verdict));
  if (claim.worst) {
    text += fmt::format("{:.4f} degrees, {}", claim.worst->degrees(), text_of(claim.worst->place));
  } else {
    text += claim.detail;
    if (claim.place) text += fmt::format("; {}", text_of(*claim.place));
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

std::string text_of(const PolygonFacts& facts) {
  std::string text = fmt::format("{} rings", facts.rings);
  if (facts.steiner)
    text += fmt::format("; Steiner points on each of {} edges: {} to {}, mean {:.4f}, total {}",
                        facts.steiner->edges, facts.steiner->fewest, facts.steiner->most,
                        nearest_double(facts.steiner->mean()), facts.steiner->total);
  text += fmt::format("\n{} input angles are whole, {} of them beyond the bounds",
                      facts.whole_corners, facts.whole_beyond_bounds);
  if (facts.smallest_whole)
    text += fmt::format("; from {:.4f} to {:.4f} degrees, never judged",
                        facts.smallest_whole->degrees(), facts.largest_whole->degrees());
  return text + "\n";
}

}  // namespace

std::optional<Rational> JudgedCorner::tangent() const {
  if (dot == 0) return std::nullopt;
  return Rational(cross / dot);
}

double JudgedCorner::degrees() const {
  const Rational larger = std::max(Rational(abs(cross)), Rational(abs(dot)));
  if (larger == 0) return 0;
  const double angle =
      std::atan2(nearest_double(Rational(cross / larger)), nearest_double(Rational(dot / larger)));
  return (angle < 0 ? angle + 2 * std::numbers::pi : angle) * 180 / std::numbers::pi;
}

const Claim* Report::find(std::string_view id) const {
  const auto it = std::find_if(claims.begin(), claims.end(),
                               [&](const Claim& claim) { return claim.id == id; });
  return it == claims.end() ? nullptr : &*it;
}

bool Report::holds() const {
  const Claim* claim = find(theorem);
  return claim != nullptr && claim->exact == Verdict::holds;
}

std::string to_json(const Report& report) {
  Json json{{"format", "quadbound-report"}, {"version", 1}, {"theorem", report.theorem}};
  json["counts"] = {{"quads", report.quads},
                    {"other_faces", report.other_faces},
                    {"used_vertices", report.used_vertices},
                    {"unused_vertices", report.unused_vertices},
                    {"edges", report.edges},
                    {"boundary_edges", report.boundary_edges},
                    {"boundary_loops", report.boundary_loops},
                    {"cells", report.cells},
                    {"input_points", report.input_points}};
  json["every_vertex_is_a_double"] = report.every_vertex_is_a_double;
  json["corners_decided_by"] = {{"filter", report.decisions.filter},
                                {"lattice", report.decisions.lattice},
                                {"rational", report.decisions.rational}};
  if (report.polygon) json["polygon"] = json_of(*report.polygon);
  json["claims"] = Json::array();
  for (const Claim& claim : report.claims) json["claims"].push_back(json_of(claim));
  return json.dump(1) + "\n";
}

std::string to_text(const Report& report) {
  std::string text;
  for (const Claim& claim : report.claims) text += text_of(claim) + "\n";
  if (report.polygon) text += text_of(*report.polygon);
  return text;
}

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::fails:
      return "fails";
    case Verdict::not_decided:
      break;
  }
  return "not-decided";
}

std::string_view name(StoredVerdict verdict) {
  switch (verdict) {
    case StoredVerdict::holds:
      return "holds";
    case StoredVerdict::within_rounding:
      return "within-rounding";
    case StoredVerdict::fails:
      break;
  }
  return "fails";
}

}  // namespace quadbound
