// SPDX-License-Identifier: Apache-2.0
#pragma once
// A report of headings, paragraphs, tables and pictures, as Markdown and as one HTML file.

#include <string>
#include <variant>
#include <vector>

namespace quadbound {

struct Heading {
  int level;  ///< 1 to 3
  std::string text;
};
/// `code` between backquotes is the only markup.
struct Paragraph {
  std::string text;
};
struct CodeBlock {
  std::string text;
};
struct TextTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};
struct DocumentPicture {
  std::string file;  ///< what the Markdown links to, beside it
  std::string text;  ///< instead of the picture, and below it
  std::string data;  ///< the bytes of an SVG or PNG file, for the HTML
};

using Block = std::variant<Heading, Paragraph, CodeBlock, TextTable, DocumentPicture>;
using Document = std::vector<Block>;

std::string to_markdown(const Document& document);

/// Guarantees: 1. needs no other file and no network; SVG is inline, PNG in base64. 2. wide tables
/// scroll on their own, so that a phone shows the text at reading size. 3. all text is escaped.
std::string to_html(const Document& document, const std::string& title);

std::string base64(const std::string& bytes);

}  // namespace quadbound
