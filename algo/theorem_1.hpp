// SPDX-License-Identifier: Apache-2.0
#pragma once
// thm-1, checked by the machine: every shape that applyTemplate, stitchChains and the warping can
// give a quad, with its angles decided exactly (Section 2.4). paper/theorem-1.md says why the list
// is complete; the census asserts it on trees.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "algo/construction.hpp"
#include "algo/point_separation.hpp"
#include "algo/quadtree.hpp"
#include "model/angle.hpp"
#include "model/polygon.hpp"

namespace quadbound {

/// How the warping moves a vertex, within half a cell side to either side of where it stands.
enum class Motion : std::uint8_t {
  kNone,
  kAlongX,  ///< the neighbours to the north and south of a point
  kAlongY,  ///< those to the east and west
  kPoint,   ///< the centre of the point's own cell
};

/// A quad before it is warped, up to translation, rotation by quarter turns, reflection, dyadic
/// scale and the choice of its first vertex; counter-clockwise.
struct ConfigurationShape {
  std::array<std::array<std::int64_t, 2>, 4> at{};
  std::array<Motion, 4> motion{};
  friend bool operator==(const ConfigurationShape&, const ConfigurationShape&) = default;
  friend bool operator<(const ConfigurationShape& a, const ConfigurationShape& b) {
    return a.at != b.at ? a.at < b.at : a.motion < b.motion;
  }
};

/// The representative of a shape's class: all similar shapes give the same one.
/// Requires: coordinate differences below 2^60.
ConfigurationShape canonical(const ConfigurationShape& shape);

struct Configuration {
  Construction construction;
  std::string name;
  ConfigurationShape shape;  ///< canonical
  bool proved = false;  ///< all corners within thm-1's interval, for all positions of the point
  Corner<Rational>
      smallest;  ///< for moving shapes: the worst of the positions tried, ends included
  Corner<Rational> largest;
  [[nodiscard]] bool moves() const;
};

/// Guarantees: 1. no shape appears twice with the same construction. 2. `proved` is decided by
/// exact arithmetic alone (Bernstein coefficients for the moving shapes). Complexity: some
/// milliseconds.
std::vector<Configuration> theorem_1_configurations();

/// Counts how often each configuration occurs in meshes.
class ConfigurationCensus {
 public:
  ConfigurationCensus();

  /// The quadrangulation of a balanced tree, not warped. Quads are taken as they come from the
  /// mesher.
  void add_tree(const Quadtree& tree);
  /// The mesh of a point set, with the moves of the warping. Requires: distinct points, and a tree
  /// within the budget (throws TreeBudgetExceeded).
  void add_points(const std::vector<Point>& points, GridRefinement refinement);

  [[nodiscard]] const std::vector<Configuration>& configurations() const { return configurations_; }
  [[nodiscard]] std::uint64_t count(std::size_t configuration) const {
    return counts_[configuration];
  }
  [[nodiscard]] std::uint64_t quads() const { return quads_; }
  /// Quads whose shape is not on the list: would refute the list.
  [[nodiscard]] std::uint64_t unlisted() const { return unlisted_; }
  [[nodiscard]] const std::optional<ConfigurationShape>& first_unlisted() const {
    return first_unlisted_;
  }

 private:
  void add(Construction construction, const ConfigurationShape& shape);

  std::vector<Configuration> configurations_;
  std::map<std::pair<Construction, ConfigurationShape>, std::size_t> index_;
  std::vector<std::uint64_t> counts_;
  std::uint64_t quads_ = 0;
  std::uint64_t unlisted_ = 0;
  std::optional<ConfigurationShape> first_unlisted_;
};

/// A random balanced tree without points for the census: splits leaves picked by the engine's bits,
/// the deeper with preference, until it has some `leaves`.
Quadtree random_balanced_tree(std::uint64_t seed, std::uint64_t leaves);

/// An angle as "arctan(1/2)", "90" or "180 - arctan(1/7)", exactly.
std::string arctangent_text(const Corner<Rational>& corner);

}  // namespace quadbound
