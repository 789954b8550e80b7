// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "algo/mesh_points.hpp"
#include "algo/mesh_polygon.hpp"
#include "cli/commands.hpp"
#include "cli/mesh_statistics.hpp"
#include "cli/progress.hpp"
#include "model/errors.hpp"
#include "model/files.hpp"
#include "model/read_points.hpp"
#include "model/read_polygon.hpp"
#include "model/validate.hpp"
#include "model/write_mesh.hpp"
#include "verify/verify.hpp"

namespace quadbound::cli {
namespace {

struct MeshOptions {
  bool points = false;
  std::string input;
  std::vector<std::string> outputs;
  std::string report;
  std::string statistics;
  bool no_verify = false;
  bool quiet = false;
  unsigned threads = 1;
  PointMeshOptions mesh;  ///< the budget also for polygons
  EdgeInsertion insertion = EdgeInsertion::kSearch;
  Sizing sizing;
  std::vector<std::string> refine_near;
  std::string size_field;
  PictureColour colour = PictureColour::kNone;
  bool dots = false;
  std::vector<double> window;
};

const std::map<std::string, GridRefinement> kGrids{{"6x6", GridRefinement::kSixBySix},
                                                   {"5x5", GridRefinement::kFiveByFive}};
const std::map<std::string, TwoTwoVariant> kTwoTwo{{"exact", TwoTwoVariant::kExact},
                                                   {"paper", TwoTwoVariant::kPaper}};
const std::map<std::string, Warping> kWarpings{{"aligned", Warping::kAligned},
                                               {"paper", Warping::kPaper}};
const std::map<std::string, EdgeInsertion> kInsertions{{"search", EdgeInsertion::kSearch},
                                                       {"paper", EdgeInsertion::kLemmas}};
const std::map<std::string, PictureColour> kColours{{"none", PictureColour::kNone},
                                                    {"min-angle", PictureColour::kMinAngle},
                                                    {"max-angle", PictureColour::kMaxAngle},
                                                    {"construction", PictureColour::kConstruction},
                                                    {"level", PictureColour::kLevel}};

WriteOptions write_options(const MeshOptions& options, const std::vector<Point>& input) {
  WriteOptions write;
  write.picture.colour = options.colour;
  if (options.dots) write.picture.points = input;
  if (options.window.size() == 4)
    write.picture.window = {{options.window[0], options.window[1]},
                            {options.window[2], options.window[3]}};
  return write;
}

std::string summary(const Mesh& mesh, std::string_view of_what) {
  const auto n = static_cast<double>(mesh.input_vertices);
  const auto cells = static_cast<double>(mesh.cells);
  const auto quads = static_cast<double>(mesh.quads.size());
  return fmt::format("{} {}, N = {} cells (N/n = {:.2f}), {} vertices, {} quads (quads/N = {:.3f})",
                     mesh.input_vertices, of_what, mesh.cells, cells / n, mesh.vertices.size(),
                     mesh.quads.size(), quads / cells);
}

/// Whether every claim holds; says on standard error which do not.
bool proved(const Report& report) {
  for (const Claim& claim : report.claims) {
    if (claim.exact == Verdict::holds || claim.id == report.theorem) continue;
    fmt::print(stderr, "quadbound: claim {} {}: {}\n", claim.id, name(claim.exact), claim.detail);
  }
  return report.holds();
}

/// What was made of the input, before it is proved and written.
struct Made {
  std::variant<PointSet, Polygon> input;
  Mesh mesh;
  std::optional<PolygonCounters> counters;
};

Report judge(const Made& made, const VerifyOptions& verify) {
  if (const auto* points = std::get_if<PointSet>(&made.input))
    return verify_points(*points, made.mesh, verify);
  return verify_polygon(std::get<Polygon>(made.input), made.mesh, verify);
}

std::vector<Point> input_points(const Made& made) {
  if (const auto* points = std::get_if<PointSet>(&made.input)) return points->points;
  std::vector<Point> result;
  for (const Ring& ring : std::get<Polygon>(made.input).rings)
    result.insert(result.end(), ring.begin(), ring.end());
  return result;
}

/// What was made, or the status to end with.
using MeshOutcome = std::variant<Made, ExitStatus>;

ExitStatus refused(const MeshOptions& options, const Refusal& refusal) {
  fmt::print(stderr, "quadbound: {}: {}\n", options.input, refusal.message);
  return kBudgetRanOut;
}

/// Cells grow by this part of the distance from what they are refined near: neighbours differ by a
/// factor of two at most anyway.
constexpr double kGrowth = 0.5;

/// From X,Y,SIZE or X0,Y0,X1,Y1,SIZE.
SizeSource size_source(const std::vector<double>& numbers) {
  const bool is_point = numbers.size() == 3;
  const Point a{numbers[0], numbers[1]};
  return {a, is_point ? a : Point{numbers[2], numbers[3]}, numbers.back(), kGrowth};
}

/// Finite numbers separated by commas.
std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (;;) {
    const std::size_t comma = text.find(',');
    const std::string_view word = text.substr(0, comma);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
      return std::nullopt;
    numbers.push_back(value);
    if (comma == std::string_view::npos) return numbers;
    text.remove_prefix(comma + 1);
  }
}

/// Errors: InputError naming the file and the line.
std::vector<SizeSource> read_size_field(const std::string& path) {
  std::istringstream lines(read_file(path));
  std::vector<SizeSource> sources;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    const auto numbers = parse_numbers(line);
    if (!numbers || numbers->size() != 3 || !(numbers->back() > 0))
      throw InputError({path, std::nullopt, std::nullopt},
                       fmt::format("line {}: X,Y,SIZE with a positive size is expected", number));
    sources.push_back(size_source(*numbers));
  }
  return sources;
}

