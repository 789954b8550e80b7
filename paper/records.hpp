// SPDX-License-Identifier: Apache-2.0
#pragma once
// Experiments that take hours and were recorded in results/: their Markdown on the report's page.

#include <string>

#include "paper/document.hpp"

namespace quadbound {

/// The Markdown that the records are written in: headings, paragraphs, fenced code, tables, lists
/// of one level, pictures on a line of their own. Links become their text; comments are left out.
/// Guarantees: 1. pictures are taken from `folder`; one that is not there becomes its text.
Document read_markdown(const std::string& text, const std::string& folder);

/// All .md files of the folder and of its bench/ but README.md and reproduction.md, by name, each
/// folded under its title; on paper their names. An empty block where the folder is not there.
/// Errors: InputError where a file cannot be read.
PageBlock records_block(const std::string& folder);

}  // namespace quadbound
