// SPDX-License-Identifier: Apache-2.0
// The page of the report: all claims in it, in order, and meshes without loss.
#include "paper/report_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "generators/polygons.hpp"
#include "model/errors.hpp"
#include "paper/polygon_experiment.hpp"
#include "paper/records.hpp"
#include "paper/viewer_mesh.hpp"

namespace quadbound {
namespace {

const PaperClaim kMeasured{"thm-13", "a <b>", "1", "2", PaperVerdict::kHolds, "because"};

TEST(ClaimsList, HasEveryClaimOfTheFileThatIsNotMeasured) {
  const auto file = nlohmann::json::parse(file_of_claims());
  std::size_t others = 0;
  for (const auto& claim : file.at("claims"))
    others += claim.at("checked_by") == "quadbound reproduce" ? 0U : 1U;
  const auto claims = list_claims(file_of_claims(), {kMeasured});
  EXPECT_EQ(claims.size(), others + 1);
  std::set<std::string> anchors;
  for (const ListedClaim& claim : claims) {
    anchors.insert(claim.anchor);
    EXPECT_NE(claim.place, "-") << claim.id << " has no place in claims.json";
    EXPECT_FALSE(claim.verdict.empty()) << claim.id;
    EXPECT_FALSE(claim.command.empty()) << claim.id;
  }
  EXPECT_EQ(anchors.size(), claims.size());
}

TEST(ClaimsList, IsInTheOrderOfThePlaces) {
  const char* const file =
      R"({"places": {"lemma-2": "3.1", "thm-13": "3.3", "sec-4": "4"}, "claims": [
    {"id": "sec-4", "what": "c", "verdict": "fails", "checked_by": "Departures.Kite"},
    {"id": "thm-13", "what": "b", "verdict": "not audited", "checked_by": "nothing yet"},
    {"id": "thm-13", "what": "x", "verdict": "fails", "checked_by": "quadbound reproduce"},
    {"id": "lemma-2", "what": "a", "verdict": "holds", "checked_by": "quadbound audit"}]})";
  const auto claims = list_claims(file, {kMeasured});
  ASSERT_EQ(claims.size(), 4U);
  EXPECT_EQ(claims[0].id, "lemma-2");
  EXPECT_EQ(claims[0].command, "quadbound audit");
  EXPECT_EQ(claims[1].anchor, "thm-13");
  EXPECT_EQ(claims[1].verdict, "holds");
  EXPECT_EQ(claims[1].why, "because");
  EXPECT_EQ(claims[2].anchor, "thm-13-2");
  EXPECT_EQ(claims[2].command, "none yet");
  EXPECT_EQ(claims[3].command, "ctest --preset release -R Departures.Kite");
}

TEST(ClaimsList, RefusesWhatIsNoFileOfClaims) {
  EXPECT_THROW(list_claims("{", {}), InputError);
  EXPECT_THROW(list_claims(R"({"claims": []})", {}), InputError);
}

TEST(ReportPage, ClaimsAreRowsWithLinksAndEscaped) {
  const auto claims = list_claims(file_of_claims(), {kMeasured});
  const PageBlock block = claims_block(claims, {{"thm-13", "#polygons", "Polygons"}});
  EXPECT_NE(block.html.find("<tr id=\"thm-13\" data-verdict=\"holds\">"), std::string::npos);
  EXPECT_NE(block.html.find("a &lt;b&gt;"), std::string::npos);
  EXPECT_NE(block.html.find("<a href=\"#polygons\">Polygons</a>"), std::string::npos);
  EXPECT_NE(block.html.find("data-verdict=\"fails\""), std::string::npos);
  const auto& table = std::get<TextTable>(block.markdown.at(0));
  EXPECT_EQ(table.rows.size(), claims.size());
}

TEST(ReportPage, SectionsAndPicturesAreLinked) {
  const Document document{
      Heading{2, "Polygons (all)", "polygons", {"thm-13"}},
      DocumentPicture{"fig-46.svg", "a hole", "<svg/>", {"fig-46"}, "view"},
  };
  const auto links = claim_links(document);
  ASSERT_EQ(links.size(), 3U);
  EXPECT_EQ(links[0].address, "#polygons");
  EXPECT_EQ(links[1].address, "#figure-fig-46");
  EXPECT_EQ(links[2].address, "#view-view");
  const std::string html = to_html(document, report_frame("t"));
  EXPECT_NE(html.find("<a href=\"#polygons\">Polygons</a>"), std::string::npos);
  EXPECT_NE(html.find("<figure id=\"figure-fig-46\">"), std::string::npos);
  EXPECT_NE(html.find("<a href=\"#fig-46\">"), std::string::npos);
}

