// SPDX-License-Identifier: Apache-2.0
#include "model/write_points.hpp"

#include <fmt/format.h>

#include <ostream>
#include <string>

namespace quadbound {
namespace {

std::string line_of(const Point& p, std::size_t number, PointFormat format) {
  switch (format) {
    case PointFormat::kCsv:
      return fmt::format("{},{}\n", p.x, p.y);
    case PointFormat::kNode:
      return fmt::format("{} {} {}\n", number, p.x, p.y);
    case PointFormat::kXyz:
    case PointFormat::kText:
      break;
  }
  return fmt::format("{} {}\n", p.x, p.y);
}

}  // namespace

void write_points(std::ostream& stream, const PointSet& points, PointFormat format) {
  if (format == PointFormat::kCsv) stream << "x,y\n";
  if (format == PointFormat::kNode) stream << points.points.size() << " 2 0 0\n";
  for (std::size_t i = 0; i < points.points.size(); ++i)
    stream << line_of(points.points[i], i, format);
}

}  // namespace quadbound
