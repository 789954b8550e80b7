// SPDX-License-Identifier: Apache-2.0
#include "paper/reproduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <string_view>
#include <utility>

#include "generators/points.hpp"
#include "generators/polygons.hpp"
#include "model/read_points.hpp"
#include "model/read_polygon.hpp"
#include "model/validate.hpp"
#include "paper/lemma_claims.hpp"

namespace quadbound {
namespace {

constexpr std::array<std::uint64_t, 11> kSizes{
    100, 300, 1000, 3000, 10'000, 30'000, 100'000, 300'000, 1'000'000, 3'000'000, 10'000'000};
constexpr std::uint64_t kSeeds = 5;
constexpr std::uint64_t kLargeSize = 100'000;  ///< from here on fewer seeds
constexpr std::uint64_t kSeedsOfLarge = 3;
constexpr std::uint64_t kFamilySize = 1000;
constexpr std::uint64_t kWarpedSize = 60;
constexpr std::array<GridRefinement, 2> kGrids{GridRefinement::kSixBySix,
                                               GridRefinement::kFiveByFive};

/// Partners one unit in the last place apart need cells below 2^-60 of the extent; the mesher says
/// so and refuses. 1024 units are within its reach.
std::string set_name(std::string_view family) {
  return std::string(family) + (family == "near-duplicate" ? " ulps=1024" : "");
}

class Clock {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class Measuring {
 public:
  Measuring(const MeasureOptions& options, Watcher& watcher)
      : options_(options), watcher_(watcher) {}

  Reproduction run() {
    step("fig-10: Lake Superior", [this] { lake(); });
    step("80n: uniform sets", [this] { uniform(); });
    step("80n: other families", [this] { families(); });
    step("80n: real sets", [this] { real_sets(); });
    step("thm-1: configurations",
         [this] { result_.theorem_1 = make_theorem_1_table(options_.trees, watcher_); });
    step("warping of the paper", [this] { warped(); });
    step("thm-13: polygons", [this] { polygons(); });
    step("lemmas: audited", [this] {
      result_.lemmas =
          audit_paper_lemmas(options_.audits, {result_.polygon("fig-50").polygon}, watcher_);
    });
    return std::move(result_);
  }

 private:
  template <class Work>
  void step(const std::string& name, const Work& work) {
    watcher_.stage(name);
    const Clock clock;
    work();
    result_.times.push_back({name, clock.seconds()});
    watcher_.finished(name, result_.times.back().seconds);
  }

  [[nodiscard]] PointSet read(const std::filesystem::path& path) const {
    PointSet points = read_points(path.string());
    validate(points);
    return points;
  }

  void lake() {
    result_.lake_points = read(std::filesystem::path(options_.data) / "superior-303.csv");
    Trial trial{"superior-303", std::nullopt};
    result_.lake = run_trial(trial, result_.lake_points, options_.threads);
    trial.two_two = TwoTwoVariant::kPaper;
    result_.lake_with_their_case =
        run_trial(trial, result_.lake_points, options_.threads).measurement;
  }

  /// One group per grid.
  void add_random(const std::string& family, std::uint64_t n, std::uint64_t seeds) {
    for (const GridRefinement grid : kGrids) {
      Group group{family, n, grid, {}};
      for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        watcher_.steps(seed - 1, seeds);
        const Trial trial{family, seed, grid};
        group.runs.push_back(run_trial(trial, points_of(trial, n), options_.threads).measurement);
      }
      result_.groups.push_back(std::move(group));
    }
  }

  void uniform() {
    for (const std::uint64_t n : kSizes) {
      if (n > options_.max_n) break;
      watcher_.stage(fmt::format("80n: uniform, n = {}", n));
      add_random("uniform", n, n >= kLargeSize ? kSeedsOfLarge : kSeeds);
    }
  }

  void families() {
    const std::uint64_t n = std::min(kFamilySize, options_.max_n);
    for (const FamilyDescription& family : point_families()) {
      if (family.name == "uniform") continue;
      watcher_.stage(fmt::format("80n: {}, n = {}", family.name, n));
      add_random(set_name(family.name), n, kSeeds);
    }
  }

  void add_real(const std::string& name, const PointSet& points) {
    for (const GridRefinement grid : kGrids) {
      Group group{name, points.points.size(), grid, {}};
      group.runs.push_back(
          run_trial({name, std::nullopt, grid}, points, options_.threads).measurement);
      result_.groups.push_back(std::move(group));
    }
  }

