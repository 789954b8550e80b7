// SPDX-License-Identifier: Apache-2.0
#include "paper/document.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace quadbound {

std::string escaped_html(const std::string& text) {
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

std::string inline_html(const std::string& text) {
  std::string result;
  bool open = false;
  for (const char c : escaped_html(text)) {
    if (c != '`') {
      result += c;
      continue;
    }
    result += open ? "</code>" : "<code>";
    open = !open;
  }
  return result;
}

namespace {

/// "figure-fig-46" for fig-46.svg.
std::string anchor_of(const DocumentPicture& picture) {
  return "figure-" + picture.file.substr(0, picture.file.rfind('.'));
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
  void operator()(const PageBlock& block) {
    for (const auto& part : block.markdown) std::visit(*this, part);
  }

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
    const std::string id = h.anchor.empty() ? "" : fmt::format(" id=\"{}\"", h.anchor);
    out += fmt::format("<h{0}{1}>{2}</h{0}>\n", h.level, id, inline_html(h.text));
    if (!h.claims.empty()) out += "<p class=\"links\">" + links_to(h.claims) + "</p>\n";
  }
  void operator()(const Paragraph& p) { out += "<p>" + inline_html(p.text) + "</p>\n"; }
  void operator()(const CodeBlock& c) { out += "<pre>" + escaped_html(c.text) + "</pre>\n"; }
  void operator()(const TextTable& table) {
    out += "<div class=\"wide\"><table>\n<thead>";
    row("th", table.head);
    out += "</thead>\n<tbody>\n";
    for (const auto& cells : table.rows) row("td", cells);
    out += "</tbody></table></div>\n";
  }
  void operator()(const DocumentPicture& p) {
    const bool is_svg = p.file.ends_with(".svg");
    out += fmt::format("<figure id=\"{}\">", anchor_of(p));
    out += is_svg ? inline_svg(p.data)
                  : fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">",
                                escaped_html(p.text), base64(p.data));
    out += "<figcaption>" + inline_html(p.text);
    if (!p.claims.empty()) out += " " + links_to(p.claims) + ".";
    if (!p.view.empty())
      out +=
          fmt::format(" <a class=\"to-viewer\" href=\"#view-{}\">Open in the viewer</a>", p.view);
    out += "</figcaption></figure>\n";
  }
  void operator()(const PageBlock& block) { out += block.html; }

 private:
  /// Without the XML declaration, which HTML does not know.
  static std::string inline_svg(const std::string& data) {
    const std::size_t start = data.find("<svg");
    return start == std::string::npos ? std::string() : data.substr(start);
  }
  static std::string links_to(const std::vector<std::string>& claims) {
    std::string text = claims.size() == 1 ? "Claim" : "Claims";
    for (const std::string& id : claims) text += fmt::format(" <a href=\"#{0}\">{0}</a>", id);
    return text;
  }
  void row(const char* tag, const std::vector<std::string>& cells) {
    out += "<tr>";
    for (const std::string& cell : cells)
      out += fmt::format("<{0}>{1}</{0}>", tag, inline_html(cell));
    out += "</tr>\n";
  }
};

/// The first words of a heading.
std::string short_text(const Heading& heading) {
  const std::string text = heading.text.substr(0, heading.text.find_first_of(",("));
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

/// Links to the sections.
std::string menu_of(const Document& document) {
  std::string menu = "<nav>";
  for (const Block& block : document) {
    const auto* const heading = std::get_if<Heading>(&block);
    if (heading == nullptr || heading->level != 2 || heading->anchor.empty()) continue;
    menu +=
        fmt::format("<a href=\"#{}\">{}</a> ", heading->anchor, inline_html(short_text(*heading)));
  }
  return menu + "</nav>\n";
}

constexpr const char* kHtmlStart = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<title>{}</title>
<style>
{}</style>
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

std::string to_html(const Document& document) {
  HtmlWriter writer;
  for (const Block& block : document) std::visit(writer, block);
  return std::move(writer.out);
}

std::string to_html(const Document& document, const PageFrame& frame) {
  const std::string script =
      frame.script.empty() ? "" : "<script>\n" + frame.script + "</script>\n";
  return fmt::format(kHtmlStart, escaped_html(frame.title), frame.style) + menu_of(document) +
         to_html(document) + script + "</body>\n</html>\n";
}

std::vector<ClaimLink> claim_links(const Document& document) {
  std::vector<ClaimLink> links;
  const auto add = [&](const std::vector<std::string>& claims, const std::string& address,
                       const std::string& text) {
    for (const std::string& id : claims) links.push_back({id, address, text});
  };
  for (const Block& block : document) {
    if (const auto* const heading = std::get_if<Heading>(&block))
      add(heading->claims, "#" + heading->anchor, short_text(*heading));
    const auto* const picture = std::get_if<DocumentPicture>(&block);
    if (picture == nullptr) continue;
    add(picture->claims, "#" + anchor_of(*picture), "figure");
    if (!picture->view.empty()) add(picture->claims, "#view-" + picture->view, "mesh");
  }
  return links;
}

}  // namespace quadbound
