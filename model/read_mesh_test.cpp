// SPDX-License-Identifier: Apache-2.0
#include "model/read_mesh.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "model/refusal_for_tests.hpp"
#include "model/write_json.hpp"
#include "model/write_msh.hpp"
#include "model/write_obj.hpp"

namespace quadbound {
namespace {

std::string refused(const std::string& text, MeshFormat format) {
  return refusal([&] { (void)parse_mesh(text, format, "a.file"); });
}
std::string json(const std::string& text) { return refused(text, MeshFormat::kJson); }
std::string gmsh(const std::string& text) { return refused(text, MeshFormat::kGmsh); }
std::string obj(const std::string& text) { return refused(text, MeshFormat::kObj); }

RationalPoint at(const Mesh& mesh, VertexId vertex) { return mesh.vertices.exact(vertex); }

/// A mesh file of the unit square; `more` follows the last key.
std::string with(const std::string& more, const std::string& quads = "[[0,1,2,3]]") {
  return R"({"format": "quadbound-mesh", "version": 1,)"
         R"( "vertices": [["0","0"],["1","0"],["1","1"],["0","1"]], "quads": )" +
         quads + more + "}";
}

TEST(ReadMeshJson, ReadsAllKeysInAnyOrder) {
  const Mesh mesh = parse_mesh(
      R"({"quads": [[0,1,2,3],[3,2,1,0]], "faces": [[0,1,2]], "unknown": {"quads": [[1]], "a": null},
          "level": [7, 255], "construction": [1, 0], "construction_names": ["b", "a"],
          "input_vertices": 12, "cells": 5000000000, "version": 1,
          "vertices": [["0","0"],["1/2","0"],["3/1","-1/4"],["-0","1/3"]],
          "format": "quadbound-mesh"})",
      MeshFormat::kJson, "a.file");
  EXPECT_EQ(mesh.quads, (std::vector<Quad>{{0, 1, 2, 3}, {3, 2, 1, 0}}));
  EXPECT_EQ(mesh.other_faces, (std::vector<std::vector<VertexId>>{{0, 1, 2}}));
  EXPECT_EQ(mesh.cells, 5000000000U);
  EXPECT_EQ(mesh.input_vertices, 12U);
  EXPECT_EQ(mesh.construction_names, (std::vector<std::string>{"b", "a"}));
  EXPECT_EQ(mesh.construction, (std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(mesh.level, (std::vector<std::uint8_t>{7, 255}));
  ASSERT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.vertices.exponent(), -2);
  EXPECT_EQ(mesh.vertices.lattice(2), (LatticePoint{12, -1}));
  EXPECT_EQ(at(mesh, 3), (RationalPoint{Rational(0), Rational(1, 3)}));
  EXPECT_EQ(mesh.vertices.off_lattice_count(), 1U);
}

/// A mesh file whose vertices lie at (x, 0).
Mesh on_a_line(const std::vector<std::string>& xs) {
  std::string list;
  for (const std::string& x : xs) list += (list.empty() ? "[\"" : ", [\"") + x + "\", \"0\"]";
  return parse_mesh(
      R"({"format": "quadbound-mesh", "version": 1, "quads": [], "vertices": [)" + list + "]}",
      MeshFormat::kJson, "a.file");
}

TEST(ReadMeshJson, KeepsEveryRationalAndChoosesTheLattice) {
  const std::vector<std::string> xs{"1",
                                    "-3/1024",
                                    "6/4",
                                    "007/010",
                                    "1/1180591620717411303424",
                                    "1180591620717411303424",
                                    "18446744073709551617/3",
                                    "1180591620717411303424/2361183241434822606848",
                                    "999999999999999999/576460752303423488",
                                    "-9223372036854775809"};
  // Any single one, each pair, and all together: the lattice differs, the values do not.
  for (std::size_t i = 0; i < xs.size(); ++i)
    for (std::size_t k = 0; k < xs.size(); ++k) {
      const Mesh mesh = on_a_line({xs[i], xs[k]});
      EXPECT_EQ(at(mesh, 0).x, *parse_rational(xs[i]));
      EXPECT_EQ(at(mesh, 1).x, *parse_rational(xs[k]));
    }
  const Mesh all = on_a_line(xs);
  for (std::size_t i = 0; i < xs.size(); ++i)
    EXPECT_EQ(at(all, static_cast<VertexId>(i)).x, *parse_rational(xs[i])) << xs[i];
  EXPECT_EQ(on_a_line({"1", "3/1024", "1/3"}).vertices.exponent(), -10);
  EXPECT_EQ(on_a_line({"1", "1/1180591620717411303424"}).vertices.exponent(), 1 - kLatticeBits);
  EXPECT_EQ(on_a_line({"1024", "3072"}).vertices.exponent(), 10);
  EXPECT_EQ(on_a_line({"0", "1/3"}).vertices.exponent(), 0);
  EXPECT_EQ(on_a_line({}).vertices.size(), 0U);
}

TEST(ReadMeshJson, RefusesWrongVertexNumbers) {
  EXPECT_EQ(json(with("", "[[0,1,2,3],[0,1,2,4]]")),
            "a.file: quad 1 names a vertex that is not among the 4");
  EXPECT_EQ(json(with(R"(, "faces": [[0,1,9]])")),
            "a.file: face 0 names a vertex that is not among the 4");
  EXPECT_EQ(json(with("", "[[0,1,2,4294967295]]")),
            "a.file: \"quads\" has vertex 4294967295, which cannot be");
  const std::string quads =
      "a.file: \"quads\" must be a list of lists of four vertex numbers, at entry ";
  EXPECT_EQ(json(with("", "[[0,1,2,3],[0,1,2,-1]]")), quads + "1");
  EXPECT_EQ(json(with("", "[[0,1,2,3.0]]")), quads + "0");
  EXPECT_EQ(json(with("", "[[0,1,2,\"3\"]]")), quads + "0");
  EXPECT_EQ(json(with("", "[[0,1,2]]")), quads + "0");
  EXPECT_EQ(json(with("", "[[0,1,2,3,0]]")), quads + "0");
  EXPECT_EQ(json(with("", "[0]")), quads + "0");
  EXPECT_EQ(json(with("", "[[[0]]]")), quads + "0");
  EXPECT_EQ(json(with("", "[{}]")), quads + "0");
  EXPECT_EQ(json(with("", "null")), quads + "0");
  for (const char* face : {"[0,1]", "[0,1,2,3]", "[]"})
    EXPECT_EQ(json(with(std::string(", \"faces\": [") + face + "]")),
              "a.file: \"faces\" must be a list of lists of three, five or more vertex numbers, at "
              "entry 0");
}

TEST(ReadMeshJson, RefusesWrongTypesAndValues) {
  const auto vertices = [](const std::string& list) {
    return json(R"({"format": "quadbound-mesh", "version": 1, "quads": [], "vertices": )" + list +
                "}");
  };
  const std::string pairs =
      "a.file: \"vertices\" must be a list of pairs of rationals in quotation marks, at entry ";
  EXPECT_EQ(vertices("[[\"0\",\"0\"],[\"0\"]]"), pairs + "1");
  EXPECT_EQ(vertices("[[\"0\",\"0\",\"0\"]]"), pairs + "0");
  EXPECT_EQ(vertices("[[0,0]]"), pairs + "0");
  EXPECT_EQ(vertices("\"0\""), pairs + "0");
  for (const char* bad : {"1.5", "1/0", "+1", "", "1/-2", "nan", "0x10", " 1"})
    EXPECT_EQ(vertices("[[\"0\",\"0\"],[\"0\",\"" + std::string(bad) + "\"]]"),
              "a.file: vertex 1: \"" + std::string(bad) + "\" is not a rational number");
  EXPECT_EQ(json(with(R"(, "cells": -1)")), "a.file: \"cells\" must be a whole number");
  EXPECT_EQ(json(with(R"(, "input_vertices": [])")),
            "a.file: \"input_vertices\" must be a whole number");
  EXPECT_EQ(json(with(R"(, "level": [256])")),
            "a.file: \"level\" must be a list of whole numbers up to 255");
  EXPECT_EQ(json(with(R"(, "level": [1, 2])")), "a.file: \"level\" has 2 entries for 1 quads");
  EXPECT_EQ(json(with(R"(, "construction_names": [1])")),
            "a.file: \"construction_names\" must be a list of texts");
  EXPECT_EQ(json(with(R"(, "construction_names": ["a"], "construction": [1])")),
            "a.file: \"construction\" has 1, but there are 1 construction names");
  EXPECT_EQ(json(with(R"(, "construction": [])")),
            "a.file: \"construction\" has 0 entries for 1 quads");
}

TEST(ReadMeshJson, RefusesOtherFiles) {
  EXPECT_EQ(json(""), "a.file: the file is empty");
  EXPECT_EQ(json("[]"), "a.file: a mesh must be a JSON object");
  EXPECT_EQ(json("7"), "a.file: a mesh must be a JSON object");
  EXPECT_EQ(json("{}"), "a.file: the key \"format\" is missing");
  EXPECT_EQ(json(R"({"format": "quadbound-mesh", "version": 1, "vertices": []})"),
            "a.file: the key \"quads\" is missing");
  EXPECT_EQ(json(R"({"format": "other"})"),
            "a.file: \"format\" must be the text \"quadbound-mesh\"");
  EXPECT_EQ(json(R"({"version": 2})"), "a.file: version 2 of the mesh format; 1 is read");
  EXPECT_EQ(json(with(R"(, "quads": [])")), "a.file: the key \"quads\" is repeated");
  EXPECT_EQ(json(with(R"(, "x": {"y": 1, "y": 2})")), "a.file: the key \"y\" is repeated");
  EXPECT_EQ(json(with(", \"x\": " + std::string(100000, '['))),
            "a.file: JSON nested deeper than 100");
  EXPECT_EQ(json(with("") + "\n]"),
            "a.file: line 2: syntax error while parsing value - unexpected ']'; expected end of "
            "input");
  EXPECT_EQ(json(with("").substr(0, 90)).substr(0, 52),
            "a.file: line 1: syntax error while parsing array - u");
}

const std::string kGmsh41 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
2 1 "a domain"
$EndPhysicalNames
$Nodes
2 5 3 20
0 1 0 2
3
20
0 0 0
0.5 0 0
2 -1 1 3
4
5
6
0.5 0.5 -0 1 2
0 0.5 0 1 2
0 0.25 0 1 2
$EndNodes
$Elements
4 5 1 5
0 1 15 1
1 3
1 1 1 1
2 3 20
2 1 3 1
3 3 20 4 5
2 1 2 2
4 3 20 4
5 3 4 5
$EndElements
)";

