// SPDX-License-Identifier: Apache-2.0
#pragma once
// What may be meshed: point sets without duplicates, polygons whose rings are simple, disjoint and
// nested one level deep. Exact predicates decide; floating point only filters.

#include "model/polygon.hpp"

namespace quadbound {

/// Coordinates must be zero or have a magnitude from 2^-1000 to 2^1000, so that the program can
/// double, halve and subtract them without leaving the doubles.
inline constexpr int kLargestExponent = 1000;

/// Guarantees: 1. returns exactly where the set is not empty, all coordinates are finite and in
/// range, and no two points are equal (0 and -0 are). One point, and points on one line, are fine.
/// Errors: InputError at the first point that is out of range or, of all points that occur again,
/// the first; the message names the next point that equals it.
/// Complexity: O(n log n).
void validate(const PointSet& points);

/// Guarantees: 1. returns exactly where there is a ring, each ring has three vertices or more that
/// are finite, in range and all different (0 and -0 are equal), edges meet only where they follow
/// each other in a ring and only in their common vertex, and each hole lies inside ring 0 and in no
/// other hole. 2. Orientation and straight angles (180 degrees) are never errors. 3. The finding is
/// the first in this order, and among equals the one with the smallest ring and vertex: no ring,
/// ring too short, coordinate out of range, zero-length edge, zero area, spike, vertex repeated,
/// edges that meet, hole in a wrong place. 4. Of edges that meet it is, in the order of the file,
/// the first edge that meets an earlier one, together with the first that it meets; the earlier of
/// the two gives the place of the error, and the message names the other.
/// Errors: InputError naming ring and vertex. A finding about an edge names its first vertex.
/// Complexity: O(n log n) for valid polygons, however long and close their edges are;
/// O(n log^2 n) where edges meet.
void validate(const Polygon& polygon);

/// The polygon with ring 0 counter-clockwise, the holes clockwise, and 0 in place of -0; the first
/// vertex of each ring stays the first. Errors: those of validate.
Polygon normalised(Polygon polygon);

}  // namespace quadbound
