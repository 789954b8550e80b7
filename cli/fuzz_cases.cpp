// SPDX-License-Identifier: Apache-2.0
#include "cli/fuzz_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace quadbound::cli {

std::uint64_t case_seed(std::uint64_t campaign_seed, std::uint64_t index) {
  // The finaliser of splitmix64.
  std::uint64_t z = campaign_seed * 0x9E3779B97F4A7C15U + index + 1;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31);
}

std::uint64_t any_magnitude(RandomIntegers& random, std::uint64_t largest) {
  const auto bits = random.between(0, static_cast<std::int64_t>(std::bit_width(largest)));
  return std::min(largest, random.below(std::uint64_t{1} << bits));
}

std::int64_t any_value(RandomIntegers& random, const Parameter& parameter) {
  const auto kind = random.below(3);
  if (kind == 0) return parameter.default_value;
  const std::int64_t range = parameter.largest - parameter.smallest;
  if (kind == 1) return random.between(parameter.smallest, parameter.largest);
  const auto away =
      static_cast<std::int64_t>(any_magnitude(random, static_cast<std::uint64_t>(range)));
  return std::clamp(parameter.default_value + (random.chance(50) ? away : -away),
                    parameter.smallest, parameter.largest);
}

std::vector<std::string> names_of(std::span<const FamilyDescription> families) {
  std::vector<std::string> names;
  for (const FamilyDescription& family : families) names.emplace_back(family.name);
  return names;
}

std::optional<BrokenClaim> broken_claim(const Report& report) {
  for (const Claim& claim : report.claims)
    if (claim.exact != Verdict::holds)
      return BrokenClaim{claim.id, fmt::format("{}: {}", name(claim.exact), claim.detail)};
  if (!report.holds()) return BrokenClaim{report.theorem, {}};
  return std::nullopt;
}

std::optional<Corner<Rational>> extreme(const Report& report, std::string_view claim) {
  const Claim* found = report.find(claim);
  if (found == nullptr || !found->worst) return std::nullopt;
  return Corner<Rational>{found->worst->cross, found->worst->dot};
}

bool smaller_angle(const Corner<Rational>& a, const Corner<Rational>& b) {
  return a.dot * b.cross > b.dot * a.cross;
}

}  // namespace quadbound::cli
