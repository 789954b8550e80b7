// SPDX-License-Identifier: Apache-2.0
#pragma once
// `quadbound reproduce`: measures what the paper reports again and writes the results.

#include <string>
#include <vector>

#include "paper/claims.hpp"
#include "paper/reproduction.hpp"
#include "paper/watcher.hpp"

namespace quadbound {

struct ReproduceOptions {
  std::string out = "results";  ///< made if it is not there
  std::string command;          ///< for the report
  MeasureOptions measure;
};

struct ReproduceResult {
  bool holds = false;
  std::vector<PaperClaim> claims;
  std::string report;  ///< the HTML file
};

/// Files: fig-10-whole and fig-10-magnified (.svg, .png), fig-46 to fig-53 and plate (.svg, .pdf),
/// fig-10, fig-46, fig-49, fig-50, plate -report.json, n-against-N (.csv, .svg), reproduction
/// (.json, .md, .html), machine.json. The page has the viewer's meshes, and the records of results/
/// beside the data's paper/ where there are some.
///
/// Guarantees: 1. the same options and data give the same bytes in every file but machine.json, on
/// machines with the same graphics library. 2. Each file is written whole or not at all.
/// Errors: InputError for the data, OutputError for the folder. Complexity: see measure().
ReproduceResult reproduce(const ReproduceOptions& options, Watcher& watcher);

/// The folder with the paper's inputs: paper/data here or in a folder above, or else where the
/// program was built. Errors: InputError.
std::string find_data_folder();

/// What `git describe` said when the program was built, or "unknown".
std::string build_commit();

}  // namespace quadbound
