// SPDX-License-Identifier: Apache-2.0
#pragma once
// A reproduction as texts: JSON, CSV, and the report for readers.

#include <string>
#include <vector>

#include "paper/document.hpp"
#include "paper/reproduction.hpp"
#include "paper/viewer_mesh.hpp"

namespace quadbound {

/// What made the numbers.
struct Provenance {
  std::string command;
  std::string commit;
};

/// {"format": "quadbound-reproduction", "version": 1, ...}: all numbers; exact angles as "cross"
/// over "dot" in lowest terms ("tan"), null at a right angle.
/// Guarantees: 1. equal measurements give equal bytes; no times.
std::string reproduction_json(const Reproduction& reproduction, const Provenance& provenance);

/// One line per mesh of the experiment 80n.
std::string n_against_n_csv(const Reproduction& reproduction);

/// Name of the processor, number of cores and seconds per step: the one file with times.
std::string machine_json(const Reproduction& reproduction);

/// The pictures' bytes for the HTML; the Markdown links to the files of the same names.
struct ReportPictures {
  std::vector<DocumentPicture> polygons;
  std::vector<DocumentPicture> shapes;  ///< fig-44 and fig-45
  std::string chart;      ///< n-against-N.svg
  std::string whole;      ///< fig-10-whole.png
  std::string magnified;  ///< fig-10-magnified.png
  std::vector<ViewerMesh> meshes;
  std::vector<ViewerView> views;
};
/// `records` are the experiments that other commands measured.
Document reproduction_report(const Reproduction& reproduction, const Provenance& provenance,
                             const ReportPictures& pictures, const PageBlock& records);

}  // namespace quadbound