const std::string kGmsh22 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
5
3 0 0 0
20 0.5 0 0
4 0.5 0.5 0
5 0 0.5 0
6 0 0.25 0
$EndNodes
$Elements
5
1 15 2 1 1 3
2 1 2 1 1 3 20
3 3 2 1 1 3 20 4 5
4 2 2 1 1 3 20 4
5 2 0 3 4 5
$EndElements
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t position = text.find(from);
  EXPECT_NE(position, std::string::npos) << from;
  return text.replace(position, from.size(), to);
}

TEST(ReadMeshGmsh, ReadsBothVersions) {
  std::string crlf = kGmsh41;
  for (std::size_t i = 0; (i = crlf.find('\n', i)) != std::string::npos; i += 2)
    crlf.insert(i, 1, '\r');
  for (const std::string& text : {kGmsh41, kGmsh22, "\xEF\xBB\xBF" + crlf}) {
    const Mesh mesh = parse_mesh(text, MeshFormat::kGmsh, "a.file");
    ASSERT_EQ(mesh.vertices.size(), 5U);
    EXPECT_EQ(mesh.vertices.exponent(), -2);
    EXPECT_EQ(mesh.vertices.lattice(2), (LatticePoint{2, 2}));
    EXPECT_EQ(mesh.quads, (std::vector<Quad>{{0, 1, 2, 3}}));
    EXPECT_EQ(mesh.other_faces, (std::vector<std::vector<VertexId>>{{0, 1, 2}, {0, 2, 3}}));
  }
}

