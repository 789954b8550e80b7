// SPDX-License-Identifier: Apache-2.0
#include "generators/gallery.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "generators/polygons.hpp"

namespace quadbound {
namespace {

std::string drawn(const Gallery& gallery) {
  std::ostringstream stream;
  draw_svg(stream, gallery.width, gallery.height, gallery.drawing);
  return stream.str();
}

TEST(Gallery, EveryFamilyIsDrawnWithItsNameAndRecipe) {
  const std::string svg = drawn(gallery_of_polygons());
  for (const FamilyDescription& family : polygon_families()) {
    EXPECT_NE(svg.find('>' + std::string(family.name) + "</text>"), std::string::npos)
        << family.name;
    EXPECT_NE(svg.find('>' + std::string(family.name) + ":n="), std::string::npos) << family.name;
  }
}

TEST(Gallery, SameBytesEachTime) {
  EXPECT_EQ(drawn(gallery_of_polygons()), drawn(gallery_of_polygons()));
}

/// Notes how far a drawing reaches.
class Ruler : public Canvas {
 public:
  void fill(const Chains& polygons, Colour) override { measure(polygons.points); }
  void stroke(const Chains& lines, Colour, double) override { measure(lines.points); }
  void dots(const std::vector<Point>& centres, Colour, double) override { measure(centres); }
  void text(const Point& at, const std::string&, double) override { measure({at}); }

  Point low{1e9, 1e9};
  Point high{-1e9, -1e9};

 private:
  void measure(const std::vector<Point>& points) {
    for (const Point& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
};

TEST(Gallery, NothingLiesOutsideOfTheSheet) {
  const Gallery gallery = gallery_of_polygons();
  Ruler ruler;
  gallery.drawing(ruler);
  EXPECT_GE(ruler.low.x, 0);
  EXPECT_GE(ruler.low.y, 0);
  EXPECT_LE(ruler.high.x, gallery.width);
  EXPECT_LE(ruler.high.y, gallery.height);
}

}  // namespace
}  // namespace quadbound
