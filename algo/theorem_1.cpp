// SPDX-License-Identifier: Apache-2.0
#include "algo/theorem_1.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

#include "algo/quadrangulation.hpp"
#include "algo/template_tree.hpp"
#include "algo/warping.hpp"

namespace quadbound {
namespace {

using Position = std::array<std::int64_t, 2>;

// --- the classes of similar shapes ---------------------------------------------------------------

/// Mirrored in the diagonal first if `swapped`, then turned by quarter turns.
ConfigurationShape transformed(const ConfigurationShape& shape, bool swapped, int turns) {
  ConfigurationShape result = shape;
  for (std::size_t i = 0; i < 4; ++i) {
    Position p = shape.at[i];
    Motion motion = shape.motion[i];
    bool axes_swapped = swapped;
    if (swapped) std::swap(p[0], p[1]);
    for (int t = 0; t < turns; ++t) {
      p = {-p[1], p[0]};
      axes_swapped = !axes_swapped;
    }
    if (axes_swapped && motion == Motion::kAlongX) {
      motion = Motion::kAlongY;
    } else if (axes_swapped && motion == Motion::kAlongY) {
      motion = Motion::kAlongX;
    }
    result.at[i] = p;
    result.motion[i] = motion;
  }
  if (swapped) {  // a reflection turns counter-clockwise into clockwise
    std::reverse(result.at.begin(), result.at.end());
    std::reverse(result.motion.begin(), result.motion.end());
  }
  return result;
}

void move_to_origin_and_reduce(ConfigurationShape& shape) {
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    std::int64_t low = shape.at[0][axis];
    for (const Position& p : shape.at) low = std::min(low, p[axis]);
    for (Position& p : shape.at) p[axis] -= low;
  }
  std::int64_t divisor = 0;
  for (const Position& p : shape.at) divisor = std::gcd(divisor, std::gcd(p[0], p[1]));
  if (divisor == 0) return;
  for (Position& p : shape.at) p = {p[0] / divisor, p[1] / divisor};
}

ConfigurationShape rotated_list(const ConfigurationShape& shape, std::size_t first) {
  ConfigurationShape result;
  for (std::size_t i = 0; i < 4; ++i) {
    result.at[i] = shape.at[(first + i) % 4];
    result.motion[i] = shape.motion[(first + i) % 4];
  }
  return result;
}

// --- angles of moving shapes ---------------------------------------------------------------------

/// A polynomial in two parameters s, t of [0, 1], of degree at most two in each.
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(const Rational& constant) { c_[0][0] = constant; }
  static Polynomial parameter(std::size_t index) {
    Polynomial result;
    (index == 0 ? result.c_[1][0] : result.c_[0][1]) = 1;
    return result;
  }

  friend Polynomial operator+(Polynomial a, const Polynomial& b) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) a.c_[i][j] += b.c_[i][j];
    return a;
  }
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    return a + Polynomial(-1) * b;
  }
  /// Requires: the product's degree is at most two in each parameter.
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial result;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; i + k < 3; ++k)
          for (std::size_t l = 0; j + l < 3; ++l)
            result.c_[i + k][j + l] += a.c_[i][j] * b.c_[k][l];
    return result;
  }

  [[nodiscard]] Rational value(const Rational& s, const Rational& t) const {
    Rational sum = 0;
    const std::array<Rational, 3> ps{1, s, s * s};
    const std::array<Rational, 3> pt{1, t, t * t};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) sum += c_[i][j] * ps[i] * pt[j];
    return sum;
  }

  /// The smallest Bernstein coefficient of degree (2, 2): a lower bound on [0, 1]^2.
  [[nodiscard]] Rational bernstein_minimum() const {
    std::array<std::array<Rational, 3>, 3> rows;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto column = bernstein({c_[0][j], c_[1][j], c_[2][j]});
      for (std::size_t i = 0; i < 3; ++i) rows[i][j] = column[i];
    }
    Rational smallest = rows[0][0];
    for (const auto& row : rows)
      for (const Rational& b : bernstein(row)) smallest = std::min(smallest, b);
    return smallest;
  }

 private:
  static std::array<Rational, 3> bernstein(const std::array<Rational, 3>& a) {
    return {a[0], Rational(a[0] + a[1] / 2), Rational(a[0] + a[1] + a[2])};
  }
  std::array<std::array<Rational, 3>, 3> c_{};
};

struct MovingPoint {
  Polynomial x;
  Polynomial y;
};

