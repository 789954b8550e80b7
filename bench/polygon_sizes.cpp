// SPDX-License-Identifier: Apache-2.0
// How many cells N polygons of all families, or of files, take, against their vertices n and
// against what really asks for cells, the sum over the boundary of 1 / feature size. Every mesh is
// proved.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "algo/fine_point.hpp"
#include "algo/mesh_polygon.hpp"
#include "algo/point_separation.hpp"
#include "bench/feature_size.hpp"
#include "generators/polygons.hpp"
#include "model/errors.hpp"
#include "model/read_polygon.hpp"
#include "model/validate.hpp"
#include "verify/verify.hpp"

namespace quadbound {
namespace {

// --- one polygon ---------------------------------------------------------------------------------

struct Size {
  double vertices = 0;
  double cells = 0;
  double quads = 0;
  double cells_before = 0;  ///< before edge separation: of the vertices and their 5x5 grids
  double five_by_five = 0;  ///< leaves of that tree in the root square of point sets
  double six_by_six = 0;    ///< the same with the paper's 6x6 refinement
  double integral = 0;      ///< sum over the boundary of 1 / feature size
};

double leaves_with(const std::vector<Point>& points, GridRefinement refinement) {
  return static_cast<double>(
      separate_points(place_root(points), refinement, Budget{}).tree.leaf_count());
}

std::vector<Point> vertices_of(const Polygon& polygon) {
  std::vector<Point> points;
  for (const Ring& ring : polygon.rings) points.insert(points.end(), ring.begin(), ring.end());
  return points;
}

/// Of the mesh and its judge nothing is left in memory when the rest is measured.
std::variant<Size, Refusal> mesh_size(const Polygon& polygon, std::uint64_t max_cells) {
  Budget budget;
  budget.max_cells = max_cells;
  PolygonMeshResult result = mesh_polygon(polygon, {budget, {}});
  if (const auto* refusal = std::get_if<Refusal>(&result)) return *refusal;
  const auto& made = std::get<PolygonMesh>(result);
  if (!verify_polygon(polygon, made.mesh).holds())
    throw std::runtime_error(polygon.file + ": A CLAIM FAILED");
  Size size;
  size.cells = static_cast<double>(made.mesh.cells);
  size.quads = static_cast<double>(made.mesh.quads.size());
  size.cells_before = static_cast<double>(made.counters.cells_before);
  return size;
}

/// The refusal where the budget ran out. Throws: std::runtime_error where a claim fails.
std::variant<Size, Refusal> size_of(const Polygon& polygon, std::uint64_t max_cells) {
  std::variant<Size, Refusal> result = mesh_size(polygon, max_cells);
  if (auto* const size = std::get_if<Size>(&result)) {
    const std::vector<Point> points = vertices_of(polygon);
    size->vertices = static_cast<double>(points.size());
    size->five_by_five = leaves_with(points, GridRefinement::kFiveByFive);
    size->six_by_six = leaves_with(points, GridRefinement::kSixBySix);
    size->integral = inverse_feature_size_integral(polygon);
  }
  return result;
}

// --- many ----------------------------------------------------------------------------------------

struct Spread {
  double sum = 0;
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  unsigned count = 0;

  void add(double value) {
    sum += value;
    least = std::min(least, value);
    most = std::max(most, value);
    ++count;
  }
  [[nodiscard]] double mean() const { return sum / count; }
  [[nodiscard]] std::string text(int digits) const {
    if (count == 0) return "";
    const auto number = [&](double value) { return fmt::format("{:.{}f}", value, digits); };
    if (number(least) == number(most)) return number(most);
    return fmt::format("{} ({} to {})", number(mean()), number(least), number(most));
  }
};

/// log N against log n, and the exponent with its standard error.
class PowerLaw {
 public:
  void add(double n, double cells) {
    x_.push_back(std::log(n));
    y_.push_back(std::log(cells));
  }

  [[nodiscard]] std::string exponent() const {
    const auto count = static_cast<double>(x_.size());
    double mean_x = 0;
    double mean_y = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      mean_x += x_[i] / count;
      mean_y += y_[i] / count;
    }
    double xx = 0;
    double xy = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      xx += (x_[i] - mean_x) * (x_[i] - mean_x);
      xy += (x_[i] - mean_x) * (y_[i] - mean_y);
    }
    if (count < 3 || xx == 0) return "";
    const double slope = xy / xx;
    double rest = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const double off = y_[i] - mean_y - slope * (x_[i] - mean_x);
      rest += off * off;
    }
    // Two standard errors: 95 % where deviations are independent and normal.
    const double error = 2 * std::sqrt(rest / (count - 2) / xx);
    return fmt::format("{:.2f} +- {:.2f}", slope, error);
  }

 private:
  std::vector<double> x_;
  std::vector<double> y_;
};

