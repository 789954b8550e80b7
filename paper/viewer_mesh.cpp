// SPDX-License-Identifier: Apache-2.0
#include "paper/viewer_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "model/picture_classes.hpp"

namespace quadbound {
namespace {

using Json = nlohmann::ordered_json;

/// Trailing zeros that all coordinates on the lattice have in common.
int common_zeros(const Vertices& vertices) {
  std::uint64_t bits = 0;
  for (VertexId v = 0; v < vertices.size(); ++v) {
    if (!vertices.on_lattice(v)) continue;
    const LatticePoint point = vertices.lattice(v);
    bits |= static_cast<std::uint64_t>(point.x) | static_cast<std::uint64_t>(point.y);
  }
  return bits == 0 ? 0 : std::countr_zero(bits);
}

void add_vertices(Json& json, const Vertices& vertices) {
  const int zeros = common_zeros(vertices);
  std::string xy;
  Json rational = Json::object();
  for (VertexId v = 0; v < vertices.size(); ++v) {
    LatticePoint point;
    if (vertices.on_lattice(v)) {
      point = vertices.lattice(v);
    } else {
      const RationalPoint exact = vertices.exact(v);
      rational[std::to_string(v)] = {to_text(exact.x), to_text(exact.y)};
    }
    xy += fmt::format("{}{} {}", v == 0 ? "" : " ", point.x >> zeros, point.y >> zeros);
  }
  json["exponent"] = vertices.exponent() + zeros;
  json["xy"] = std::move(xy);
  json["rational"] = std::move(rational);
}

Json vertices_at(const Mesh& mesh, const std::vector<Point>& input) {
  std::set<std::pair<Rational, Rational>> places;
  for (const Point& point : input) {
    RationalPoint exact = exact_value(point);
    places.emplace(std::move(exact.x), std::move(exact.y));
  }
  Json found = Json::array();
  for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
    RationalPoint exact = mesh.vertices.exact(v);
    if (places.contains({std::move(exact.x), std::move(exact.y)})) found.push_back(v);
  }
  return found;
}

Json bounds_of(const Report& report) {
  const AngleInterval& bounds = report.polygon ? kTheorem13 : kTheorem1;
  const auto pair = [](Arctangent angle) { return Json{angle.numerator, angle.denominator}; };
  return {{"theorem", report.theorem},
          {"smallest", pair(bounds.smallest)},
          {"from_straight", pair(bounds.from_straight)}};
}

Json worst_of(const Report& report, std::string_view id) {
  const Claim* const claim = report.find(id);
  if (claim == nullptr || !claim->worst)
    throw std::logic_error(fmt::format("a report without a worst corner of {}", id));
  const JudgedCorner& corner = *claim->worst;
  const auto tangent = corner.tangent();
  return {{"quad", corner.place.quad.value()},
          {"corner", corner.place.corner.value()},
          {"tan", tangent ? Json(to_text(*tangent)) : Json(nullptr)},
          {"degrees", std::round(corner.degrees() * 1e4) / 1e4}};
}

Json colour_of(const Mesh& mesh, PictureColour colour) {
  const PictureClasses classes = picture_classes(mesh, colour);
  Json json{{"title", classes.title}, {"classes", Json::array()}};
  for (const PictureClass& one : classes.classes)
    json["classes"].push_back({{"label", one.label},
                               {"colour", fmt::format("#{:02x}{:02x}{:02x}", one.colour.red,
                                                      one.colour.green, one.colour.blue)}});
  std::string text;
  for (const std::uint8_t number : classes.of_quad) text += static_cast<char>('0' + number);
  json["of_quad"] = std::move(text);
  return json;
}

/// No "</script>" can be in it.
std::string for_html(const Json& json) {
  std::string text = json.dump();
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at))
    text.insert(at + 1, 1, '\\');
  return text;
}

}  // namespace

std::string viewer_mesh_json(const Mesh& mesh, const Report& report,
                             const std::vector<Point>& input) {
  Json json = Json::object();
  add_vertices(json, mesh.vertices);
  json["quads"] = Json::array();
  for (const Quad& quad : mesh.quads)
    for (const VertexId v : quad) json["quads"].push_back(v);
  json["input"] = vertices_at(mesh, input);
  json["polygon"] = report.polygon.has_value();
  json["bounds"] = bounds_of(report);
  json["worst"] = {{"smallest", worst_of(report, "min-angle")},
                   {"largest", worst_of(report, "max-angle")}};
  json["colours"] = Json::array();
  for (const PictureColour colour : {PictureColour::kMinAngle, PictureColour::kMaxAngle,
                                     PictureColour::kConstruction, PictureColour::kLevel})
    json["colours"].push_back(colour_of(mesh, colour));
  return for_html(json);
}

std::string viewer_views_json(const std::vector<ViewerView>& views) {
  Json json = Json::array();
  for (const ViewerView& view : views) {
    Json entry{{"id", view.id}, {"text", view.text}, {"mesh", view.mesh}};
    if (view.window)
      entry["window"] = {view.window->low.x, view.window->low.y, view.window->high.x,
                         view.window->high.y};
    json.push_back(std::move(entry));
  }
  return for_html(json);
}

}  // namespace quadbound
