// SPDX-License-Identifier: Apache-2.0
#include "model/read_points.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "model/refusal_for_tests.hpp"

namespace quadbound {
namespace {

using Points = std::vector<Point>;

Points points_of(std::string_view text, PointFormat format) {
  return parse_points(text, format, "a.file").points;
}

std::string refused(std::string_view text, PointFormat format) {
  return refusal([&] { (void)parse_points(text, format, "a.file"); });
}

TEST(ReadPoints, CsvWithAndWithoutHeader) {
  const Points expected{{1, -2.5}, {0.1, 300}};
  for (const char* text : {"1,-2.5\n0.1,3e2\n", "x,y\n1,-2.5\n0.1,300",
                           "\xEF\xBB\xBFX, Y\r\n+1 , -2.5\r\n\r\n.1,+3E+2\r\n",
                           "\"y\",\"name\",\"x\"\n-2.5,first,1\n300,second,0.1\n"})
    EXPECT_EQ(points_of(text, PointFormat::kCsv), expected) << text;
  EXPECT_TRUE(points_of("x,y\n", PointFormat::kCsv).empty());
}

TEST(ReadPoints, CsvRefusals) {
  const auto csv = [](std::string_view text) { return refused(text, PointFormat::kCsv); };
  EXPECT_EQ(csv(""), "a.file: the file is empty");
  EXPECT_EQ(csv("\xEF\xBB\xBF \r\n\n"), "a.file: the file is empty");
  EXPECT_EQ(csv("1,2\n3\n"), "a.file: vertex 1: line 2: 1 columns instead of 2");
  EXPECT_EQ(csv("1,2,3\n"), "a.file: vertex 0: line 1: 3 columns instead of 2");
  EXPECT_EQ(csv("1,2,\n"), "a.file: vertex 0: line 1: 3 columns instead of 2");
  EXPECT_EQ(csv("x,y,z\n1,2\n"), "a.file: vertex 0: line 2: 2 columns instead of 3");
  EXPECT_EQ(csv("x,z\n"), "a.file: line 1: the header must name a column x and a column y");
  EXPECT_EQ(csv("x,y,X\n"), "a.file: line 1: the header names a column twice");
  EXPECT_EQ(csv("lon,lat\n"), "a.file: vertex 0: line 1: \"lon\" is not a number");
  EXPECT_EQ(csv("1,2\n\n3,4x\n"), "a.file: vertex 1: line 3: \"4x\" is not a number");
  EXPECT_EQ(csv("1,\n"), "a.file: vertex 0: line 1: \"\" is not a number");
  EXPECT_EQ(csv("1,+-2\n"), "a.file: vertex 0: line 1: \"+-2\" is not a number");
  EXPECT_EQ(csv("0x10,1\n"), "a.file: vertex 0: line 1: \"0x10\" is not a number");
  EXPECT_EQ(csv("nan,1\n"), "a.file: vertex 0: line 1: \"nan\" is not a finite number");
  EXPECT_EQ(csv("1,-Infinity\n"), "a.file: vertex 0: line 1: \"-Infinity\" is not a finite number");
  EXPECT_EQ(csv("1,1e999\n"),
            "a.file: vertex 0: line 1: \"1e999\" is out of the range of a double");
  EXPECT_EQ(csv("1e-999,1\n"),
            "a.file: vertex 0: line 1: \"1e-999\" is out of the range of a double");
}

TEST(ReadPoints, LongOrUnprintableTextIsShortenedInMessages) {
  EXPECT_EQ(refused(std::string(1000, 'a') + ",1", PointFormat::kCsv),
            "a.file: vertex 0: line 1: \"" + std::string(40, 'a') + "...\" is not a number");
  EXPECT_EQ(refused(std::string("1,\x01\x00z", 5), PointFormat::kCsv),
            "a.file: vertex 0: line 1: \"??z\" is not a number");
}

TEST(ReadPoints, NumbersAreTheNearestDoubles) {
  EXPECT_EQ(points_of("0.1,9007199254740993\n", PointFormat::kCsv),
            (Points{{0.1, 9007199254740992.0}}));
  EXPECT_EQ(points_of("1.7976931348623157e308,5e-324\n", PointFormat::kCsv),
            (Points{{1.7976931348623157e308, 5e-324}}));
}

TEST(ReadPoints, NodeCountedFromZeroOrOne) {
  const Points expected{{1, 2}, {3, 4}};
  for (const char* text :
       {"2 2 0 0\n0 1 2\n1 3 4\n",
        "# made by hand\n2 2 1 1\r\n1  1 2  7.5 0 # first\r\n\n2 3 4 -1 1", "2 2\n1 1 2\n2 3 4\n"})
    EXPECT_EQ(points_of(text, PointFormat::kNode), expected) << text;
}

TEST(ReadPoints, NodeRefusals) {
  const auto node = [](std::string_view text) { return refused(text, PointFormat::kNode); };
  EXPECT_EQ(node("# nothing\n"), "a.file: line 1: the file ends before the vertex counts");
  EXPECT_EQ(node("2\n"), "a.file: line 1: expected \"vertices dimension attributes markers\"");
  EXPECT_EQ(node("2 3 0 0\n"), "a.file: line 1: the dimension is not 2");
  EXPECT_EQ(node("-1 2 0 0\n"), "a.file: line 1: \"-1\" is not a whole number");
  EXPECT_EQ(node("99999999999999 2 0 0\n0 1 2\n"),
            "a.file: line 2: the file ends after 1 of 99999999999999 vertices");
  EXPECT_EQ(node("1 2 0 0\n5 1 2\n"), "a.file: vertex 0: line 2: vertex number 5 where 0 is due");
  EXPECT_EQ(node("2 2 0 0\n1 1 2\n1 3 4\n"),
            "a.file: vertex 1: line 3: vertex number 1 where 2 is due");
  EXPECT_EQ(node("1 2 0 0\n1 1\n"), "a.file: vertex 0: line 2: 2 fields in the line of a vertex");
  EXPECT_EQ(node("1 2 0 0\n1 1 2 3\n"),
            "a.file: vertex 0: line 2: 4 fields in the line of a vertex");
  EXPECT_EQ(node("1 2 1 0\n1 1 2 z\n"), "a.file: vertex 0: line 2: \"z\" is not a number");
  EXPECT_EQ(node("1 2 0 0\n1 1 inf\n"), "a.file: vertex 0: line 2: \"inf\" is not a finite number");
  EXPECT_EQ(node("1 2 0 0\n1 1 2\nmore\n"), "a.file: line 3: text after the last vertex");
}

TEST(ReadPoints, ColumnsOfTextAndXyz) {
  const Points expected{{1, 2}, {3, 4}};
  EXPECT_EQ(points_of("1 2\n\t3\t4\r\n# end", PointFormat::kText), expected);
  EXPECT_EQ(points_of("1 2 9\n3 4\n", PointFormat::kXyz), expected);
  EXPECT_EQ(refused("1 2 9\n", PointFormat::kText),
            "a.file: vertex 0: line 1: 3 columns instead of 2");
  EXPECT_EQ(refused("1 2\n3\n", PointFormat::kXyz),
            "a.file: vertex 1: line 2: 1 columns instead of 2 or 3");
  EXPECT_EQ(refused("1 2 3 4\n", PointFormat::kXyz),
            "a.file: vertex 0: line 1: 4 columns instead of 2 or 3");
  EXPECT_EQ(refused("1 2 up\n", PointFormat::kXyz),
            "a.file: vertex 0: line 1: \"up\" is not a number");
}

TEST(ReadPoints, CorruptedTextsAreReadOrRefused) {
  const auto refusals = [](const std::string& text, PointFormat format) {
    return corrupted(text, [&](const std::string& bad) { (void)parse_points(bad, format, ""); });
  };
  EXPECT_GT(refusals("x,y\n1,2\n3.5,-4e2\n", PointFormat::kCsv), 300);
  EXPECT_GT(refusals("2 2 1 0\n1 1 2 7\n2 3.5 -4e2 8\n", PointFormat::kNode), 300);
  EXPECT_GT(refusals("1 2 3\n3.5 -4e2\n", PointFormat::kXyz), 300);
}

TEST(ReadPoints, FormatGoesByExtensionUnlessGiven) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_points(folder.file("points.CSV", "1,2\n")).points, (Points{{1, 2}}));
  EXPECT_EQ(read_points(folder.file("points.node", "1 2 0 0\n1 1 2\n")).points, (Points{{1, 2}}));
  EXPECT_EQ(read_points(folder.file("points.xyz", "1 2 3\n")).points, (Points{{1, 2}}));
  const std::string path = folder.file("points.txt", "1 2\n");
  const PointSet set = read_points(path);
  EXPECT_EQ(set.points, (Points{{1, 2}}));
  EXPECT_EQ(set.file, path);
  const std::string odd = folder.file("points.dat", "1,2\n");
  EXPECT_EQ(read_points(odd, PointFormat::kCsv).points, (Points{{1, 2}}));
  EXPECT_EQ(refusal([&] { (void)read_points(odd); }),
            odd + ": not a point file: the extension must be .csv, .node, .xyz or .txt");
  EXPECT_EQ(refusal([] { (void)read_points("-"); }),
            "standard input: the format of the points must be given");
  const std::string missing = folder.path("no-such-points.csv");
  EXPECT_EQ(refusal([&] { (void)read_points(missing); }),
            missing + ": cannot be read: No such file or directory");
}

}  // namespace
}  // namespace quadbound
