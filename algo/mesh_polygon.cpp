// SPDX-License-Identifier: Apache-2.0
#include "algo/mesh_polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "algo/kites.hpp"
#include "model/predicates.hpp"

namespace quadbound {
namespace {

/// Input is often dyadic, and its vertices would lie on borders and corners of cells at every
/// level. Divided by odd numbers, a square puts them elsewhere: shifted by 1/3 at 1/3 or 2/3 of a
/// cell. Different numbers in x and y keep them away from its diagonals.
constexpr std::array<RootShift, 4> kRootShifts{{{3, 5}, {5, 3}, {7, 11}, {11, 9}}};

std::vector<Point> vertices_of(const Polygon& polygon) {
  std::vector<Point> points;
  for (const Ring& ring : polygon.rings) points.insert(points.end(), ring.begin(), ring.end());
  return points;
}

InputVertices inputs_of(const std::vector<bool>& cut) {
  InputVertices result;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    if (cut[i]) {
      result.resize(result.size() + 3);
    } else {
      result.emplace_back(i);
    }
  }
  return result;
}

/// Scaled by a power of two, so that its squares neither overflow nor vanish.
Vector near_unit(Vector v) {
  const int exponent = std::ilogb(std::max(std::abs(v.x), std::abs(v.y)));
  return {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent)};
}

/// Below 30 degrees the corner construction nearly never finds a way; to learn that each time would
/// cost an attempt. The exact angle does not matter: others are given a kite when they need one.
bool needs_kite(const Point& before, const Point& at, const Point& after) {
  constexpr double kSquaredCosine = 0.75;  // of 30 degrees
  const Vector u = near_unit({after.x - at.x, after.y - at.y});
  const Vector v = near_unit({before.x - at.x, before.y - at.y});
  const double d = dot(u, v);
  return d > 0 && d * d > kSquaredCosine * dot(u, u) * dot(v, v) &&
         orientation(before, at, after) > 0;
}

/// By vertex, rings in order.
std::vector<bool> sharp_vertices(const Polygon& polygon) {
  std::vector<bool> sharp;
  for (const Ring& ring : polygon.rings) {
    const std::size_t size = ring.size();
    for (std::size_t i = 0; i < size; ++i)
      sharp.push_back(needs_kite(ring[(i + size - 1) % size], ring[i], ring[(i + 1) % size]));
  }
  return sharp;
}

class PolygonMesher {
 public:
  PolygonMesher(const Polygon& polygon, const PolygonMeshOptions& options)
      : polygon_(polygon),
        points_(vertices_of(polygon)),
        options_(options),
        sizes_(options.sizing, polygon) {}

  PolygonMeshResult run() {
    try {
      for (std::size_t i = 0;; ++i) {
        result_.root = place_root(points_, kRootShifts[i]).root;
        result_.counters.other_roots = i;
        const bool is_last = i + 1 == kRootShifts.size();
        if (mesh_in_root(is_last)) return std::move(result_);
      }
    } catch (const TreeBudgetExceeded& exceeded) {
      return refusal(exceeded);
    }
  }

  PolygonMeshResult run_in(const RootSquare& root) {
    try {
      result_.root = root;
      mesh_in_root(true);
      return std::move(result_);
    } catch (const TreeBudgetExceeded& exceeded) {
      return refusal(exceeded);
    }
  }

  LemmaMeshResult run_by_lemmas() {
    try {
      result_.root = place_root(points_, kRootShifts.front()).root;
      const std::vector<bool> cut = acute_vertices();
      const Domain domain = cut_kites(polygon_, result_.root, cut);
      result_.counters.kites = domain.kites.size();
      Learnt learnt(cut.size());
      auto made = DomainMesher(domain, inputs_of(cut), sizes_, remaining(), true, learnt,
                               result_.counters, EdgeInsertion::kLemmas)
                      .run();
      if (const auto* fault = std::get_if<LemmaFault>(&made)) return no_case(*fault);
      take(std::get<DomainMesh>(std::move(made)));
      return std::move(result_);
    } catch (const TreeBudgetExceeded& exceeded) {
      return refusal(exceeded);
    }
  }