/// Where the vertices may be: a moved centre within half a cell side, i.e. 4 units of the quarter
/// grid below, of where it stands; each moved vertex has a parameter of its own (two at the most).
std::array<MovingPoint, 4> moving_points(const ConfigurationShape& shape,
                                         const Rational& half_side) {
  std::array<MovingPoint, 4> points;
  std::size_t parameters = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    points[i] = {Polynomial(shape.at[i][0]), Polynomial(shape.at[i][1])};
    if (shape.motion[i] == Motion::kNone) continue;
    const Polynomial shift =
        Polynomial(Rational(2 * half_side)) * Polynomial::parameter(parameters++ % 2) -
        Polynomial(half_side);
    (shape.motion[i] == Motion::kAlongX ? points[i].x : points[i].y) =
        (shape.motion[i] == Motion::kAlongX ? points[i].x : points[i].y) + shift;
  }
  return points;
}

/// Around the point itself the aligned centres make a rectangle, whatever its position.
bool is_rectangle_at_point(const ConfigurationShape& shape) {
  return std::find(shape.motion.begin(), shape.motion.end(), Motion::kPoint) != shape.motion.end();
}

bool smaller_angle(const Corner<Rational>& a, const Corner<Rational>& b) {
  return a.dot * b.cross > b.dot * a.cross;  // both cross products are positive
}

void note_extremes(Configuration& configuration, const Corner<Rational>& corner) {
  if (configuration.smallest.cross == 0) configuration.smallest = configuration.largest = corner;
  if (smaller_angle(corner, configuration.smallest)) configuration.smallest = corner;
  if (smaller_angle(configuration.largest, corner)) configuration.largest = corner;
}

/// Decides one corner for all positions, and notes the angle at a grid of them for the table.
bool prove_corner(Configuration& configuration, const Corner<Polynomial>& corner) {
  constexpr int kSteps = 8;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j <= kSteps; ++j) {
      const Rational s(i, kSteps);
      const Rational t(j, kSteps);
      note_extremes(configuration, {corner.cross.value(s, t), corner.dot.value(s, t)});
    }
  // cross > 0 and 2 cross >= |dot| is thm-1's interval.
  const Polynomial twice = Polynomial(2) * corner.cross;
  return corner.cross.bernstein_minimum() > 0 && (twice - corner.dot).bernstein_minimum() >= 0 &&
         (twice + corner.dot).bernstein_minimum() >= 0;
}

void prove(Configuration& configuration, const Rational& half_side) {
  if (is_rectangle_at_point(configuration.shape)) {
    configuration.proved = true;
    configuration.smallest = configuration.largest = {1, 0};
    return;
  }
  const auto points = moving_points(configuration.shape, half_side);
  configuration.proved = true;
  for (std::size_t i = 0; i < 4; ++i) {
    const MovingPoint& at = points[i];
    const MovingPoint& next = points[(i + 1) % 4];
    const MovingPoint& previous = points[(i + 3) % 4];
    const Polynomial ux = next.x - at.x;
    const Polynomial uy = next.y - at.y;
    const Polynomial vx = previous.x - at.x;
    const Polynomial vy = previous.y - at.y;
    const bool holds = prove_corner(configuration, {ux * vy - uy * vx, ux * vx + uy * vy});
    configuration.proved = configuration.proved && holds;
  }
}

// --- the list ------------------------------------------------------------------------------------

/// Collects shapes; positions are in quarters of the unit of paper/theorem-1.md, where the two
/// leaves c and d have side 2 and centres (1, 1) and (1, 3), left of the line x = 2.
class ConfigurationList {
 public:
  void add(Construction construction, const std::string& name, const std::array<Position, 4>& at,
           const std::array<Motion, 4>& motion = {}) {
    const ConfigurationShape shape = canonical({at, motion});
    if (!seen_.insert({{construction, shape}, true}).second) return;
    Configuration configuration{construction, name, shape, false, {0, 1}, {0, 1}};
    // Half a side of a cell in the units of the canonical shape: moving shapes join cells of
    // side 8.
    prove(configuration, half_side(at, shape));
    list_.push_back(std::move(configuration));
  }
  [[nodiscard]] std::vector<Configuration> take() { return std::move(list_); }

 private:
  static Rational half_side(const std::array<Position, 4>& given, const ConfigurationShape& shape) {
    const auto width = [](const std::array<Position, 4>& at) {
      std::int64_t low_x = at[0][0], high_x = at[0][0], low_y = at[0][1], high_y = at[0][1];
      for (const Position& p : at) {
        low_x = std::min(low_x, p[0]);
        high_x = std::max(high_x, p[0]);
        low_y = std::min(low_y, p[1]);
        high_y = std::max(high_y, p[1]);
      }
      return std::max(high_x - low_x, high_y - low_y);
    };
    return Rational(4 * width(shape.at), width(given));
  }

