// SPDX-License-Identifier: Apache-2.0
#pragma once
// A campaign of polygons over MPI: rank 0 hands out the cases and keeps journal, findings and
// summary; the other ranks try them, in as many child processes each as --threads says.

#include "cli/campaign.hpp"

namespace quadbound::cli {

/// Runs on every rank of `mpirun quadbound fuzz --mpi ...`.
///
/// Guarantees: 1. journal, findings and summary are those of a campaign without MPI. 2. The cases
/// of a rank that is lost are given to others, where mpirun lets these live (Open MPI 4:
/// --enable-recovery); where it ends them all, rank 0 writes the summary so far, and --resume goes
/// on. 3. Only rank 0 prints.
/// Errors: as without MPI; and for fewer than two ranks.
ExitStatus fuzz_over_mpi(const FuzzOptions& options);

}  // namespace quadbound::cli
