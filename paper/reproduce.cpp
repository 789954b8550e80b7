// SPDX-License-Identifier: Apache-2.0
#include "paper/reproduce.hpp"

#include <chrono>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "model/errors.hpp"
#include "model/files.hpp"
#include "model/picture.hpp"
#include "paper/chart.hpp"
#include "paper/commit.hpp"
#include "paper/reproduction_files.hpp"

namespace quadbound {
namespace {

namespace fs = std::filesystem;

/// The part of the lake that is magnified: Isle Royale and the mainland north of it.
constexpr PictureWindow kMagnified{{2.3, 1.75}, {3.0, 2.45}};

/// Dots along the square's border, close enough to make a line.
std::vector<Point> square_dots(const PictureWindow& window) {
  constexpr int kDots = 40;
  std::vector<Point> dots;
  for (int i = 0; i <= kDots; ++i) {
    const double share = static_cast<double>(i) / kDots;
    const double x = window.low.x + share * (window.high.x - window.low.x);
    const double y = window.low.y + share * (window.high.y - window.low.y);
    dots.push_back({x, window.low.y});
    dots.push_back({x, window.high.y});
    dots.push_back({window.low.x, y});
    dots.push_back({window.high.x, y});
  }
  return dots;
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

ReportPictures write_all_pictures(const ResultFolder& folder, const Reproduction& r) {
  ReportPictures pictures;
  PictureOptions whole;
  whole.points = square_dots(kMagnified);
  pictures.whole = write_pictures(folder, "fig-10-whole", r.lake->mesh, whole);
  PictureOptions magnified;
  magnified.window = kMagnified;
  magnified.points = r.lake_points.points;
  magnified.width = 1000;
  pictures.magnified = write_pictures(folder, "fig-10-magnified", r.lake->mesh, magnified);
  pictures.chart = cells_per_point_chart(r);
  folder.write("n-against-N.svg", pictures.chart);
  return pictures;
}

}  // namespace

ReproduceResult reproduce(const ReproduceOptions& options, Watcher& watcher) {
  const ResultFolder folder(options.out);  // refuse before the work
  const Reproduction r = measure(options.measure, watcher);
  watcher.stage("writing");
  const Provenance provenance{options.command, build_commit()};
  folder.write("fig-10-report.json", to_json(r.lake->report));
  folder.write("n-against-N.csv", n_against_n_csv(r));
  folder.write("reproduction.json", reproduction_json(r, provenance));
  folder.write("machine.json", machine_json(r));
  const Document report = reproduction_report(r, provenance, write_all_pictures(folder, r));
  folder.write("reproduction.md", to_markdown(report));
  folder.write("reproduction.html", to_html(report, "Section 2 of the paper, reproduced"));
  return {r.holds(), compare_with_paper(r), folder.file("reproduction.html")};
}

std::string find_data_folder() {
  const auto has_lake = [](const fs::path& folder) {
    return fs::exists(folder / "superior-303.csv");
  };
  std::error_code error;
  for (fs::path at = fs::current_path(error); !error; at = at.parent_path()) {
    if (has_lake(at / "paper" / "data"))
      return (at / "paper" / "data").lexically_relative(fs::current_path()).string();
    if (at == at.root_path()) break;
  }
  if (has_lake(QUADBOUND_PAPER_DATA)) return QUADBOUND_PAPER_DATA;
  throw InputError({"paper/data", {}, {}},
                   "no superior-303.csv here or in a folder above; --data says where it is");
}

std::string build_commit() { return kCommit; }

}  // namespace quadbound
