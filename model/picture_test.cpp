// SPDX-License-Identifier: Apache-2.0
#include "model/picture.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "model/mesh_edges.hpp"
#include "model/picture_classes.hpp"
#include "model/write_samples.hpp"

namespace quadbound {
namespace {

std::string svg(const Mesh& mesh, const PictureOptions& options = {}) {
  std::ostringstream stream;
  write_svg(stream, mesh, options);
  return stream.str();
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

/// A grid with slanted quads, constructions and levels.
Mesh slanted_grid(int columns, int rows) {
  Mesh mesh = sample_grid(columns, rows, -4, [](int column, int row) {
    return RationalPoint{Rational(4 * column + row % 3, 4), Rational(4 * row + column % 2, 4)};
  });
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    mesh.construction.push_back(static_cast<std::uint8_t>(i % 9));
    mesh.level.push_back(static_cast<std::uint8_t>(3 + i % 5));
  }
  for (int i = 0; i < 9; ++i) mesh.construction_names.push_back("kind " + std::to_string(i));
  return mesh;
}

/// The points of all paths, in pixels: "M" or "l" and two numbers.
std::vector<Point> path_points(const std::string& text) {
  std::vector<Point> points;
  Point at;
  for (const char* c = text.c_str(); *c != 0; ++c) {
    if ((*c != 'M' && *c != 'l') || (c[1] != '-' && (c[1] < '0' || c[1] > '9'))) continue;
    char* end = nullptr;
    const auto x = static_cast<double>(std::strtol(c + 1, &end, 10)) / 100;
    const auto y = static_cast<double>(std::strtol(end, &end, 10)) / 100;
    at = *c == 'M' ? Point{x, y} : Point{at.x + x, at.y + y};
    points.push_back(at);
  }
  return points;
}

TEST(Picture, SvgDrawsEachEdgeOnce) {
  for (const SampleMesh& sample : sample_meshes()) {
    std::size_t edges = 0;
    for_each_edge(sample.mesh, [&](const EdgeUse&) { ++edges; });
    const std::string text = svg(sample.mesh);
    const std::size_t chains = occurrences(text, "M");
    EXPECT_EQ(path_points(text).size() - chains, edges) << sample.name;
  }
}

TEST(Picture, SvgStaysSmall) {
  const Mesh mesh = slanted_grid(250, 100);
  for (const PictureColour colour :
       {PictureColour::kNone, PictureColour::kMinAngle, PictureColour::kConstruction}) {
    PictureOptions options;
    options.colour = colour;
    EXPECT_LT(svg(mesh, options).size(), 3'000'000U);
  }
}

TEST(Picture, YPointsUpAndTheMeshFitsTheWidth) {
  // One square: the first corner drawn is vertex 0, at the lower left.
  PictureOptions options;
  options.width = 200;
  const std::string text = svg(sample_grid(1, 1), options);
  EXPECT_NE(text.find("width=\"200\" height=\"200\" viewBox=\"0 0 20000 20000\""),
            std::string::npos);
  const std::vector<Point> points = path_points(text);
  ASSERT_FALSE(points.empty());
  EXPECT_EQ(points.front(), (Point{12, 188}));
}

TEST(Picture, AWindowCutsOffWhatLiesFarOutside) {
  const Mesh mesh = slanted_grid(20, 20);
  PictureOptions options;
  options.colour = PictureColour::kMaxAngle;
  for (const double size : {5.0, 0.5, 1e-6, 1e-12}) {
    options.window = PictureWindow{{7.0 - size, 9.0 - size}, {7.0 + size, 9.0 + size}};
    const std::vector<Point> points = path_points(svg(mesh, options));
    EXPECT_FALSE(points.empty());
    for (const Point& point : points) {
      EXPECT_LE(std::abs(point.x - 800), 900) << size;
      EXPECT_LE(std::abs(point.y - 800), 900) << size;
    }
  }
}

TEST(Picture, AWindowInsideOfAQuadIsFilledWithItsColour) {
  PictureOptions options;
  options.colour = PictureColour::kMinAngle;
  options.window = PictureWindow{{0.25, 0.25}, {0.5, 0.5}};
  const std::string text = svg(sample_grid(1, 1), options);
  EXPECT_NE(text.find("<path fill=\"#ffffcc\""), std::string::npos);
}

TEST(Picture, PointsAreDots) {
  PictureOptions options;
  options.points = {{0, 0}, {1, 0.5}, {4, 0.5}};
  const std::string text = svg(sample_grid(1, 1), options);
  EXPECT_EQ(occurrences(text, "l0 0"), 3U);
  EXPECT_EQ(occurrences(text, "#cc2222"), 1U);
}

TEST(Picture, TheLegendNamesWhatIsInSight) {
  Mesh mesh = slanted_grid(3, 3);
  mesh.construction_names[0] = "a<b & \"c\"";
  PictureOptions options;
  options.colour = PictureColour::kConstruction;
  const std::string all = svg(mesh, options);
  EXPECT_NE(all.find(">a&lt;b &amp; \"c\"<"), std::string::npos);
  for (int i = 1; i < 9; ++i)
    EXPECT_NE(all.find(">kind " + std::to_string(i) + "<"), std::string::npos);
  options.window = PictureWindow{{0.4, 0.4}, {0.6, 0.6}};
  EXPECT_EQ(svg(mesh, options).find(">kind 8<"), std::string::npos);
}

TEST(Picture, ProblemsAreTold) {
  Mesh mesh = sample_grid(1, 1);
  PictureOptions options;
  EXPECT_FALSE(picture_problem(mesh, options));
  options.colour = PictureColour::kLevel;
  EXPECT_TRUE(picture_problem(mesh, options));
  mesh.level = {3};
  EXPECT_FALSE(picture_problem(mesh, options));
  for (const double bad : {0.0, -1.0, 1e9, std::nan("")}) {
    options.width = bad;
    EXPECT_TRUE(picture_problem(mesh, options)) << bad;
  }
  options.width = 800;
  options.window = PictureWindow{{1, 1}, {1, 2}};
  EXPECT_TRUE(picture_problem(mesh, options));
}

TEST(PictureClasses, AnglesAtABoundAreOnItsGoodSide) {
  // Isosceles trapezoids with legs of slope 1/3 and 1/2, a little above and a little below.
  const auto trapezoid = [](std::int64_t run, std::int64_t rise) {
    Mesh mesh;
    for (const LatticePoint point : {LatticePoint{0, 0}, LatticePoint{3 * run, 0},
                                     LatticePoint{2 * run, rise}, LatticePoint{run, rise}})
      mesh.vertices.add(point);
    mesh.quads = {{0, 1, 2, 3}};
    return mesh;
  };
  const auto class_of = [&](std::int64_t run, std::int64_t rise) {
    return picture_classes(trapezoid(run, rise), PictureColour::kMinAngle).of_quad.at(0);
  };
  constexpr std::int64_t big = 1'000'000;
  EXPECT_EQ(class_of(3, 1), 1);
  EXPECT_EQ(class_of(3 * big, big + 1), 1);
  EXPECT_EQ(class_of(3 * big, big - 1), 0);
  EXPECT_EQ(class_of(2, 1), 2);
  EXPECT_EQ(class_of(2 * big, big - 1), 1);
}

TEST(PictureClasses, LargestAnglesFallIntoClassesFromTheOtherEnd) {
  const auto class_of = [](std::int64_t run, std::int64_t rise) {
    Mesh mesh;
    for (const LatticePoint point : {LatticePoint{0, 0}, LatticePoint{3 * run, 0},
                                     LatticePoint{2 * run, rise}, LatticePoint{run, rise}})
      mesh.vertices.add(point);
    mesh.quads = {{0, 1, 2, 3}};
    return picture_classes(mesh, PictureColour::kMaxAngle).of_quad.at(0);
  };
  EXPECT_EQ(class_of(8, 1), 0);  // beyond 180 degrees - arctan(1/7)
  EXPECT_EQ(class_of(7, 1), 1);  // at it
  EXPECT_EQ(class_of(2, 1), 2);  // 180 degrees - arctan(1/2)
  EXPECT_EQ(class_of(1, 1), 3);  // 135 degrees
  EXPECT_EQ(class_of(1, 100), 5);
}

TEST(Picture, PngHasTheSizeThatWasAskedFor) {
  PictureOptions options;
  options.width = 320;
  options.colour = PictureColour::kMinAngle;
  std::ostringstream stream;
  write_png(stream, slanted_grid(4, 2), options);
  const std::string text = stream.str();
  ASSERT_GT(text.size(), 24U);
  EXPECT_EQ(text.substr(1, 3), "PNG");
  // Bytes 16 to 19 hold the width, the highest byte first.
  EXPECT_EQ(static_cast<unsigned char>(text[18]) * 256 + static_cast<unsigned char>(text[19]), 320);
}

TEST(Picture, PdfHasNoTimeOfDay) {
  std::ostringstream stream;
  write_pdf(stream, slanted_grid(4, 2));
  const std::string text = stream.str();
  EXPECT_EQ(text.substr(0, 5), "%PDF-");
  EXPECT_NE(text.find("20000101000000"), std::string::npos);
}

}  // namespace
}  // namespace quadbound
