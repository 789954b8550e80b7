// SPDX-License-Identifier: Apache-2.0
#pragma once
// A mesh into a file of any format we write.

#include <optional>
#include <stdexcept>
#include <string>

#include "model/mesh.hpp"
#include "model/picture.hpp"

namespace quadbound {

enum class OutputFormat { kJson, kVtu, kMsh, kObj, kSvg, kPdf, kPng };

struct WriteOptions {
  std::optional<OutputFormat> format;  ///< instead of the one that the file name tells
  PictureOptions picture;              ///< for SVG, PDF and PNG
};

/// What was asked for cannot be written: an unknown extension, a picture coloured by something that
/// the mesh does not have, a face that the format has no room for. The program turns it into exit
/// status 2.
class WriteRefused : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The format that a file name tells: .json .vtu .msh .obj .svg .pdf .png in any case; "-"
/// (standard output) is JSON.
/// Errors: WriteRefused, on one line that names the file and the extensions there are.
OutputFormat output_format(const std::string& path);

/// Guarantees: 1. all that WriteRefused tells is found before anything is written. 2. The file
/// holds either all of the new content or what it held before (see files.hpp). 3. The same mesh and
/// options give the same bytes; in pictures with text, on machines with the same fonts.
/// Requires: all ids in the mesh are vertices of it; construction and level are empty or as long as
/// quads; construction indexes construction_names.
/// Errors: WriteRefused, OutputError.
void write_mesh(const std::string& path, const Mesh& mesh, const WriteOptions& options = {});

}  // namespace quadbound