Sizing sizing_of(const MeshOptions& options) {
  Sizing sizing = options.sizing;
  for (const std::string& text : options.refine_near)
    sizing.sources.push_back(size_source(*parse_numbers(text)));
  if (!options.size_field.empty())
    for (const SizeSource& source : read_size_field(options.size_field))
      sizing.sources.push_back(source);
  return sizing;
}

/// Says on standard error why there is no mesh.
MeshOutcome make_point_mesh(const MeshOptions& options, Progress& progress) {
  PointSet points = read_points(options.input);
  validate(points);
  progress.stage("building the quadtree and the quads");
  PointMeshResult result = mesh_points(points, options.mesh);
  if (const auto* refusal = std::get_if<Refusal>(&result)) return refused(options, *refusal);
  return Made{std::move(points), std::get<PointMesh>(std::move(result)).mesh, std::nullopt};
}

LemmaMeshResult mesh_by(EdgeInsertion insertion, const Polygon& polygon,
                        const PolygonMeshOptions& options) {
  if (insertion == EdgeInsertion::kLemmas) return mesh_polygon_by_lemmas(polygon, options);
  PolygonMeshResult result = mesh_polygon(polygon, options);
  if (auto* refusal = std::get_if<Refusal>(&result)) return std::move(*refusal);
  return std::get<PolygonMesh>(std::move(result));
}

MeshOutcome make_polygon_mesh(const MeshOptions& options, Progress& progress) {
  Polygon polygon = normalised(read_polygon(options.input));
  progress.stage("meshing");
  LemmaMeshResult result =
      mesh_by(options.insertion, polygon, {options.mesh.budget, sizing_of(options)});
  if (const auto* refusal = std::get_if<Refusal>(&result)) return refused(options, *refusal);
  if (const auto* no_case = std::get_if<NoCase>(&result)) {
    fmt::print(stderr, "quadbound: {}: {}\n", options.input, no_case->message);
    return kClaimFailed;
  }
  PolygonMesh& made = std::get<PolygonMesh>(result);
  return Made{std::move(polygon), std::move(made.mesh), made.counters};
}

/// Whether the mesh is proved; writes the report that was asked for.
bool prove(const Made& made, const MeshOptions& options) {
  VerifyOptions verify;
  verify.threads = options.threads;
  const Report report = judge(made, verify);
  if (!options.report.empty())
    write_file(options.report, [&report](std::ostream& stream) { stream << to_json(report); });
  if (proved(report)) return true;
  fmt::print(stderr, "quadbound: nothing was written; --no-verify writes the mesh all the same\n");
  return false;
}

ExitStatus mesh(const MeshOptions& options) {
  for (const std::string& path : options.outputs) output_format(path);  // refuse before the work
  Progress progress;
  progress.stage("reading");
  const MeshOutcome outcome =
      options.points ? make_point_mesh(options, progress) : make_polygon_mesh(options, progress);
  if (const auto* status = std::get_if<ExitStatus>(&outcome)) return *status;
  const Made& made = std::get<Made>(outcome);
  if (!options.no_verify) {
    progress.stage("proving the mesh");
    if (!prove(made, options)) return kClaimFailed;
  }
  progress.stage("writing");
  for (const std::string& path : options.outputs)
    write_mesh(path, made.mesh, write_options(options, input_points(made)));
  if (!options.statistics.empty())
    write_file(options.statistics,
               [&](std::ostream& stream) { stream << statistics_json(made.mesh, made.counters); });
  if (!options.quiet)
    fmt::print(stderr, "{}; {}\n", summary(made.mesh, options.points ? "points" : "vertices"),
               options.no_verify ? "not verified"
               : options.points  ? "thm-1 proved"
                                 : "thm-13 proved");
  return kGood;
}

constexpr const char* kFooter = R"(Examples:
  quadbound mesh plate.geojson -o mesh.json -o mesh.svg
  quadbound mesh lake.poly -o mesh.msh --report proof.json --statistics shape.json
  quadbound mesh --points points.csv -o mesh.json
  quadbound mesh --points points.csv -o mesh.vtu -o mesh.msh -o mesh.svg --colour min-angle
  quadbound mesh --points points.csv --warp paper   (ends with status 1: the paper's warping)

Pictures: .svg .pdf .png; meshes: .json (exact) .vtu .msh .obj)";

