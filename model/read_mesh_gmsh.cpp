// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <unordered_map>
#include <utility>

#include "model/mesh_formats.hpp"
#include "model/text_scanner.hpp"

namespace quadbound {
namespace {

constexpr std::uint64_t kLine = 1;
constexpr std::uint64_t kTriangle = 2;
constexpr std::uint64_t kQuadrangle = 3;
constexpr std::uint64_t kPoint = 15;

class GmshParser {
 public:
  GmshParser(std::string_view text, const std::string& file)
      : scanner_(text, file, TextScanner::Comments::kNone) {}

  Mesh parse() {
    if (scanner_.next_field("$MeshFormat") != "$MeshFormat")
      scanner_.fail("a gmsh file starts with $MeshFormat");
    read_format();
    while (scanner_.has_more()) read_section(scanner_.next_field("a section"));
    if (!has_nodes_ || !has_elements_) scanner_.fail("the file ends without $Nodes and $Elements");
    mesh_.vertices = lattice_vertices(points_, scanner_.file());
    return std::move(mesh_);
  }

 private:
  void read_format() {
    const std::string_view version = scanner_.next_field("the version");
    if (version != "4.1" && version != "2.2")
      scanner_.fail(fmt::format("gmsh format {}; only 4.1 and 2.2 are read", excerpt(version)));
    blocks_ = version == "4.1";
    if (scanner_.next_count("the file type") != 0)
      scanner_.fail("a binary gmsh file; only ASCII is read");
    (void)scanner_.next_count("the data size");
    expect_end("$EndMeshFormat");
  }

  void read_section(std::string_view name) {
    if (!name.starts_with('$')) scanner_.fail(fmt::format("{} outside a section", excerpt(name)));
    if (name == "$Nodes") {
      if (std::exchange(has_nodes_, true)) scanner_.fail("a second section $Nodes");
      blocks_ ? read_node_blocks() : read_nodes();
      expect_end("$EndNodes");
    } else if (name == "$Elements") {
      if (std::exchange(has_elements_, true)) scanner_.fail("a second section $Elements");
      if (!has_nodes_) scanner_.fail("$Elements before $Nodes");
      blocks_ ? read_element_blocks() : read_elements();
      expect_end("$EndElements");
    } else {
      const std::string end = "$End" + std::string(name.substr(1));
      while (scanner_.next_field(end.c_str()) != end) {
      }
    }
  }

  void read_node_blocks() {
    const std::uint64_t blocks = next("the node blocks");
    const std::uint64_t nodes = next("the nodes");
    (void)next("the smallest tag");
    (void)next("the largest tag");
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const std::uint64_t dimension = next("a node block");
      (void)scanner_.next_number("the tag of an entity");
      const bool parametric = next("the parametric flag") != 0;
      const std::uint64_t count = next("the nodes of a block");
      for (std::uint64_t i = 0; i < count; ++i) add_tag(next("the tag of a node"));
      for (std::uint64_t i = 0; i < count; ++i) {
        add_position();
        for (std::uint64_t k = 0; parametric && k < dimension; ++k)
          (void)scanner_.next_number("a parameter");
      }
    }
    if (points_.size() != nodes)
      scanner_.fail(fmt::format("{} nodes where {} are announced", points_.size(), nodes));
  }

  void read_nodes() {
    const std::uint64_t count = next("the nodes");
    for (std::uint64_t i = 0; i < count; ++i) {
      add_tag(next("the tag of a node"));
      add_position();
    }
  }

  void read_element_blocks() {
    const std::uint64_t blocks = next("the element blocks");
    const std::uint64_t elements = next("the elements");
    (void)next("the smallest tag");
    (void)next("the largest tag");
    std::uint64_t seen = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      (void)next("the dimension of an element block");
      (void)scanner_.next_number("the tag of an entity");
      const std::uint64_t type = next("the type of elements");
      const std::uint64_t count = next("the elements of a block");
      for (std::uint64_t i = 0; i < count; ++i) read_element(next("an element"), type);
      seen += count;
    }
    if (seen != elements)
      scanner_.fail(fmt::format("{} elements where {} are announced", seen, elements));
  }

  void read_elements() {
    const std::uint64_t count = next("the elements");
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t tag = next("an element");
      const std::uint64_t type = next("the type of an element");
      const std::uint64_t tags = next("the tags of an element");
      for (std::uint64_t k = 0; k < tags; ++k) (void)scanner_.next_number("a tag of an element");
      read_element(tag, type);
    }
  }

  void read_element(std::uint64_t tag, std::uint64_t type) {
    const std::size_t size = corner_count(type);
    std::vector<VertexId> corners;
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint64_t node = next("the nodes of an element");
      const auto found = vertex_of_tag_.find(node);
      if (found == vertex_of_tag_.end())
        scanner_.fail(fmt::format("element {} names node {}, which is not there", tag, node));
      corners.push_back(found->second);
    }
    if (type == kTriangle || type == kQuadrangle) add_face(mesh_, std::move(corners));
  }

  std::size_t corner_count(std::uint64_t type) const {
    switch (type) {
      case kPoint:
        return 1;
      case kLine:
        return 2;
      case kTriangle:
        return 3;
      case kQuadrangle:
        return 4;
      default:
        scanner_.fail(
            fmt::format("element type {}; only points, lines, triangles and quadrangles "
                        "of first order are read",
                        type));
    }
  }

  void add_tag(std::uint64_t tag) {
    const auto vertex = static_cast<VertexId>(vertex_of_tag_.size());
    if (!vertex_of_tag_.emplace(tag, vertex).second)
      scanner_.fail(fmt::format("the node tag {} is repeated", tag));
  }

  void add_position() {
    const double x = coordinate();
    const double y = coordinate();
    if (coordinate() != 0) scanner_.fail("the node is not in the plane z = 0", points_.size());
    points_.push_back({x, y});
  }

  double coordinate() {
    return scanner_.number(scanner_.next_field("a coordinate"), points_.size());
  }

  std::uint64_t next(const char* what) { return scanner_.next_count(what); }

  void expect_end(std::string_view end) {
    const std::string_view field = scanner_.next_field("the end of the section");
    if (field != end) scanner_.fail(fmt::format("{} where {} is due", excerpt(field), end));
  }

  TextScanner scanner_;
  bool blocks_ = true;  ///< format 4.1
  bool has_nodes_ = false;
  bool has_elements_ = false;
  std::vector<Point> points_;
  std::unordered_map<std::uint64_t, VertexId> vertex_of_tag_;
  Mesh mesh_;
};

}  // namespace

Mesh parse_mesh_gmsh(std::string_view text, const std::string& file) {
  return GmshParser(text, file).parse();
}

}  // namespace quadbound
