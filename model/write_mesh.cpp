// SPDX-License-Identifier: Apache-2.0
#include "model/write_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <ostream>
#include <string_view>
#include <utility>

#include "model/files.hpp"
#include "model/write_json.hpp"
#include "model/write_msh.hpp"
#include "model/write_obj.hpp"
#include "model/write_vtu.hpp"

namespace quadbound {
namespace {

constexpr std::array<std::pair<std::string_view, OutputFormat>, 7> kExtensions{{
    {".json", OutputFormat::kJson},
    {".vtu", OutputFormat::kVtu},
    {".msh", OutputFormat::kMsh},
    {".obj", OutputFormat::kObj},
    {".svg", OutputFormat::kSvg},
    {".pdf", OutputFormat::kPdf},
    {".png", OutputFormat::kPng},
}};

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

bool is_picture(OutputFormat format) {
  return format == OutputFormat::kSvg || format == OutputFormat::kPdf ||
         format == OutputFormat::kPng;
}

void refuse_what_cannot_be(const std::string& path, OutputFormat format, const Mesh& mesh,
                           const WriteOptions& options) {
  if (format == OutputFormat::kMsh && !can_be_msh(mesh))
    throw WriteRefused(
        fmt::format("{}: MSH has only quads and triangles, and the mesh has a face "
                    "with another number of sides",
                    path));
  if (!is_picture(format)) return;
  if (const auto problem = picture_problem(mesh, options.picture))
    throw WriteRefused(fmt::format("{}: {}", path, *problem));
}

void write_as(OutputFormat format, std::ostream& stream, const Mesh& mesh,
              const PictureOptions& picture) {
  switch (format) {
    case OutputFormat::kJson:
      return write_json(stream, mesh);
    case OutputFormat::kVtu:
      return write_vtu(stream, mesh);
    case OutputFormat::kMsh:
      return write_msh(stream, mesh);
    case OutputFormat::kObj:
      return write_obj(stream, mesh);
    case OutputFormat::kSvg:
      return write_svg(stream, mesh, picture);
    case OutputFormat::kPdf:
      return write_pdf(stream, mesh, picture);
    case OutputFormat::kPng:
      return write_png(stream, mesh, picture);
  }
}

}  // namespace

OutputFormat output_format(const std::string& path) {
  if (path == "-") return OutputFormat::kJson;
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  for (const auto& [known, format] : kExtensions)
    if (extension == known) return format;
  std::string all;
  for (const auto& [known, format] : kExtensions) all += fmt::format(" {}", known);
  throw WriteRefused(
      extension.empty()
          ? fmt::format("{}: the name has no extension to tell the format; there are{}", path, all)
          : fmt::format("{}: unknown extension {}; there are{}", path, extension, all));
}

void write_mesh(const std::string& path, const Mesh& mesh, const WriteOptions& options) {
  const OutputFormat format = options.format ? *options.format : output_format(path);
  refuse_what_cannot_be(path, format, mesh, options);
  write_file(path, [&](std::ostream& stream) { write_as(format, stream, mesh, options.picture); });
}

}  // namespace quadbound