TEST(Records, MarkdownIsRead) {
  const Document read = read_markdown(
      "# A `title`\n\nOne **line**,\nand [a link](b.md).\n<!-- no -->\n- item\n  goes on\n\n"
      "| a | b&#124;c |\n| --- | --: |\n| 1 | x \\| y |\n\n```\n# "
      "code\n\nmore\n```\n![gone](no.svg)\n",
      "/nowhere");
  ASSERT_EQ(read.size(), 6U);
  EXPECT_EQ(std::get<Heading>(read[0]).text, "A `title`");
  EXPECT_EQ(std::get<Paragraph>(read[1]).text, "One line, and a link.");
  EXPECT_EQ(std::get<Paragraph>(read[2]).text, "• item goes on");
  const auto& table = std::get<TextTable>(read[3]);
  EXPECT_EQ(table.head, (std::vector<std::string>{"a", "b|c"}));
  EXPECT_EQ(table.rows, (std::vector<std::vector<std::string>>{{"1", "x | y"}}));
  EXPECT_EQ(std::get<CodeBlock>(read[4]).text, "# code\n\nmore");
  EXPECT_EQ(std::get<Paragraph>(read[5]).text, "gone");
  EXPECT_TRUE(records_block("/nowhere").html.empty());
}

class ViewerMeshJson : public testing::Test {
 protected:
  static JudgedPolygonMesh judged() {
    return judge_polygon_mesh(generate_polygon(parse_polygon_recipe("blob:n=13,seed=1,holes=1")),
                              1);
  }
};

TEST_F(ViewerMeshJson, LosesNothing) {
  const JudgedPolygonMesh made = judged();
  const auto json = nlohmann::json::parse(viewer_mesh_json(made.mesh, made.report, {}));
  std::istringstream xy(json.at("xy").get<std::string>());
  const int exponent = json.at("exponent");
  std::size_t rational = 0;
  for (VertexId v = 0; v < made.mesh.vertices.size(); ++v) {
    std::int64_t x = 0;
    std::int64_t y = 0;
    ASSERT_TRUE(xy >> x >> y);
    RationalPoint read{dyadic(x, exponent), dyadic(y, exponent)};
    if (const auto found = json.at("rational").find(std::to_string(v));
        found != json.at("rational").end()) {
      read = {parse_rational(found->at(0).get<std::string>()).value(),
              parse_rational(found->at(1).get<std::string>()).value()};
      ++rational;
    }
    ASSERT_EQ(read, made.mesh.vertices.exact(v)) << v;
  }
  EXPECT_EQ(rational, made.mesh.vertices.off_lattice_count());
  ASSERT_EQ(json.at("quads").size(), 4 * made.mesh.quads.size());
  for (std::size_t i = 0; i < json.at("quads").size(); ++i)
    EXPECT_EQ(json.at("quads").at(i), made.mesh.quads[i / 4][i % 4]);
  for (const auto& colour : json.at("colours")) {
    const std::string classes = colour.at("of_quad");
    ASSERT_EQ(classes.size(), made.mesh.quads.size());
    for (const char c : classes)
      ASSERT_LT(static_cast<std::size_t>(c - '0'), colour.at("classes").size());
  }
}

TEST_F(ViewerMeshJson, NamesTheInputAndTheJudgesWorstCorners) {
  const JudgedPolygonMesh made = judged();
  std::vector<Point> input;
  for (const Ring& ring : made.polygon.rings) input.insert(input.end(), ring.begin(), ring.end());
  const std::string text = viewer_mesh_json(made.mesh, made.report, input);
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json.at("input").size(), 19U);
  for (const auto& v : json.at("input")) {
    const RationalPoint at = made.mesh.vertices.exact(v.get<VertexId>());
    EXPECT_TRUE(std::any_of(input.begin(), input.end(),
                            [&](const Point& point) { return exact_value(point) == at; }));
  }
  const JudgedCorner& worst = made.report.find("min-angle")->worst.value();
  EXPECT_EQ(json.at("worst").at("smallest").at("quad"), worst.place.quad.value());
  EXPECT_EQ(json.at("worst").at("smallest").at("tan"), to_text(worst.tangent().value()));
  EXPECT_EQ(json.at("bounds").at("theorem"), "thm-13");
  EXPECT_EQ(text.find("</"), std::string::npos);
}

}  // namespace
}  // namespace quadbound
