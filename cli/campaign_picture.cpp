// SPDX-License-Identifier: Apache-2.0
#include "cli/campaign_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <vector>

#include "model/files.hpp"
#include "model/picture_canvas.hpp"

namespace quadbound::cli {
namespace {

constexpr double kWidth = 860;
constexpr double kHeight = 600;
constexpr double kPanelWidth = 360;
constexpr double kPanelHeight = 180;
constexpr double kLeft = 60;
constexpr double kTop = 76;
constexpr double kAcross = 420;  // from one panel to the next
constexpr double kDown = 272;
constexpr double kTextSize = 12;
constexpr double kDigitWidth = 0.6 * kTextSize;  // of a sans-serif digit, near enough to centre it
constexpr Colour kInk{34, 34, 34};
constexpr Colour kBar{11, 95, 165};
constexpr Colour kBound{200, 60, 20};

struct Bar {
  double left;
  double right;
  std::uint64_t count;
};

struct Tick {
  double at;
  std::string text;
};

struct Bound {
  double at;
  std::string text;
};

struct Panel {
  std::string title;
  double low = 0;
  double high = 1;
  std::vector<Bar> bars;
  std::vector<Tick> ticks;
  std::optional<Bound> bound;
};

/// Draws a panel with its upper left corner at `corner`.
class PanelDrawing {
 public:
  PanelDrawing(Canvas& canvas, const Panel& panel, const Point& corner)
      : canvas_(canvas), panel_(panel), corner_(corner) {
    for (const Bar& bar : panel.bars) highest_ = std::max(highest_, bar.count);
  }

  void draw() {
    Chains bars;
    for (const Bar& bar : panel_.bars)
      bars.add({{x(bar.left), y(0)},
                {x(bar.right), y(0)},
                {x(bar.right), y(bar.count)},
                {x(bar.left), y(bar.count)}});
    canvas_.fill(bars, kBar);
    canvas_.text({corner_.x, corner_.y - 26}, panel_.title, kTextSize);
    line(corner_.x, y(0), corner_.x + kPanelWidth, y(0), kInk);
    line(corner_.x, y(0), corner_.x, corner_.y, kInk);
    number_left(highest_);
    number_left(0);
    for (const Tick& tick : panel_.ticks) {
      line(x(tick.at), y(0), x(tick.at), y(0) + 5, kInk);
      centred(x(tick.at), y(0) + 20, tick.text);
    }
    if (panel_.bound) draw_bound(*panel_.bound);
  }

 private:
  [[nodiscard]] double x(double value) const {
    const double share = (value - panel_.low) / (panel_.high - panel_.low);
    return corner_.x + std::clamp(share, 0.0, 1.0) * kPanelWidth;
  }
  [[nodiscard]] double y(std::uint64_t count) const {
    const double share = static_cast<double>(count) / static_cast<double>(highest_);
    return corner_.y + (1 - share) * kPanelHeight;
  }
  void line(double x0, double y0, double x1, double y1, Colour colour) {
    Chains chains;
    chains.add({{x0, y0}, {x1, y1}});
    canvas_.stroke(chains, colour, 1);
  }
  void centred(double at_x, double at_y, const std::string& text) {
    const double width = kDigitWidth * static_cast<double>(text.size());
    canvas_.text({at_x - width / 2, at_y}, text, kTextSize);
  }
  void number_left(std::uint64_t count) {
    const std::string text = fmt::format("{}", count);
    const double width = kDigitWidth * static_cast<double>(text.size());
    canvas_.text({corner_.x - 6 - width, y(count) + 4}, text, kTextSize);
  }
  void draw_bound(const Bound& bound) {
    line(x(bound.at), y(0), x(bound.at), corner_.y, kBound);
    const double width = kDigitWidth * static_cast<double>(bound.text.size());
    const bool is_left = x(bound.at) < corner_.x + kPanelWidth / 2;
    canvas_.text({is_left ? x(bound.at) + 4 : x(bound.at) - 4 - width, corner_.y - 6}, bound.text,
                 kTextSize);
  }

