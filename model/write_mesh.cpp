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

constexpr std::array<std::pair<std::string_view, MeshFormat>, 7> kExtensions{{
    {".json", MeshFormat::kJson},
    {".vtu", MeshFormat::kVtu},
    {".msh", MeshFormat::kMsh},
    {".obj", MeshFormat::kObj},
    {".svg", MeshFormat::kSvg},
    {".pdf", MeshFormat::kPdf},
    {".png", MeshFormat::kPng},
}};

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

bool is_picture(MeshFormat format) {
  return format == MeshFormat::kSvg || format == MeshFormat::kPdf || format == MeshFormat::kPng;
}

void refuse_what_cannot_be(const std::string& path, MeshFormat format, const Mesh& mesh,
                           const WriteOptions& options) {
  if (format == MeshFormat::kMsh && !can_be_msh(mesh))
    throw WriteRefused(
        fmt::format("{}: MSH has only quads and triangles, and the mesh has a face "
                    "with another number of sides",
                    path));
  if (!is_picture(format)) return;
  if (const auto problem = picture_problem(mesh, options.picture))
    throw WriteRefused(fmt::format("{}: {}", path, *problem));
}

void write_as(MeshFormat format, std::ostream& stream, const Mesh& mesh,
              const PictureOptions& picture) {
  switch (format) {
    case MeshFormat::kJson:
      return write_json(stream, mesh);
    case MeshFormat::kVtu:
      return write_vtu(stream, mesh);
    case MeshFormat::kMsh:
      return write_msh(stream, mesh);
    case MeshFormat::kObj:
      return write_obj(stream, mesh);
    case MeshFormat::kSvg:
      return write_svg(stream, mesh, picture);
    case MeshFormat::kPdf:
      return write_pdf(stream, mesh, picture);
    case MeshFormat::kPng:
      return write_png(stream, mesh, picture);
  }
}

}  // namespace

MeshFormat mesh_format(const std::string& path) {
  if (path == "-") return MeshFormat::kJson;
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
  const MeshFormat format = options.format ? *options.format : mesh_format(path);
  refuse_what_cannot_be(path, format, mesh, options);
  write_file(path, [&](std::ostream& stream) { write_as(format, stream, mesh, options.picture); });
}

}  // namespace quadbound
