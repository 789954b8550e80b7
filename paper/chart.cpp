// SPDX-License-Identifier: Apache-2.0
#include "paper/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace quadbound {
namespace {

constexpr double kWidth = 720;
constexpr double kHeight = 440;
constexpr double kLeft = 64;
constexpr double kRight = 20;
constexpr double kTop = 84;
constexpr double kBottom = 56;
constexpr double kLowestN = 2;     // powers of ten
constexpr double kApart = 6;       // of the families at the same n
constexpr double kStep = 20;       // of the axis of N / n
constexpr double kTopRatio = 120;  // what is above is drawn at the top, with its value

// Distinct for colour-blind readers.
constexpr std::string_view kSixColour = "#0b5fa5";
constexpr std::string_view kFiveColour = "#d1700b";
constexpr std::string_view kFamilyColour = "#777777";
constexpr std::string_view kRealColour = "#1a7f4b";
constexpr std::string_view kPaperColour = "#222222";

class Chart {
 public:
  explicit Chart(const Reproduction& reproduction) : r_(reproduction) {
    for (const Group& g : r_.groups)
      highest_n_ = std::max(highest_n_, std::log10(static_cast<double>(g.points)));
  }

  std::string draw() {
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"sans-serif\" font-size=\"13\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
        kWidth, kHeight);
    axes();
    paper_line(80, "paper: about 80 n", 5);
    paper_line(20845.0 / 303.0, "paper: its lake, 68.8 n", 5);
    marks();
    series(GridRefinement::kSixBySix, kSixColour);
    series(GridRefinement::kFiveByFive, kFiveColour);
    legend();
    return out_ + "</svg>\n";
  }

 private:
  [[nodiscard]] double x(double n) const {
    const double share = (std::log10(n) - kLowestN) / (highest_n_ - kLowestN);
    return kLeft + 14 + share * (kWidth - kLeft - kRight - 28);
  }
  [[nodiscard]] static double y(double ratio) {
    return kHeight - kBottom - std::min(ratio, kTopRatio) / kTopRatio * (kHeight - kTop - kBottom);
  }

  void text(double at_x, double at_y, std::string_view anchor, std::string_view words,
            std::string_view colour = "#222222") {
    out_ +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n",
                    at_x, at_y, anchor, colour, words);
  }
  void line(double x0, double y0, double x1, double y1, std::string_view style) {
    out_ += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" fill=\"none\" {}/>\n", x0, y0, x1,
                        y1, style);
  }

  void axes() {
    for (double ratio = 0; ratio <= kTopRatio; ratio += kStep) {
      line(kLeft, y(ratio), kWidth - kRight, y(ratio), "stroke=\"#e4e4e4\"");
      text(kLeft - 8, y(ratio) + 4, "end", fmt::format("{}", ratio));
    }
    for (const int n : {100, 300, 1000, 3000, 10'000, 30'000, 100'000, 300'000, 1'000'000,
                        3'000'000, 10'000'000}) {
      if (std::log10(n) > highest_n_) break;
      line(x(n), y(0), x(n), y(0) + 5, "stroke=\"#222222\"");
      text(x(n), y(0) + 20, "middle", fmt::format("{}", n));
    }
    line(kLeft, y(0), kWidth - kRight, y(0), "stroke=\"#222222\"");
    text((kLeft + kWidth - kRight) / 2, kHeight - 12, "middle", "points n");
    out_ += fmt::format(
        "<text transform=\"translate(18 {:.1f}) rotate(-90)\" text-anchor=\"middle\" "
        "fill=\"#222222\">cells per point N / n</text>\n",
        (kTop + kHeight - kBottom) / 2);
  }

  /// `rise` keeps the words of neighbouring lines apart.
  void paper_line(double ratio, std::string_view words, double rise) {
    line(kLeft, y(ratio), kWidth - kRight, y(ratio),
         fmt::format("stroke=\"{}\" stroke-dasharray=\"6 4\"", kPaperColour));
    text(kWidth - kRight - 4, y(ratio) - rise, "end", words, kPaperColour);
  }

  /// The mean of each size joined by a line, and the spread over the seeds as a bar.
  void series(GridRefinement grid, std::string_view colour) {
    std::string path;
    for (const Group& g : r_.groups) {
      if (g.set != "uniform" || g.refinement != grid) continue;
      const double at = x(static_cast<double>(g.points));
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at, y(g.mean_ratio()));
      line(at, y(g.smallest_ratio()), at, y(g.largest_ratio()),
           fmt::format("stroke=\"{}\" stroke-width=\"5\" stroke-opacity=\"0.45\"", colour));
      out_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>\n", at,
                          y(g.mean_ratio()), colour);
    }
    out_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", path,
                        colour);
  }

  /// The other families beside each other around their n, and the real sets.
  void marks() {
    double shift = -4 * kApart;
    for (const Group& g : r_.groups) {
      if (g.set == "uniform" || g.refinement != GridRefinement::kSixBySix) continue;
      const double at = x(static_cast<double>(g.points));
      if (g.runs.front().trial.seed) {
        family_mark(at + shift, g);
        shift += kApart;
      } else {
        real_mark(at, g.mean_ratio());
      }
    }
  }

  void family_mark(double at, const Group& g) {
    if (g.mean_ratio() > kTopRatio)
      text(at + 6, y(kTopRatio) + 16, "start",
           fmt::format("{:.0f} ({}) \u2191", g.mean_ratio(), g.set), kFamilyColour);
    line(at, y(g.smallest_ratio()), at, y(g.largest_ratio()),
         fmt::format("stroke=\"{}\" stroke-width=\"2\"", kFamilyColour));
    out_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n", at,
                        y(g.mean_ratio()), kFamilyColour);
  }

  void real_mark(double at, double ratio) { diamond(at, y(ratio)); }

  void diamond(double at_x, double at_y) {
    out_ += fmt::format("<path d=\"M{:.1f} {:.1f}l5 5l-5 5l-5 -5z\" fill=\"{}\"/>\n", at_x,
                        at_y - 5, kRealColour);
  }

  void legend() {
    text(kLeft, 22, "start", "Cells of the quadtree per point (80n)");
    legend_entry(kLeft, 42, kSixColour, "uniform, 6x6 grid: mean and spread");
    legend_entry(kLeft + 320, 42, kFiveColour, "uniform, 5x5 grid");
    legend_entry(kLeft, 62, kFamilyColour, "other families, n = 1000, 6x6 grid");
    diamond(kLeft + 326, 58);
    text(kLeft + 338, 62, "start", "lake and coasts, 6x6 grid", kRealColour);
  }

  void legend_entry(double at_x, double at_y, std::string_view colour, std::string_view words) {
    out_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>\n", at_x + 6,
                        at_y - 4, colour);
    text(at_x + 18, at_y, "start", words, colour);
  }

  const Reproduction& r_;
  double highest_n_ = 5;  // powers of ten
  std::string out_;
};

}  // namespace

std::string cells_per_point_chart(const Reproduction& reproduction) {
  return Chart(reproduction).draw();
}

}  // namespace quadbound