/// The numbers of one row.
struct Row {
  Spread per_vertex, per_cell, separation, grids, integral;

  void add(const Size& size) {
    per_vertex.add(size.cells / size.vertices);
    per_cell.add(size.quads / size.cells);
    separation.add(size.cells / size.cells_before);
    grids.add(size.six_by_six / size.five_by_five);
    integral.add(size.cells / size.integral);
  }
  [[nodiscard]] std::string text() const {
    return fmt::format("{} | {} | {} | {} | {}", per_vertex.text(1), per_cell.text(2),
                       separation.text(2), grids.text(2), integral.text(2));
  }
};

constexpr const char* kColumns = R"(
n counts all vertices, those of holes too; N the leaves of the quadtree. Every mesh is proved. *before separation*: N of
the tree of the vertices and their 5x5 grids alone. *6x6 / 5x5*: leaves of the paper's first refinement over those of its
"possible smaller-sized" one, for the same vertices in the root square of point sets. *integral*: the sum over the
boundary of 1 / local feature size (Ruppert's). Refused: more than {} cells.

)";

/// What is being done, on a terminal only.
class ProgressLine {
 public:
  ~ProgressLine() { show(""); }
  void show(const std::string& what) const {
    if (is_terminal_) fmt::print(stderr, "\r\033[K{}", what);
  }

 private:
  bool is_terminal_ = ::isatty(STDERR_FILENO) == 1;
};

struct Options {
  std::uint64_t most = 10'000;
  std::uint64_t seeds = 5;
  std::uint64_t max_cells = 5'000'000;
  std::vector<std::string> families;  ///< empty: all
  std::vector<std::string> files;
  std::string command;
};

void print_row(const std::string& row) {
  fmt::print("{}\n", row);
  std::fflush(stdout);
}

// --- families ------------------------------------------------------------------------------------

/// Beyond, one seed is enough: the sizes hardly differ.
constexpr std::uint64_t kMostForSeeds = 1000;

class FamilyExperiment {
 public:
  explicit FamilyExperiment(const Options& options) : options_(options) {}

  void run() {
    fmt::print(
        "Families with their default parameters, n up to {}, {} seeds each (one beyond n = {}); "
        "mean, least and largest. A family that\nis refused at one size is not tried at the "
        "next.\n",
        options_.most, options_.seeds, kMostForSeeds);
    fmt::print(kColumns, options_.max_cells);
    fmt::print(
        "| family | n | meshed | refused | N/n | quads/N | N / before separation | 6x6 / 5x5 | N / "
        "integral |\n| --- | ---: | ---: | ---: | --- | --- | --- | --- | --- |\n");
    for (const FamilyDescription& family : polygon_families())
      if (is_wanted(family.name)) run_family(family);
    fmt::print(
        "\nN as a power of n, fitted to all meshes of a family, and twice its standard error:\n\n");
    fmt::print("| family | exponent |\n| --- | --- |\n");
    for (const auto& [name, law] : laws_) fmt::print("| {} | {} |\n", name, law.exponent());
  }

 private:
  [[nodiscard]] bool is_wanted(std::string_view name) const {
    return options_.families.empty() ||
           std::count(options_.families.begin(), options_.families.end(), name) != 0;
  }

  void run_family(const FamilyDescription& family) {
    PowerLaw law;
    std::uint64_t last = 0;
    for (double wanted = 10; std::llround(wanted) <= static_cast<long long>(options_.most);
         wanted *= std::sqrt(10)) {
      const std::uint64_t n =
          fitting(family.sizes, static_cast<std::uint64_t>(std::llround(wanted)));
      if (n == last) continue;
      last = n;
      if (!run_size(std::string(family.name), n, law)) break;
    }
    laws_.emplace_back(family.name, law);
  }

  /// False where all that there are were refused.
  bool run_size(const std::string& family, std::uint64_t n, PowerLaw& law) {
    Row row;
    unsigned refused = 0;
    const std::uint64_t seeds = n > kMostForSeeds ? 1 : options_.seeds;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const std::string recipe = fmt::format("{}:n={},seed={}", family, n, seed);
      progress_.show(recipe);
      std::optional<Polygon> polygon = made(recipe);
      if (!polygon) continue;
      const std::variant<Size, Refusal> result = size_of(*polygon, options_.max_cells);
      if (const auto* const size = std::get_if<Size>(&result)) {
        law.add(size->vertices, size->cells);
        row.add(*size);
      } else {
        ++refused;
      }
    }
    progress_.show("");
    const unsigned meshed = row.per_vertex.count;
    if (meshed + refused == 0) return true;  // the family has none of this size
    print_row(fmt::format("| {} | {} | {} | {} | {} |", family, n, meshed, refused, row.text()));
    return meshed != 0;
  }

  static std::optional<Polygon> made(const std::string& recipe) {
    try {
      return generate_polygon(parse_polygon_recipe(recipe));
    } catch (const RecipeError&) {
      return std::nullopt;
    }
  }

  const Options& options_;
  ProgressLine progress_;
  std::vector<std::pair<std::string_view, PowerLaw>> laws_;
};

