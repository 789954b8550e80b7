// SPDX-License-Identifier: Apache-2.0
#include "model/write_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "model/files.hpp"
#include "model/read_mesh.hpp"
#include "model/write_json.hpp"
#include "model/write_msh.hpp"
#include "model/write_obj.hpp"
#include "model/write_samples.hpp"
#include "model/write_vtu.hpp"

namespace quadbound {
namespace {

using nlohmann::json;

template <class Write>
std::string text_of(const Mesh& mesh, const Write& write) {
  std::ostringstream stream;
  write(stream, mesh);
  return stream.str();
}

void expect_same_faces(const Mesh& mesh, const Mesh& read) {
  EXPECT_EQ(read.quads, mesh.quads);
  EXPECT_EQ(read.other_faces, mesh.other_faces);
}

/// A folder that is gone after the test.
class Folder {
 public:
  Folder() : path_(std::filesystem::path(testing::TempDir()) / "quadbound_write_mesh_test") {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directory(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] std::string file(const char* name) const { return path_ / name; }
  [[nodiscard]] bool is_empty() const { return std::filesystem::is_empty(path_); }

 private:
  std::filesystem::path path_;
};

TEST(WriteJson, HoldsEveryVertexAndFaceExactly) {
  for (const SampleMesh& sample : sample_meshes()) {
    SCOPED_TRACE(sample.name);
    const Mesh& mesh = sample.mesh;
    const json content = json::parse(text_of(mesh, write_json));
    EXPECT_EQ(content["format"], "quadbound-mesh");
    EXPECT_EQ(content["version"], 1);
    EXPECT_EQ(content["cells"], mesh.cells);
    EXPECT_EQ(content["input_vertices"], mesh.input_vertices);
    EXPECT_EQ(content["quads"].get<std::vector<Quad>>(), mesh.quads);
    ASSERT_EQ(content["vertices"].size(), mesh.vertices.size());
    for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
      const RationalPoint exact = mesh.vertices.exact(v);
      EXPECT_EQ(content["vertices"][v], json({to_text(exact.x), to_text(exact.y)}));
    }
    const auto expect_key = [&](const char* key, const auto& values) {
      EXPECT_EQ(content.contains(key), !values.empty()) << key;
      EXPECT_EQ(content.value(key, json::array()), json(values)) << key;
    };
    expect_key("level", mesh.level);
    expect_key("construction", mesh.construction);
    expect_key("construction_names", mesh.construction_names);
    expect_key("faces", mesh.other_faces);
  }
}

/// The fast way of writing lattice coordinates against rational arithmetic, on all kinds of
/// lattices and on numbers with few and many trailing zeros.
TEST(WriteJson, LatticeCoordinatesAreInLowestTerms) {
  std::mt19937_64 engine(1);
  int integers = 0;
  int fractions = 0;
  for (const int exponent :
       {-1134, -200, -65, -64, -63, -62, -60, -46, -1, 0, 1, 2, 3, 4, 70, 960}) {
    Mesh mesh;
    mesh.vertices = Vertices(exponent);
    for (const std::int64_t k :
         {std::int64_t{0}, std::int64_t{1}, std::int64_t{-1}, kMaxLatticeCoordinate,
          -kMaxLatticeCoordinate, kMaxLatticeCoordinate - 1, 1 - kMaxLatticeCoordinate})
      mesh.vertices.add(LatticePoint{k, -k});
    for (int i = 0; i < 300; ++i) {
      const auto odd = static_cast<std::int64_t>(engine()) >> (4 + engine() % 60);
      const auto even = odd & ~((std::int64_t{1} << engine() % 60) - 1);
      mesh.vertices.add(LatticePoint{odd, even});
    }
    const json content = json::parse(text_of(mesh, write_json));
    for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
      const RationalPoint exact = mesh.vertices.exact(v);
      const std::string x = content["vertices"][v][0];
      ASSERT_EQ(x, to_text(exact.x));
      ASSERT_EQ(content["vertices"][v][1], to_text(exact.y));
      ++(x.find('/') == std::string::npos ? integers : fractions);
    }
  }
  EXPECT_GT(integers, 1000);
  EXPECT_GT(fractions, 1000);
}

TEST(WriteJson, ReadsBackAsTheSameMesh) {
  for (const SampleMesh& sample : sample_meshes()) {
    SCOPED_TRACE(sample.name);
    const Mesh& mesh = sample.mesh;
    const std::string text = text_of(mesh, write_json);
    const Mesh read = parse_mesh(text, MeshFormat::kJson, "sample");
    expect_same_faces(mesh, read);
    ASSERT_EQ(read.vertices.size(), mesh.vertices.size());
    for (VertexId v = 0; v < mesh.vertices.size(); ++v)
      EXPECT_EQ(read.vertices.exact(v), mesh.vertices.exact(v));
    EXPECT_EQ(read.cells, mesh.cells);
    EXPECT_EQ(read.input_vertices, mesh.input_vertices);
    EXPECT_EQ(read.construction_names, mesh.construction_names);
    EXPECT_EQ(read.construction, mesh.construction);
    EXPECT_EQ(read.level, mesh.level);
    EXPECT_EQ(text_of(read, write_json), text);
  }
}

TEST(WriteMsh, ReadsBackWithCoordinatesAsStored) {
  for (const SampleMesh& sample : sample_meshes()) {
    SCOPED_TRACE(sample.name);
    const Mesh read = parse_mesh(text_of(sample.mesh, write_msh), MeshFormat::kGmsh, "sample");
    // The reader keeps the order of the file, which lists the nodes ring by ring.
    EXPECT_EQ(read.vertices.size(), sample.mesh.vertices.size());
    ASSERT_EQ(read.quads.size(), sample.mesh.quads.size());
    for (std::size_t i = 0; i < read.quads.size(); ++i)
      for (std::size_t corner = 0; corner < 4; ++corner)
        EXPECT_EQ(read.vertices.rounded(read.quads[i][corner]),
                  sample.mesh.vertices.rounded(sample.mesh.quads[i][corner]));
    EXPECT_EQ(read.other_faces.size(), sample.mesh.other_faces.size());
  }
}

TEST(WriteObj, ReadsBackWithCoordinatesAsStored) {
  for (const SampleMesh& sample : sample_meshes()) {
    SCOPED_TRACE(sample.name);
    if (sample.mesh.vertices.size() == 0) continue;  // the reader refuses a file without vertices
    const Mesh read = parse_mesh(text_of(sample.mesh, write_obj), MeshFormat::kObj, "sample");
    expect_same_faces(sample.mesh, read);
    ASSERT_EQ(read.vertices.size(), sample.mesh.vertices.size());
    for (VertexId v = 0; v < read.vertices.size(); ++v)
      EXPECT_EQ(read.vertices.rounded(v), sample.mesh.vertices.rounded(v));
  }
}

TEST(WriteObj, DigitsAreTheShortestThatReadBack) {
  Mesh mesh;
  mesh.vertices = Vertices(-200);
  mesh.vertices.add_double({0.1, 1e-9});
  mesh.vertices.add_double({1e6 + 0.3, -100000});
  mesh.vertices.add_exact({Rational(1, 3), Rational(0)});
  EXPECT_EQ(
      text_of(mesh, write_obj),
      "# 3 vertices, 0 faces\nv 0.1 1e-09 0\nv 1000000.3 -100000 0\nv 0.3333333333333333 0 0\n");
}

TEST(WriteMsh, GroupsTheDomainAndEveryRing) {
  const std::string text = text_of(sample_grid(1, 1), write_msh);
  EXPECT_EQ(text,
            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
            "$PhysicalNames\n2\n1 1 \"ring 0\"\n2 2 \"domain\"\n$EndPhysicalNames\n"
            "$Entities\n0 1 1 0\n1 0 0 0 1 1 0 1 1 0\n1 0 0 0 1 1 0 1 2 1 1\n$EndEntities\n"
            "$Nodes\n2 4 1 4\n1 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 1 0 0\n$EndNodes\n"
            "$Elements\n2 5 1 5\n1 1 1 4\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n2 1 3 1\n5 1 2 3 4\n"
            "$EndElements\n");
}

TEST(WriteMesh, FormatGoesByTheExtension) {
  EXPECT_EQ(output_format("a.json"), OutputFormat::kJson);
  EXPECT_EQ(output_format("b/a.tar.VTU"), OutputFormat::kVtu);
  EXPECT_EQ(output_format("a.msh"), OutputFormat::kMsh);
  EXPECT_EQ(output_format("a.obj"), OutputFormat::kObj);
  EXPECT_EQ(output_format("a.svg"), OutputFormat::kSvg);
  EXPECT_EQ(output_format("a.pdf"), OutputFormat::kPdf);
  EXPECT_EQ(output_format("a.Png"), OutputFormat::kPng);
  EXPECT_EQ(output_format("-"), OutputFormat::kJson);
  for (const char* bad : {"", "a", "json", "a.", "a.jsn", "a.json.gz", "dir.json/a", ".json"})
    EXPECT_THROW(output_format(bad), WriteRefused) << bad;
}

TEST(WriteMesh, RefusesBeforeItTouchesTheFile) {
  const Folder folder;
  const Mesh mesh = sample_grid(1, 1);
  EXPECT_THROW(write_mesh(folder.file("a.stl"), mesh), WriteRefused);
  WriteOptions options;
  for (const PictureColour colour : {PictureColour::kConstruction, PictureColour::kLevel}) {
    options.picture.colour = colour;
    EXPECT_THROW(write_mesh(folder.file("a.svg"), mesh, options), WriteRefused);
  }
  options = {};
  options.picture.window = PictureWindow{{0, 0}, {1, 0}};
  EXPECT_THROW(write_mesh(folder.file("a.png"), mesh, options), WriteRefused);
  Mesh pentagon;
  pentagon.vertices = Vertices(0);
  for (const std::int64_t x : {0, 2, 3, 1, -1}) pentagon.vertices.add(LatticePoint{x, x * x});
  pentagon.other_faces = {{0, 1, 2, 3, 4}};
  EXPECT_THROW(write_mesh(folder.file("a.msh"), pentagon), WriteRefused);
  EXPECT_TRUE(folder.is_empty());
}

TEST(WriteMesh, TellsWhatCannotBeWritten) {
  const Folder folder;
  const std::string path = folder.file("missing/a.obj");
  try {
    write_mesh(path, sample_grid(1, 1));
    FAIL();
  } catch (const OutputError& error) {
    EXPECT_NE(std::string(error.what()).find(path), std::string::npos);
  }
}

TEST(WriteMesh, TheGivenFormatBeatsTheExtension) {
  const Folder folder;
  WriteOptions options;
  options.format = OutputFormat::kObj;
  const Mesh mesh = sample_grid(2, 1);
  write_mesh(folder.file("mesh.txt"), mesh, options);
  EXPECT_EQ(read_file(folder.file("mesh.txt")), text_of(mesh, write_obj));
}

TEST(WriteMesh, EveryFormatGivesTheSameBytesTwice) {
  const Folder folder;
  for (const SampleMesh& sample : sample_meshes())
    for (const char* name : {"a.json", "a.vtu", "a.msh", "a.obj", "a.svg", "a.pdf", "a.png"}) {
      write_mesh(folder.file(name), sample.mesh);
      const std::string first = read_file(folder.file(name));
      write_mesh(folder.file(name), sample.mesh);
      EXPECT_EQ(read_file(folder.file(name)), first) << sample.name << ' ' << name;
    }
}

}  // namespace
}  // namespace quadbound
