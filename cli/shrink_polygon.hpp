// SPDX-License-Identifier: Apache-2.0
#pragma once
// Makes a polygon that shows a fault smaller, as long as the fault stays.

#include <cstddef>
#include <functional>

#include "model/polygon.hpp"

namespace quadbound::cli {

/// Drops holes, then vertices, many at once first, until nothing more can go; then moves the
/// vertices to the coarsest multiples of a power of two that will do.
///
/// Guarantees: 1. the result is the polygon itself or one that `still_fails`. 2. `still_fails` is
/// called at most `most_tries` times, with polygons that pass validate() and are normalised.
/// 3. With tries left over, no hole and no single vertex of the result can be dropped.
/// Requires: polygon valid and normalised. Complexity: O(v log v) beside the calls, for each of
/// them and for each polygon that is not valid.
Polygon shrunk(Polygon polygon, const std::function<bool(const Polygon&)>& still_fails,
               std::size_t most_tries);

}  // namespace quadbound::cli
