// SPDX-License-Identifier: Apache-2.0
#pragma once
// All that the paper claims, with its verdict: what `reproduce` measures, and what other checks or
// nothing yet decide.

#include <string>
#include <string_view>
#include <vector>

#include "paper/claims.hpp"

namespace quadbound {

struct ListedClaim {
  std::string anchor;  ///< the id, with -2, -3 and so on for further ones of the same id
  std::string id;
  std::string place;  ///< in the paper; "-" where the file does not say
  std::string what;
  std::string paper;    ///< "-" where the claim is no number
  std::string ours;     ///< "-" where nothing is measured
  std::string verdict;  ///< in words
  std::string why;      ///< may be empty
  std::string command;  ///< that checks it; "none yet" where nothing does
};

/// claims.json as it was when the program was built.
std::string_view file_of_claims();

/// Guarantees: 1. in the order of the file's places, which is that of the paper; of one id the
/// measured ones first, in their order. 2. Verdicts of measured claims are those of the
/// measurement, not of the file. 3. Anchors differ. Errors: InputError where the text is no file of
/// claims.
std::vector<ListedClaim> list_claims(std::string_view file_of_claims,
                                     const std::vector<PaperClaim>& measured);

}  // namespace quadbound
