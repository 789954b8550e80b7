// SPDX-License-Identifier: Apache-2.0
#include "paper/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "paper/page_files.hpp"

namespace quadbound {
namespace {

/// "holds-after-a-repair", for the style sheet.
std::string class_of(std::string verdict) {
  std::replace(verdict.begin(), verdict.end(), ' ', '-');
  return verdict;
}

/// The verdicts that are met, in the order in which they are, with their numbers.
std::vector<std::pair<std::string, int>> verdicts_of(const std::vector<ListedClaim>& claims) {
  std::vector<std::pair<std::string, int>> counts;
  for (const ListedClaim& claim : claims) {
    const auto found = std::find_if(counts.begin(), counts.end(), [&](const auto& entry) {
      return entry.first == claim.verdict;
    });
    if (found == counts.end())
      counts.emplace_back(claim.verdict, 1);
    else
      ++found->second;
  }
  return counts;
}

std::string filter_html(const std::vector<ListedClaim>& claims) {
  std::string html =
      "<div class=\"filter\"><input type=\"search\" aria-label=\"Filter the claims\" "
      "placeholder=\"Filter: lemma 11, fig-46, angle, 18.43 ...\" autocomplete=\"off\">\n"
      "<output data-part=\"count\" aria-live=\"polite\"></output>\n<div class=\"verdicts\">\n";
  for (const auto& [verdict, count] : verdicts_of(claims))
    html += fmt::format(
        "<button type=\"button\" class=\"verdict {}\" data-verdict=\"{}\" aria-pressed=\"false\">"
        "{} <b>{}</b></button>\n",
        class_of(verdict), verdict, verdict, count);
  return html + "</div></div>\n";
}

std::string links_html(const ListedClaim& claim, const std::vector<ClaimLink>& links) {
  std::string html;
  for (const ClaimLink& link : links)
    if (link.claim == claim.id)
      html += fmt::format("<a href=\"{}\">{}</a> ", link.address, inline_html(link.text));
  return html;
}

std::string row_html(const ListedClaim& claim, const std::vector<ClaimLink>& links) {
  std::string html = fmt::format(
      "<tr id=\"{0}\" data-verdict=\"{1}\">\n<td data-head=\"claim\">"
      "<a href=\"#{0}\">{2}</a></td>",
      claim.anchor, claim.verdict, claim.id);
  const auto cell = [&html](const char* head, const std::string& inside) {
    html += fmt::format("<td data-head=\"{}\">{}</td>", head, inside);
  };
  cell("place", inline_html(claim.place));
  cell("what it says", inline_html(claim.what));
  cell("paper", inline_html(claim.paper));
  cell("ours", inline_html(claim.ours));
  const std::string why =
      claim.why.empty() ? ""
                        : fmt::format(" <span class=\"why\">{}</span>", inline_html(claim.why));
  cell("verdict", fmt::format("<span class=\"verdict {}\">{}</span>{}", class_of(claim.verdict),
                              claim.verdict, why));
  cell("checked by", claim.command == "none yet"
                         ? claim.command
                         : fmt::format("<code>{}</code>", escaped_html(claim.command)));
  cell("see", links_html(claim, links));
  return html + "</tr>\n";
}

TextTable plain_table(const std::vector<ListedClaim>& claims) {
  TextTable table{{"claim", "place", "what it says", "paper", "ours", "verdict", "checked by"}, {}};
  for (const ListedClaim& c : claims)
    table.rows.push_back({c.id, c.place, c.what, c.paper, c.ours,
                          c.why.empty() ? c.verdict : c.verdict + ": " + c.why,
                          c.command == "none yet" ? c.command : "`" + c.command + "`"});
  return table;
}

}  // namespace

PageBlock claims_block(const std::vector<ListedClaim>& claims,
                       const std::vector<ClaimLink>& links) {
  std::string html = "<div id=\"claims\">\n" + filter_html(claims) +
                     "<div class=\"wide\"><table class=\"claims\">\n<thead><tr>";
  for (const char* const head :
       {"claim", "place", "what it says", "paper", "ours", "verdict", "checked by", "see"})
    html += fmt::format("<th>{}</th>", head);
  html += "</tr></thead>\n<tbody>\n";
  for (const ListedClaim& claim : claims) html += row_html(claim, links);
  html += "</tbody></table></div></div>\n";
  return {{plain_table(claims)}, std::move(html)};
}

PageBlock viewer_block(const std::vector<ViewerMesh>& meshes,
                       const std::vector<ViewerView>& views) {
  std::string html(kPageViewer);
  html += fmt::format("<script type=\"application/json\" id=\"views\">{}</script>\n",
                      viewer_views_json(views));
  for (const ViewerMesh& mesh : meshes)
    html += fmt::format("<script type=\"application/json\" id=\"mesh-{}\">{}</script>\n", mesh.id,
                        mesh.json);
  return {{}, std::move(html)};
}

PageFrame report_frame(const std::string& title) {
  return {title, std::string(kPageStyle), std::string(kPageScript)};
}

}  // namespace quadbound
