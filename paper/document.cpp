// SPDX-License-Identifier: Apache-2.0
#include "paper/document.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace quadbound {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// Escaped, and with what stands between backquotes as code.
std::string inline_html(const std::string& text) {
  std::string result;
  bool open = false;
  for (const char c : escaped(text)) {
    if (c != '`') {
      result += c;
      continue;
    }
    result += open ? "</code>" : "<code>";
    open = !open;
  }
  return result;
}

struct MarkdownWriter {
  std::string out;

  void operator()(const Heading& h) {
    out += std::string(static_cast<std::size_t>(h.level), '#') + " " + h.text + "\n\n";
  }
  void operator()(const Paragraph& p) { out += p.text + "\n\n"; }
  void operator()(const CodeBlock& c) { out += "```\n" + c.text + "\n```\n\n"; }
  void operator()(const TextTable& table) {
    row(table.head);
    out += "|";
    for (std::size_t i = 0; i < table.head.size(); ++i) out += " --- |";
    out += "\n";
    for (const auto& cells : table.rows) row(cells);
    out += "\n";
  }
  void operator()(const DocumentPicture& p) { out += fmt::format("![{}]({})\n\n", p.text, p.file); }

 private:
  /// A bar inside a cell ("stitch 1|4") would end it.
  static std::string cell_text(const std::string& cell) {
    std::string result;
    for (const char c : cell) result += c == '|' ? std::string("\\|") : std::string(1, c);
    return result;
  }
  void row(const std::vector<std::string>& cells) {
    out += "|";
    for (const std::string& cell : cells) out += " " + cell_text(cell) + " |";
    out += "\n";
  }
};

struct HtmlWriter {
  std::string out;

  void operator()(const Heading& h) {
    out += fmt::format("<h{0}>{1}</h{0}>\n", h.level, inline_html(h.text));
  }
  void operator()(const Paragraph& p) { out += "<p>" + inline_html(p.text) + "</p>\n"; }
  void operator()(const CodeBlock& c) { out += "<pre>" + escaped(c.text) + "</pre>\n"; }
  void operator()(const TextTable& table) {
    out += "<div class=\"wide\"><table>\n";
    row("th", table.head);
    for (const auto& cells : table.rows) row("td", cells);
    out += "</table></div>\n";
  }
  void operator()(const DocumentPicture& p) {
    const bool is_svg = p.file.ends_with(".svg");
    out += "<figure>";
    out += is_svg ? inline_svg(p.data)
                  : fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">",
                                escaped(p.text), base64(p.data));
    out += "<figcaption>" + inline_html(p.text) + "</figcaption></figure>\n";
  }

 private:
  /// Without the XML declaration, which HTML does not know.
  static std::string inline_svg(const std::string& data) {
    const std::size_t start = data.find("<svg");
    return start == std::string::npos ? std::string() : data.substr(start);
  }
  void row(const char* tag, const std::vector<std::string>& cells) {
    out += "<tr>";
    for (const std::string& cell : cells)
      out += fmt::format("<{0}>{1}</{0}>", tag, inline_html(cell));
    out += "</tr>\n";
  }
};

constexpr const char* kHtmlStart = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{}</title>
<style>
body {{ font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 0 auto; padding: 1rem;
       color: #222; background: #fff; }}
h1 {{ font-size: 1.5rem; }} h2 {{ font-size: 1.2rem; margin-top: 2rem; }} h3 {{ font-size: 1rem; }}
.wide {{ overflow-x: auto; }}
table {{ border-collapse: collapse; font-size: 0.85rem; }}
th, td {{ border: 1px solid #ccc; padding: 0.25rem 0.5rem; text-align: left; vertical-align: top; }}
th {{ background: #f2f2f2; }}
td:first-child {{ white-space: nowrap; }} td {{ min-width: 4rem; }}
td:nth-child(5):last-child {{ min-width: 16rem; }}
figure {{ margin: 1rem 0; }} figure img, figure svg {{ width: 100%; height: auto; }}
figcaption {{ font-size: 0.85rem; color: #555; }}
pre {{ overflow-x: auto; background: #f6f6f6; padding: 0.5rem; font-size: 0.85rem; }}
</style>
</head>
<body>
)";

}  // namespace

std::string base64(const std::string& bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63U];
  }
  return text;
}

std::string to_markdown(const Document& document) {
  MarkdownWriter writer;
  for (const Block& block : document) std::visit(writer, block);
  writer.out.pop_back();  // the blank line after the last block
  return std::move(writer.out);
}

std::string to_html(const Document& document, const std::string& title) {
  HtmlWriter writer;
  for (const Block& block : document) std::visit(writer, block);
  return fmt::format(kHtmlStart, escaped(title)) + writer.out + "</body>\n</html>\n";
}

}  // namespace quadbound
