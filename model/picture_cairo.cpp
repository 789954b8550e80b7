// SPDX-License-Identifier: Apache-2.0
// The PNG and PDF canvas: Cairo.

#include <cairo/cairo-pdf.h>
#include <cairo/cairo.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <ostream>
#include <stdexcept>
#include <string>

#include "model/picture_canvas.hpp"

#ifdef __SANITIZE_ADDRESS__
// Cairo keeps the last fonts for the next text, and fontconfig behind it loses sight of a few of
// its tables. Our own leaks are still reported.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }
#endif

namespace quadbound {
namespace {

struct DestroySurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyContext {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, DestroySurface>;
using Context = std::unique_ptr<cairo_t, DestroyContext>;

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("the picture cannot be drawn: ") +
                             cairo_status_to_string(status));
}

class CairoCanvas : public Canvas {
 public:
  explicit CairoCanvas(cairo_t* context) : context_(context) {
    cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(context_, CAIRO_LINE_CAP_ROUND);
    cairo_select_font_face(context_, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
  }

  void fill(const Chains& polygons, Colour colour) override {
    set(colour);
    for_each_batch(polygons, true, [this] { cairo_fill(context_); });
  }

  void stroke(const Chains& lines, Colour colour, double width) override {
    set(colour);
    cairo_set_line_width(context_, width);
    for_each_batch(lines, false, [this] { cairo_stroke(context_); });
  }

  void dots(const std::vector<Point>& centres, Colour colour, double radius) override {
    set(colour);
    for (const Point& centre : centres) {
      cairo_new_sub_path(context_);  // after a text, no line leads from its end to the arc
      cairo_arc(context_, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
      cairo_fill(context_);
    }
  }

  void text(const Point& at, const std::string& line, double size) override {
    set(Colour{});
    cairo_set_font_size(context_, size);
    cairo_move_to(context_, at.x, at.y);
    cairo_show_text(context_, line.c_str());
  }

 private:
  void set(Colour colour) {
    cairo_set_source_rgb(context_, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  }

  /// Cairo's time for one path grows faster than its length.
  template <class Paint>
  void for_each_batch(const Chains& chains, bool closed, const Paint& paint) {
    constexpr std::size_t kPointsPerBatch = 4096;
    std::size_t i = 0;
    std::size_t batch_start = 0;
    for (const std::size_t end : chains.ends) {
      cairo_new_sub_path(context_);
      for (; i < end; ++i) cairo_line_to(context_, chains.points[i].x, chains.points[i].y);
      if (closed) cairo_close_path(context_);
      if (i - batch_start < kPointsPerBatch) continue;
      paint();
      batch_start = i;
    }
    paint();
  }

  cairo_t* context_;
};

cairo_status_t put_bytes(void* stream, const unsigned char* bytes, unsigned int count) {
  static_cast<std::ostream*>(stream)->write(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;  // errors stay in the stream's state
}

void draw_on(cairo_surface_t* surface, const Drawing& drawing) {
  check(cairo_surface_status(surface));
  const Context context(cairo_create(surface));
  cairo_set_source_rgb(context.get(), 1, 1, 1);
  cairo_paint(context.get());
  CairoCanvas canvas(context.get());
  drawing(canvas);
  check(cairo_status(context.get()));
}

}  // namespace

void draw_pdf(std::ostream& stream, double width, double height, const Drawing& drawing) {
  const Surface surface(cairo_pdf_surface_create_for_stream(put_bytes, &stream, width, height));
  // The time of day would make every file different.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                 "2000-01-01T00:00:00Z");
  draw_on(surface.get(), drawing);
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
}

void draw_png(std::ostream& stream, double width, double height, const Drawing& drawing) {
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                                   std::max(1, static_cast<int>(width)),
                                                   std::max(1, static_cast<int>(height))));
  draw_on(surface.get(), drawing);
  check(cairo_surface_write_to_png_stream(surface.get(), put_bytes, &stream));
}

}  // namespace quadbound
