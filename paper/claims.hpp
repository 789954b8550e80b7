// SPDX-License-Identifier: Apache-2.0
#pragma once
// The paper's numbers beside ours.

#include <string>
#include <string_view>
#include <vector>

#include "paper/reproduction.hpp"

namespace quadbound {

enum class PaperVerdict {
  kHolds,
  kHoldsAfterRepair,
  kOwnPolygon,       ///< reproduced on a polygon of ours of the same kind
  kNotReproducible,  ///< `why` says what the paper does not give
  kDiffers,          ///< by what `why` says, no failure
  kRefuted,          ///< the paper's statement fails; `why` says how
  kFails,            ///< a claim of ours failed
};

struct PaperClaim {
  std::string id;
  std::string what;
  std::string paper;
  std::string ours;
  PaperVerdict verdict = PaperVerdict::kHolds;
  std::string why;  ///< what was repaired, or why it differs
};

/// Guarantees: 1. one entry per number that Section 2, Section 5 and Figures 10 and 46 to 53 give.
/// 2. kFails exactly where something that we claim to hold does not.
std::vector<PaperClaim> compare_with_paper(const Reproduction& reproduction);

/// "holds", "differs", ...
std::string_view verdict_name(PaperVerdict verdict);
/// The name, and after a colon the reason where there is one.
std::string verdict_text(const PaperClaim& claim);
std::string_view grid_name(GridRefinement refinement);

/// A corner as "26.57 = arctan(1/2)"; degrees alone where the fraction is longer than readers like.
std::string angle_text(const Corner<Rational>& corner);

/// 20845 as "20,845".
std::string with_commas(std::uint64_t value);

}  // namespace quadbound