  std::map<std::pair<Construction, ConfigurationShape>, bool> seen_;
  std::vector<Configuration> list_;
};

// The points of the figures, in quarters.
constexpr Position kC{4, 4}, kD{4, 12};              // the two leaves
constexpr Position kLeafA{12, 4}, kLeafB{12, 12};    // leaves across
constexpr Position kExtraA{10, 2}, kExtraB{10, 14};  // their outer extras
constexpr Position kExtraAMirrored{6, 2}, kExtraBMirrored{6, 14};
constexpr Position kS1{10, 2}, kS2{10, 6}, kS3{10, 10}, kS4{10, 14};  // split cells across
constexpr Position kE1{9, 1}, kE2{9, 7}, kE4{9, 15};
constexpr Position kE1Mirrored{7, 1};
constexpr Position kInner{6, 6};  // c's extra at the inner end

void add_templates(ConfigurationList& list) {
  const std::array<Position, 4> square{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}};
  list.add(Construction::kT4, "four centres", square);
  list.add(Construction::kTwoTwo, "four centres", square);
  // T3 in the frame of the node [0,4]^2 with the split child [0,2]^2.
  constexpr Position a{4, 12}, d{12, 12}, b{12, 4}, nw{2, 6}, ne{6, 6};
  list.add(Construction::kT3Two, "a nw ne d", {{a, nw, ne, d}});
  list.add(Construction::kT3Four, "a e nw ne", {{a, {1, 7}, nw, ne}});
  list.add(Construction::kT3Four, "a ne b d", {{a, ne, b, d}});
}

void add_base_cases(ConfigurationList& list) {
  list.add(Construction::kOneOne, "c A eA e", {{kC, kLeafA, {10, 6}, kInner}});
  list.add(Construction::kOneTwo, "c s1 s2 e", {{kC, kS1, kS2, kInner}});
  list.add(Construction::kOneFour, "c e1 s1 s2", {{kC, kE1, kS1, kS2}});
  list.add(Construction::kOneFour, "c e1 s1 s2, e1 mirrored", {{kC, kE1Mirrored, kS1, kS2}});
  list.add(Construction::kOneFour, "c s2 e2 e", {{kC, kS2, kE2, kInner}});
}

void add_two_leaf_cases(ConfigurationList& list) {
  list.add(Construction::kLeafLeaf, "c eA A d", {{kC, kExtraA, kLeafA, kD}});
  list.add(Construction::kLeafLeaf, "c eA A d, eA mirrored", {{kC, kExtraAMirrored, kLeafA, kD}});
  list.add(Construction::kLeafLeaf, "d A B eB", {{kD, kLeafA, kLeafB, kExtraB}});
  list.add(Construction::kLeafLeaf, "d A B eB, eB mirrored",
           {{kD, kLeafA, kLeafB, kExtraBMirrored}});
  list.add(Construction::kLeafTwo, "c eA A s3", {{kC, kExtraA, kLeafA, kS3}});
  list.add(Construction::kLeafTwo, "c eA A s3, eA mirrored", {{kC, kExtraAMirrored, kLeafA, kS3}});
  list.add(Construction::kLeafTwo, "c s3 s4 d", {{kC, kS3, kS4, kD}});
  constexpr Position mc{6, 6}, md{6, 10};
  list.add(Construction::kTwoTwoHalves, "c s1 s2 mc", {{kC, kS1, kS2, mc}});
  list.add(Construction::kTwoTwoHalves, "mc s2 s3 md", {{mc, kS2, kS3, md}});
  list.add(Construction::kTwoTwoHalves, "c mc md d", {{kC, mc, md, kD}});
  constexpr Position e3_mirrored{9, 7}, e2_mirrored{9, 9};
  list.add(Construction::kLeafFour, "c eA A e3'", {{kC, kExtraA, kLeafA, e3_mirrored}});
  list.add(Construction::kLeafFour, "c eA A e3', eA mirrored",
           {{kC, kExtraAMirrored, kLeafA, e3_mirrored}});
  list.add(Construction::kLeafFour, "c e3' s3 d", {{kC, e3_mirrored, kS3, kD}});
  list.add(Construction::kLeafFour, "d s3 s4 e4", {{kD, kS3, kS4, kE4}});
  list.add(Construction::kFourTwo, "c e1 s1 s2", {{kC, kE1, kS1, kS2}});
  list.add(Construction::kFourTwo, "c e1 s1 s2, e1 mirrored", {{kC, kE1Mirrored, kS1, kS2}});
  list.add(Construction::kFourTwo, "c s2 e2' d", {{kC, kS2, e2_mirrored, kD}});
  list.add(Construction::kFourTwo, "d e2' s3 s4", {{kD, e2_mirrored, kS3, kS4}});
  list.add(Construction::kFourFour, "c e1 s1 s2", {{kC, kE1, kS1, kS2}});
  list.add(Construction::kFourFour, "c e1 s1 s2, e1 mirrored", {{kC, kE1Mirrored, kS1, kS2}});
  list.add(Construction::kFourFour, "c s2 s3 d", {{kC, kS2, kS3, kD}});
}

