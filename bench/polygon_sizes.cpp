// SPDX-License-Identifier: Apache-2.0
// polygon_sizes [MOST] [SEEDS]: how many cells N the polygons of all families take, against their
// vertices n and against what really asks for cells, the sum over the boundary of 1 / feature size.
// Every mesh is proved. Writes Markdown to standard output.
#include <fmt/format.h>

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
#include "generators/polygons.hpp"
#include "verify/verify.hpp"

namespace quadbound {
namespace {

// --- sum over the boundary of 1 / feature size
// ----------------------------------------------------------

struct Segment {
  Vector from;
  Vector to;
};

double distance(Vector at, const Segment& edge) {
  const Vector d = edge.to - edge.from;
  const double t = std::clamp(dot(at - edge.from, d) / dot(d, d), 0.0, 1.0);
  return length(at - edge.from - t * d);
}

/// Ruppert's local feature size on the boundary, by looking at all edges.
class FeatureSize {
 public:
  explicit FeatureSize(const Polygon& polygon) {
    for (const Ring& ring : polygon.rings) {
      const std::size_t first = edges_.size();
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i];
        const Point b = ring[(i + 1) % ring.size()];
        edges_.push_back({{a.x, a.y}, {b.x, b.y}});
        previous_.push_back(i == 0 ? first + ring.size() - 1 : edges_.size() - 2);
        next_.push_back(i + 1 == ring.size() ? first : edges_.size());
      }
    }
  }

  /// The integral over the boundary. The feature size changes by no more than the way along it, so
  /// steps of a quarter of it are off by an eighth or so at most.
  [[nodiscard]] double integral_of_inverse() const {
    double sum = 0;
    for (std::size_t e = 0; e < edges_.size(); ++e) sum += along(e);
    return sum;
  }

 private:
  [[nodiscard]] double along(std::size_t e) const {
    const Vector d = edges_[e].to - edges_[e].from;
    const double size = length(d);
    double sum = 0;
    for (double done = 0; done < size;) {
      const double first = at(e, edges_[e].from + (done / size) * d);
      const double step = std::min(first / 4, size - done);
      sum += step / at(e, edges_[e].from + ((done + step / 2) / size) * d);
      done += step;
    }
    return sum;
  }

  /// Nearest edge without a common vertex, or the two neighbours, which have none with each other.
  [[nodiscard]] double at(std::size_t e, Vector point) const {
    double least = std::numeric_limits<double>::infinity();
    if (next_[next_[e]] != previous_[e])
      least = std::max(distance(point, edges_[previous_[e]]), distance(point, edges_[next_[e]]));
    for (std::size_t other = 0; other < edges_.size(); ++other)
      if (other != e && other != previous_[e] && other != next_[e])
        least = std::min(least, distance(point, edges_[other]));
    // A triangle has no two edges apart: a vertex and the opposite edge.
    if (std::isinf(least))
      least = std::max(length(point - edges_[e].from), length(point - edges_[e].to));
    return least;
  }

  std::vector<Segment> edges_;
  std::vector<std::size_t> previous_;
  std::vector<std::size_t> next_;
};

// --- one polygon
// ----------------------------------------------------------------------------------------

struct Size {
  double vertices = 0;
  double cells = 0;
  double quads = 0;
  double cells_before = 0;  ///< before edge separation: of the vertices and their 5x5 grids
  double five_by_five = 0;  ///< leaves of that tree in the root square of point sets
  double six_by_six = 0;    ///< the same with the paper's 6x6 refinement
  double integral = 0;      ///< sum over the boundary of 1 / feature size; 0 where n is large
};

/// Looking at all pairs takes seconds beyond.
constexpr std::size_t kMostForIntegral = 1000;

double leaves_with(const std::vector<Point>& points, GridRefinement refinement) {
  return static_cast<double>(
      separate_points(place_root(points), refinement, Budget{}).tree.leaf_count());
}

/// Empty where the budget ran out. Throws: std::runtime_error where a claim fails.
std::optional<Size> size_of(const Polygon& polygon) {
  const Budget budget{5'000'000, 600};
  const PolygonMeshResult result = mesh_polygon(polygon, {budget, {}});
  const auto* made = std::get_if<PolygonMesh>(&result);
  if (made == nullptr) return std::nullopt;
  if (!verify_polygon(polygon, made->mesh).holds())
    throw std::runtime_error(polygon.file + ": a claim failed");
  std::vector<Point> points;
  for (const Ring& ring : polygon.rings) points.insert(points.end(), ring.begin(), ring.end());
  return Size{static_cast<double>(points.size()),
              static_cast<double>(made->mesh.cells),
              static_cast<double>(made->mesh.quads.size()),
              static_cast<double>(made->counters.cells_before),
              leaves_with(points, GridRefinement::kFiveByFive),
              leaves_with(points, GridRefinement::kSixBySix),
              points.size() <= kMostForIntegral ? FeatureSize(polygon).integral_of_inverse() : 0};
}