TEST(ReadMeshGmsh, Refusals) {
  const auto broken = [](const std::string& from, const std::string& to) {
    return gmsh(replaced(kGmsh41, from, to));
  };
  EXPECT_EQ(gmsh(""), "a.file: the file is empty");
  EXPECT_EQ(gmsh("solid\n"), "a.file: line 1: a gmsh file starts with $MeshFormat");
  EXPECT_EQ(broken("4.1 0", "4.0 0"),
            "a.file: line 2: gmsh format \"4.0\"; only 4.1 and 2.2 are read");
  EXPECT_EQ(broken("4.1 0", "4.1 1"), "a.file: line 2: a binary gmsh file; only ASCII is read");
  EXPECT_EQ(broken("0.5 0 0\n", "0.5 0 1\n"),
            "a.file: vertex 1: line 14: the node is not in the plane z = 0");
  EXPECT_EQ(broken("0.5 0 0\n", "0.5 nan 0\n"),
            "a.file: vertex 1: line 14: \"nan\" is not a finite number");
  EXPECT_EQ(broken("2 5 3 20", "2 6 3 20"), "a.file: line 21: 5 nodes where 6 are announced");
  EXPECT_EQ(broken("4 5 1 5", "4 9 1 5"), "a.file: line 33: 5 elements where 9 are announced");
  EXPECT_EQ(broken("\n4\n5\n6\n", "\n4\n3\n6\n"), "a.file: line 17: the node tag 3 is repeated");
  EXPECT_EQ(broken("3 3 20 4 5", "3 3 20 4 7"),
            "a.file: line 30: element 3 names node 7, which is not there");
  EXPECT_EQ(broken("2 1 3 1", "2 1 10 1"),
            "a.file: line 30: element type 10; only points, lines, triangles and quadrangles of "
            "first order are read");
  EXPECT_EQ(broken("$EndNodes", "7 $EndNodes"), "a.file: line 22: \"7\" where $EndNodes is due");
  EXPECT_EQ(broken("$EndElements\n", "$EndElements garbage\n"),
            "a.file: line 34: \"garbage\" outside a section");
  EXPECT_EQ(broken("$EndPhysicalNames", "$EndPhysical"),
            "a.file: line 34: the file ends before $EndPhysicalNames");
  EXPECT_EQ(gmsh(kGmsh41.substr(0, kGmsh41.find("$Elements"))),
            "a.file: line 22: the file ends without $Nodes and $Elements");
  EXPECT_EQ(gmsh(kGmsh41.substr(0, kGmsh41.find("20 4 5\n"))),
            "a.file: line 30: the file ends before the nodes of an element");
  EXPECT_EQ(gmsh(kGmsh41 + kGmsh41.substr(kGmsh41.find("$Nodes"))),
            "a.file: line 35: a second section $Nodes");
  EXPECT_EQ(gmsh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n"),
            "a.file: line 4: $Elements before $Nodes");
}