  Canvas& canvas_;
  const Panel& panel_;
  Point corner_;
  std::uint64_t highest_ = 1;
};

// --- the four panels -----------------------------------------------------------------------------

Panel angles_panel(const Histogram& histogram, double (*start)(std::int64_t), const char* title,
                   double low, double high) {
  Panel panel{title, low, high, {}, {}, std::nullopt};
  for (const auto& [bin, count] : histogram)
    panel.bars.push_back({start(bin), start(bin + 1), count});
  constexpr double kStep = 10;
  for (double at = std::ceil(low / kStep) * kStep; at <= high; at += kStep)
    panel.ticks.push_back({at, fmt::format("{}", at)});
  return panel;
}

/// On a scale of powers of two.
Panel cells_panel(const Histogram& histogram) {
  Panel panel{"cells per vertex, N/n", 4, 5, {}, {}, std::nullopt};
  if (!histogram.empty()) {
    panel.low = std::floor(std::log2(ratio_bin_start(histogram.begin()->first)));
    panel.high = std::ceil(std::log2(ratio_bin_start(histogram.rbegin()->first + 1)));
  }
  for (const auto& [bin, count] : histogram)
    panel.bars.push_back(
        {std::log2(ratio_bin_start(bin)), std::log2(ratio_bin_start(bin + 1)), count});
  for (double at = panel.low; at <= panel.high; ++at)
    panel.ticks.push_back({at, fmt::format("{}", std::exp2(at))});
  return panel;
}

Panel quads_panel(const Histogram& histogram) {
  Panel panel{"quads per cell, quads/N (at most 5)", 0, 1, {}, {}, std::nullopt};
  if (!histogram.empty())
    panel.high = std::max(1.0, std::ceil(quads_bin_start(histogram.rbegin()->first + 1)));
  for (const auto& [bin, count] : histogram)
    panel.bars.push_back({quads_bin_start(bin), quads_bin_start(bin + 1), count});
  constexpr int kTicks = 5;
  for (int i = 0; i <= kTicks; ++i) {
    const double at = panel.high * i / kTicks;
    panel.ticks.push_back({at, fmt::format("{:.1f}", at)});
  }
  return panel;
}

std::array<Panel, 4> panels(const PolygonTally& tally) {
  // Bins begin, or end, at the bounds.
  const double lower = smallest_angle_bin_start(0);
  const double upper = largest_angle_bin_start(0);
  std::array<Panel, 4> all{angles_panel(tally.smallest_angles, smallest_angle_bin_start,
                                        "smallest new angle of each mesh, degrees", 15, 90),
                           angles_panel(tally.largest_angles, largest_angle_bin_start,
                                        "largest new angle of each mesh, degrees", 90, 175),
                           cells_panel(tally.cells_per_vertex), quads_panel(tally.quads_per_cell)};
  all[0].bound = {lower, fmt::format("bound {:.2f}", lower)};
  all[1].bound = {upper, fmt::format("bound {:.2f}", upper)};
  return all;
}

void draw(Canvas& canvas, const PolygonTally& tally) {
  canvas.text({kLeft, 28},
              fmt::format("{} polygons: {} proved, {} refused, {} findings", tally.all.cases,
                          tally.all.count(PolygonOutcome::kProved), tally.refusals.size(),
                          tally.findings.size()),
              15);
  const std::array<Panel, 4> all = panels(tally);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t row = i / 2;
    const std::size_t column = i % 2;
    const Point corner{kLeft + kAcross * static_cast<double>(column),
                       kTop + kDown * static_cast<double>(row)};
    PanelDrawing(canvas, all[i], corner).draw();
  }
}

}  // namespace

void write_campaign_picture(const std::string& path, const PolygonTally& tally) {
  const std::string ending = std::filesystem::path(path).extension().string();
  const auto drawing = [&tally](Canvas& canvas) { draw(canvas, tally); };
  const auto draw_as = ending == ".svg"   ? draw_svg
                       : ending == ".pdf" ? draw_pdf
                       : ending == ".png" ? draw_png
                                          : nullptr;
  if (draw_as == nullptr) throw std::invalid_argument(path + ": .svg, .pdf or .png is expected");
  write_file(path, [&](std::ostream& stream) { draw_as(stream, kWidth, kHeight, drawing); });
}

}  // namespace quadbound::cli