// --- many
// -----------------------------------------------------------------------------------------------

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

constexpr const char* kTitle = R"(# How many cells polygons take

```
polygon_sizes {} {} > results/sizes.md
```

All families with their default parameters, n up to {}, {} seeds each (one beyond n = {}); mean, least and largest. Every
mesh is proved. n counts all vertices, those of holes too; N the leaves of the quadtree. *before separation*: N of the
tree of the vertices and their 5x5 grids alone. *6x6 / 5x5*: leaves of the paper's first refinement over those of its "possible
smaller-sized" one, for the same vertices in the root square of point sets. *integral*: the sum over the boundary of
1 / local feature size (Ruppert's, by looking at all pairs of edges), for n up to {}. Refused: more than 5,000,000 cells.

)";
constexpr const char* kHead =
    R"(| family | n | meshed | refused | N/n | quads/N | N / before separation | 6x6 / 5x5 | N / integral |
| --- | ---: | ---: | ---: | --- | --- | --- | --- | --- |
)";

class Experiment {
 public:
  Experiment(std::uint64_t most, std::uint64_t seeds) : most_(most), seeds_(seeds) {}

  void run() {
    fmt::print(kTitle, most_, seeds_, most_, seeds_, kMostForIntegral, kMostForIntegral);
    fmt::print("{}", kHead);
    for (const FamilyDescription& family : polygon_families()) run_family(family);
    fmt::print(
        "\nN as a power of n, fitted to all meshes of a family, and twice its standard error:\n\n");
    fmt::print("| family | exponent |\n| --- | --- |\n");
    for (const auto& [name, law] : laws_) fmt::print("| {} | {} |\n", name, law.exponent());
  }

 private:
  void run_family(const FamilyDescription& family) {
    PowerLaw law;
    std::uint64_t last = 0;
    for (double wanted = 10; std::llround(wanted) <= static_cast<long long>(most_);
         wanted *= std::sqrt(10)) {
      const std::uint64_t n =
          fitting(family.sizes, static_cast<std::uint64_t>(std::llround(wanted)));
      if (n == last) continue;
      last = n;
      run_size(std::string(family.name), n, law);
    }
    laws_.emplace_back(family.name, law);
  }

  void run_size(const std::string& family, std::uint64_t n, PowerLaw& law) {
    Spread per_vertex, per_cell, separation, grids, integral;
    unsigned refused = 0;
    const std::uint64_t seeds = n > kMostForIntegral ? 1 : seeds_;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      std::optional<Polygon> polygon = made(fmt::format("{}:n={},seed={}", family, n, seed));
      if (!polygon) continue;
      const std::optional<Size> size = size_of(*polygon);
      if (!size) {
        ++refused;
        continue;
      }
      law.add(size->vertices, size->cells);
      per_vertex.add(size->cells / size->vertices);
      per_cell.add(size->quads / size->cells);
      separation.add(size->cells / size->cells_before);
      grids.add(size->six_by_six / size->five_by_five);
      if (size->integral != 0) integral.add(size->cells / size->integral);
    }
    if (per_vertex.count + refused == 0) return;  // the family has none of this size
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", family, n, per_vertex.count,
               refused, per_vertex.text(1), per_cell.text(2), separation.text(2), grids.text(2),
               integral.text(2));
    std::fflush(stdout);
  }

  static std::optional<Polygon> made(const std::string& recipe) {
    try {
      return generate_polygon(parse_polygon_recipe(recipe));
    } catch (const RecipeError&) {
      return std::nullopt;
    }
  }

  std::uint64_t most_;
  std::uint64_t seeds_;
  std::vector<std::pair<std::string_view, PowerLaw>> laws_;
};

}  // namespace
}  // namespace quadbound

int main(int argc, char** argv) {
  try {
    const std::uint64_t most = argc > 1 ? std::stoull(argv[1]) : 10'000;
    const std::uint64_t seeds = argc > 2 ? std::stoull(argv[2]) : 5;
    quadbound::Experiment(most, seeds).run();
  } catch (const std::exception& error) {
    fmt::print(stderr, "polygon_sizes: {}\n", error.what());
    return 1;
  }
  return 0;
}
