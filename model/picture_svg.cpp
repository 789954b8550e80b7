// SPDX-License-Identifier: Apache-2.0
// The SVG canvas. Ours and not Cairo's, whose files are several times as large: here coordinates
// are integers in units of 1/100 pixel, relative to the point before, and one path holds all
// polygons of a colour.

#include <cmath>

#include "model/picture_canvas.hpp"
#include "model/write_text.hpp"

namespace quadbound {
namespace {

constexpr double kUnits = 100;  // per pixel

struct Unit {
  std::int64_t x;
  std::int64_t y;
};

std::int64_t to_units(double pixels) {
  return static_cast<std::int64_t>(std::llround(pixels * kUnits));
}

class SvgCanvas : public Canvas {
 public:
  explicit SvgCanvas(TextOut& out) : out_(out) {}

  void fill(const Chains& polygons, Colour colour) override {
    out_ << "<path fill=\"";
    put(colour);
    out_ << "\" d=\"";
    put(polygons, "z");
    out_ << "\"/>\n";
  }

  void stroke(const Chains& lines, Colour colour, double width) override {
    out_ << "<path fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\" stroke=\"";
    put(colour);
    out_ << "\" stroke-width=\"" << to_units(width) << "\" d=\"";
    put(lines, "");
    out_ << "\"/>\n";
  }

  void dots(const std::vector<Point>& centres, Colour colour, double radius) override {
    // A line of length zero with round ends is a dot.
    Chains lines;
    for (const Point& centre : centres) lines.add({centre, centre});
    stroke(lines, colour, 2 * radius);
  }

  void text(const Point& at, const std::string& line, double size) override {
    out_ << "<text font-family=\"sans-serif\" font-size=\"" << to_units(size) << "\" x=\""
         << to_units(at.x) << "\" y=\"" << to_units(at.y) << "\">";
    for (const char c : line) put_escaped(c);
    out_ << "</text>\n";
  }

 private:
  void put(Colour colour) {
    char text[8];
    *fmt::format_to_n(text, 7, "#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue).out =
        0;
    out_ << std::string_view(text, 7);
  }

  void put(const Chains& chains, std::string_view close) {
    std::size_t i = 0;
    for (const std::size_t end : chains.ends) {
      Unit last = unit(chains.points[i]);
      out_ << 'M' << last.x;
      put_next(last.y);
      for (++i; i < end; ++i) {
        const Unit here = unit(chains.points[i]);
        out_ << 'l' << here.x - last.x;
        put_next(here.y - last.y);
        last = here;
      }
      out_ << close;
    }
  }

  /// A minus sign separates as well as a blank.
  void put_next(std::int64_t value) {
    if (value >= 0) out_ << ' ';
    out_ << value;
  }

  void put_escaped(char c) {
    if (c == '&') {
      out_ << "&amp;";
    } else if (c == '<') {
      out_ << "&lt;";
    } else if (static_cast<unsigned char>(c) >= 0x20) {
      out_ << c;
    }
  }

  static Unit unit(const Point& point) { return {to_units(point.x), to_units(point.y)}; }

  TextOut& out_;
};

}  // namespace

void draw_svg(std::ostream& stream, double width, double height, const Drawing& drawing) {
  TextOut out(stream);
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\""
      << width << "\" height=\"" << height << "\" viewBox=\"0 0 " << to_units(width) << ' '
      << to_units(height) << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  SvgCanvas canvas(out);
  drawing(canvas);
  out << "</svg>\n";
}

}  // namespace quadbound
