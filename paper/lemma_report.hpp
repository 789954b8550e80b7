// SPDX-License-Identifier: Apache-2.0
#pragma once
// The audit of Section 3 for readers.

#include <string>
#include <vector>

#include "paper/document.hpp"
#include "paper/lemma_audits.hpp"

namespace quadbound {

/// A section of the report.
std::vector<Block> lemma_section(const LemmaAudits& audits);
/// One JSON object.
std::string lemma_json(const LemmaAudits& audits);
/// For a terminal: the checks one by one, Table 1, the strips and the corners.
std::string to_text(const LemmaAudits& audits);

}  // namespace quadbound