// --- files ---------------------------------------------------------------------------------------

class FileExperiment {
 public:
  explicit FileExperiment(const Options& options) : options_(options) {}

  void run() {
    fmt::print("Polygons of files as they are.\n");
    fmt::print(kColumns, options_.max_cells);
    fmt::print(
        "| file | n | holes | N | N/n | quads/N | N / before separation | 6x6 / 5x5 | N / integral "
        "|\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
    for (const std::string& file : options_.files) run_file(file);
    fmt::print("\nN as a power of n, fitted to all meshes, and twice its standard error: {}.\n",
               law_.exponent().empty() ? "too few" : law_.exponent());
  }

 private:
  void run_file(const std::string& file) {
    progress_.show(file);
    const Polygon polygon = read_polygon(file);
    std::string numbers;
    try {
      numbers = numbers_of(normalised(polygon));
    } catch (const InputError& error) {
      numbers = fmt::format("invalid:{} | | | | |", what_of(error, file));
    }
    progress_.show("");
    print_row(fmt::format("| {} | {} | {} | {} |", file, vertices_of(polygon).size(),
                          polygon.rings.size() - 1, numbers));
  }

  std::string numbers_of(const Polygon& polygon) {
    const std::variant<Size, Refusal> result = size_of(polygon, options_.max_cells);
    if (const auto* const refusal = std::get_if<Refusal>(&result))
      return fmt::format("refused: {} | | | | |", refusal->message);
    const Size& size = std::get<Size>(result);
    law_.add(size.vertices, size.cells);
    Row row;
    row.add(size);
    return fmt::format("{:.0f} | {}", size.cells, row.text());
  }

  /// Without the name, which is in the row already.
  static std::string what_of(const InputError& error, const std::string& file) {
    const std::string what = error.what();
    return what.starts_with(file + ":") ? what.substr(file.size() + 1) : " " + what;
  }

  const Options& options_;
  ProgressLine progress_;
  PowerLaw law_;
};

// --- the program ---------------------------------------------------------------------------------

constexpr const char* kFooter =
    R"(Writes Markdown to standard output. Exit status: 0 every mesh is proved, 1 a claim failed, 2 bad usage
or a file that is no polygon. A polygon of a file that is invalid, or refused, has a row that says why. Some
170 bytes a quad.

Examples:
  polygon_sizes > sizes.md
  polygon_sizes --family regular,coast --most 1000000 --max-cells 60000000
  polygon_sizes --max-cells 20000000 paper/data/superior-303.geojson)";

CLI::Validator family_name() {
  return {[](const std::string& name) {
            for (const FamilyDescription& family : polygon_families())
              if (family.name == name) return std::string();
            return "no family of polygons is called " + name;
          },
          "FAMILY"};
}

void add_options(CLI::App& app, Options& options) {
  app.footer(kFooter);
  app.add_option("files", options.files,
                 "polygons (.geojson, .json, .poly, .wkt) to measure instead of families");
  app.add_option("--most", options.most, "vertices of the largest polygons of families")
      ->capture_default_str();
  app.add_option("--seeds", options.seeds, "polygons of each family and size")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--family", options.families, "families, all by default")
      ->delimiter(',')
      ->check(family_name());
  app.add_option("--max-cells", options.max_cells, "refuse polygons that take more")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

/// What was asked for, without the program's folder.
std::string command_of(int argc, char** argv) {
  std::string command = "polygon_sizes";
  for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
  return command;
}

int run(int argc, char** argv) {
  CLI::App app{
      "How many cells N polygons take, against their vertices n and against the sum over "
      "the boundary of 1 / feature size.",
      "polygon_sizes"};
  Options options;
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "polygon_sizes: {} (see polygon_sizes --help)\n", error.what());
    return 2;
  }
  fmt::print("# How many cells polygons take\n\n```\n{}\n```\n\n", command_of(argc, argv));
  if (options.files.empty())
    FamilyExperiment(options).run();
  else
    FileExperiment(options).run();
  return 0;
}

}  // namespace
}  // namespace quadbound

int main(int argc, char** argv) {
  try {
    return quadbound::run(argc, argv);
  } catch (const quadbound::InputError& error) {
    fmt::print(stderr, "polygon_sizes: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "polygon_sizes: {}\n", error.what());
    return 1;
  }
}
