// SPDX-License-Identifier: Apache-2.0
#pragma once
// The verdicts on Observations 1 and 2, rules 1 to 3 of beta, Table 1 and Lemmas 2 to 12.

#include <vector>

#include "paper/claims.hpp"
#include "paper/lemma_audits.hpp"

namespace quadbound {

/// In the order of claims.json. kFails where what is said to hold was broken, and where what is
/// said to fail did not.
std::vector<PaperClaim> lemma_claims(const LemmaAudits& audits);
/// No kFails.
bool lemmas_hold(const LemmaAudits& audits);

}  // namespace quadbound
