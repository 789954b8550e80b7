// SPDX-License-Identifier: Apache-2.0
#include "generators/gallery.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "generators/polygons.hpp"

namespace quadbound {
namespace {

constexpr std::size_t kColumns = 5;
constexpr double kCell = 260;
constexpr double kPolygon = 210;  ///< the larger side of a polygon
constexpr double kCaption = 40;
constexpr double kMargin = 14;
constexpr std::size_t kDotted = 220;  ///< outer vertices are drawn where they are fewer
constexpr Colour kInside{216, 228, 240};
constexpr Colour kLine{20, 40, 80};

/// What shows a family best; others are drawn with 60 vertices and 3 holes.
constexpr std::array<std::string_view, 21> kExamples{"glyph:n=48,seed=1,character=38,font=4",
                                                     "star:n=30,seed=4,holes=3",
                                                     "regular:n=9,seed=1,holes=3",
                                                     "gear:n=48,seed=1,holes=3",
                                                     "annulus:n=14,seed=3",
                                                     "sharp:n=20,seed=2",
                                                     "notch:n=32,seed=1,holes=3",
                                                     "slit:n=40,seed=2,slits=9,holes=3",
                                                     "blob:n=90,seed=3,holes=3",
                                                     "comb:n=32,seed=1,holes=3",
                                                     "spiral-band:n=34,seed=1",
                                                     "obtuse-spiral:n=33,seed=1,holes=3",
                                                     "collinear:n=140,seed=2,holes=3",
                                                     "growth:n=120,seed=1,holes=3",
                                                     "coast:n=800,seed=3,holes=3",
                                                     "koch:n=192,seed=1,holes=3",
                                                     "plate:n=4,seed=1,holes=7,sides=16",
                                                     "needle:n=12,seed=2,holes=9,depth=6",
                                                     "clusters:n=12,seed=1,spread=3",
                                                     "slopes:n=44,seed=1,holes=3",
                                                     "near-grid:n=40,seed=3,holes=3,amplitude=2"};

std::string example(const FamilyDescription& family) {
  const auto found = std::ranges::find_if(kExamples, [&](std::string_view recipe) {
    return recipe.substr(0, recipe.find(':')) == family.name;
  });
  if (found != kExamples.end()) return std::string(*found);
  return fmt::format("{}:n={},seed=1,holes={}", family.name, fitting(family.sizes, 60),
                     std::min<std::int64_t>(3, family.parameters.front().largest));
}

/// Fits a ring's box into a square around the given middle.
struct Frame {
  Point low;
  double scale = 1;
  Point corner;  ///< where low goes to, in pixels

  Frame(const Ring& ring, Point middle) : low(ring.front()) {
    Point high = low;
    for (const Point& p : ring) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    scale = kPolygon / std::max(high.x - low.x, high.y - low.y);
    corner = {middle.x - scale * (high.x - low.x) / 2, middle.y + scale * (high.y - low.y) / 2};
  }
  [[nodiscard]] std::vector<Point> apply(const Ring& ring) const {
    std::vector<Point> chain;
    for (const Point& p : ring)
      chain.push_back({corner.x + scale * (p.x - low.x), corner.y - scale * (p.y - low.y)});
    return chain;
  }
};

void draw(Canvas& canvas, const Polygon& polygon, Point middle) {
  const Frame frame(polygon.rings.front(), middle);
  Chains outer;
  Chains holes;
  Chains lines;
  for (const Ring& ring : polygon.rings) {
    std::vector<Point> chain = frame.apply(ring);
    (outer.empty() ? outer : holes).add(chain);
    chain.push_back(chain.front());
    lines.add(chain);
  }
  canvas.fill(outer, kInside);
  if (!holes.empty()) canvas.fill(holes, kWhite);
  canvas.stroke(lines, kLine, 0.8);
  if (outer.points.size() < kDotted) canvas.dots(outer.points, kLine, 1.1);
}

/// The family's example in a cell, its name and recipe below.
void draw_cell(Canvas& canvas, const FamilyDescription& family, Point corner) {
  const std::string recipe = example(family);
  draw(canvas, generate_polygon(parse_polygon_recipe(recipe)),
       {corner.x + kCell / 2, corner.y + kCell / 2});
  canvas.text({corner.x + kMargin, corner.y + kCell + 12}, std::string(family.name), 15);
  canvas.text({corner.x + kMargin, corner.y + kCell + 27}, recipe, 10);
}

}  // namespace

Gallery gallery_of_polygons() {
  const auto families = polygon_families();
  const std::size_t rows = (families.size() + kColumns - 1) / kColumns;
  constexpr double kRow = kCell + kCaption;
  return {kCell * kColumns, kRow * static_cast<double>(rows), [families](Canvas& canvas) {
            for (std::size_t i = 0; i < families.size(); ++i) {
              const std::size_t row = i / kColumns;
              draw_cell(
                  canvas, families[i],
                  {kCell * static_cast<double>(i % kColumns), kRow * static_cast<double>(row)});
            }
          }};
}

}  // namespace quadbound
