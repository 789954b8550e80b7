// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a picture is drawn on: pixels, y down.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "model/exact.hpp"

namespace quadbound {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

inline constexpr Colour kWhite{255, 255, 255};

/// Many chains of points, one after the other.
struct Chains {
  std::vector<Point> points;
  std::vector<std::size_t> ends;  ///< of chain i, as an index into points

  /// The points from the last end on become a chain.
  void end_chain() { ends.push_back(points.size()); }
  void add(const std::vector<Point>& chain) {
    points.insert(points.end(), chain.begin(), chain.end());
    end_chain();
  }
  [[nodiscard]] bool empty() const { return ends.empty(); }
};

class Canvas {
 public:
  Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  virtual ~Canvas() = default;

  /// Each chain as a closed polygon; polygons of one call do not overlap.
  virtual void fill(const Chains& polygons, Colour colour) = 0;
  /// Each chain as an open line with round joins and ends.
  virtual void stroke(const Chains& lines, Colour colour, double width) = 0;
  virtual void dots(const std::vector<Point>& centres, Colour colour, double radius) = 0;
  /// Sans-serif; `at` is the left end of the base line.
  virtual void text(const Point& at, const std::string& line, double size) = 0;
};

using Drawing = std::function<void(Canvas&)>;

/// A picture of width x height pixels on white, drawn by `drawing`. A PDF page is as many points
/// (1/72 inch) wide as pixels.
/// Errors: show in the stream's state; std::runtime_error naming Cairo's reason.
void draw_svg(std::ostream& stream, double width, double height, const Drawing& drawing);
void draw_pdf(std::ostream& stream, double width, double height, const Drawing& drawing);
void draw_png(std::ostream& stream, double width, double height, const Drawing& drawing);

}  // namespace quadbound
