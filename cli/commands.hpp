// SPDX-License-Identifier: Apache-2.0
#pragma once
// The commands of the program. Each adds its options to the command line and sets `status` when it
// was asked for and ran.

#include <CLI/CLI.hpp>
#include <optional>

namespace quadbound::cli {

enum ExitStatus : int { kGood = 0, kClaimFailed = 1, kBadInput = 2, kBudgetRanOut = 3 };

struct Outcome {
  ExitStatus status = kGood;
};

void add_mesh_command(CLI::App& app, Outcome& outcome);
void add_verify_command(CLI::App& app, Outcome& outcome);
void add_generate_command(CLI::App& app, Outcome& outcome);
void add_prove_command(CLI::App& app, Outcome& outcome);
void add_fuzz_command(CLI::App& app, Outcome& outcome);
void add_reproduce_command(CLI::App& app, Outcome& outcome);

}  // namespace quadbound::cli