 private:
  /// Whether it is meshed; otherwise another root square is asked for.
  bool mesh_in_root(bool is_last) {
    std::vector<bool> cut = sharp_vertices(polygon_);
    Learnt learnt(cut.size());
    for (;; ++result_.counters.restarts) {
      const Domain domain = cut_kites(polygon_, result_.root, cut);
      result_.counters.kites = domain.kites.size();
      auto made = DomainMesher(domain, inputs_of(cut), sizes_, remaining(), is_last, learnt,
                               result_.counters)
                      .run();
      if (std::holds_alternative<NeedsOtherRoot>(made)) return false;
      if (auto* mesh = std::get_if<DomainMesh>(&made)) {
        take(std::move(*mesh));
        return true;
      }
      for (const std::size_t input : std::get<NeedsKites>(made).inputs) cut[input] = true;
      learnt.undo([&](const Split& split) { return split.acute && cut[*split.acute]; });
    }
  }

  void take(DomainMesh made) {
    result_.mesh = std::move(made.mesh);
    result_.mesh.input_vertices = points_.size();
  }

  /// "Perform this procedure at every acute vertex."
  [[nodiscard]] std::vector<bool> acute_vertices() const {
    std::vector<bool> acute(points_.size());
    const Domain whole = cut_kites(polygon_, result_.root, acute);
    for (EdgeId v = 0; v < whole.size(); ++v) acute[v] = whole.is_acute(v);
    return acute;
  }

  [[nodiscard]] Point in_input(LatticePoint point) const {
    const int exponent = result_.root.exponent;
    return {nearest_double(point.x, exponent), nearest_double(point.y, exponent)};
  }

  [[nodiscard]] NoCase no_case(const LemmaFault& fault) const {
    const Point where = in_input(fault.where);
    return {
        std::string(fault.claim), where,
        fmt::format("{} has no case near ({}, {}): {}", fault.claim, where.x, where.y, fault.what),
        *result_.counters.lemmas};
  }

  [[nodiscard]] Budget remaining() const {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    return {options_.budget.max_cells, std::max(0.0, options_.budget.max_seconds - spent.count())};
  }

  [[nodiscard]] Refusal refusal(const TreeBudgetExceeded& exceeded) const {
    const Point where = in_input(exceeded.where);
    return {exceeded.kind, where, exceeded.level, explain(exceeded, where)};
  }

  [[nodiscard]] std::string explain(const TreeBudgetExceeded& exceeded, const Point& where) const {
    const int side_bits = result_.root.side_bits;
    const double whole = std::ldexp(1.0, side_bits + result_.root.exponent);
    const std::string place = fmt::format(
        "cells of {:.3g} are asked for near ({}, {}), in a square of {:.3g}: edges, vertices or an "
        "angle there leave so little room",
        std::ldexp(whole, -exceeded.level), where.x, where.y, whole);
    switch (exceeded.kind) {
      case RefusalKind::kTooDeep:
        return fmt::format(
            "{}; exact coordinates end there: widen that place, or mesh it apart, nearer to the "
            "origin",
            place);
      case RefusalKind::kTooManyCells:
        return fmt::format(
            "the budget of {} cells ran out; {}; widen that place or raise --max-cells",
            options_.budget.max_cells, place);
      case RefusalKind::kTooMuchTime:
        return fmt::format(
            "the budget of {} seconds ran out; {}; widen that place or raise --max-seconds",
            options_.budget.max_seconds, place);
    }
    return {};
  }

  const Polygon& polygon_;
  std::vector<Point> points_;
  const PolygonMeshOptions& options_;
  SizeField sizes_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  PolygonMesh result_;
};

}  // namespace

PolygonMeshResult mesh_polygon(const Polygon& polygon, const PolygonMeshOptions& options) {
  return PolygonMesher(polygon, options).run();
}

PolygonMeshResult mesh_polygon_in(const RootSquare& root, const Polygon& polygon,
                                  const PolygonMeshOptions& options) {
  return PolygonMesher(polygon, options).run_in(root);
}

LemmaMeshResult mesh_polygon_by_lemmas(const Polygon& polygon, const PolygonMeshOptions& options) {
  return PolygonMesher(polygon, options).run_by_lemmas();
}

}  // namespace quadbound
