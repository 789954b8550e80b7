// SPDX-License-Identifier: Apache-2.0
#include "model/read_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "model/errors.hpp"
#include "model/files.hpp"
#include "model/text_scanner.hpp"
#include "model/triangle_vertices.hpp"

namespace quadbound {
namespace {

using Points = std::vector<Point>;

std::vector<std::string_view> split_at_commas(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t end = line.find(',', begin);
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    if (end == std::string_view::npos) return cells;
    begin = end + 1;
  }
}

/// Where x and y stand in a line of a .csv file.
struct Columns {
  std::size_t x = 0;
  std::size_t y = 1;
  std::size_t count = 2;
};

std::string_view without_quotation_marks(std::string_view cell) {
  if (cell.size() >= 2 && cell.starts_with('"') && cell.ends_with('"'))
    return cell.substr(1, cell.size() - 2);
  return cell;
}

Columns header_columns(const TextScanner& scanner, const std::vector<std::string_view>& cells) {
  std::optional<std::size_t> x;
  std::optional<std::size_t> y;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string_view name = without_quotation_marks(cells[i]);
    const bool is_x = equals_ignoring_case(name, "x");
    if (!is_x && !equals_ignoring_case(name, "y")) continue;
    auto& column = is_x ? x : y;
    if (column) scanner.fail("the header names a column twice");
    column = i;
  }
  if (!x || !y) scanner.fail("the header must name a column x and a column y");
  return {*x, *y, cells.size()};
}

bool names_a_coordinate(const std::vector<std::string_view>& cells) {
  return std::any_of(cells.begin(), cells.end(), [](std::string_view cell) {
    const std::string_view name = without_quotation_marks(cell);
    return equals_ignoring_case(name, "x") || equals_ignoring_case(name, "y");
  });
}

Points parse_csv(TextScanner& scanner) {
  Points points;
  std::optional<Columns> columns;
  while (scanner.next_line()) {
    const auto cells = split_at_commas(scanner.line());
    if (!columns && names_a_coordinate(cells)) {
      columns = header_columns(scanner, cells);
      continue;
    }
    if (!columns) columns = Columns{};
    if (cells.size() != columns->count)
      scanner.fail(fmt::format("{} columns instead of {}", cells.size(), columns->count),
                   points.size());
    points.push_back({scanner.number(cells[columns->x], points.size()),
                      scanner.number(cells[columns->y], points.size())});
  }
  return points;
}

Points parse_node(TextScanner& scanner) {
  Points points = read_triangle_vertices(scanner).points;
  if (scanner.next_line()) scanner.fail("text after the last vertex");
  return points;
}

Points parse_columns(TextScanner& scanner, std::size_t most) {
  Points points;
  while (scanner.next_line()) {
    const auto& fields = scanner.fields();
    if (fields.size() < 2 || fields.size() > most)
      scanner.fail(
          fmt::format("{} columns instead of {}", fields.size(), most == 2 ? "2" : "2 or 3"),
          points.size());
    for (std::size_t i = 2; i < fields.size(); ++i) (void)scanner.number(fields[i], points.size());
    points.push_back(
        {scanner.number(fields[0], points.size()), scanner.number(fields[1], points.size())});
  }
  return points;
}

}  // namespace

PointFormat point_format(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".csv") return PointFormat::kCsv;
  if (extension == ".node") return PointFormat::kNode;
  if (extension == ".xyz") return PointFormat::kXyz;
  if (extension == ".txt") return PointFormat::kText;
  throw InputError({file_name_of(path), {}, {}},
                   path == "-"
                       ? "the format of the points must be given"
                       : "not a point file: the extension must be .csv, .node, .xyz or .txt");
}

PointSet parse_points(std::string_view text, PointFormat format, std::string file) {
  if (trimmed(without_byte_order_mark(text)).empty())
    throw InputError({std::move(file), {}, {}}, "the file is empty");
  TextScanner scanner(
      text, file,
      format == PointFormat::kCsv ? TextScanner::Comments::kNone : TextScanner::Comments::kHash);
  switch (format) {
    case PointFormat::kCsv:
      return {std::move(file), parse_csv(scanner)};
    case PointFormat::kNode:
      return {std::move(file), parse_node(scanner)};
    case PointFormat::kXyz:
      return {std::move(file), parse_columns(scanner, 3)};
    case PointFormat::kText:
      break;
  }
  return {std::move(file), parse_columns(scanner, 2)};
}

PointSet read_points(const std::string& path, std::optional<PointFormat> format) {
  const PointFormat known = format ? *format : point_format(path);
  return parse_points(read_file(path), known, file_name_of(path));
}

}  // namespace quadbound
