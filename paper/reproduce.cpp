// SPDX-License-Identifier: Apache-2.0
#include "paper/reproduce.hpp"

#include <array>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "model/errors.hpp"
#include "model/files.hpp"
#include "model/picture.hpp"
#include "paper/chart.hpp"
#include "paper/commit.hpp"
#include "paper/records.hpp"
#include "paper/report_page.hpp"
#include "paper/reproduction_files.hpp"
#include "paper/shape_chart.hpp"

namespace quadbound {
namespace {

namespace fs = std::filesystem;

/// The part of the lake that is magnified: Isle Royale and the mainland north of it.
constexpr PictureWindow kMagnified{{2.3, 1.75}, {3.0, 2.45}};

/// What Figures 51 to 53 show: a narrow passage between an island and the shore, the canal's side
/// of the Keweenaw peninsula, and the south-east with Whitefish Bay.
struct Zoom {
  const char* id;
  const char* where;
  PictureWindow window;
};
constexpr std::array<Zoom, 3> kZooms{
    {{"fig-51", "the passage beside St. Ignace Island", {{3.12, 2.55}, {3.69, 3.06}}},
     {"fig-52", "Keweenaw Bay", {{2.95, 0.58}, {3.49, 1.12}}},
     {"fig-53", "Whitefish Bay", {{5.33, 0.39}, {5.86, 1.02}}}}};

/// Close enough to make a line.
void add_dots(std::vector<Point>& dots, const Point& a, const Point& b) {
  constexpr int kDots = 40;
  for (int i = 0; i <= kDots; ++i) {
    const double share = static_cast<double>(i) / kDots;
    dots.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
  }
}

/// Dots along the square's border.
void add_square_dots(std::vector<Point>& dots, const PictureWindow& window) {
  const Point& low = window.low;
  const Point& high = window.high;
  add_dots(dots, low, {low.x, high.y});
  add_dots(dots, low, {high.x, low.y});
  add_dots(dots, {low.x, high.y}, high);
  add_dots(dots, {high.x, low.y}, high);
}

std::vector<Point> outline_dots(const Polygon& polygon) {
  std::vector<Point> dots;
  for (const Ring& ring : polygon.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      add_dots(dots, ring[i], ring[(i + 1) % ring.size()]);
  return dots;
}

std::vector<Point> vertices_of(const Polygon& polygon) {
  std::vector<Point> points;
  for (const Ring& ring : polygon.rings) points.insert(points.end(), ring.begin(), ring.end());
  return points;
}

class ResultFolder {
 public:
  explicit ResultFolder(const std::string& path) : path_(path) {
    std::error_code error;
    fs::create_directories(path_, error);
    if (error) throw OutputError(path + ": " + error.message());
  }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    write_file(file(name), [&text](std::ostream& stream) { stream << text; });
  }

 private:
  fs::path path_;
};

/// Writes NAME.svg and NAME.png; the PNG's bytes for the report.
std::string write_pictures(const ResultFolder& folder, const std::string& name, const Mesh& mesh,
                           const PictureOptions& options) {
  std::ostringstream svg;
  write_svg(svg, mesh, options);
  folder.write(name + ".svg", svg.str());
  std::ostringstream png;
  write_png(png, mesh, options);
  folder.write(name + ".png", png.str());
  return png.str();
}

/// Writes NAME.svg and NAME.pdf; the former for the report.
DocumentPicture write_polygon_picture(const ResultFolder& folder, const std::string& name,
                                      const std::string& caption, const Mesh& mesh,
                                      const PictureOptions& options) {
  std::ostringstream svg;
  write_svg(svg, mesh, options);
  folder.write(name + ".svg", svg.str());
  std::ostringstream pdf;
  write_pdf(pdf, mesh, options);
  folder.write(name + ".pdf", pdf.str());
  return {name + ".svg", caption, svg.str(), {}, name};
}

std::vector<DocumentPicture> write_polygon_pictures(const ResultFolder& folder,
                                                    const Reproduction& r) {
  std::vector<DocumentPicture> pictures;
  const auto add = [&](const char* name, const std::string& caption, const Mesh& mesh,
                       const PictureOptions& options) {
    pictures.push_back(write_polygon_picture(folder, name, name + (": " + caption), mesh, options));
    if (pictures.back().file.starts_with("fig-")) pictures.back().claims = {name};
  };
  const JudgedPolygonMesh& blob = r.polygon("fig-46");
  const JudgedPolygonMesh& lake = r.polygon("fig-50");
  PictureOptions plain;
  plain.width = 1000;
  PictureOptions outline = plain;
  outline.points = outline_dots(blob.polygon);
  PictureOptions squares = plain;
  squares.width = 1600;
  for (const Zoom& zoom : kZooms) add_square_dots(squares.points, zoom.window);
  add("fig-46", "a polygon of 19 edges with a hole and no acute angle.", blob.mesh, plain);
  add("fig-47", "the mesh of its vertices by Theorem 1; dots are the polygon.", r.fig_47->mesh,
      outline);
  add("fig-48",
      "the quads that are kept before edges and corners are inserted; their boundary is "
      "the chain alpha.",
      without_strips(blob.mesh), outline);
  add("fig-49", "a spiral of 33 edges without acute angles.", r.polygon("fig-49").mesh, plain);
  add("fig-50", "Lake Superior with 303 edges; the squares are shown below.", lake.mesh, squares);
  for (const Zoom& zoom : kZooms) {
    PictureOptions zoomed = plain;
    zoomed.window = zoom.window;
    zoomed.points = vertices_of(lake.polygon);
    add(zoom.id, std::string(zoom.where) + "; dots are the polygon's vertices.", lake.mesh, zoomed);
  }
  PictureOptions coloured;
  coloured.colour = PictureColour::kMinAngle;
  add("plate", "a plate with a round hole, the picture of README.md.", r.polygon("plate").mesh,
      coloured);
  return pictures;
}

std::vector<DocumentPicture> write_shape_charts(const ResultFolder& folder, const Reproduction& r) {
  const Mesh& spiral = r.polygon("fig-49").mesh;
  const Mesh& lake = r.polygon("fig-50").mesh;
  std::vector<DocumentPicture> pictures;
  const auto add = [&](const std::string& name, const std::string& caption,
                       const VectorPicture& chart) {
    folder.write(name + ".svg", chart.svg);
    folder.write(name + ".pdf", chart.pdf);
    pictures.push_back({name + ".svg", name + ": " + caption, chart.svg, {name}});
  };
  add("fig-44", "scaled Jacobians, the sine of the angle at each corner of each quad.",
      scaled_jacobian_chart(spiral, lake));
  add("fig-45", "aspect ratio of each quad.", aspect_ratio_chart(spiral, lake));
  return pictures;
}

/// The meshes of the figures, and the parts of them that figures magnify.
void add_viewer(ReportPictures& pictures, const Reproduction& r) {
  const auto add = [&](const std::string& id, const std::string& text, const Mesh& mesh,
                       const Report& report, const std::vector<Point>& input) {
    pictures.meshes.push_back({id, viewer_mesh_json(mesh, report, input)});
    pictures.views.push_back({id, text, id, {}});
  };
  const auto add_polygon = [&](const std::string& id, const std::string& text) {
    const JudgedPolygonMesh& judged = r.polygon(id);
    add(id, text, judged.mesh, judged.report, vertices_of(judged.polygon));
  };
  add_polygon("plate", "a plate with a round hole");
  add_polygon("fig-46", "a polygon with a hole");
  add("fig-47", "its vertices, by Theorem 1", r.fig_47->mesh, r.fig_47->report,
      vertices_of(r.polygon("fig-46").polygon));
  pictures.views.push_back(
      {"fig-48", "before edges and corners (see the colour construction)", "fig-46", {}});
  add_polygon("fig-49", "a spiral");
  add_polygon("fig-50", "Lake Superior");
  for (const Zoom& zoom : kZooms)
    pictures.views.push_back({zoom.id, zoom.where, "fig-50", zoom.window});
  add("fig-10", "the points of Lake Superior, by Theorem 1", r.lake->mesh, r.lake->report,
      r.lake_points.points);
  pictures.views.push_back({"fig-10-magnified", "Isle Royale", "fig-10", kMagnified});
}

ReportPictures write_all_pictures(const ResultFolder& folder, const Reproduction& r) {
  ReportPictures pictures;
  PictureOptions whole;
  add_square_dots(whole.points, kMagnified);
  pictures.whole = write_pictures(folder, "fig-10-whole", r.lake->mesh, whole);
  PictureOptions magnified;
  magnified.window = kMagnified;
  magnified.points = r.lake_points.points;
  magnified.width = 1000;
  pictures.magnified = write_pictures(folder, "fig-10-magnified", r.lake->mesh, magnified);
  pictures.polygons = write_polygon_pictures(folder, r);
  pictures.shapes = write_shape_charts(folder, r);
  pictures.chart = cells_per_point_chart(r);
  folder.write("n-against-N.svg", pictures.chart);
  add_viewer(pictures, r);
  return pictures;
}

}  // namespace

ReproduceResult reproduce(const ReproduceOptions& options, Watcher& watcher) {
  const ResultFolder folder(options.out);  // refuse before the work
  const Reproduction r = measure(options.measure, watcher);
  watcher.stage("writing");
  const Provenance provenance{options.command, build_commit()};
  folder.write("fig-10-report.json", to_json(r.lake->report));
  for (const PolygonFigure& figure : r.polygons)
    folder.write(figure.id + "-report.json", to_json(figure.judged.report));
  folder.write("n-against-N.csv", n_against_n_csv(r));
  folder.write("reproduction.json", reproduction_json(r, provenance));
  folder.write("machine.json", machine_json(r));
  const fs::path records = fs::path(options.measure.data).lexically_normal() / "../../results";
  const Document report = reproduction_report(r, provenance, write_all_pictures(folder, r),
                                              records_block(records.lexically_normal().string()));
  folder.write("reproduction.md", to_markdown(report));
  folder.write("reproduction.html", to_html(report, report_frame("The paper, reproduced")));
  return {r.holds(), compare_with_paper(r), folder.file("reproduction.html")};
}

std::string find_data_folder() {
  const auto has_lake = [](const fs::path& folder) {
    return fs::exists(folder / "superior-303.csv") && fs::exists(folder / "superior-303.geojson");
  };
  std::error_code error;
  for (fs::path at = fs::current_path(error); !error; at = at.parent_path()) {
    if (has_lake(at / "paper" / "data"))
      return (at / "paper" / "data").lexically_relative(fs::current_path()).string();
    if (at == at.root_path()) break;
  }
  if (has_lake(QUADBOUND_PAPER_DATA)) return QUADBOUND_PAPER_DATA;
  throw InputError({"paper/data", {}, {}},
                   "no superior-303.csv and superior-303.geojson here or in a folder above; --data "
                   "says where it is");
}

std::string build_commit() { return kCommit; }

}  // namespace quadbound
