// SPDX-License-Identifier: Apache-2.0
#include "paper/reproduction_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "paper/claims.hpp"
#include "paper/claims_list.hpp"
#include "paper/lemma_report.hpp"
#include "paper/redundant_quads.hpp"
#include "paper/report_page.hpp"

namespace quadbound {
namespace {

using Json = nlohmann::ordered_json;

double two_digits(double value) { return std::round(value * 100) / 100; }
/// Four digits behind the point, so that no last bit of a library reaches the file.
double four_digits(double value) { return std::round(value * 1e4) / 1e4; }

Json json_of(const Corner<Rational>& corner) {
  Json json{{"degrees", four_digits(degrees(corner))}, {"tan", nullptr}};
  if (corner.dot != 0) json["tan"] = to_text(Rational(corner.cross / corner.dot));
  return json;
}

Json json_of(const Measurement& m) {
  Json json{{"set", m.trial.set}};
  json["seed"] = m.trial.seed ? Json(*m.trial.seed) : Json(nullptr);
  json["grid"] = grid_name(m.trial.refinement);
  json["warping"] = m.trial.warping == Warping::kAligned ? "aligned" : "paper";
  json["two_two"] = m.trial.two_two == TwoTwoVariant::kExact ? "exact" : "paper";
  json["n"] = m.points;
  json["cells"] = m.cells;
  json["vertices"] = m.vertices;
  json["quads"] = m.quads;
  json["smallest"] = json_of(m.smallest);
  json["largest"] = json_of(m.largest);
  if (m.trial.warping == Warping::kPaper) {
    json["smallest_at_points"] = json_of(m.smallest_at_points);
    json["largest_at_points"] = json_of(m.largest_at_points);
  }
  json["proved"] = m.proved();
  if (!m.proved()) json["broken"] = m.broken;
  if (!m.proved()) json["corners_beyond"] = m.corners_beyond;
  return json;
}

Json json_of(const Distribution& distribution) {
  Json json{{"smallest", four_digits(distribution.smallest())},
            {"mean", four_digits(distribution.mean())},
            {"largest", four_digits(distribution.largest())},
            {"histogram", Json::array()}};
  for (std::size_t i = 0; i < distribution.counts().size(); ++i)
    json["histogram"].push_back({distribution.ends()[i], distribution.counts()[i]});
  return json;
}

Json json_of(const PolygonFigure& figure) {
  const PolygonMeasurement& m = figure.judged.measurement;
  Json json{{"id", figure.id},
            {"polygon", m.polygon},
            {"n", m.edges},
            {"cells", m.cells},
            {"vertices", m.vertices},
            {"quads", m.quads},
            {"smallest", json_of(m.smallest)},
            {"largest", json_of(m.largest)},
            {"whole_input_angles", m.whole_corners},
            {"kites", m.kites},
            {"cells_before_separation", m.cells_before},
            {"rounds", m.rounds},
            {"proved", m.proved()}};
  if (!m.proved()) json["broken"] = m.broken;
  json["degrees"] = Json::object();
  for (const auto& [degree, count] : m.shape.degrees)
    json["degrees"][std::to_string(degree)] = count;
  json["scaled_jacobian"] = json_of(m.shape.scaled_jacobian);
  json["aspect_ratio"] = json_of(m.shape.aspect_ratio);
  return json;
}

Json json_of(const Theorem1Table& table) {
  Json json{{"holds", table.holds()},
            {"trees", table.trees},
            {"quads", table.census.quads()},
            {"unlisted", table.census.unlisted()},
            {"configurations", Json::array()}};
  for (std::size_t i = 0; i < table.census.configurations().size(); ++i) {
    const Configuration& c = table.census.configurations()[i];
    json["configurations"].push_back(
        {{"construction", kConstructionNames[static_cast<std::size_t>(c.construction)]},
         {"quad", c.name},
         {"warped", c.moves()},
         {"smallest", arctangent_text(c.smallest)},
         {"largest", arctangent_text(c.largest)},
         {"proved", c.proved},
         {"met", table.census.count(i)}});
  }
  return json;
}

Json json_of(const PaperClaim& claim) {
  return {{"id", claim.id},
          {"what", claim.what},
          {"paper", claim.paper},
          {"ours", claim.ours},
          {"verdict", verdict_text(claim)}};
}

/// The processor's name as Linux tells it.
std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string text; std::getline(file, text);)
    if (text.starts_with("model name")) return text.substr(text.find(':') + 2);
  return "unknown";
}

