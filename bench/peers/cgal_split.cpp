// SPDX-License-Identifier: Apache-2.0
// cgal_split POLYGON OUT.obj: what CGAL offers for quads. Its Mesh_2 refines a constrained Delaunay
// triangulation to its default quality (no angle below 20.7 degrees), without a bound of size, and
// each triangle is split into three quads at its centroid and the middles of its edges.
//
// Mesh_2 is under the GPL; nothing but this comparison uses it, and it is built on request only.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <exception>
#include <iostream>
#include <map>
#include <string>
#include <utility>

#include "model/mesh.hpp"
#include "model/read_polygon.hpp"
#include "model/validate.hpp"
#include "model/write_mesh.hpp"

namespace quadbound {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Delaunay_mesh_vertex_base_2<Kernel>;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
using Vertex = Triangulation::Vertex_handle;

Triangulation refined(const Polygon& polygon) {
  Triangulation triangulation;
  for (const Ring& ring : polygon.rings) {
    Vertex first;
    Vertex before;
    for (const Point& p : ring) {
      const Vertex here = triangulation.insert({p.x, p.y});
      if (before != nullptr) triangulation.insert_constraint(before, here);
      if (first == nullptr) first = here;
      before = here;
    }
    triangulation.insert_constraint(before, first);
  }
  CGAL::refine_Delaunay_mesh_2(triangulation, Criteria());
  return triangulation;
}

class Splitter {
 public:
  explicit Splitter(const Triangulation& triangulation) {
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end();
         ++face)
      if (face->is_in_domain()) split({face->vertex(0), face->vertex(1), face->vertex(2)});
  }

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

 private:
  void split(const std::array<Vertex, 3>& corners) {
    std::array<VertexId, 3> middles{};
    Point sum{0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      middles[i] = middle(corners[i], corners[(i + 1) % 3]);
      sum = {sum.x + corners[i]->point().x(), sum.y + corners[i]->point().y()};
    }
    const VertexId centre = mesh_.vertices.add_double({sum.x / 3, sum.y / 3});
    for (std::size_t i = 0; i < 3; ++i)
      mesh_.quads.push_back({corner(corners[i]), middles[i], centre, middles[(i + 2) % 3]});
  }

  VertexId corner(Vertex v) {
    const auto [place, is_new] = corners_.try_emplace(v, kNoVertex);
    if (is_new) place->second = mesh_.vertices.add_double({v->point().x(), v->point().y()});
    return place->second;
  }

  VertexId middle(Vertex a, Vertex b) {
    const auto [place, is_new] = middles_.try_emplace(std::minmax(a, b), kNoVertex);
    if (is_new)
      place->second = mesh_.vertices.add_double(
          {(a->point().x() + b->point().x()) / 2, (a->point().y() + b->point().y()) / 2});
    return place->second;
  }

  Mesh mesh_;
  std::map<Vertex, VertexId> corners_;
  std::map<std::pair<Vertex, Vertex>, VertexId> middles_;
};

}  // namespace
}  // namespace quadbound

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: cgal_split POLYGON OUT.obj\n";
    return 2;
  }
  try {
    using namespace quadbound;
    const Splitter splitter(refined(normalised(read_polygon(argv[1]))));
    write_mesh(argv[2], splitter.mesh());
  } catch (const std::exception& error) {
    std::cerr << "cgal_split: " << error.what() << '\n';
    return 2;
  }
  return 0;
}
