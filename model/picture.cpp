// SPDX-License-Identifier: Apache-2.0
#include "model/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/mesh_edges.hpp"
#include "model/picture_canvas.hpp"
#include "model/picture_classes.hpp"

namespace quadbound {
namespace {

constexpr double kMargin = 12;         // pixels around the mesh
constexpr double kTallest = 4;         // height over width
constexpr double kTextSize = 16;       // pixels
constexpr double kLetterWidth = 0.62;  // of the text size; wide enough for common sans-serif fonts
constexpr double kRow = 24;            // pixels from one line of the legend to the next
constexpr double kSwatch = 16;         // pixels
constexpr double kDotRadius = 3;       // pixels
constexpr Colour kInk{0x22, 0x22, 0x22};
constexpr Colour kDotColour{0xcc, 0x22, 0x22};

struct Box {
  Point low;
  Point high;
};

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr Box kNothing{{kFar, kFar}, {-kFar, -kFar}};

void include(Box& box, const Point& point) {
  box.low = {std::min(box.low.x, point.x), std::min(box.low.y, point.y)};
  box.high = {std::max(box.high.x, point.x), std::max(box.high.y, point.y)};
}

/// What is drawn: the window, or all of it.
Box box_of(const Mesh& mesh, const PictureOptions& options) {
  if (options.window) return {options.window->low, options.window->high};
  Box box = kNothing;
  for (VertexId v = 0; v < mesh.vertices.size(); ++v) include(box, mesh.vertices.rounded(v));
  for (const Point& point : options.points) include(box, point);
  return box.low.x <= box.high.x ? box : Box{{0, 0}, {1, 1}};
}

/// The number of characters, not of bytes, of a UTF-8 text.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

/// A quad that has a part in the window, or none (judged by its bounding box).
bool reaches(const Mesh& mesh, const Quad& quad, const Box& window) {
  Box box = kNothing;
  for (const VertexId vertex : quad) include(box, mesh.vertices.rounded(vertex));
  return box.low.x < window.high.x && box.high.x > window.low.x && box.low.y < window.high.y &&
         box.high.y > window.low.y;
}

/// The legend lists the classes of the quads in sight.
struct Legend {
  std::string title;
  std::vector<PictureClass> rows;

  Legend(const Mesh& mesh, const PictureClasses& classes, const Box& window)
      : title(classes.title) {
    std::vector<bool> seen(classes.classes.size(), false);
    for (std::size_t i = 0; i < classes.of_quad.size(); ++i)
      if (!seen[classes.of_quad[i]])
        seen[classes.of_quad[i]] = reaches(mesh, mesh.quads[i], window);
    for (std::size_t i = 0; i < seen.size(); ++i)
      if (seen[i]) rows.push_back(classes.classes[i]);
  }
  [[nodiscard]] double width() const {
    if (rows.empty()) return 0;
    std::size_t most = letters(title);
    for (const PictureClass& row : rows) most = std::max(most, letters(row.label) + 2);
    return kMargin + kSwatch / 2 + static_cast<double>(most) * kTextSize * kLetterWidth;
  }
  [[nodiscard]] double height() const {
    return rows.empty() ? 0 : 2 * kMargin + kRow * static_cast<double>(rows.size() + 1);
  }
  void draw(Canvas& canvas, double left) const {
    if (rows.empty()) return;
    double base = kMargin + kTextSize;
    canvas.text({left, base}, title, kTextSize);
    for (const PictureClass& row : rows) {
      base += kRow;
      const double top = base - kSwatch + 2;
      const std::vector<Point> swatch{{left, top},
                                      {left + kSwatch, top},
                                      {left + kSwatch, top + kSwatch},
                                      {left, top + kSwatch},
                                      {left, top}};
      Chains square;
      square.add(swatch);
      canvas.fill(square, row.colour);
      canvas.stroke(square, kInk, 0.5);
      canvas.text({left + kSwatch * 1.5, base}, row.label, kTextSize);
    }
  }
};

/// Where a point of the plane comes to lie on the canvas.
struct Frame {
  Box plane;
  double scale = 1;
  double width = 0;  ///< of the part with the mesh, margins included
  double height = 0;

  Frame(const Box& box, double available, double margin) : plane(box) {
    const double wide = box.high.x - box.low.x;
    const double tall = box.high.y - box.low.y;
    const double room = std::max(available - 2 * margin, 1.0);
    scale = std::min(room / std::max(wide, tall / kTallest), std::numeric_limits<double>::max());
    if (wide <= 0 && tall <= 0) scale = 1;
    width = wide * scale + 2 * margin;
    height = tall * scale + 2 * margin;
    margin_ = margin;
  }
  [[nodiscard]] Point pixel(const Point& point) const {
    return {(point.x - plane.low.x) * scale + margin_, (plane.high.y - point.y) * scale + margin_};
  }