/// The middle quad joins four corner points on the two diagonals through a quadtree vertex: in each
/// quadrant the centre of a cell of side s at distance s/2 (in x and y), or its extra at s/4. Sizes
/// of cells that share a side differ by a factor of two at most.
void add_middle_quads(ConfigurationList& list) {
  constexpr std::array<std::int64_t, 3> sizes{1, 2, 4};
  const auto balanced = [](std::int64_t a, std::int64_t b) { return a <= 2 * b && b <= 2 * a; };
  for (unsigned choice = 0; choice < 3 * 3 * 3 * 3 * 16; ++choice) {
    unsigned rest = choice;
    std::array<std::int64_t, 4> size{};
    std::array<std::int64_t, 4> distance{};
    std::string name;
    for (std::size_t i = 0; i < 4; ++i) {
      size[i] = sizes[rest % 3];
      rest /= 3;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const bool extra = (rest >> i & 1U) != 0;
      distance[i] = extra ? size[i] : 2 * size[i];
      name += fmt::format("{}{}{}", i == 0 ? "" : " ", size[i], extra ? "e" : "c");
    }
    if (*std::min_element(size.begin(), size.end()) > 1) continue;
    bool ok = true;
    for (std::size_t i = 0; i < 4; ++i) ok = ok && balanced(size[i], size[(i + 1) % 4]);
    if (!ok) continue;
    list.add(Construction::kMiddle, name,
             {{{distance[0], distance[0]},
               {-distance[1], distance[1]},
               {-distance[2], -distance[2]},
               {distance[3], -distance[3]}}});
  }
}

/// Quads at the aligned centres, paper/theorem-1.md: E is the centre east of the point, NE the one
/// north of E; EE and NEE lie east of them. All are leaves of one size, E and NE have no extras.
void add_warped(ConfigurationList& list) {
  constexpr Motion still = Motion::kNone, y = Motion::kAlongY, x = Motion::kAlongX;
  constexpr Position e{4, 4}, ne{4, 12}, ee{12, 4}, nee{12, 12};
  constexpr Position ee_extra{10, 6}, nee_extra{10, 10};
  for (const Construction construction :
       {Construction::kT4, Construction::kTwoTwo, Construction::kMiddle}) {
    list.add(construction, "around the point", {{e, ee, nee, ne}}, {Motion::kPoint, y, still, x});
    list.add(construction, "E EE NEE NE", {{e, ee, nee, ne}}, {y, still, still, still});
    // Only in the tree of the 5x5 grids: another point three cells further east.
    list.add(construction, "E W' NEE NE", {{e, ee, nee, ne}}, {y, y, still, still});
    list.add(construction, "E EE W' NE", {{e, ee, nee, ne}}, {y, still, y, still});
  }
  list.add(Construction::kMiddle, "E EEe NEE NE", {{e, ee_extra, nee, ne}},
           {y, still, still, still});
  list.add(Construction::kMiddle, "E EE NEEe NE", {{e, ee, nee_extra, ne}},
           {y, still, still, still});
  list.add(Construction::kMiddle, "E EEe NEEe NE", {{e, ee_extra, nee_extra, ne}},
           {y, still, still, still});
  list.add(Construction::kLeafLeaf, "E eA A NE", {{e, {10, 2}, ee, ne}}, {y, still, still, still});
  list.add(Construction::kLeafLeaf, "SE eA A E", {{e, {10, 2}, ee, ne}}, {still, still, still, y});
  list.add(Construction::kLeafLeaf, "E A B eB", {{ne, ee, nee, {10, 14}}},
           {y, still, still, still});
}