TEST(ReadMeshObj, ReadsFacesOfAnySizeAndAllKindsOfCorners) {
  const Mesh mesh = parse_mesh(
      "# by hand\r\nmtllib a.mtl\nv 0 0\nv 1 0 0\nvt 0 0\nvn 0 0 1\nv 1 1 0 1\nv 0 1 0 0.5 0.5 "
      "0.5\n"
      "f 1 2/1 3//1 4/1/1\nf -4 -3 -2\nf 1 2 3 4 5\nv 0 0.5 0\n",
      MeshFormat::kObj, "a.file");
  EXPECT_EQ(mesh.vertices.size(), 5U);
  EXPECT_EQ(at(mesh, 4), (RationalPoint{Rational(0), Rational(1, 2)}));
  EXPECT_EQ(mesh.quads, (std::vector<Quad>{{0, 1, 2, 3}}));
  EXPECT_EQ(mesh.other_faces, (std::vector<std::vector<VertexId>>{{0, 1, 2}, {0, 1, 2, 3, 4}}));
}

TEST(ReadMeshObj, Refusals) {
  const std::string vertices = "v 0 0\nv 1 0\nv 1 1\n";
  EXPECT_EQ(obj(""), "a.file: the file is empty");
  EXPECT_EQ(obj("hello\n"), "a.file: line 1: the file has no vertex");
  EXPECT_EQ(obj("v 1\n"), "a.file: vertex 0: line 1: a vertex needs two coordinates");
  EXPECT_EQ(obj("v 1 2 3\n"), "a.file: vertex 0: line 1: the vertex is not in the plane z = 0");
  EXPECT_EQ(obj("v 1 inf\n"), "a.file: vertex 0: line 1: \"inf\" is not a finite number");
  EXPECT_EQ(obj("v 0 0\nv 1 2,5\n"), "a.file: vertex 1: line 2: \"2,5\" is not a number");
  EXPECT_EQ(obj(vertices + "f 1 2\n"), "a.file: line 4: a face needs three corners");
  EXPECT_EQ(obj(vertices + "f 0 1 2\n"), "a.file: line 4: \"0\" is not the number of a vertex");
  EXPECT_EQ(obj(vertices + "f 1 2 /3\n"), "a.file: line 4: \"/3\" is not the number of a vertex");
  EXPECT_EQ(obj(vertices + "f 1 2 -4\n"), "a.file: line 4: there is no vertex \"-4\"");
  EXPECT_EQ(obj(vertices + "f 1 2 99999999999\n"),
            "a.file: line 4: there is no vertex \"99999999999\"");
  EXPECT_EQ(obj(vertices + "f 1 2 4\n"), "a.file: line 4: a face names vertex 4, but there are 3");
}