 private:
  double margin_;
};

/// Keeps what lies within the canvas and a little beyond it, so that no line ends in sight and no
/// coordinate is too large for a renderer.
class Clip {
 public:
  Clip(double width, double height) : high_{width + kBeyond, height + kBeyond} {}

  [[nodiscard]] bool holds(const Point& p) const {
    return p.x >= -kBeyond && p.x <= high_.x && p.y >= -kBeyond && p.y <= high_.y;
  }

  /// A convex polygon, cut at the four sides one after the other; fewer than 3 points: nothing
  /// left.
  [[nodiscard]] std::vector<Point> polygon(std::vector<Point> points) const {
    if (std::all_of(points.begin(), points.end(), [&](const Point& p) { return holds(p); }))
      return points;
    for (int side = 0; side < 4; ++side) points = cut(points, side);
    return points;
  }

  /// The part of a line that is kept, if any: the shares of it that the four sides leave.
  [[nodiscard]] std::optional<std::array<Point, 2>> line(const Point& a, const Point& b) const {
    double first = 0;
    double last = 1;
    for (int side = 0; side < 4; ++side) {
      const double in_a = inside(a, side);
      const double in_b = inside(b, side);
      if (in_a < 0 && in_b < 0) return std::nullopt;
      if (in_a < 0) first = std::max(first, in_a / (in_a - in_b));
      if (in_b < 0) last = std::min(last, in_a / (in_a - in_b));
    }
    if (!(first < last)) return std::nullopt;
    return {{between(a, b, first), between(a, b, last)}};
  }

 private:
  static constexpr double kBeyond = 50;

  /// How far inside of a side a point is; negative outside.
  [[nodiscard]] double inside(const Point& p, int side) const {
    switch (side) {
      case 0:
        return p.x + kBeyond;
      case 1:
        return high_.x - p.x;
      case 2:
        return p.y + kBeyond;
      default:
        return high_.y - p.y;
    }
  }

  [[nodiscard]] std::vector<Point> cut(const std::vector<Point>& points, int side) const {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point& a = points[i];
      const Point& b = points[(i + 1) % points.size()];
      const double in_a = inside(a, side);
      const double in_b = inside(b, side);
      if (in_a >= 0) kept.push_back(a);
      if ((in_a < 0) == (in_b < 0)) continue;
      kept.push_back(between(a, b, in_a / (in_a - in_b)));
    }
    return kept;
  }

  static Point between(const Point& a, const Point& b, double share) {
    return {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share};
  }

  Point high_;
};

/// Joins edges to long chains, each edge in one of them: fewer pen-ups, shorter files.
class EdgeChains {
 public:
  explicit EdgeChains(std::vector<std::array<VertexId, 2>> edges, std::size_t vertices)
      : edges_(std::move(edges)), used_(edges_.size(), false), starts_(vertices + 1, 0) {
    for (const auto& edge : edges_)
      for (const VertexId end : edge) ++starts_[end + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    incident_.resize(2 * edges_.size());
    next_.assign(starts_.begin(), starts_.end() - 1);
    for (std::size_t i = 0; i < edges_.size(); ++i)
      for (const VertexId end : edges_[i]) incident_[next_[end]++] = i;
    next_.assign(starts_.begin(), starts_.end() - 1);
  }

  void draw(const std::function<Point(VertexId)>& pixel, Chains& chains) {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (used_[i]) continue;
      VertexId at = edges_[i][0];
      chains.points.push_back(pixel(at));
      while (step(at)) chains.points.push_back(pixel(at));
      chains.end_chain();
    }
  }

 private:
  bool step(VertexId& at) {
    for (std::size_t& i = next_[at]; i < starts_[at + 1]; ++i) {
      const std::size_t edge = incident_[i];
      if (used_[edge]) continue;
      used_[edge] = true;
      at = edges_[edge][0] == at ? edges_[edge][1] : edges_[edge][0];
      return true;
    }
    return false;
  }

  std::vector<std::array<VertexId, 2>> edges_;
  std::vector<bool> used_;
  std::vector<std::size_t> starts_;    ///< of each vertex's edges in incident_
  std::vector<std::size_t> incident_;  ///< indices into edges_
  std::vector<std::size_t> next_;      ///< the first that may be unused, for each vertex
};

class Picture {
 public:
  Picture(const Mesh& mesh, const PictureOptions& options)
      : mesh_(mesh),
        options_(options),
        classes_(picture_classes(mesh, options.colour)),
        legend_(mesh, classes_, box_of(mesh, options)),
        frame_(box_of(mesh, options), options.width - legend_.width(),
               options.window ? 0 : kMargin),
        clip_(frame_.width, frame_.height) {}

  [[nodiscard]] double width() const { return std::ceil(frame_.width + legend_.width()); }
  [[nodiscard]] double height() const {
    return std::ceil(std::max(frame_.height, legend_.height()));
  }

  void draw(Canvas& canvas) const {
    draw_quads(canvas);
    draw_edges(canvas);
    draw_points(canvas);
    hide_beside(canvas);
    legend_.draw(canvas, frame_.width + kMargin);
  }

