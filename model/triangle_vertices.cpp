// SPDX-License-Identifier: Apache-2.0
#include "model/triangle_vertices.hpp"

#include <fmt/format.h>

namespace quadbound {
namespace {

struct Header {
  std::uint64_t count = 0;
  std::uint64_t extra_fields = 0;
};

Header read_header(TextScanner& scanner) {
  scanner.require_line("the vertex counts");
  const auto& fields = scanner.fields();
  if (fields.size() < 2 || fields.size() > 4)
    scanner.fail("expected \"vertices dimension attributes markers\"");
  if (scanner.count(fields[1]) != 2) scanner.fail("the dimension is not 2");
  Header header{scanner.count(fields[0]), 0};
  for (std::size_t i = 2; i < fields.size(); ++i) header.extra_fields += scanner.count(fields[i]);
  return header;
}

}  // namespace

TriangleVertices read_triangle_vertices(TextScanner& scanner) {
  const Header header = read_header(scanner);
  TriangleVertices vertices;
  for (std::size_t i = 0; i < header.count; ++i) {
    if (!scanner.next_line())
      scanner.fail(fmt::format("the file ends after {} of {} vertices", i, header.count));
    const auto& fields = scanner.fields();
    if (fields.size() < 3 || fields.size() - 3 > header.extra_fields)
      scanner.fail(fmt::format("{} fields in the line of a vertex", fields.size()), i);
    const std::uint64_t number = scanner.count(fields[0], i);
    if (i == 0 && number <= 1) vertices.first_number = number;
    if (number != vertices.first_number + i)
      scanner.fail(
          fmt::format("vertex number {} where {} is due", number, vertices.first_number + i), i);
    for (std::size_t k = 3; k < fields.size(); ++k) (void)scanner.number(fields[k], i);
    vertices.points.push_back({scanner.number(fields[1], i), scanner.number(fields[2], i)});
  }
  return vertices;
}

}  // namespace quadbound
