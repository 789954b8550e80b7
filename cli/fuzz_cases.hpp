// SPDX-License-Identifier: Apache-2.0
#pragma once
// What random point sets and random polygons share; behind `quadbound fuzz`. Prints nothing.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "generators/random.hpp"
#include "generators/recipe.hpp"
#include "model/angle.hpp"
#include "model/exact.hpp"
#include "verify/report.hpp"

namespace quadbound::cli {

/// The seed of a case. Neighbouring seeds and indices do not give neighbouring states.
std::uint64_t case_seed(std::uint64_t campaign_seed, std::uint64_t index);

/// From 0 to largest, all magnitudes equally likely.
std::uint64_t any_magnitude(RandomIntegers& random, std::uint64_t largest);

/// A third of the values are the default, a third near it, and a third anywhere.
std::int64_t any_value(RandomIntegers& random, const Parameter& parameter);

std::vector<std::string> names_of(std::span<const FamilyDescription> families);

/// The first claim that does not hold.
struct BrokenClaim {
  std::string id;
  std::string detail;
};
std::optional<BrokenClaim> broken_claim(const Report& report);

/// The extreme corner that goes with an angle claim.
std::optional<Corner<Rational>> extreme(const Report& report, std::string_view claim);

/// Whether a is smaller. Requires: both cross products are positive, as in all proved meshes.
bool smaller_angle(const Corner<Rational>& a, const Corner<Rational>& b);

template <class Array>
void add_each(Array& sums, const Array& values) {
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += values[i];
}

}  // namespace quadbound::cli