TextTable groups_table(const Reproduction& r) {
  TextTable table{{"set", "n", "grid", "meshes", "N/n least", "mean", "most", "quads/N most",
                   "smallest angle", "largest angle", "all proved"},
                  {}};
  for (const Group& g : r.groups) {
    table.rows.push_back(
        {g.set, with_commas(g.points), std::string(grid_name(g.refinement)),
         std::to_string(g.runs.size()), fmt::format("{:.2f}", g.smallest_ratio()),
         fmt::format("{:.2f}", g.mean_ratio()), fmt::format("{:.2f}", g.largest_ratio()),
         fmt::format("{:.3f}", g.largest_quads_per_cell()), arctangent_text(g.smallest()),
         arctangent_text(g.largest()), g.proved() ? "yes" : "NO"});
  }
  return table;
}

TextTable warped_table(const Reproduction& r) {
  TextTable table{
      {"seed", "n", "corners beyond", "smallest at a point", "largest", "claims broken"}, {}};
  for (const Measurement& m : r.warped) {
    std::string broken;
    for (const std::string& id : m.broken) broken += (broken.empty() ? "" : ", ") + id;
    table.rows.push_back({std::to_string(m.trial.seed.value()), std::to_string(m.points),
                          std::to_string(m.corners_beyond),
                          fmt::format("{:.2f}", degrees(m.smallest_at_points)),
                          fmt::format("{:.2f}", degrees(m.largest)), broken});
  }
  return table;
}

TextTable configurations_table(const Theorem1Table& t) {
  TextTable table{{"construction", "quad", "smallest", "largest", "verdict", "met"}, {}};
  for (std::size_t i = 0; i < t.census.configurations().size(); ++i) {
    const Configuration& c = t.census.configurations()[i];
    table.rows.push_back({std::string(kConstructionNames[static_cast<std::size_t>(c.construction)]),
                          c.name + (c.moves() ? ", warped" : ""), arctangent_text(c.smallest),
                          arctangent_text(c.largest), c.proved ? "proved" : "BROKEN",
                          with_commas(t.census.count(i))});
  }
  return table;
}

void add_lake(Document& d, const Reproduction& r, const ReportPictures& pictures) {
  const Measurement& m = r.lake->measurement;
  d.push_back(Heading{2, "Lake Superior (fig-10)", "lake"});
  d.push_back(Paragraph{fmt::format(
      "{} points, N = {} cells, {} vertices, {} quads, angles from {} to {} degrees; {}. The "
      "judge's report is `fig-10-report.json`.",
      m.points, with_commas(m.cells), with_commas(m.vertices), with_commas(m.quads),
      angle_text(m.smallest), angle_text(m.largest), m.proved() ? "proved" : "NOT PROVED")});
  d.push_back(DocumentPicture{"fig-10-whole.png",
                              "The mesh of the 303 points; the red square is magnified below.",
                              pictures.whole,
                              {"fig-10"},
                              "fig-10"});
  d.push_back(DocumentPicture{"fig-10-magnified.png",
                              "The square magnified; dots are input points.",
                              pictures.magnified,
                              {},
                              "fig-10-magnified"});
}

void add_sizes(Document& d, const Reproduction& r, const ReportPictures& pictures) {
  d.push_back(Heading{2, "Cells against points (80n, size-3N)", "sizes"});
  d.push_back(Paragraph{
      "Every mesh below was judged claim by claim on exact coordinates. Random sets come from "
      "`quadbound generate FAMILY --n N --seed SEED` with seeds from 1. Grid: how the 5x5 cells "
      "around each point are made, by the paper's 6x6 split or directly. All meshes one by one: "
      "`n-against-N.csv`."});
  d.push_back(
      DocumentPicture{"n-against-N.svg", "Cells per point.", pictures.chart, {"80n", "size-3N"}});
  d.push_back(groups_table(r));
}

void add_theorem(Document& d, const Reproduction& r) {
  d.push_back(Heading{2, "The paper's own warping (2.4.3)", "warping", {"thm-1"}});
  d.push_back(Paragraph{
      "`quadbound mesh --warp paper` on uniform sets of 60 points: it breaks Theorem 1. With "
      "the centres beside each point aligned, the default, all sets are proved."});
  d.push_back(warped_table(r));
  d.push_back(
      Heading{2, "Theorem 1, configuration by configuration (thm-1)", "theorem-1", {"thm-1"}});
  d.push_back(Paragraph{fmt::format(
      "Every shape of a quad, up to similarity; `met` counts {} quads of {} random trees and as "
      "many point sets, {} of which had a shape not listed. Also: `quadbound prove theorem-1`.",
      with_commas(r.theorem_1.census.quads()), r.theorem_1.trees, r.theorem_1.census.unlisted())});
  d.push_back(configurations_table(r.theorem_1));
}

