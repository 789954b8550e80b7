// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "model/files.hpp"
#include "model/read_mesh.hpp"
#include "model/read_points.hpp"
#include "model/read_polygon.hpp"
#include "model/validate.hpp"
#include "verify/verify.hpp"

namespace quadbound::cli {
namespace {

struct VerifyCommand {
  bool points = false;
  std::string input;
  std::string mesh;
  std::string report;
  bool quiet = false;
  unsigned threads = 1;
};

Report judge_points(const VerifyCommand& options, const VerifyOptions& verify_options,
                    Progress& progress) {
  const PointSet points = read_points(options.input);
  validate(points);
  const Mesh mesh = read_mesh(options.mesh);
  progress.stage("judging");
  return verify_points(points, mesh, verify_options);
}

Report judge_polygon(const VerifyCommand& options, const VerifyOptions& verify_options,
                     Progress& progress) {
  const Polygon polygon = normalised(read_polygon(options.input));
  const Mesh mesh = read_mesh(options.mesh);
  progress.stage("judging");
  return verify_polygon(polygon, mesh, verify_options);
}

ExitStatus verify(const VerifyCommand& options) {
  Progress progress;
  progress.stage("reading");
  VerifyOptions verify_options;
  verify_options.threads = options.threads;
  const Report report = options.points ? judge_points(options, verify_options, progress)
                                       : judge_polygon(options, verify_options, progress);
  if (!options.report.empty())
    write_file(options.report, [&report](std::ostream& stream) { stream << to_json(report); });
  if (!options.quiet) fmt::print("{}", to_text(report));
  // Not decided is no failure by itself: nobody else's mesh says how many cells it comes from, and
  // any other claim is left undecided only where one fails.
  const bool fails = std::any_of(report.claims.begin(), report.claims.end(),
                                 [](const Claim& claim) { return claim.exact == Verdict::fails; });
  return fails ? kClaimFailed : kGood;
}

constexpr const char* kFooter =
    R"(Any mesh: ours, or anyone's from gmsh or OBJ. Every verdict is exact. A polygon's boundary must
be kept exactly; input angles that no quad splits are listed and not judged by the bounds. Status 1
where a claim fails; the size is not decided where a mesh does not say its number of cells.

Examples:
  quadbound verify lake.geojson mesh.json
  quadbound verify plate.poly mesh.msh --report report.json
  quadbound verify --points points.csv mesh.json)";

}  // namespace

void add_verify_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<VerifyCommand>();
  CLI::App* command = app.add_subcommand("verify", "judge a mesh, claim by claim");
  command->footer(kFooter);
  command->add_flag("--points", options->points,
                    "INPUT is a set of points (thm-1), not a polygon (thm-13)");
  command
      ->add_option("INPUT", options->input,
                   "polygon: .geojson .json .poly .wkt; points: .csv .node .xyz .txt")
      ->required();
  command->add_option("MESH", options->mesh, "mesh: .json .msh .obj")->required();
  command->add_option("--report", options->report,
                      "write the report as JSON (- for standard output)");
  command->add_option("--threads", options->threads, "threads, 0 for all cores")
      ->capture_default_str();
  command->add_flag("-q,--quiet", options->quiet, "only the exit status");
  command->callback([options, &outcome] { outcome.status = verify(*options); });
}

}  // namespace quadbound::cli