void add_picture_options(CLI::App& command, MeshOptions& options) {
  command.add_option("--colour", options.colour, "what pictures are coloured by")
      ->transform(CLI::CheckedTransformer(kColours))
      ->option_text("none|min-angle|max-angle|construction|level");
  command.add_option("--window", options.window, "the part that pictures show: x0 y0 x1 y1")
      ->expected(4);
  command.add_flag("--dots", options.dots, "draw the input points in pictures");
}

/// CLI11's own lets NaN pass, and says what it expects with 309 digits.
CLI::Validator positive_number(bool or_zero = false) {
  return CLI::Validator(
      [or_zero](std::string& text) -> std::string {
        const auto number = parse_numbers(text);
        if (number && number->size() == 1 &&
            (number->front() > 0 || (or_zero && number->front() == 0)))
          return {};
        return fmt::format("a {} number is expected, not {}", or_zero ? "non-negative" : "positive",
                           text);
      },
      or_zero ? "NONNEGATIVE" : "POSITIVE");
}

void add_construction_options(CLI::App& command, PointMeshOptions& options) {
  command
      .add_option("--grid", options.refinement,
                  "how the 5x5 grid around each point is made (Section 2.1)")
      ->transform(CLI::CheckedTransformer(kGrids))
      ->option_text("6x6|5x5 (default 6x6)")
      ->needs("--points");
  command
      .add_option("--two-two", options.two_two,
                  "stitching two split cells without extra points (Fig. 8a)")
      ->transform(CLI::CheckedTransformer(kTwoTwo))
      ->option_text("exact|paper (default exact)")
      ->needs("--points");
  command.add_option("--warp", options.warping, "warping to the points (Section 2.4.3)")
      ->transform(CLI::CheckedTransformer(kWarpings))
      ->option_text("aligned|paper (default aligned)")
      ->needs("--points");
  command.add_option("--max-cells", options.budget.max_cells, "stop beyond so many quadtree cells")
      ->check(CLI::Range(std::uint64_t{1}, kMostCells))
      ->capture_default_str();
  command.add_option("--max-seconds", options.budget.max_seconds, "stop beyond so many seconds")
      ->check(positive_number(true))
      ->capture_default_str();
}

/// Numbers separated by commas; CLI11's own lists would swallow the options' next values.
CLI::Validator numbers_with_size() {
  return CLI::Validator(
      [](std::string& text) -> std::string {
        const auto numbers = parse_numbers(text);
        if (!numbers || (numbers->size() != 3 && numbers->size() != 5) || !(numbers->back() > 0))
          return "X,Y,SIZE or X0,Y0,X1,Y1,SIZE with a positive size is expected";
        return {};
      },
      "X,Y,SIZE|X0,Y0,X1,Y1,SIZE");
}

void add_polygon_options(CLI::App& command, MeshOptions& options) {
  command
      .add_option("--insertion", options.insertion,
                  "how edges, corners and kites are meshed: by our search, or by the paper's cases "
                  "(Lemmas 11 and 12, Section 4), which break the bounds on most polygons")
      ->transform(CLI::CheckedTransformer(kInsertions))
      ->option_text("search|paper (default search)");
  command
      .add_option("--max-size", options.sizing.largest,
                  "no quadtree cell inside is wider than this")
      ->check(positive_number());
  command
      .add_option("--refine-near", options.refine_near,
                  "cells of at most SIZE at a point or a segment, growing with half the distance; "
                  "may be repeated")
      ->check(numbers_with_size());
  command.add_option("--size-field", options.size_field,
                     "file with lines X,Y,SIZE, each as with --refine-near");
  command
      .add_option("--boundary-size", options.sizing.boundary_size,
                  "no wider than this at the boundary")
      ->check(positive_number());
  command
      .add_option("--boundary-growth", options.sizing.boundary_growth,
                  "and this part of the distance to it more inside")
      ->check(positive_number(true))
      ->needs("--boundary-size");
  for (const char* name :
       {"--insertion", "--max-size", "--refine-near", "--size-field", "--boundary-size"})
    command.get_option(name)->excludes("--points");
}

}  // namespace

void add_mesh_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<MeshOptions>();
  CLI::App* command =
      app.add_subcommand("mesh", "mesh a polygon, or a point set, and prove the mesh");
  command->footer(kFooter);
  command->add_flag("--points", options->points,
                    "INPUT is a set of points (thm-1), not a polygon (thm-13)");
  command
      ->add_option("INPUT", options->input,
                   "polygon: .geojson .json .poly .wkt; points: .csv .node .xyz .txt")
      ->required();
  command
      ->add_option("-o,--output", options->outputs,
                   "where to write, format by extension; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--report", options->report, "write the judge's report as JSON");
  command->add_option("--statistics", options->statistics,
                      "write sizes, shapes, degrees and constructions as JSON");
  command->add_flag("--no-verify", options->no_verify, "do not prove the mesh before writing");
  command->add_option("--threads", options->threads, "threads of the proof, 0 for all cores")
      ->capture_default_str();
  command->add_flag("-q,--quiet", options->quiet, "no summary");
  add_construction_options(*command, options->mesh);
  add_polygon_options(*command, *options);
  add_picture_options(*command, *options);
  command->callback([options, &outcome] { outcome.status = mesh(*options); });
}

}  // namespace quadbound::cli