  void real_sets() {
    add_real("superior-303", result_.lake_points);
    for (const char* const name : {"coast-1000", "coast-10000"}) {
      const auto path = std::filesystem::path(options_.data) / (std::string(name) + ".csv");
      if (!std::filesystem::exists(path)) continue;
      const PointSet points = read(path);
      if (points.points.size() <= options_.max_n) add_real(name, points);
    }
  }

  void warped() {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const Trial trial{"uniform", seed, GridRefinement::kSixBySix, Warping::kPaper};
      result_.warped.push_back(
          run_trial(trial, points_of(trial, kWarpedSize), options_.threads).measurement);
    }
  }

  void add_polygon(std::string id, std::string how, const Polygon& polygon) {
    result_.polygons.push_back(
        {std::move(id), std::move(how), judge_polygon_mesh(polygon, options_.threads)});
  }

  void add_generated(std::string id, std::string_view family, int n, int holes) {
    add_polygon(
        std::move(id), fmt::format("quadbound generate {} --n {} --holes {}", family, n, holes),
        generate_polygon(
            parse_polygon_recipe(fmt::format("{}:n={},seed=1,holes={}", family, n, holes))));
  }

  void polygons() {
    add_generated("fig-46", "blob", 13, 1);  // a hole of a blob has 6 edges
    add_generated("fig-49", "obtuse-spiral", 33, 0);
    const auto path = std::filesystem::path(options_.data) / "superior-303.geojson";
    Polygon lake = read_polygon(path.string());
    lake.file = path.filename().string();
    add_polygon("fig-50", "paper/data/superior-303.geojson", lake);
    add_generated("plate", "plate", 4, 1);
    PointSet vertices{"fig-46", {}};
    for (const Ring& ring : result_.polygon("fig-46").polygon.rings)
      vertices.points.insert(vertices.points.end(), ring.begin(), ring.end());
    result_.fig_47 = run_trial({"fig-46", std::nullopt, GridRefinement::kFiveByFive}, vertices,
                               options_.threads);
  }

  const MeasureOptions& options_;
  Watcher& watcher_;
  Reproduction result_;
};

template <class Value>
std::pair<double, double> range(const std::vector<Measurement>& runs, const Value& value) {
  double low = value(runs.front());
  double high = low;
  for (const Measurement& run : runs) {
    low = std::min(low, value(run));
    high = std::max(high, value(run));
  }
  return {low, high};
}

double ratio_of(const Measurement& m) { return m.cells_per_point(); }
double quads_of(const Measurement& m) { return m.quads_per_cell(); }

}  // namespace

double Group::smallest_ratio() const { return range(runs, ratio_of).first; }
double Group::largest_ratio() const { return range(runs, ratio_of).second; }
double Group::largest_quads_per_cell() const { return range(runs, quads_of).second; }

double Group::mean_ratio() const {
  double sum = 0;
  for (const Measurement& run : runs) sum += run.cells_per_point();
  return sum / static_cast<double>(runs.size());
}

Corner<Rational> Group::smallest() const {
  Corner<Rational> best = runs.front().smallest;
  for (const Measurement& run : runs)
    if (smaller_angle(run.smallest, best)) best = run.smallest;
  return best;
}

Corner<Rational> Group::largest() const {
  Corner<Rational> best = runs.front().largest;
  for (const Measurement& run : runs)
    if (smaller_angle(best, run.largest)) best = run.largest;
  return best;
}

bool Group::proved() const {
  return std::all_of(runs.begin(), runs.end(), [](const Measurement& m) { return m.proved(); });
}

bool Reproduction::holds() const {
  return lake && lake->report.holds() && theorem_1.holds() && lemmas_hold(lemmas) &&
         std::all_of(groups.begin(), groups.end(), [](const Group& g) { return g.proved(); }) &&
         std::all_of(polygons.begin(), polygons.end(),
                     [](const PolygonFigure& f) { return f.judged.report.holds(); });
}

const JudgedPolygonMesh& Reproduction::polygon(std::string_view id) const {
  return std::find_if(polygons.begin(), polygons.end(),
                      [&](const PolygonFigure& f) { return f.id == id; })
      ->judged;
}

const Group* Reproduction::find(const std::string& set, std::uint64_t points,
                                GridRefinement refinement) const {
  const auto found = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
    return g.set == set && g.points == points && g.refinement == refinement;
  });
  return found == groups.end() ? nullptr : &*found;
}

MeasureOptions full_measure_options() {
  MeasureOptions options;
  options.max_n = 1'000'000;
  options.trees = 20'000;
  options.audits = 200'000;
  return options;
}

Reproduction measure(const MeasureOptions& options, Watcher& watcher) {
  return Measuring(options, watcher).run();
}

}  // namespace quadbound