 private:
  [[nodiscard]] Point pixel(VertexId vertex) const {
    return frame_.pixel(mesh_.vertices.rounded(vertex));
  }

  void draw_quads(Canvas& canvas) const {
    std::vector<Chains> of_class(classes_.classes.size());
    for (std::size_t i = 0; i < classes_.of_quad.size(); ++i) {
      std::vector<Point> corners;
      for (const VertexId vertex : mesh_.quads[i]) corners.push_back(pixel(vertex));
      corners = clip_.polygon(std::move(corners));
      if (corners.size() >= 3) of_class[classes_.of_quad[i]].add(corners);
    }
    for (std::size_t i = 0; i < of_class.size(); ++i)
      if (!of_class[i].empty()) canvas.fill(of_class[i], classes_.classes[i].colour);
  }

  void draw_edges(Canvas& canvas) const {
    const double width = line_width();
    for (const bool boundary : {false, true}) {
      Chains lines;
      std::vector<std::array<VertexId, 2>> whole;
      for_each_edge(mesh_, [&](const EdgeUse& use) {
        if ((use.forward != use.backward) != boundary) return;
        if (clip_.holds(pixel(use.low)) && clip_.holds(pixel(use.high))) {
          whole.push_back({use.low, use.high});
        } else if (const auto part = clip_.line(pixel(use.low), pixel(use.high))) {
          lines.add({(*part)[0], (*part)[1]});
        }
      });
      EdgeChains(std::move(whole), mesh_.vertices.size())
          .draw([&](VertexId vertex) { return pixel(vertex); }, lines);
      if (!lines.empty()) canvas.stroke(lines, kInk, boundary ? 2 * width : width);
    }
  }

  void draw_points(Canvas& canvas) const {
    std::vector<Point> centres;
    for (const Point& point : options_.points)
      if (const Point centre = frame_.pixel(point); clip_.holds(centre)) centres.push_back(centre);
    if (!centres.empty()) canvas.dots(centres, kDotColour, kDotRadius);
  }

  /// Beside a window the canvas is white again where what lies beyond the window reaches into it.
  void hide_beside(Canvas& canvas) const {
    if (!options_.window || legend_.rows.empty()) return;
    const double right = width();
    const double bottom = height();
    Chains strips;
    strips.add({{frame_.width, 0}, {right, 0}, {right, bottom}, {frame_.width, bottom}});
    strips.add({{0, frame_.height}, {right, frame_.height}, {right, bottom}, {0, bottom}});
    canvas.fill(strips, kWhite);
  }

  /// A tenth of the side of a square as large as the average quad in sight, but a line that can
  /// still be seen and is not heavy.
  [[nodiscard]] double line_width() const {
    if (options_.line_width > 0) return options_.line_width;
    std::size_t in_sight = 0;
    for (const Quad& quad : mesh_.quads) in_sight += clip_.holds(pixel(quad[0])) ? 1U : 0U;
    const double area = frame_.width * frame_.height;
    return std::clamp(0.1 * std::sqrt(area / static_cast<double>(in_sight + 1)), 0.2, 1.0);
  }

  const Mesh& mesh_;
  const PictureOptions& options_;
  PictureClasses classes_;
  Legend legend_;
  Frame frame_;
  Clip clip_;
};

}  // namespace

std::optional<std::string> picture_problem(const Mesh& mesh, const PictureOptions& options) {
  if (options.colour == PictureColour::kConstruction &&
      mesh.construction.size() < mesh.quads.size())
    return "the mesh does not know its constructions, so they cannot be coloured";
  if (options.colour == PictureColour::kLevel && mesh.level.size() < mesh.quads.size())
    return "the mesh does not know its cell levels, so they cannot be coloured";
  // Written so that NaN is a problem, too.
  if (options.window && !(options.window->low.x < options.window->high.x &&
                          options.window->low.y < options.window->high.y))
    return "the window of the picture is empty";
  if (!(options.width >= 64 && options.width <= 16384))
    return "the width of the picture is not between 64 and 16384 pixels";
  if (!(options.line_width >= 0)) return "the line width of the picture is negative";
  return std::nullopt;
}

void write_svg(std::ostream& stream, const Mesh& mesh, const PictureOptions& options) {
  const Picture picture(mesh, options);
  draw_svg(stream, picture.width(), picture.height(),
           [&](Canvas& canvas) { picture.draw(canvas); });
}

void write_pdf(std::ostream& stream, const Mesh& mesh, const PictureOptions& options) {
  const Picture picture(mesh, options);
  draw_pdf(stream, picture.width(), picture.height(),
           [&](Canvas& canvas) { picture.draw(canvas); });
}

void write_png(std::ostream& stream, const Mesh& mesh, const PictureOptions& options) {
  const Picture picture(mesh, options);
  draw_png(stream, picture.width(), picture.height(),
           [&](Canvas& canvas) { picture.draw(canvas); });
}

}  // namespace quadbound
