// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "model/files.hpp"
#include "model/read_mesh.hpp"
#include "model/read_points.hpp"
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

ExitStatus verify(const VerifyCommand& options) {
  if (!options.points)
    throw CLI::ValidationError("--points",
                               "is needed: this version judges sets of points, not polygons");
  Progress progress;
  progress.stage("reading");
  const PointSet points = read_points(options.input);
  validate(points);
  const Mesh mesh = read_mesh(options.mesh);
  progress.stage("judging");
  VerifyOptions verify_options;
  verify_options.threads = options.threads;
  const Report report = verify_points(points, mesh, verify_options);
  if (!options.report.empty())
    write_file(options.report, [&report](std::ostream& stream) { stream << to_json(report); });
  if (!options.quiet) fmt::print("{}", to_text(report));
  return report.holds() ? kGood : kClaimFailed;
}

constexpr const char* kFooter =
    R"(Any mesh: ours, or anyone's from gmsh or OBJ. Every verdict is exact.

Examples:
  quadbound verify --points points.csv mesh.json
  quadbound verify --points points.csv mesh.msh --report report.json)";

}  // namespace

void add_verify_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<VerifyCommand>();
  CLI::App* command = app.add_subcommand("verify", "judge a mesh, claim by claim");
  command->footer(kFooter);
  command->add_flag("--points", options->points, "INPUT is a set of points (thm-1)");
  command->add_option("INPUT", options->input, "points: .csv .node .xyz .txt")->required();
  command->add_option("MESH", options->mesh, "mesh: .json .msh .obj")->required();
  command->add_option("--report", options->report,
                      "write the report as JSON (- for standard output)");
  command->add_option("--threads", options->threads, "threads, 0 for all cores")
      ->capture_default_str();
  command->add_flag("-q,--quiet", options->quiet, "only the exit status");
  command->callback([options, &outcome] { outcome.status = verify(*options); });
}

}  // namespace quadbound::cli
