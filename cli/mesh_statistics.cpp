// SPDX-License-Identifier: Apache-2.0
#include "cli/mesh_statistics.hpp"

#include <nlohmann/json.hpp>
#include <vector>

#include "model/mesh_shape.hpp"

namespace quadbound::cli {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Distribution& distribution) {
  Json histogram = Json::array();
  for (std::size_t i = 0; i < distribution.counts().size(); ++i)
    histogram.push_back(
        {distribution.ends()[i], distribution.ends()[i + 1], distribution.counts()[i]});
  if (distribution.count() == 0) return {{"histogram", histogram}};
  return {{"smallest", distribution.smallest()},
          {"mean", distribution.mean()},
          {"largest", distribution.largest()},
          {"histogram", histogram}};
}

void add_sizes(Json& json, const Mesh& mesh) {
  const auto cells = static_cast<double>(mesh.cells);
  json["input_vertices"] = mesh.input_vertices;
  json["cells"] = mesh.cells;
  json["vertices"] = mesh.vertices.size();
  json["quads"] = mesh.quads.size();
  if (mesh.input_vertices != 0)
    json["cells_per_input_vertex"] = cells / static_cast<double>(mesh.input_vertices);
  if (mesh.cells != 0) json["quads_per_cell"] = static_cast<double>(mesh.quads.size()) / cells;
}

void add_shape(Json& json, const MeshShape& shape) {
  Json degrees = Json::object();
  for (const auto& [degree, count] : shape.degrees) degrees[std::to_string(degree)] = count;
  json["degrees"] = degrees;
  json["scaled_jacobian"] = json_of(shape.scaled_jacobian);
  json["aspect_ratio"] = json_of(shape.aspect_ratio);
}

void add_constructions(Json& json, const Mesh& mesh) {
  std::vector<std::uint64_t> counts(mesh.construction_names.size());
  for (const std::uint8_t construction : mesh.construction) ++counts[construction];
  Json object = Json::object();
  for (std::size_t i = 0; i < counts.size(); ++i) object[mesh.construction_names[i]] = counts[i];
  json["constructions"] = object;
}

Json section_3_4(const PolygonCounters& counters) {
  const InsertionCounters& insertion = counters.insertion;
  return {{"cells_before_separation", counters.cells_before},
          {"rounds", counters.rounds},
          {"local_rounds", counters.local_rounds},
          {"separation_splits", counters.separation_splits},
          {"size_splits", counters.size_splits},
          {"dead_end_splits", counters.dead_end_splits},
          {"kite_splits", counters.kite_splits},
          {"restarts", counters.restarts},
          {"other_roots", counters.other_roots},
          {"kites", counters.kites},
          {"kept_quads", counters.kept_quads},
          {"alpha_vertices_by_level", insertion.alpha_vertices_by_level},
          {"chains_cut_elsewhere", insertion.other_cuts},
          {"centres_aligned", insertion.moves},
          {"alignments_refused", insertion.moves_refused},
          {"alignments_undone", insertion.moves_undone}};
}

Json lemmas(const LemmaCounters& counters) {
  return {
      {"strips_by_edges_of_alpha", counters.strips}, {"corners_by_case", counters.corners},
      {"replaced_chains", counters.replaced_chains}, {"moved_feet", counters.moved_feet},
      {"strips_outside", counters.strips_outside},   {"corners_outside", counters.corners_outside},
      {"kites_outside", counters.kites_outside}};
}

}  // namespace

std::string statistics_json(const Mesh& mesh, const std::optional<PolygonCounters>& counters) {
  Json json = Json::object();
  add_sizes(json, mesh);
  add_shape(json, mesh_shape(mesh));
  add_constructions(json, mesh);
  if (counters) json["section_3_4"] = section_3_4(*counters);
  if (counters && counters->lemmas) json["lemmas"] = lemmas(*counters->lemmas);
  return json.dump(1) + "\n";
}

}  // namespace quadbound::cli
