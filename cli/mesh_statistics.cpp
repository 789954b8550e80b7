// SPDX-License-Identifier: Apache-2.0
#include "cli/mesh_statistics.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "model/mesh_edges.hpp"
#include "model/quad_shape.hpp"

namespace quadbound::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Of values by classes; a class holds its lower end, the last one its upper end as well.
class Distribution {
 public:
  explicit Distribution(std::vector<double> ends) : ends_(std::move(ends)) {
    counts_.resize(ends_.size() - 1);
  }

  void add(double value) {
    smallest_ = count_ == 0 ? value : std::min(smallest_, value);
    largest_ = count_ == 0 ? value : std::max(largest_, value);
    sum_ += value;
    ++count_;
    const auto beyond = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, value);
    ++counts_[static_cast<std::size_t>(beyond - ends_.begin()) - 1];
  }

  [[nodiscard]] Json json() const {
    Json histogram = Json::array();
    for (std::size_t i = 0; i < counts_.size(); ++i)
      histogram.push_back({ends_[i], ends_[i + 1], counts_[i]});
    if (count_ == 0) return {{"histogram", histogram}};
    return {{"smallest", smallest_},
            {"mean", sum_ / static_cast<double>(count_)},
            {"largest", largest_},
            {"histogram", histogram}};
  }

 private:
  std::vector<double> ends_;
  std::vector<std::uint64_t> counts_;
  double smallest_ = 0;
  double largest_ = 0;
  double sum_ = 0;
  std::uint64_t count_ = 0;
};

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

void add_degrees(Json& json, const Mesh& mesh) {
  std::vector<std::uint32_t> degrees(mesh.vertices.size());
  for_each_edge(mesh, [&degrees](const EdgeUse& edge) {
    ++degrees[edge.low];
    ++degrees[edge.high];
  });
  std::map<std::uint32_t, std::uint64_t> counts;
  for (const std::uint32_t degree : degrees) ++counts[degree];
  Json object = Json::object();
  for (const auto& [degree, count] : counts) object[std::to_string(degree)] = count;
  json["degrees"] = object;
}

void add_shapes(Json& json, const Mesh& mesh) {
  Distribution jacobian({0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1});
  Distribution aspect({1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 7, 10, 20});
  for (const Quad& quad : mesh.quads) {
    const QuadShape shape = quad_shape(mesh.vertices, quad);
    jacobian.add(shape.scaled_jacobian);
    aspect.add(shape.aspect_ratio);
  }
  json["scaled_jacobian"] = jacobian.json();
  json["aspect_ratio"] = aspect.json();
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
          {"separation_splits", counters.separation_splits},
          {"dead_end_splits", counters.dead_end_splits},
          {"restarts", counters.restarts},
          {"kites", counters.kites},
          {"kept_quads", counters.kept_quads},
          {"alpha_vertices_by_level", insertion.alpha_vertices_by_level},
          {"chains_cut_elsewhere", insertion.other_cuts},
          {"centres_aligned", insertion.moves},
          {"alignments_refused", insertion.moves_refused}};
}

}  // namespace

std::string statistics_json(const Mesh& mesh, const std::optional<PolygonCounters>& counters) {
  Json json = Json::object();
  add_sizes(json, mesh);
  add_degrees(json, mesh);
  add_shapes(json, mesh);
  add_constructions(json, mesh);
  if (counters) json["section_3_4"] = section_3_4(*counters);
  return json.dump(1) + "\n";
}

}  // namespace quadbound::cli
