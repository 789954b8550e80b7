// SPDX-License-Identifier: Apache-2.0
#include "paper/shape_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "model/picture_canvas.hpp"
#include "model/quad_shape.hpp"

namespace quadbound {
namespace {

constexpr double kWidth = 1000;
constexpr double kHeight = 420;
constexpr double kLeft = 56;  // of a panel
constexpr double kRight = 12;
constexpr double kTop = 44;
constexpr double kBottom = 48;
constexpr double kPanel = kWidth / 2;
constexpr double kText = 13;
constexpr double kDot = 0.9;
constexpr double kDotsPerPixel = 2;  // in a row

// claims.cpp has them as text.
constexpr double kSpiralJacobian = 0.017576;
constexpr double kLakeJacobian = 0.001242;
constexpr double kSpiralAspectRatio = 14.83;

// Distinct for colour-blind readers, and those of chart.cpp.
constexpr Colour kQuadColour{0x0b, 0x5f, 0xa5};
constexpr Colour kLineColour{0xd1, 0x70, 0x0b};
constexpr Colour kGridColour{0xe4, 0xe4, 0xe4};
constexpr Colour kAxisColour{0x22, 0x22, 0x22};

struct Mark {
  double value;
  std::string text;
};

struct Axis {
  bool is_logarithmic;
  double lowest;
  double highest;
  std::vector<double> ticks;

  /// 0 at the lowest, 1 at the highest.
  [[nodiscard]] double share(double value) const {
    const auto scaled = [this](double v) { return is_logarithmic ? std::log10(v) : v; };
    return (scaled(value) - scaled(lowest)) / (scaled(highest) - scaled(lowest));
  }
};

struct Panel {
  std::string title;
  std::size_t quads;
  std::vector<double> values;
  std::vector<Mark> marks;
};

class PanelPainter {
 public:
  PanelPainter(Canvas& canvas, const Axis& axis, double left)
      : canvas_(canvas), axis_(axis), left_(left) {}

  void draw(const Panel& panel) {
    canvas_.text({left_ + kLeft, kText + 6}, panel.title, kText);
    for (const double tick : axis_.ticks) {
      line(tick, kGridColour, 1);
      canvas_.text({left_ + 8, y(tick) + 4}, fmt::format("{:g}", tick), kText);
    }
    draw_dots(panel.values);
    for (const Mark& mark : panel.marks) {
      line(mark.value, kLineColour, 1.5);
      canvas_.text({left_ + kLeft + 8, y(mark.value) - 4}, mark.text, kText - 1);
    }
    line(axis_.lowest, kAxisColour, 1);
    canvas_.text({left_ + kLeft, kHeight - kBottom + 20},
                 fmt::format("{} quads, in the order of the mesh", panel.quads), kText);
  }

 private:
  [[nodiscard]] double y(double value) const {
    return kHeight - kBottom - axis_.share(value) * (kHeight - kTop - kBottom);
  }

  void draw_dots(const std::vector<double>& values) {
    std::set<std::pair<double, double>> places;
    const double width = kPanel - kLeft - kRight;
    const auto rounded = [](double pixels) {
      return std::round(pixels * kDotsPerPixel) / kDotsPerPixel;
    };
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(values.size());
      places.emplace(rounded(left_ + kLeft + share * width), rounded(y(values[i])));
    }
    std::vector<Point> dots;
    for (const auto& [at_x, at_y] : places) dots.push_back({at_x, at_y});
    canvas_.dots(dots, kQuadColour, kDot);
  }

  void line(double value, Colour colour, double width) {
    Chains lines;
    lines.add({{left_ + kLeft, y(value)}, {left_ + kPanel - kRight, y(value)}});
    canvas_.stroke(lines, colour, width);
  }

  Canvas& canvas_;
  const Axis& axis_;
  double left_;
};

VectorPicture drawn(const Axis& axis, const std::array<Panel, 2>& panels) {
  const Drawing drawing = [&](Canvas& canvas) {
    for (std::size_t i = 0; i < panels.size(); ++i)
      PanelPainter(canvas, axis, kPanel * static_cast<double>(i)).draw(panels[i]);
  };
  std::ostringstream svg;
  draw_svg(svg, kWidth, kHeight, drawing);
  std::ostringstream pdf;
  draw_pdf(pdf, kWidth, kHeight, drawing);
  return {svg.str(), pdf.str()};
}

/// The sine of the angle at each corner.
void add_sines(const Mesh& mesh, const Quad& quad, std::vector<double>& sines) {
  for (unsigned k = 0; k < 4; ++k) {
    const Point at = mesh.vertices.rounded(quad[k]);
    const Point next = mesh.vertices.rounded(quad[(k + 1) & 3U]);
    const Point before = mesh.vertices.rounded(quad[(k + 3) & 3U]);
    const Point u{next.x - at.x, next.y - at.y};
    const Point w{before.x - at.x, before.y - at.y};
    sines.push_back((u.x * w.y - u.y * w.x) /
                    std::sqrt((u.x * u.x + u.y * u.y) * (w.x * w.x + w.y * w.y)));
  }
}

}  // namespace

VectorPicture scaled_jacobian_chart(const Mesh& spiral, const Mesh& lake) {
  const Axis axis{false, 0, 1, {0.2, 0.4, 0.6, 0.8, 1}};
  const Mark bound{std::sin(std::atan(1.0 / 7)), "Theorem 13: 0.1414 or more"};
  const auto panel = [&](const Mesh& mesh, const char* name, double paper) {
    Panel made{fmt::format("scaled Jacobian at corners: {}", name),
               mesh.quads.size(),
               {},
               {bound, {paper, fmt::format("the paper's smallest: {:.6f}", paper)}}};
    for (const Quad& quad : mesh.quads) add_sines(mesh, quad, made.values);
    return made;
  };
  return drawn(axis, {panel(spiral, "spiral", kSpiralJacobian),
                      panel(lake, "Lake Superior", kLakeJacobian)});
}

VectorPicture aspect_ratio_chart(const Mesh& spiral, const Mesh& lake) {
  Axis axis{true, 1, 1, {}};
  const auto panel = [&](const Mesh& mesh, const char* name, std::vector<Mark> marks) {
    Panel made{fmt::format("aspect ratio: {}", name), mesh.quads.size(), {}, std::move(marks)};
    for (const Quad& quad : mesh.quads)
      made.values.push_back(quad_shape(mesh.vertices, quad).aspect_ratio);
    const double largest = *std::max_element(made.values.begin(), made.values.end());
    axis.highest = std::max(axis.highest, std::pow(10, std::ceil(std::log10(largest))));
    return made;
  };
  const std::array<Panel, 2> panels{
      panel(spiral, "spiral",
            {{kSpiralAspectRatio, fmt::format("the paper's largest: {}", kSpiralAspectRatio)}}),
      panel(lake, "Lake Superior", {})};
  for (double decade = 1; decade <= axis.highest; decade *= 10)
    for (const double digit : {1, 2, 5})
      if (digit * decade <= axis.highest) axis.ticks.push_back(digit * decade);
  return drawn(axis, panels);
}

}  // namespace quadbound
