// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the judge found: one entry per claim, with exact values and the place of the worst one.
// Keys of the JSON form: verify/report-format.md.

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/exact.hpp"

namespace quadbound {

enum class Verdict { holds, fails, not_decided };

/// The verdict on coordinates rounded to doubles. within_rounding: broken, but at no corner by more
/// than rounding alone explains.
enum class StoredVerdict { holds, within_rounding, fails };

/// Where something sits; what is unknown or does not apply is empty. Quads, corners (0 to 3) and
/// vertices are counted from 0 in the order of the mesh.
struct Place {
  std::optional<std::uint64_t> quad;
  std::optional<int> corner;
  std::optional<std::uint64_t> vertex;
  std::optional<RationalPoint> position;  ///< of the vertex, in the input's coordinates
  std::string construction;
  std::optional<int> level;
};

/// The angle at a corner, counter-clockwise from its outgoing edge to its incoming one, in [0,
/// 360).
struct JudgedCorner {
  Place place;
  Rational cross;
  Rational dot;
  /// cross / dot; empty at a right angle.
  [[nodiscard]] std::optional<Rational> tangent() const;
  /// A convenience, correctly rounded to nothing in particular.
  [[nodiscard]] double degrees() const;
};

/// An angle bound on the coordinates as stored in doubles.
struct StoredBound {
  StoredVerdict verdict = StoredVerdict::holds;
  std::optional<JudgedCorner> worst;  ///< empty where it is the same as on exact coordinates
  double excess_radians = 0;          ///< of the worst corner beyond the bound; 0 where it holds
  double slack_radians = 0;           ///< what rounding explains at that corner; 0 where it holds
};

struct Claim {
  std::string id;
  Verdict exact = Verdict::not_decided;
  std::optional<StoredBound> stored;  ///< only where rounding to doubles matters
  std::string detail;                 ///< one sentence: what was found, or why it is not decided
  std::optional<Place> place;
  std::optional<JudgedCorner> worst;                     ///< angle claims: the extreme corner
  std::vector<std::pair<std::string, Rational>> values;  ///< named exact numbers
};

/// What is said of a polygon besides the claims.
struct PolygonFacts {
  std::uint64_t rings = 0;

  /// Steiner points on the edges of the polygon; only where boundary-kept holds.
  struct Steiner {
    std::uint64_t edges = 0;
    std::uint64_t fewest = 0;  ///< on one edge
    std::uint64_t most = 0;    ///< on one edge
    std::uint64_t total = 0;
    [[nodiscard]] Rational mean() const { return Rational(total) / Rational(edges); }
  };
  std::optional<Steiner> steiner;

  /// Corners of quads that share an input angle; the bounds judge them.
  std::uint64_t split_corners = 0;
  /// Corners of quads that are a whole input angle; they are listed here and judged by no bound.
  std::uint64_t whole_corners = 0;
  std::uint64_t whole_beyond_bounds = 0;
  std::optional<JudgedCorner> smallest_whole;  ///< of equal ones the first by quad and corner
  std::optional<JudgedCorner> largest_whole;
};

struct Report {
  std::string theorem;  ///< the claim that is the conjunction of all others; last in `claims`
  std::vector<Claim> claims;

  std::uint64_t quads = 0;
  std::uint64_t other_faces = 0;
  std::uint64_t used_vertices = 0;
  std::uint64_t unused_vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t boundary_edges = 0;
  std::uint64_t boundary_loops = 0;
  std::uint64_t cells = 0;         ///< 0 where unknown
  std::uint64_t input_points = 0;  ///< vertices of the polygon where one is meshed
  bool every_vertex_is_a_double = false;

  /// How the corners were decided on exact coordinates.
  struct Decisions {
    std::uint64_t filter = 0;    ///< a floating-point bound was enough
    std::uint64_t lattice = 0;   ///< 128-bit integers
    std::uint64_t rational = 0;  ///< neither: the corner or an end of its edges is off the lattice
  } decisions;

  std::optional<PolygonFacts> polygon;  ///< thm-13 only

  /// nullptr where there is no such claim.
  [[nodiscard]] const Claim* find(std::string_view id) const;
  /// Whether the theorem holds on exact coordinates.
  [[nodiscard]] bool holds() const;
};

/// Guarantees: 1. equal reports give equal bytes. 2. Rationals are strings that parse_rational
/// reads.
std::string to_json(const Report& report);

/// One line per claim, for a terminal.
std::string to_text(const Report& report);

std::string_view name(Verdict verdict);
std::string_view name(StoredVerdict verdict);

}  // namespace quadbound
