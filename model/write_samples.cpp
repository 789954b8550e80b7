// SPDX-License-Identifier: Apache-2.0
#include "model/write_samples.hpp"

#include <map>

namespace quadbound {
namespace {

RationalPoint point(double x, double y) { return exact_value(Point{x, y}); }

/// A parallelogram grid whose coordinates are sums of rounded decimals.
Mesh offset_grid(double offset, double step) {
  const auto place = [=](int column, int row) {
    return point(offset + step * column + step * 0.3 * row, -offset + step * 1.1 * row);
  };
  std::vector<Point> corners;
  for (int column = 0; column <= 4; ++column)
    for (int row = 0; row <= 3; ++row) {
      const RationalPoint corner = place(column, row);
      corners.push_back({nearest_double(corner.x), nearest_double(corner.y)});
    }
  return sample_grid(4, 3, common_exponent(corners), place);
}

Mesh thirds() {
  return sample_grid(3, 3, -20, [](int column, int row) {
    return RationalPoint{Rational(column, 3), Rational(row * 2 + (column % 2), 7)};
  });
}

Mesh with_hole() {
  const auto place = [](int column, int row) { return point(column, row); };
  return sample_grid(5, 4, 0, place, [](int column, int row) {
    return !(column >= 1 && column <= 2 && row == 1) && !(column == 3 && row == 2);
  });
}

Mesh touching_parts() {
  const auto place = [](int column, int row) { return point(column, row); };
  return sample_grid(2, 2, 0, place, [](int column, int row) { return column == row; });
}

Mesh with_triangles() {
  Mesh mesh = sample_grid(2, 1);
  const VertexId tip = mesh.vertices.add_exact(point(3, 0.5));
  mesh.other_faces = {{4, tip, 5}};
  return mesh;
}

Mesh with_constructions() {
  Mesh mesh = sample_grid(4, 3);
  mesh.cells = 21;
  mesh.input_vertices = 4;
  mesh.construction_names = {"cell", "warped", "\"edge\" <&>", "corner \xC3\xA9"};
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    mesh.construction.push_back(static_cast<std::uint8_t>(i % 4));
    mesh.level.push_back(static_cast<std::uint8_t>(2 + i / 4));
  }
  return mesh;
}

}  // namespace

Mesh sample_grid(int columns, int rows, int exponent, const GridPlace& place,
                 const GridCells& cells) {
  Mesh mesh;
  mesh.vertices = Vertices(exponent);
  std::map<std::pair<int, int>, VertexId> ids;
  const auto id = [&](int column, int row) {
    const auto [found, is_new] = ids.try_emplace({column, row}, kNoVertex);
    if (is_new) found->second = mesh.vertices.add_exact(place(column, row));
    return found->second;
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      if (!cells(column, row)) continue;
      const VertexId low_left = id(column, row);
      const VertexId low_right = id(column + 1, row);
      mesh.quads.push_back({low_left, low_right, id(column + 1, row + 1), id(column, row + 1)});
    }
  return mesh;
}

Mesh sample_grid(int columns, int rows) {
  return sample_grid(columns, rows, 0, [](int column, int row) { return point(column, row); });
}

std::vector<SampleMesh> sample_meshes() {
  return {{"constructions", with_constructions()},
          {"tenths", offset_grid(0.1, 0.1)},
          {"million", offset_grid(1e6 + 0.3, 0.7)},
          {"tiny", offset_grid(1e-9, 1.3e-9)},
          {"huge", offset_grid(1e300, 1e299)},
          {"thirds", thirds()},
          {"hole", with_hole()},
          {"touching", touching_parts()},
          {"triangles", with_triangles()},
          {"empty", sample_grid(0, 0)}};
}

}  // namespace quadbound
