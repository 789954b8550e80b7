// SPDX-License-Identifier: Apache-2.0
// What the exact angle tests cost in the representations of coordinates that could carry a mesh.
// The measurement behind model/exact-coordinates.md.
//
// Every representation judges the four corners of the same quads against kTheorem1. Before anything
// is timed, all must give the same verdicts, corner by corner. Then come the meshes whose figures
// the text quotes: how far they keep to the lattice, and how often a bound is met exactly.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <string>
#include <variant>
#include <vector>

#include "algo/mesh_points.hpp"
#include "generators/points.hpp"
#include "generators/random.hpp"
#include "model/angle.hpp"
#include "model/exact.hpp"

namespace quadbound {
namespace {

namespace mp = boost::multiprecision;

constexpr std::size_t kQuads = 100'000;
/// The lattice is 2^-60 of the root square, as in a mesh of points of magnitude one.
constexpr int kExponent = -kLatticeBits;

template <class PointType>
using QuadOf = std::array<PointType, 4>;

/// Bit i is set where corner i is within thm-1's bounds.
using Verdicts = unsigned;

template <class Number, class PointType>
Verdicts judge(const QuadOf<PointType>& quad) {
  Verdicts verdicts = 0;
  for (unsigned i = 0; i < 4; ++i) {
    const Corner<Number> corner = corner_at<Number>(quad[i], quad[(i + 1) % 4], quad[(i + 3) % 4]);
    verdicts |= static_cast<Verdicts>(within(corner, kTheorem1)) << i;
  }
  return verdicts;
}

// ---- The quads

constexpr Verdicts kAllWithin = 15;

/// A quad within the bounds with corners on the 9 x 9 grid of eighths, as in templates: quarters of
/// a cell and of its parent. Bounds are met with equality by many.
QuadOf<LatticePoint> random_shape(RandomIntegers& random) {
  for (;;) {
    QuadOf<LatticePoint> shape;
    for (LatticePoint& p : shape) p = {random.between(0, 8), random.between(0, 8)};
    if (judge<Int128>(shape) == kAllWithin) return shape;
  }
}

/// Three in four quads are as a template leaves them; the others have one corner moved: by one
/// lattice unit, the hardest there is, or by anything up to half an eighth, as warping would.
QuadOf<LatticePoint> random_quad(RandomIntegers& random) {
  QuadOf<LatticePoint> quad = random_shape(random);
  const int eighth_bits = static_cast<int>(random.between(4, 50));
  const std::int64_t eighth = std::int64_t{1} << eighth_bits;
  const std::int64_t cells = std::int64_t{1} << (kLatticeBits - eighth_bits - 4);
  const LatticePoint corner{random.between(-cells, cells) * 8, random.between(-cells, cells) * 8};
  for (LatticePoint& p : quad) p = {(corner.x + p.x) * eighth, (corner.y + p.y) * eighth};
  const std::int64_t kind = random.between(0, 7);
  if (kind < 6) return quad;
  const std::int64_t reach = kind == 6 ? 1 : eighth / 2;
  LatticePoint& moved = quad[random.below(4)];
  moved.x += random.between(-reach, reach);
  moved.y += random.between(-reach, reach);
  return quad;
}

const std::vector<QuadOf<LatticePoint>>& lattice_quads() {
  static const std::vector<QuadOf<LatticePoint>> quads = [] {
    RandomIntegers random(1);
    std::vector<QuadOf<LatticePoint>> result(kQuads);
    for (auto& quad : result) quad = random_quad(random);
    return result;
  }();
  return quads;
}

// ---- Representations other than the lattice itself

template <class Number>
struct PointOf {
  Number x;
  Number y;
};

template <class Number>
Number integer_coordinate(std::int64_t value) {
  return Number(value);
}

/// The coordinate in the units of the input.
template <class Number>
Number rational_coordinate(std::int64_t value) {
  return Number(value) / (std::int64_t{1} << -kExponent);
}

template <class Number, Number (*convert)(std::int64_t)>
std::vector<QuadOf<PointOf<Number>>> converted() {
  std::vector<QuadOf<PointOf<Number>>> result(kQuads);
  for (std::size_t i = 0; i < kQuads; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      result[i][k] = {convert(lattice_quads()[i][k].x), convert(lattice_quads()[i][k].y)};
  return result;
}

// ---- Doubles in front of the lattice

/// With u = 2^-53: the integer differences are exact, their conversion adds u each, the product and
/// the sum u each, so cross and dot are off by 4 u (|u_x v_y| + ...), and 2 cross - |dot|, with its
/// own rounding, by at most 10 u size. The rest covers terms in u^2 and the rounding of size.
constexpr double kFilterError = 16 * 0x1p-53;

/// Counts the corners that the doubles leave to Int128.
std::uint64_t undecided_corners = 0;

/// Whether the corner is within kTheorem1, by doubles where they can tell. Both bounds of kTheorem1
/// are arctan(1/2): the corner is within them exactly when 2 cross >= |dot|.
bool filtered_within(LatticePoint at, LatticePoint next, LatticePoint previous) {
  const auto ux = static_cast<double>(next.x - at.x);
  const auto uy = static_cast<double>(next.y - at.y);
  const auto vx = static_cast<double>(previous.x - at.x);
  const auto vy = static_cast<double>(previous.y - at.y);
  const double excess = 2 * (ux * vy - uy * vx) - std::abs(ux * vx + uy * vy);
  const double size = (std::abs(ux) + std::abs(uy)) * (std::abs(vx) + std::abs(vy));
  if (std::abs(excess) > kFilterError * size) return excess > 0;
  ++undecided_corners;
  return within(corner_at<Int128>(at, next, previous), kTheorem1);
}

Verdicts judge_filtered(const QuadOf<LatticePoint>& quad) {
  Verdicts verdicts = 0;
  for (unsigned i = 0; i < 4; ++i)
    verdicts |=
        static_cast<Verdicts>(filtered_within(quad[i], quad[(i + 1) % 4], quad[(i + 3) % 4])) << i;
  return verdicts;
}

// ---- Check, then time

bool all_agree = true;

/// Registers the timing of one representation after comparing its verdicts with the lattice's.
template <class Quads, class Judge>
void add_benchmark(const std::string& name, Quads quads, Judge judge_one) {
  for (std::size_t i = 0; i < kQuads; ++i)
    if (judge_one(quads[i]) != judge<Int128>(lattice_quads()[i])) {
      std::cerr << name << " disagrees with int64_lattice on quad " << i << '\n';
      all_agree = false;
      return;
    }
  const auto time = [quads = std::move(quads), judge_one](benchmark::State& state) {
    for (auto _ : state)
      for (const auto& quad : quads) benchmark::DoNotOptimize(judge_one(quad));
    state.counters["per_quad"] = benchmark::Counter(
        static_cast<double>(kQuads),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["bytes_per_point"] = sizeof(quads[0][0]);
  };
  benchmark::RegisterBenchmark(name.c_str(), time)->Unit(benchmark::kMillisecond);
}

template <class Number, Number (*convert)(std::int64_t)>
void add_number(const std::string& name) {
  add_benchmark(name, converted<Number, convert>(), judge<Number, PointOf<Number>>);
}

template <unsigned bits>
using FixedInteger =
    mp::number<mp::cpp_int_backend<bits, bits, mp::signed_magnitude, mp::unchecked, void>,
               mp::et_off>;

void add_all() {
  add_benchmark("int64_lattice", lattice_quads(), judge<Int128, LatticePoint>);
  add_benchmark("double_filter", lattice_quads(), judge_filtered);
  add_number<FixedInteger<256>, integer_coordinate>("int256_t");
  add_number<FixedInteger<512>, integer_coordinate>("int512_t");
  add_number<mp::cpp_int, integer_coordinate>("cpp_int");
  add_number<mp::mpz_int, integer_coordinate>("mpz_int");
  add_number<mp::mpq_rational, rational_coordinate>("mpq_rational");
  add_number<mp::cpp_rational, rational_coordinate>("cpp_rational");
}

/// Whether the angle is exactly one of kTheorem1's bounds.
template <class Number>
bool meets_bound(const Corner<Number>& corner) {
  return corner.cross > 0 && (2 * corner.cross == corner.dot || 2 * corner.cross == -corner.dot);
}

void describe_quads() {
  std::size_t within_bounds = 0;
  std::size_t equal = 0;
  for (const auto& quad : lattice_quads()) {
    if (judge<Int128>(quad) == kAllWithin) ++within_bounds;
    for (unsigned i = 0; i < 4; ++i) {
      const auto corner = corner_at<Int128>(quad[i], quad[(i + 1) % 4], quad[(i + 3) % 4]);
      if (meets_bound(corner)) ++equal;
    }
  }
  std::cout << kQuads << " quads, " << within_bounds << " within both bounds; of " << 4 * kQuads
            << " corners " << equal << " meet a bound exactly and " << undecided_corners
            << " are left undecided by doubles\n";
}

std::size_t corners_at_bounds(const Mesh& mesh) {
  const Vertices& vertices = mesh.vertices;
  const auto is_on_lattice = [&](VertexId v) { return vertices.on_lattice(v); };
  std::size_t count = 0;
  for (const Quad& quad : mesh.quads) {
    const bool on_lattice = std::ranges::all_of(quad, is_on_lattice);
    for (unsigned i = 0; i < 4; ++i) {
      const VertexId at = quad[i];
      const VertexId next = quad[(i + 1) % 4];
      const VertexId previous = quad[(i + 3) % 4];
      count += on_lattice
                   ? meets_bound(corner_at<Int128>(vertices.lattice(at), vertices.lattice(next),
                                                   vertices.lattice(previous)))
                   : meets_bound(corner_at<Rational>(vertices.exact(at), vertices.exact(next),
                                                     vertices.exact(previous)));
    }
  }
  return count;
}

void describe_mesh(const char* recipe) {
  const PointMeshResult result = mesh_points(generate_points(parse_point_recipe(recipe)));
  if (const auto* refusal = std::get_if<Refusal>(&result)) {
    std::cout << recipe << ": " << refusal->message << '\n';
    return;
  }
  const Mesh& mesh = std::get<PointMesh>(result).mesh;
  std::cout << recipe << ": cells down to level " << int{*std::ranges::max_element(mesh.level)}
            << "; of " << mesh.vertices.size() << " vertices " << mesh.vertices.off_lattice_count()
            << " are off the lattice; of " << 4 * mesh.quads.size() << " corners "
            << corners_at_bounds(mesh) << " meet a bound exactly\n";
}

void describe_meshes() {
  for (const char* recipe :
       {"uniform:n=1000,seed=1", "near-duplicate:n=1000,seed=1,share=100,offset=1",
        "near-duplicate:n=1000,seed=1,share=100,offset=0", "exponential:n=1000,seed=1,octaves=50"})
    describe_mesh(recipe);
}

}  // namespace
}  // namespace quadbound

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  quadbound::add_all();
  if (!quadbound::all_agree) return 1;
  // Before the timing, which would count the undecided corners again.
  quadbound::describe_quads();
  quadbound::describe_meshes();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
