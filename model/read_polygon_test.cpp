// SPDX-License-Identifier: Apache-2.0
#include "model/read_polygon.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "model/refusal_for_tests.hpp"

namespace quadbound {
namespace {

using Rings = std::vector<Ring>;

const Rings kTriangle{{{0, 0}, {4, 0}, {0, 4}}};
const Rings kSquareWithHole{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{2, 2}, {2, 4}, {4, 4}}};

Rings rings_of(std::string_view text, PolygonFormat format) {
  return parse_polygon(text, format, "a.file").rings;
}

std::string refused(std::string_view text, PolygonFormat format) {
  return refusal([&] { (void)parse_polygon(text, format, "a.file"); });
}

std::string geojson(std::string_view text) { return refused(text, PolygonFormat::kGeoJson); }
std::string wkt(std::string_view text) { return refused(text, PolygonFormat::kWkt); }
std::string poly(std::string_view text) { return refused(text, PolygonFormat::kPoly); }

/// A GeoJSON Polygon with these coordinates.
std::string with(const std::string& coordinates) {
  return R"({"type": "Polygon", "coordinates": )" + coordinates + "}";
}

TEST(ReadGeoJson, PolygonBareInFeatureAndInCollection) {
  const std::string bare = with("[[[0,0],[4,0],[0,4],[0,0]]]");
  const std::string feature =
      R"({"geometry": )" + bare + R"(, "properties": {"a": [1e-999, {}]}, "type": "Feature"})";
  const std::string collection = R"({"type": "FeatureCollection", "features": [)" + feature + "]}";
  for (const std::string& text : {bare, feature, collection})
    EXPECT_EQ(rings_of(text, PolygonFormat::kGeoJson), kTriangle) << text;
}

TEST(ReadGeoJson, HolesThirdCoordinatesByteOrderMarkAndCarriageReturns) {
  const std::string text =
      "\xEF\xBB\xBF" +
      with("[[[0,0,7],[8,0],[8e0,8.0],[0,8],[-0.0,0]],\r\n[[2,2],[2,4],[4,4],[2,2]]]\r\n");
  EXPECT_EQ(rings_of(text, PolygonFormat::kGeoJson), kSquareWithHole);
}

TEST(ReadGeoJson, RefusesARingOfOneVertex) {
  // Found by fuzz_geojson: it is closed, and nothing was left of it.
  EXPECT_EQ(geojson(R"({"type": "Polygon", "coordinates": [[[0, 0]]]})"),
            "a.file: ring 0, vertex 0: the ring has no other vertex");
}

TEST(ReadGeoJson, RefusesOtherShapes) {
  EXPECT_EQ(geojson(" \n"), "a.file: the file is empty");
  EXPECT_EQ(geojson("[]"), "a.file: a GeoJSON object is due, not array");
  EXPECT_EQ(geojson("{}"), "a.file: \"type\" is missing or null");
  EXPECT_EQ(geojson(R"({"type": 3})"), "a.file: \"type\" is not a string");
  for (const std::string type :
       {"MultiPolygon", "LineString", "Point", "GeometryCollection", "polygon"})
    EXPECT_EQ(geojson(R"({"type": ")" + type + R"(", "coordinates": []})"),
              "a.file: \"" + type + "\" where a Polygon is due");
  EXPECT_EQ(geojson(R"({"type": "Feature", "geometry": null})"),
            "a.file: \"geometry\" is missing or null");
  EXPECT_EQ(geojson(R"({"type": "Feature", "geometry": 1})"),
            "a.file: a GeoJSON object is due, not number");
  EXPECT_EQ(geojson(R"({"type": "FeatureCollection", "features": []})"),
            "a.file: a FeatureCollection must have exactly one feature");
  EXPECT_EQ(geojson(R"({"type": "FeatureCollection", "features": [{}, {}]})"),
            "a.file: a FeatureCollection must have exactly one feature");
  EXPECT_EQ(geojson(R"({"type": "FeatureCollection", "features": [{"type": "Polygon"}]})"),
            "a.file: \"Polygon\" where a Feature is due");
}

TEST(ReadGeoJson, RefusesBadCoordinates) {
  EXPECT_EQ(geojson(R"({"type": "Polygon"})"), "a.file: \"coordinates\" is missing or null");
  EXPECT_EQ(geojson(with("null")), "a.file: \"coordinates\" is missing or null");
  EXPECT_EQ(geojson(with("{}")), "a.file: \"coordinates\" is not a list of rings");
  EXPECT_EQ(geojson(with("[]")), "a.file: the polygon is empty");
  EXPECT_EQ(geojson(with("[3]")), "a.file: ring 0: a ring must be a list of positions");
  EXPECT_EQ(geojson(with("[[]]")), "a.file: ring 0: the ring is empty");
  EXPECT_EQ(geojson(with("[[[0,0],[4,0],[0,4]]]")),
            "a.file: ring 0, vertex 2: the ring is not closed: its last vertex differs from its "
            "first");
  const std::string good = "[[0,0],[4,0],[0,4],[0,0]]";
  EXPECT_EQ(geojson(with("[" + good + ",[[0,0],null]]")),
            "a.file: ring 1, vertex 1: a position must be a list of two or three numbers");
  EXPECT_EQ(geojson(with("[" + good + ",[[0,0],[1]]]")),
            "a.file: ring 1, vertex 1: a position must be a list of two or three numbers");
  EXPECT_EQ(geojson(with("[" + good + ",[[0,0],[1,2,3,4]]]")),
            "a.file: ring 1, vertex 1: a position must be a list of two or three numbers");
  EXPECT_EQ(geojson(with("[[[0,\"1\"]]]")),
            "a.file: ring 0, vertex 0: a coordinate is string, not a number");
  EXPECT_EQ(geojson(with("[[[0,null]]]")),
            "a.file: ring 0, vertex 0: a coordinate is null, not a number");
  EXPECT_EQ(geojson(with("[[[0,0],[1e-999,0]]]")),
            "a.file: ring 0, vertex 1: a coordinate is out of the range of a double");
}

TEST(ReadGeoJson, RefusesWhatIsNoJson) {
  EXPECT_EQ(geojson("{\n" + with("[[[0,1e999]]]").substr(1)),
            "a.file: line 2: number overflow parsing '1e999'");
  for (const char* text : {"NaN", "Infinity", "+1", "01", ".5"})
    EXPECT_TRUE(geojson(with("[[[0,\n" + std::string(text) + "]]]"))
                    .starts_with("a.file: line 2: syntax error while parsing"))
        << text;
  EXPECT_EQ(geojson(R"({"type": "Polygon", "coordinates": [[[0,0])"),
            "a.file: line 1: syntax error while parsing array - unexpected end of input; expected "
            "']'");
  EXPECT_EQ(geojson(with("[]") + "\n}"),
            "a.file: line 2: syntax error while parsing value - unexpected '}'; expected end of "
            "input");
  EXPECT_EQ(geojson(R"({"type": "Polygon", "type": "Polygon"})"),
            "a.file: the key \"type\" is repeated");
}

TEST(ReadGeoJson, RefusesDeepNestingWithoutOverflow) {
  const std::string deep(100000, '[');
  EXPECT_EQ(geojson(deep), "a.file: JSON nested deeper than 100");
  EXPECT_EQ(geojson(with(deep)), "a.file: JSON nested deeper than 100");
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_EQ(geojson(objects), "a.file: JSON nested deeper than 100");
}

TEST(ReadWkt, AcceptsPolygons) {
  for (const char* text :
       {"POLYGON((0 0,4 0,0 4,0 0))", " Polygon ( (0 0, +4 0.0 , 0 4e0,-0 0) )\r\n",
        "\xEF\xBB\xBFpolygon\n(\n(0 0,\r\n4 0,\r\n0 4,0 0))"})
    EXPECT_EQ(rings_of(text, PolygonFormat::kWkt), kTriangle) << text;
  EXPECT_EQ(
      rings_of("POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 2 4, 4 4, 2 2))", PolygonFormat::kWkt),
      kSquareWithHole);
}

TEST(ReadWkt, Refusals) {
  EXPECT_EQ(wkt("polygon((-1e2 .5))"), "a.file: ring 0, vertex 0: the ring has no other vertex");
  EXPECT_EQ(wkt(""), "a.file: the file is empty");
  EXPECT_EQ(wkt("MULTIPOLYGON (((0 0)))"), "a.file: line 1: \"MULTIPOLYGON\" where POLYGON is due");
  EXPECT_EQ(wkt("POLYGON EMPTY"), "a.file: line 1: the polygon is empty");
  EXPECT_EQ(wkt("POLYGON Z ((0 0 0))"),
            "a.file: line 1: POLYGON Z has more than two coordinates per vertex");
  EXPECT_EQ(wkt("POLYGON zm ((0 0 0 0))"),
            "a.file: line 1: POLYGON ZM has more than two coordinates per vertex");
  EXPECT_EQ(wkt("POLYGON ((0 0, 4 0 1, 0 4, 0 0))"),
            "a.file: ring 0, vertex 1: line 1: a third coordinate \"1\"");
  EXPECT_EQ(wkt("POLYGON (EMPTY)"), "a.file: ring 0: line 1: the ring is empty");
  EXPECT_EQ(wkt("POLYGON (())"), "a.file: ring 0: line 1: the ring is empty");
  EXPECT_EQ(wkt("POLYGON ()"), "a.file: ring 0: line 1: \")\" where \"(\" is due");
  EXPECT_EQ(wkt("POLYGON"), "a.file: line 1: the text ends where \"(\" is due");
  EXPECT_EQ(wkt("POLYGON ((0 0, 4 0, 0 4))"),
            "a.file: ring 0, vertex 2: the ring is not closed: its last vertex differs from its "
            "first");
  EXPECT_EQ(wkt("POLYGON ((0 0, 4 0, 0 4, 0 0),\n(1 1, 2 1, 1"),
            "a.file: ring 1, vertex 2: line 2: the text ends where a coordinate is due");
  EXPECT_EQ(wkt("POLYGON ((0 0, 4 0, 0 4, 0 0)"),
            "a.file: line 1: the text ends where \",\" or \")\" is due");
  EXPECT_EQ(wkt("POLYGON ((0 0, 4 0, 0 4, 0 0)) x"),
            "a.file: line 1: \"x\" after the end of the polygon");
  EXPECT_EQ(wkt("POLYGON ((0 0,\n4, 0 4, 0 0))"),
            "a.file: ring 0, vertex 1: line 2: \",\" where a coordinate is due");
  EXPECT_EQ(wkt("POLYGON ((0 0, 4 1e999))"),
            "a.file: ring 0, vertex 1: line 1: \"1e999\" is out of the range of a double");
  EXPECT_EQ(wkt("POLYGON ((nan 0))"),
            "a.file: ring 0, vertex 0: line 1: \"nan\" is not a finite number");
  EXPECT_EQ(wkt("POLYGON ((a 0))"), "a.file: ring 0, vertex 0: line 1: \"a\" is not a number");
}

/// The vertices of kSquareWithHole, numbered from `first`.
std::string square_vertices(int first) {
  std::string text;
  for (const Ring& ring : kSquareWithHole)
    for (const Point& p : ring)
      text +=
          std::to_string(first++) + ' ' + std::to_string(p.x) + ' ' + std::to_string(p.y) + '\n';
  return text;
}

TEST(ReadPoly, SegmentsInAnyOrderAndDirection) {
  const std::string from_one =
      "7 2 0 0\n" + square_vertices(1) +
      "7 1\n1 5 6 0\n2 2 1 0\n3 7 5 0\n4 3 4 0\n5 3 2 0\n6 1 4 0\n7 6 7 0\n"
      "1\n1 2.5 3.5\n";
  EXPECT_EQ(rings_of(from_one, PolygonFormat::kPoly), kSquareWithHole);
  const std::string from_zero = "# a comment\r\n7 2 0\r\n" + square_vertices(0) +
                                "7\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 4 5\n5 5 6\n6 6 4\n"
                                "0\n1\n0 1 1 7 -1\n";
  EXPECT_EQ(rings_of(from_zero, PolygonFormat::kPoly), kSquareWithHole);
}

TEST(ReadPoly, TheRingWithTheLeftmostVertexComesFirst) {
  const std::string text =
      "6 2 0 0\n1 1 1\n2 2 1\n3 1 2\n4 0 0\n5 9 0\n6 0 9\n"
      "6 0\n1 1 2\n2 2 3\n3 3 1\n4 4 5\n5 5 6\n6 6 4\n0\n";
  EXPECT_EQ(rings_of(text, PolygonFormat::kPoly),
            (Rings{{{0, 0}, {9, 0}, {0, 9}}, {{1, 1}, {2, 1}, {1, 2}}}));
}

TEST(ReadPoly, VerticesFromTheSiblingFile) {
  const TemporaryFolder folder;
  (void)folder.file("sibling.node", "3 2 0 0\n1 0 0\n2 4 0\n3 0 4\n");
  const std::string text = "0 2 0 0\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n";
  EXPECT_EQ(read_polygon(folder.file("sibling.poly", text)).rings, kTriangle);
  const std::string alone = folder.file("alone.poly", text);
  EXPECT_EQ(refusal([&] { (void)read_polygon(alone); }),
            alone + ": no vertices here, and there is no file " + folder.path("alone.node"));
}

TEST(ReadPoly, Refusals) {
  const std::string vertices = "3 2 0 0\n1 0 0\n2 4 0\n3 0 4\n";
  const std::string triangle = vertices + "3 0\n1 1 2\n2 2 3\n3 3 1\n";
  EXPECT_EQ(poly(""), "a.file: the file is empty");
  EXPECT_EQ(poly(vertices), "a.file: line 4: the file ends before the segments");
  EXPECT_EQ(poly(triangle), "a.file: line 8: the file ends before the holes");
  EXPECT_EQ(poly(vertices + "3 0\n1 1 2\n"), "a.file: line 6: the file ends before a segment");
  EXPECT_EQ(poly(vertices + "3 0 0\n"), "a.file: line 5: too many fields before the segments");
  EXPECT_EQ(poly(vertices + "1 0\n1 1\n"), "a.file: line 6: 2 fields in the line of a segment");
  EXPECT_EQ(poly(vertices + "1 0\n1 1 4\n"), "a.file: line 6: there is no vertex number 4");
  EXPECT_EQ(poly(vertices + "1 0\n1 0 1\n"), "a.file: line 6: there is no vertex number 0");
  EXPECT_EQ(poly(vertices + "1 0\n1 2 2\n"),
            "a.file: vertex 1: line 6: a segment from a vertex to itself");
  EXPECT_EQ(poly(vertices + "2 0\n1 1 2\n2 2 3\n0\n"),
            "a.file: vertex 0: 1 segments end here, not 2: the segments must form closed rings");
  EXPECT_EQ(poly(vertices + "4 0\n1 1 2\n2 2 3\n3 3 1\n4 2 3\n0\n"),
            "a.file: vertex 1: 3 segments end here, not 2: the segments must form closed rings");
  EXPECT_EQ(poly(triangle + "1\n1 1 1\n"), "a.file: hole point 0 lies inside no inner ring");
  EXPECT_EQ(poly(triangle + "1\n1 1 nan\n"), "a.file: line 10: \"nan\" is not a finite number");
  EXPECT_EQ(poly(triangle + "0\nmore text\n"), "a.file: line 10: text after the holes");
  EXPECT_EQ(poly(triangle + "0\n0\n7\n"), "a.file: line 11: text after the regions");
  EXPECT_EQ(poly("7 2 0 0\n" + square_vertices(1) +
                 "7\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 5\n2\n1 2.5 3.5\n2 2 3\n"),
            "a.file: hole point 1 lies inside no inner ring");
}

TEST(ReadPolygon, CorruptedTextsAreReadOrRefused) {
  const auto refusals = [](const std::string& text, PolygonFormat format) {
    return corrupted(text, [&](const std::string& bad) { (void)parse_polygon(bad, format, ""); });
  };
  const std::string geometry = with("[[[0,0],[8,0],[0,8],[0,0]],[[1,1],[1.5,2],[2,1e0],[1,1]]]");
  EXPECT_GT(
      refusals(R"({"type": "Feature", "geometry": )" + geometry + "}", PolygonFormat::kGeoJson),
      1000);
  EXPECT_GT(refusals("POLYGON ((0 0,8 0,0 8,0 0),(1 1,1.5 2,2 1e0,1 1))", PolygonFormat::kWkt),
            1000);
  EXPECT_GT(refusals("7 2 0 0\n" + square_vertices(1) +
                         "7 1\n1 5 6 0\n2 2 1 0\n3 7 5 0\n4 3 4 0\n5 3 2 0\n6 1 4 0\n7 6 7 0\n"
                         "1\n1 2.5 3.5\n",
                     PolygonFormat::kPoly),
            1000);
}

TEST(ReadPolygon, FormatGoesByExtensionUnlessGiven) {
  const TemporaryFolder folder;
  const std::string text = "POLYGON((0 0,4 0,0 4,0 0))";
  const std::string path = folder.file("polygon.wkt", text);
  EXPECT_EQ(read_polygon(path).rings, kTriangle);
  EXPECT_EQ(read_polygon(path).file, path);
  const std::string json = with("[[[0,0],[4,0],[0,4],[0,0]]]");
  EXPECT_EQ(read_polygon(folder.file("polygon.geojson", json)).rings, kTriangle);
  EXPECT_EQ(read_polygon(folder.file("polygon.json", json)).rings, kTriangle);
  const std::string odd = folder.file("polygon.dat", text);
  EXPECT_EQ(read_polygon(odd, PolygonFormat::kWkt).rings, kTriangle);
  EXPECT_EQ(refusal([&] { (void)read_polygon(odd); }),
            odd + ": not a polygon file: the extension must be .geojson, .json, .poly or .wkt");
  EXPECT_EQ(refusal([] { (void)read_polygon("-"); }),
            "standard input: the format of the polygon must be given");
}

}  // namespace
}  // namespace quadbound
