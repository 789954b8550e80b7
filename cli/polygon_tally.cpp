// SPDX-License-Identifier: Apache-2.0
#include "cli/polygon_tally.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/fuzz_cases.hpp"

namespace quadbound::cli {
namespace {

constexpr int kSpreadBits = 32;

constexpr std::int64_t kMicrodegreesOfABin = 500'000;
constexpr int kBinsOfAnOctave = 4;
constexpr std::int64_t kQuadBinsOfOne = 20;

/// As the angles are rounded, so are the bounds: arctan(1/3) and 180 degrees - arctan(1/7).
constexpr std::int64_t kLowerMicrodegrees = 18'434'949;
constexpr std::int64_t kUpperMicrodegrees = 171'869'898;

std::int64_t rounded_down(std::int64_t value, std::int64_t unit) {
  return value / unit - (value % unit < 0 ? 1 : 0);
}

/// The bin of part / whole.
std::int64_t ratio_bin(std::uint64_t part, std::uint64_t whole) {
  int exponent = 0;
  const double half_to_one =
      std::frexp(static_cast<double>(part) / static_cast<double>(whole), &exponent);
  const double within = (2 * half_to_one - 1) * kBinsOfAnOctave;
  return std::int64_t{kBinsOfAnOctave} * (exponent - 1) + static_cast<std::int64_t>(within);
}

void add_to_histograms(const PolygonResult& result, PolygonTally& tally) {
  if (result.cells == 0) return;
  ++tally.cells_per_vertex[ratio_bin(result.cells, result.vertices)];
  ++tally.quads_per_cell[static_cast<std::int64_t>(result.quads) * kQuadBinsOfOne /
                         static_cast<std::int64_t>(result.cells)];
  if (result.largest_microdegrees == 0) return;  // not judged
  ++tally.smallest_angles[rounded_down(result.smallest_microdegrees - kLowerMicrodegrees,
                                       kMicrodegreesOfABin)];
  ++tally.largest_angles[-1 - rounded_down(kUpperMicrodegrees - result.largest_microdegrees,
                                           kMicrodegreesOfABin)];
}

}  // namespace

double smallest_angle_bin_start(std::int64_t bin) {
  return static_cast<double>(kLowerMicrodegrees + bin * kMicrodegreesOfABin) / 1e6;
}

double largest_angle_bin_start(std::int64_t bin) {
  return static_cast<double>(kUpperMicrodegrees + bin * kMicrodegreesOfABin) / 1e6;
}

double ratio_bin_start(std::int64_t bin) {
  const std::int64_t octave =
      bin >= 0 ? bin / kBinsOfAnOctave : -((kBinsOfAnOctave - 1 - bin) / kBinsOfAnOctave);
  const auto within = static_cast<double>(bin - octave * kBinsOfAnOctave);
  return std::ldexp(1 + within / kBinsOfAnOctave, static_cast<int>(octave));
}

double quads_bin_start(std::int64_t bin) { return static_cast<double>(bin) / kQuadBinsOfOne; }

void Spread::add(std::uint64_t part, std::uint64_t whole) {
  const double value = static_cast<double>(part) / static_cast<double>(whole);
  smallest = count == 0 ? value : std::min(smallest, value);
  largest = count == 0 ? value : std::max(largest, value);
  sum += (Int128{part} << kSpreadBits) / whole;
  ++count;
}

double Spread::mean() const {
  if (count == 0) return 0;
  return std::ldexp(static_cast<double>(sum), -kSpreadBits) / static_cast<double>(count);
}

bool Record::is_smaller(const std::optional<Corner<Rational>>& candidate, std::uint64_t of) const {
  if (!candidate || !corner) return candidate.has_value();
  if (smaller_angle(*candidate, *corner)) return true;
  return of < index && !smaller_angle(*corner, *candidate);
}

bool Record::is_larger(const std::optional<Corner<Rational>>& candidate, std::uint64_t of) const {
  if (!candidate || !corner) return candidate.has_value();
  if (smaller_angle(*corner, *candidate)) return true;
  return of < index && !smaller_angle(*candidate, *corner);
}

void Record::keep_smaller(const std::optional<Corner<Rational>>& candidate, std::uint64_t of,
                          const std::string& with) {
  if (is_smaller(candidate, of)) *this = {candidate, of, with};
}

void Record::keep_larger(const std::optional<Corner<Rational>>& candidate, std::uint64_t of,
                         const std::string& with) {
  if (is_larger(candidate, of)) *this = {candidate, of, with};
}

void PolygonFamilyTally::add(std::uint64_t index, const PolygonResult& result) {
  ++cases;
  ++outcomes[static_cast<std::size_t>(result.outcome)];
  if (result.cells == 0) return;
  vertices += result.vertices;
  cells += result.cells;
  quads += result.quads;
  cells_per_vertex.add(result.cells, result.vertices);
  quads_per_cell.add(result.quads, result.cells);
  smallest.keep_smaller(result.smallest, index, result.recipe);
  largest.keep_larger(result.largest, index, result.recipe);
}

void PolygonTally::add(std::uint64_t index, const PolygonResult& result,
                       const std::string& family) {
  all.add(index, result);
  families[family].add(index, result);
  add_each(counts, result.counts);
  add_to_histograms(result, *this);
  for (std::size_t i = 0; i < constructions.size(); ++i) {
    const ConstructionUse& use = result.constructions[i];
    constructions[i].quads += use.quads;
    constructions[i].cases += use.quads == 0 ? 0 : 1;
    constructions[i].smallest.keep_smaller(use.smallest, index, result.recipe);
    constructions[i].largest.keep_larger(use.largest, index, result.recipe);
  }
  const Remark remark{result.recipe, result.claim, result.detail};
  if (result.outcome == PolygonOutcome::kFinding)
    findings.emplace(index, remark);
  else if (result.outcome != PolygonOutcome::kProved)
    refusals.emplace(index, remark);
}

PolygonResult PolygonTally::news(std::uint64_t index, PolygonResult result,
                                 const std::string& family) const {
  bool is_needed = result.outcome != PolygonOutcome::kProved;
  const auto keep = [&](std::optional<Corner<Rational>>& corner, bool is_record) {
    if (!is_record) corner.reset();
    is_needed = is_needed || is_record;
  };
  // A record of all cases is one of its family.
  if (const auto found = families.find(family); found != families.end()) {
    keep(result.smallest, found->second.smallest.is_smaller(result.smallest, index));
    keep(result.largest, found->second.largest.is_larger(result.largest, index));
  } else {
    is_needed = true;
  }
  for (std::size_t i = 0; i < constructions.size(); ++i) {
    ConstructionUse& use = result.constructions[i];
    keep(use.smallest, constructions[i].smallest.is_smaller(use.smallest, index));
    keep(use.largest, constructions[i].largest.is_larger(use.largest, index));
  }
  if (!is_needed) result.recipe.clear();
  return result;
}

std::vector<std::string> PolygonTally::never_reached() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < constructions.size(); ++i) {
    // A whole kite needs sides without Steiner points, but condition A.3 makes every side of a kite
    // longer than 2 sqrt(2) cells: only tests of fill_kites by itself reach it.
    if (i == number_of(StripConstruction::kKiteWhole)) continue;
    if (constructions[i].quads == 0) names.emplace_back(polygon_construction_name(i));
  }
  return names;
}

}  // namespace quadbound::cli
