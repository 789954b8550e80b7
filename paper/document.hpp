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
  std::string anchor = {};               ///< for links of the page; may be empty
  std::vector<std::string> claims = {};  ///< ids of the claims that the section is about
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
  std::string file;                      ///< what the Markdown links to, beside it
  std::string text;                      ///< instead of the picture, and below it
  std::string data;                      ///< the bytes of an SVG or PNG file, for the HTML
  std::vector<std::string> claims = {};  ///< ids of the claims that it shows
  std::string view = {};                 ///< of the page's viewer that shows the same; may be empty
};
/// What is different on paper and on the page.
struct PageBlock {
  std::vector<std::variant<Paragraph, TextTable>> markdown;
  std::string html;
};

using Block = std::variant<Heading, Paragraph, CodeBlock, TextTable, DocumentPicture, PageBlock>;
using Document = std::vector<Block>;

std::string to_markdown(const Document& document);

/// The head and the end of a page.
struct PageFrame {
  std::string title;
  std::string style;   ///< CSS
  std::string script;  ///< may be empty
};

/// Guarantees: 1. needs no other file and no network; SVG is inline, PNG in base64. 2. wide tables
/// scroll on their own, so that a phone shows the text at reading size. 3. all text is escaped, but
/// for PageBlock::html. 4. Sections and pictures link to their claims (#ID), a menu to the
/// sections.
std::string to_html(const Document& document, const PageFrame& frame);

/// The blocks alone, for a part of a page.
std::string to_html(const Document& document);

/// Where the claims are met: the sections and pictures that name them.
struct ClaimLink {
  std::string claim;
  std::string address;  ///< #...
  std::string text;
};
std::vector<ClaimLink> claim_links(const Document& document);

std::string escaped_html(const std::string& text);
/// Escaped, and with what stands between backquotes as code.
std::string inline_html(const std::string& text);

std::string base64(const std::string& bytes);

}  // namespace quadbound