/// Splits of the walk for the census: the shape of a quad of a mesh before it is warped.
ConfigurationShape shape_of(const Mesh& mesh, const Quad& quad, const std::vector<Motion>& motion) {
  ConfigurationShape shape;
  for (std::size_t i = 0; i < 4; ++i) {
    const LatticePoint p = mesh.vertices.lattice(quad[i]);
    shape.at[i] = {p.x, p.y};
    if (!motion.empty()) shape.motion[i] = motion[quad[i]];
  }
  return shape;
}

}  // namespace

bool Configuration::moves() const {
  return std::any_of(shape.motion.begin(), shape.motion.end(),
                     [](Motion m) { return m != Motion::kNone; });
}

ConfigurationShape canonical(const ConfigurationShape& shape) {
  std::optional<ConfigurationShape> best;
  for (const bool swapped : {false, true}) {
    for (int turns = 0; turns < 4; ++turns) {
      ConfigurationShape turned_shape = transformed(shape, swapped, turns);
      move_to_origin_and_reduce(turned_shape);
      for (std::size_t first = 0; first < 4; ++first) {
        const ConfigurationShape candidate = rotated_list(turned_shape, first);
        if (!best || candidate < *best) best = candidate;
      }
    }
  }
  return *best;
}

std::vector<Configuration> theorem_1_configurations() {
  ConfigurationList list;
  add_templates(list);
  add_base_cases(list);
  add_two_leaf_cases(list);
  add_middle_quads(list);
  add_warped(list);
  return list.take();
}

ConfigurationCensus::ConfigurationCensus()
    : configurations_(theorem_1_configurations()), counts_(configurations_.size()) {
  for (std::size_t i = 0; i < configurations_.size(); ++i)
    index_.emplace(std::pair{configurations_[i].construction, configurations_[i].shape}, i);
}

void ConfigurationCensus::add(Construction construction, const ConfigurationShape& shape) {
  ++quads_;
  const ConfigurationShape key = canonical(shape);
  const auto found = index_.find({construction, key});
  if (found != index_.end()) {
    ++counts_[found->second];
    return;
  }
  ++unlisted_;
  if (!first_unlisted_) first_unlisted_ = key;
}

void ConfigurationCensus::add_tree(const Quadtree& quadtree) {
  TemplateTree tree(quadtree);
  Counters counters;
  const Mesh mesh = quadrangulate(tree, quadtree.root(), TwoTwoVariant::kExact, counters);
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    add(static_cast<Construction>(mesh.construction[q]), shape_of(mesh, mesh.quads[q], {}));
}

void ConfigurationCensus::add_points(const std::vector<Point>& points, GridRefinement refinement) {
  const SeparatedTree separated = separate_points(place_root(points), refinement, {});
  TemplateTree tree(separated.tree);
  Counters counters;
  const Mesh mesh = quadrangulate(tree, separated.tree.root(), TwoTwoVariant::kExact, counters);
  std::vector<Motion> motion(mesh.vertices.size(), Motion::kNone);
  for (const WarpSite& site : warp_sites(site_cells(separated), tree)) {
    motion[site.centre] = Motion::kPoint;
    for (const Direction d : kDirections)
      motion[site.neighbour[d]] = is_horizontal(d) ? Motion::kAlongY : Motion::kAlongX;
  }
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    add(static_cast<Construction>(mesh.construction[q]), shape_of(mesh, mesh.quads[q], motion));
}

Quadtree random_balanced_tree(std::uint64_t seed, std::uint64_t leaves) {
  // Large enough for the deepest tree that the number of splits allows to be interesting.
  const RootSquare root{{0, 0}, 48, 0};
  Quadtree tree(root, {}, leaves + 100'000);
  std::mt19937_64 engine(seed);
  std::vector<Cell> changed;
  while (tree.leaf_count() < leaves) {
    // Half of the splits go to one of the newest blocks: local depth makes the rare configurations.
    const std::uint64_t size = tree.blocks().size();
    const std::uint64_t newest = std::min<std::uint64_t>(size, 8);
    const std::uint64_t bits = engine();
    const std::uint64_t block =
        bits % 2 == 0 ? size - 1 - (bits >> 8) % newest : (bits >> 8) % size;
    const Cell cell{static_cast<BlockId>(block), kQuadrants[(bits >> 1) % 4]};
    if (tree.is_leaf(cell) && tree.side_bits(cell) > 12) tree.split(cell, changed);
    changed.clear();
  }
  return tree;
}

std::string arctangent_text(const Corner<Rational>& corner) {
  if (corner.dot == 0) return "90";
  const Rational tangent = corner.cross / boost::multiprecision::abs(corner.dot);
  return fmt::format("{}arctan({})", corner.dot < 0 ? "180 - " : "", to_text(tangent));
}

}  // namespace quadbound