std::string written(void (*write)(std::ostream&, const Mesh&), const Mesh& mesh) {
  std::ostringstream stream;
  write(stream, mesh);
  return stream.str();
}

/// The corners of all quads, by value.
std::vector<RationalPoint> corners_of(const Mesh& mesh) {
  std::vector<RationalPoint> corners;
  for (const Quad& quad : mesh.quads)
    for (const VertexId v : quad) corners.push_back(at(mesh, v));
  return corners;
}

TEST(ReadMesh, ReadsWhatTheWritersWrite) {
  const Mesh mesh = parse_mesh(
      R"({"format": "quadbound-mesh", "version": 1, "quads": [[0,1,2,3], [1,4,5,2]],
          "level": [1, 2], "construction_names": ["a"], "construction": [0, 0], "cells": 3,
          "vertices": [["0","0"],["1/2","0"],["1/2","3"],["0","3"],["1/1024","-5"],["7","1/4"]]})",
      MeshFormat::kJson, "a.file");
  const std::string text = written(write_json, mesh);
  EXPECT_EQ(written(write_json, parse_mesh(text, MeshFormat::kJson, "a.file")), text);
  const Mesh from_msh = parse_mesh(written(write_msh, mesh), MeshFormat::kGmsh, "a.file");
  EXPECT_EQ(corners_of(from_msh), corners_of(mesh));
  const Mesh from_obj = parse_mesh(written(write_obj, mesh), MeshFormat::kObj, "a.file");
  EXPECT_EQ(corners_of(from_obj), corners_of(mesh));
}

TEST(ReadMesh, CorruptedTextsAreReadOrRefused) {
  const auto refusals = [](const std::string& text, MeshFormat format) {
    return corrupted(text, [&](const std::string& bad) { (void)parse_mesh(bad, format, ""); });
  };
  EXPECT_GT(refusals(with(R"(, "faces": [[0,1,2]], "cells": 3, "level": [4])"), MeshFormat::kJson),
            1000);
  EXPECT_GT(refusals(kGmsh41, MeshFormat::kGmsh), 1000);
  EXPECT_GT(refusals(kGmsh22, MeshFormat::kGmsh), 1000);
  EXPECT_GT(refusals("v 0 0\nv 1 0 0\nv 1 1\nv 0 1\nf 1 2 3/1 4\nf -4 -3 -2\n", MeshFormat::kObj),
            300);
}

TEST(ReadMesh, FormatGoesByExtensionUnlessGiven) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_mesh(folder.file("mesh.json", with(""))).quads.size(), 1U);
  EXPECT_EQ(read_mesh(folder.file("mesh.msh", kGmsh41)).quads.size(), 1U);
  EXPECT_EQ(read_mesh(folder.file("mesh.obj", "v 0 0\n")).vertices.size(), 1U);
  const std::string odd = folder.file("mesh.dat", "v 0 0\n");
  EXPECT_EQ(read_mesh(odd, MeshFormat::kObj).vertices.size(), 1U);
  EXPECT_EQ(refusal([&] { (void)read_mesh(odd); }),
            odd + ": not a mesh file: the extension must be .json, .msh or .obj");
  EXPECT_EQ(refusal([] { (void)read_mesh("-"); }),
            "standard input: the format of the mesh must be given");
}

}  // namespace
}  // namespace quadbound
