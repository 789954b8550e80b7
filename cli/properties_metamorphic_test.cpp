// SPDX-License-Identifier: Apache-2.0
// Properties: what must not change a mesh, or no more than its numbers. Where the root square
// stands decides: it is shifted to the left and down by different parts of its side, so that a
// polygon that is turned or mirrored gets another mesh, and its proof is all that must stay.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cli/property_cases.hpp"
#include "generators/random.hpp"
#include "model/validate.hpp"
#include "verify/verify.hpp"

namespace quadbound::cli {
namespace {

/// Whether `image` is `mesh` with every vertex multiplied by 2^exponent and moved.
bool is_image(const Mesh& mesh, const Mesh& image, int exponent, const Point& by) {
  if (mesh.quads != image.quads || mesh.vertices.size() != image.vertices.size()) return false;
  const Rational factor = dyadic(1, exponent);
  const RationalPoint shift = exact_value(by);
  for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
    const RationalPoint a = mesh.vertices.exact(v);
    const RationalPoint b = image.vertices.exact(v);
    if (a.x * factor + shift.x != b.x || a.y * factor + shift.y != b.y) return false;
  }
  return true;
}

auto moving(const Point& by) {
  return [by](Point p) { return Point{p.x + by.x, p.y + by.y}; };
}

auto scaling(int exponent) {
  return [exponent](Point p) {
    return Point{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
  };
}

TEST(Metamorphic, ScalingAPolygonByAPowerOfTwoScalesItsMesh) {
  Reached reached(Reached::Of::kPolygons);
  check_property(100, reached, [&](const PolygonSample& sample) {
    const int exponent = *rc::gen::inRange(-900, 900);
    const auto made = meshed(sample.polygon);
    RC_PRE(made.has_value());
    const auto image = meshed(mapped(sample.polygon, scaling(exponent)));
    RC_ASSERT(is_image(made->mesh, image->mesh, exponent, {}));
    reached.add(*made);
  });
}

/// The lattice ends where doubles would: farther from the origin it is coarser, and Steiner points
/// are other ones. The polygon is first moved to where its neighbourhood has one lattice.
TEST(Metamorphic, MovingAPolygonBySixteenthsOfTheRootMovesItsMesh) {
  Reached reached(Reached::Of::kPolygons);
  check_property(100, reached, [&](const PolygonSample& sample) {
    const auto near = meshed(sample.polygon);
    RC_PRE(near.has_value());
    const double side = std::ldexp(1.0, near->root.side_bits + near->root.exponent);
    const Polygon polygon = mapped(sample.polygon, moving({5 * side, 5 * side}));
    const auto made = meshed(polygon);
    const Point by{*rc::gen::inRange(-8, 9) * side / 16, *rc::gen::inRange(-8, 9) * side / 16};
    const auto image = meshed(mapped(polygon, moving(by)));
    RC_ASSERT(made.has_value() && image.has_value());
    RC_ASSERT(is_image(made->mesh, image->mesh, 0, by));
    reached.add(*made);
  });
}

/// A mesh but for its numbering: the places of the vertices in order, and the quads as numbers of
/// places, the smallest first, in order.
struct Shape {
  std::vector<std::pair<Rational, Rational>> places;
  std::vector<Quad> quads;
  friend bool operator==(const Shape&, const Shape&) = default;
};

Shape shape_of(const Mesh& mesh) {
  std::vector<std::pair<std::pair<Rational, Rational>, VertexId>> sorted;
  for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
    const RationalPoint p = mesh.vertices.exact(v);
    sorted.push_back({{p.x, p.y}, v});
  }
  std::ranges::sort(sorted);
  Shape shape;
  std::vector<VertexId> rank(sorted.size());
  for (const auto& [place, v] : sorted) {
    rank[v] = static_cast<VertexId>(shape.places.size());
    shape.places.push_back(place);
  }
  for (Quad quad : mesh.quads) {
    for (VertexId& v : quad) v = rank[v];
    std::rotate(quad.begin(), std::ranges::min_element(quad), quad.end());
    shape.quads.push_back(quad);
  }
  std::ranges::sort(shape.quads);
  return shape;
}

TEST(Metamorphic, TheOrderOfRingsAndTheirFirstVerticesDoNotMatter) {
  Reached reached(Reached::Of::kPolygons);
  check_property(100, reached, [&](const PolygonSample& sample) {
    RandomIntegers random(*rc::gen::arbitrary<std::uint64_t>());
    Polygon other = sample.polygon;
    std::vector<Ring> holes(other.rings.begin() + 1, other.rings.end());
    random.shuffle(holes);
    std::ranges::copy(holes, other.rings.begin() + 1);
    for (Ring& ring : other.rings)
      std::rotate(ring.begin(),
                  ring.begin() + static_cast<std::ptrdiff_t>(random.below(ring.size())),
                  ring.end());
    const auto made = meshed(sample.polygon);
    RC_PRE(made.has_value());
    RC_ASSERT(shape_of(meshed(other)->mesh) == shape_of(made->mesh));
    reached.add(*made);
  });
}

TEST(Metamorphic, TurnedAndMirroredPolygonsAreProved) {
  Reached reached(Reached::Of::kPolygons);
  check_property(100, reached, [&](const PolygonSample& sample) {
    const bool swaps = *rc::gen::arbitrary<bool>();
    const double x = *rc::gen::element(1.0, -1.0);
    const double y = *rc::gen::element(1.0, -1.0);
    const Polygon image = normalised(mapped(sample.polygon, [&](Point p) {
      return swaps ? Point{x * p.y, y * p.x} : Point{x * p.x, y * p.y};
    }));
    const auto made = meshed(image);
    RC_PRE(made.has_value());
    RC_ASSERT(broken_claims(verify_polygon(image, made->mesh)) == "");
    reached.add(*made);
  });
}

// --- point sets ----------------------------------------------------------------------------------

struct Counts {
  std::uint64_t cells;
  std::size_t vertices;
  std::size_t quads;
  std::array<std::uint64_t, kTemplateCount> templates;
  std::array<std::uint64_t, kStitchCaseCount> stitch_cases;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts counts_of(const PointMesh& made) {
  return {made.mesh.cells, made.mesh.vertices.size(), made.mesh.quads.size(),
          made.counters.templates, made.counters.stitch_cases};
}

/// Multiples of 3 * 2^-21 moved by odd multiples of 2^-31, so that no site is on a cell border, and
/// a box around them with its centre in the origin. Only then is the root square the same after
/// mirroring: its corner is rounded down to a sixteenth of its side, which mirrors to rounding up.
PointSet centred(const std::vector<std::pair<int, int>>& sites) {
  const auto coordinate = [](int site) {
    return std::ldexp(3.0 * site + 1 + std::ldexp(1.0, -10), -21);
  };
  PointSet points{"centred", {{-0.5123, -0.5123}, {0.5123, 0.5123}}};
  for (const auto& [x, y] : sites) points.points.push_back({coordinate(x), coordinate(y)});
  return points;
}

TEST(Metamorphic, MirroringAndTurningPointSetsKeepsTheCounts) {
  Reached reached(Reached::Of::kPoints);
  const auto site = rc::gen::inRange(-300'000, 300'000);
  const auto any_sites = rc::gen::nonEmpty(
      rc::gen::unique<std::vector<std::pair<int, int>>>(rc::gen::pair(site, site)));
  check_property(100, reached, [&] {
    const PointSet points = centred(*any_sites);
    for (const GridRefinement grid : {GridRefinement::kSixBySix, GridRefinement::kFiveByFive}) {
      const auto made = meshed(points, grid);
      RC_PRE(made.has_value());
      const Counts counts = counts_of(*made);
      const auto mirrored = [](Point p) { return Point{-p.x, p.y}; };
      const auto turned = [](Point p) { return Point{-p.y, p.x}; };
      RC_ASSERT(counts_of(*meshed(mapped(points, mirrored), grid)) == counts);
      RC_ASSERT(counts_of(*meshed(mapped(points, turned), grid)) == counts);
      reached.add(*made);
    }
  });
}

TEST(Metamorphic, ScalingAPointSetByAPowerOfTwoScalesItsMesh) {
  Reached reached(Reached::Of::kPoints);
  check_property(100, reached, [&](const PointSample& sample) {
    const int exponent = *rc::gen::inRange(-300, 300);
    const auto made = meshed(sample.points);
    RC_PRE(made.has_value());
    const auto image = meshed(mapped(sample.points, scaling(exponent)));
    RC_ASSERT(is_image(made->mesh, image->mesh, exponent, {}));
    reached.add(*made);
  });
}

}  // namespace
}  // namespace quadbound::cli
