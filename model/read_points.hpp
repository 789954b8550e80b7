// SPDX-License-Identifier: Apache-2.0
#pragma once
// Point sets from text files.

#include <optional>
#include <string>
#include <string_view>

#include "model/polygon.hpp"

namespace quadbound {

enum class PointFormat {
  kCsv,   ///< .csv: "x,y" lines; with a header, other columns beside x and y are skipped
  kNode,  ///< .node: Triangle's vertices, numbered from 0 or 1
  kXyz,   ///< .xyz: "x y" or "x y z" lines, z ignored
  kText,  ///< .txt: "x y" lines
};

/// The format that a file name tells. Errors: InputError, on one line that names the extensions
/// there are.
PointFormat point_format(const std::string& path);

/// Reads a point set; the format goes by the extension unless it is given. "-" is standard input
/// and needs a format.
///
/// Guarantees: 1. every coordinate is the double nearest to the decimal number in the file, in
/// every locale. 2. The order of the file is kept. 3. A byte-order mark, blank lines and carriage
/// returns are skipped, and '#' comments in all formats but .csv.
/// Not checked here: that the set is not empty and that no point occurs twice (see validate).
/// Errors: InputError with the line and the point (as "vertex", counted from 0).
PointSet read_points(const std::string& path, std::optional<PointFormat> format = {});

/// The same for a text in memory; `file` is the name in messages.
PointSet parse_points(std::string_view text, PointFormat format, std::string file);

}  // namespace quadbound
