// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "algo/mesh_points.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "model/files.hpp"
#include "model/read_points.hpp"
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
  bool no_verify = false;
  bool quiet = false;
  unsigned threads = 1;
  PointMeshOptions mesh;
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
const std::map<std::string, PictureColour> kColours{{"none", PictureColour::kNone},
                                                    {"min-angle", PictureColour::kMinAngle},
                                                    {"max-angle", PictureColour::kMaxAngle},
                                                    {"construction", PictureColour::kConstruction},
                                                    {"level", PictureColour::kLevel}};

WriteOptions write_options(const MeshOptions& options, const PointSet& points) {
  WriteOptions write;
  write.picture.colour = options.colour;
  if (options.dots) write.picture.points = points.points;
  if (options.window.size() == 4)
    write.picture.window = {{options.window[0], options.window[1]},
                            {options.window[2], options.window[3]}};
  return write;
}

std::string summary(const PointMesh& made) {
  const auto n = static_cast<double>(made.mesh.input_vertices);
  const auto cells = static_cast<double>(made.mesh.cells);
  const auto quads = static_cast<double>(made.mesh.quads.size());
  return fmt::format(
      "{} points, N = {} cells (N/n = {:.2f}), {} vertices, {} quads (quads/N = {:.3f})",
      made.mesh.input_vertices, made.mesh.cells, cells / n, made.mesh.vertices.size(),
      made.mesh.quads.size(), quads / cells);
}

/// Whether every claim holds; says on standard error which do not.
bool proved(const Report& report) {
  for (const Claim& claim : report.claims) {
    if (claim.exact == Verdict::holds || claim.id == report.theorem) continue;
    fmt::print(stderr, "quadbound: claim {} {}: {}\n", claim.id, name(claim.exact), claim.detail);
  }
  return report.holds();
}

ExitStatus mesh(const MeshOptions& options) {
  if (!options.points)
    throw CLI::ValidationError("--points",
                               "is needed: this version meshes sets of points, not polygons");
  for (const std::string& path : options.outputs) output_format(path);  // refuse before the work
  Progress progress;
  progress.stage("reading");
  const PointSet points = read_points(options.input);
  validate(points);
  progress.stage("building the quadtree and the quads");
  const PointMeshResult result = mesh_points(points, options.mesh);
  if (const auto* refusal = std::get_if<Refusal>(&result)) {
    fmt::print(stderr, "quadbound: {}: {}\n", options.input, refusal->message);
    return kBudgetRanOut;
  }
  const PointMesh& made = std::get<PointMesh>(result);
  if (!options.no_verify) {
    progress.stage("proving the mesh");
    VerifyOptions verify;
    verify.threads = options.threads;
    const Report report = verify_points(points, made.mesh, verify);
    if (!options.report.empty())
      write_file(options.report, [&report](std::ostream& stream) { stream << to_json(report); });
    if (!proved(report)) {
      fmt::print(stderr,
                 "quadbound: nothing was written; --no-verify writes the mesh all the same\n");
      return kClaimFailed;
    }
  }
  progress.stage("writing");
  for (const std::string& path : options.outputs)
    write_mesh(path, made.mesh, write_options(options, points));
  if (!options.quiet)
    fmt::print(stderr, "{}; {}\n", summary(made),
               options.no_verify ? "not verified" : "thm-1 proved");
  return kGood;
}

constexpr const char* kFooter = R"(Examples:
  quadbound mesh --points points.csv -o mesh.json
  quadbound mesh --points points.csv -o mesh.vtu -o mesh.msh -o mesh.svg --colour min-angle
  quadbound mesh --points points.csv --report proof.json
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

void add_construction_options(CLI::App& command, PointMeshOptions& options) {
  command
      .add_option("--grid", options.refinement,
                  "how the 5x5 grid around each point is made (Section 2.1)")
      ->transform(CLI::CheckedTransformer(kGrids))
      ->option_text("6x6|5x5 (default 6x6)");
  command
      .add_option("--two-two", options.two_two,
                  "stitching two split cells without extra points (Fig. 8a)")
      ->transform(CLI::CheckedTransformer(kTwoTwo))
      ->option_text("exact|paper (default exact)");
  command.add_option("--warp", options.warping, "warping to the points (Section 2.4.3)")
      ->transform(CLI::CheckedTransformer(kWarpings))
      ->option_text("aligned|paper (default aligned)");
  command.add_option("--max-cells", options.budget.max_cells, "stop beyond so many quadtree cells")
      ->check(CLI::Range(std::uint64_t{1}, kMostCells))
      ->capture_default_str();
  command
      .add_option("--max-seconds", options.budget.max_seconds,
                  "stop the tree beyond so many seconds")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

}  // namespace

void add_mesh_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<MeshOptions>();
  CLI::App* command = app.add_subcommand("mesh", "mesh a point set and prove the mesh");
  command->footer(kFooter);
  command->add_flag("--points", options->points, "INPUT is a set of points (thm-1)");
  command->add_option("INPUT", options->input, "points: .csv .node .xyz .txt")->required();
  command
      ->add_option("-o,--output", options->outputs,
                   "where to write, format by extension; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--report", options->report, "write the judge's report as JSON");
  command->add_flag("--no-verify", options->no_verify, "do not prove the mesh before writing");
  command->add_option("--threads", options->threads, "threads of the proof, 0 for all cores")
      ->capture_default_str();
  command->add_flag("-q,--quiet", options->quiet, "no summary");
  add_construction_options(*command, options->mesh);
  add_picture_options(*command, *options);
  command->callback([options, &outcome] { outcome.status = mesh(*options); });
}

}  // namespace quadbound::cli