TextTable polygons_table(const Reproduction& r) {
  TextTable table{{"figure", "polygon", "edges", "N", "vertices", "quads", "quads/N", "smallest",
                   "largest", "kites", "proved"},
                  {}};
  for (const PolygonFigure& f : r.polygons) {
    const PolygonMeasurement& m = f.judged.measurement;
    table.rows.push_back(
        {f.id, f.how, with_commas(m.edges), with_commas(m.cells), with_commas(m.vertices),
         with_commas(m.quads), fmt::format("{:.3f}", m.quads_per_cell()),
         fmt::format("{:.2f}", degrees(m.smallest)), fmt::format("{:.2f}", degrees(m.largest)),
         std::to_string(m.kites), m.proved() ? "yes" : "NO"});
  }
  return table;
}

/// The two meshes that Section 5 looks at.
constexpr std::array<const char*, 2> kMeasured{"fig-49", "fig-50"};

TextTable degrees_table(const Reproduction& r) {
  std::uint32_t most = 0;
  for (const char* const id : kMeasured)
    most = std::max(most, r.polygon(id).measurement.shape.degrees.rbegin()->first);
  TextTable table{{"degree"}, {}};
  for (std::uint32_t degree = 2; degree <= most; ++degree)
    table.head.push_back(std::to_string(degree));
  const auto add = [&](std::string name, const std::map<std::uint32_t, std::uint64_t>& degrees) {
    std::vector<std::string> row{std::move(name)};
    for (std::uint32_t degree = 2; degree <= most; ++degree) {
      const auto found = degrees.find(degree);
      row.push_back(with_commas(found == degrees.end() ? 0 : found->second));
    }
    table.rows.push_back(std::move(row));
  };
  for (const char* const id : kMeasured) {
    const JudgedPolygonMesh& judged = r.polygon(id);
    add(id, judged.measurement.shape.degrees);
    const ThinnedFigure thinned = thinned_figure(judged.polygon);
    add(fmt::format("{} less {} redundant, {}", id, thinned.removed,
                    thinned.broken.empty() ? "proved" : "NOT PROVED"),
        thinned.shape.degrees);
  }
  return table;
}

/// Quads by classes of one measure.
TextTable shape_table(const Reproduction& r, Distribution MeshShape::*measure) {
  const auto& ends = (r.polygon(kMeasured[0]).measurement.shape.*measure).ends();
  TextTable table{{"mesh", "smallest", "mean", "largest"}, {}};
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    table.head.push_back(i + 2 < ends.size() ? fmt::format("{} to {}", ends[i], ends[i + 1])
                                             : fmt::format("from {}", ends[i]));
  for (const char* const id : kMeasured) {
    const Distribution& d = r.polygon(id).measurement.shape.*measure;
    std::vector<std::string> row{id, fmt::format("{:.4f}", d.smallest()),
                                 fmt::format("{:.4f}", d.mean()),
                                 fmt::format("{:.4f}", d.largest())};
    for (const std::uint64_t count : d.counts()) row.push_back(with_commas(count));
    table.rows.push_back(std::move(row));
  }
  return table;
}

void add_polygons(Document& d, const Reproduction& r, const ReportPictures& pictures) {
  d.push_back(Heading{2, "Polygons (thm-13, fig-46 to fig-53)", "polygons", {"thm-13", "size-5N"}});
  d.push_back(Paragraph{
      "Made by `mesh_polygon`, judged by `verify_polygon` on exact coordinates. Each is what "
      "`quadbound mesh POLYGON` makes without options. The paper's polygons are lost; these are "
      "of the same kind with as many edges. Input angles that stay whole are not judged."});
  d.push_back(polygons_table(r));
  for (const DocumentPicture& picture : pictures.polygons) d.push_back(picture);
  d.push_back(Heading{2,
                      "Quality (Section 5: fig-44, fig-45, table-2)",
                      "quality",
                      {"fig-44", "fig-45", "table-2"}});
  d.push_back(Paragraph{
      "Vertices by their number of edges (table-2), also less the redundant quads of template T2b "
      "that no strip reaches: shrunk to a point each, and judged again."});
  d.push_back(degrees_table(r));
  d.push_back(Paragraph{
      "Quads by their scaled Jacobian, the least of the sines of their angles (fig-44):"});
  d.push_back(shape_table(r, &MeshShape::scaled_jacobian));
  d.push_back(pictures.shapes.front());
  d.push_back(Paragraph{
      "Quads by their aspect ratio (fig-45). The longest ones of the lake fill the sharp ends of "
      "its acute input angles:"});
  d.push_back(shape_table(r, &MeshShape::aspect_ratio));
  d.push_back(pictures.shapes.back());
}

