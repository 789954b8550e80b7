// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <new>
#include <string>

#include "cli/commands.hpp"
#include "generators/recipe.hpp"
#include "model/errors.hpp"
#include "model/files.hpp"
#include "model/write_mesh.hpp"

namespace {

using namespace quadbound::cli;

constexpr const char* kFooter =
    R"(Exit status: 0 good, 1 a claim failed, 2 bad input or usage, 3 a budget ran out.

Examples:
  quadbound generate uniform --n 1000 --seed 1 -o points.csv
  quadbound mesh --points points.csv -o mesh.json -o mesh.svg
  quadbound verify --points points.csv mesh.json
  quadbound prove theorem-1
  quadbound fuzz --count 1000
  quadbound fuzz --points --count 1000)";

/// Ctrl-C leaves no half-written file behind; then it ends the program as ever.
extern "C" void interrupted(int number) {
  quadbound::remove_unfinished_file();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

int run(int argc, char** argv) {
  CLI::App app{"Quadrilateral meshes with proved angle bounds (Atalay, Ramaswami, Xu 2012).",
               "quadbound"};
  app.footer(kFooter);
  app.set_version_flag("--version", "quadbound " QUADBOUND_VERSION);
  app.require_subcommand(0, 1);  // none at all is told below; a word that is no command is named
  Outcome outcome;
  add_mesh_command(app, outcome);
  add_verify_command(app, outcome);
  add_generate_command(app, outcome);
  add_prove_command(app, outcome);
  add_fuzz_command(app, outcome);
  add_reproduce_command(app, outcome);
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) throw CLI::RequiredError("A command");
  } catch (const CLI::Success& success) {  // --help, --version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "quadbound: {} (see quadbound --help)\n", error.what());
    return kBadInput;
  }
  return outcome.status;
}

}  // namespace

int main(int argc, char** argv) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(number, interrupted) == SIG_IGN)
      std::signal(number, SIG_IGN);  // as under nohup
  try {
    return run(argc, argv);
  } catch (const quadbound::InputError& error) {
    fmt::print(stderr, "quadbound: {}\n", error.what());
  } catch (const quadbound::OutputError& error) {
    fmt::print(stderr, "quadbound: {}\n", error.what());
  } catch (const quadbound::WriteRefused& error) {
    fmt::print(stderr, "quadbound: {}\n", error.what());
  } catch (const quadbound::RecipeError& error) {
    fmt::print(stderr, "quadbound: {}\n", error.what());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "quadbound: out of memory; lower --max-cells to be told before\n");
    return kBudgetRanOut;
  } catch (const std::exception& error) {
    fmt::print(stderr, "quadbound: {}\n", error.what());
  }
  return kBadInput;
}