/// Last, because they link to all the rest.
void insert_claims(Document& d, std::size_t at, const Reproduction& r) {
  const auto claims = list_claims(file_of_claims(), compare_with_paper(r));
  const bool all_audited = std::none_of(claims.begin(), claims.end(), [](const ListedClaim& claim) {
    return claim.verdict == "not audited";
  });
  const std::string about = fmt::format(
      "Everything that the paper says, in the words of this report, and what became of it. `fails` "
      "is the paper's statement as it stands, with what we do instead in paper/departures.md.{}",
      all_audited ? "" : " `not audited` means that nobody has checked it yet.");
  const auto place = d.begin() + static_cast<std::ptrdiff_t>(at);
  d.insert(place, {Heading{2, "Claims, the paper's and ours", "all-claims"}, Paragraph{about},
                   claims_block(claims, claim_links(d))});
}

}  // namespace

std::string reproduction_json(const Reproduction& r, const Provenance& provenance) {
  Json json{{"format", "quadbound-reproduction"},
            {"version", 1},
            {"command", provenance.command},
            {"commit", provenance.commit},
            {"holds", r.holds()}};
  json["claims"] = Json::array();
  for (const PaperClaim& claim : compare_with_paper(r)) json["claims"].push_back(json_of(claim));
  json["fig-10"] = json_of(r.lake->measurement);
  json["fig-10-two-two-paper"] = json_of(r.lake_with_their_case);
  json["n-against-N"] = Json::array();
  for (const Group& g : r.groups)
    for (const Measurement& m : g.runs) json["n-against-N"].push_back(json_of(m));
  json["paper-warping"] = Json::array();
  for (const Measurement& m : r.warped) json["paper-warping"].push_back(json_of(m));
  json["theorem-1"] = json_of(r.theorem_1);
  json["polygons"] = Json::array();
  for (const PolygonFigure& figure : r.polygons) json["polygons"].push_back(json_of(figure));
  json["fig-47"] = json_of(r.fig_47->measurement);
  json["lemmas"] = Json::parse(lemma_json(r.lemmas));
  return json.dump(1) + "\n";
}

std::string n_against_n_csv(const Reproduction& r) {
  std::string text =
      "set,n,seed,grid,cells,cells_per_point,vertices,quads,quads_per_cell,smallest,largest,"
      "proved\n";
  for (const Group& g : r.groups) {
    for (const Measurement& m : g.runs) {
      text += fmt::format("{},{},{},{},{},{:.4f},{},{},{:.4f},{},{},{}\n", m.trial.set, m.points,
                          m.trial.seed ? std::to_string(*m.trial.seed) : "",
                          grid_name(m.trial.refinement), m.cells, m.cells_per_point(), m.vertices,
                          m.quads, m.quads_per_cell(), arctangent_text(m.smallest),
                          arctangent_text(m.largest), m.proved() ? "yes" : "no");
    }
  }
  return text;
}

std::string machine_json(const Reproduction& r) {
  Json json{{"format", "quadbound-machine"},
            {"version", 1},
            {"processor", processor_name()},
            {"cores", std::thread::hardware_concurrency()},
            {"steps", Json::array()}};
  double total = 0;
  for (const StepTime& time : r.times) {
    json["steps"].push_back({{"step", time.step}, {"seconds", two_digits(time.seconds)}});
    total += time.seconds;
  }
  json["seconds"] = two_digits(total);
  return json.dump(1) + "\n";
}

Document reproduction_report(const Reproduction& r, const Provenance& provenance,
                             const ReportPictures& pictures, const PageBlock& records) {
  Document d;
  d.push_back(Heading{1, "The paper, reproduced"});
  d.push_back(Paragraph{
      "Atalay, Ramaswami, Xu: Quadrilateral meshes with provable angle bounds. Engineering with "
      "Computers (2012). Made by"});
  d.push_back(CodeBlock{provenance.command});
  d.push_back(Paragraph{fmt::format(
      "at commit {}. Times and the machine: `machine.json`; all numbers: `reproduction.json`. {}",
      provenance.commit,
      r.holds()
          ? "Every mesh is proved to be as Theorem 1 or Theorem 13 says, but for those made by the "
            "paper's own warping."
          : "A CLAIM FAILED: see the verdicts.")});
  const std::size_t claims_at = d.size();
  d.push_back(Heading{2, "Meshes, to look into", "meshes"});
  d.push_back(viewer_block(pictures.meshes, pictures.views));
  add_lake(d, r, pictures);
  add_polygons(d, r, pictures);
  add_sizes(d, r, pictures);
  add_theorem(d, r);
  for (Block& block : lemma_section(r.lemmas)) d.push_back(std::move(block));
  d.push_back(Heading{2, "Records, of commands that take longer", "records"});
  d.push_back(Paragraph{"Measured by other commands, each with the command that repeats it:"});
  d.push_back(records);
  insert_claims(d, claims_at, r);
  return d;
}

}  // namespace quadbound
