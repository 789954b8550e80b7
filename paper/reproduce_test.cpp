// SPDX-License-Identifier: Apache-2.0
// fig-10, 80n, fig-46 to fig-53, table-2 and the rest of `quadbound reproduce`, on a small scale.
#include "paper/reproduce.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "model/errors.hpp"
#include "model/files.hpp"
#include "paper/claims_list.hpp"
#include "paper/document.hpp"

namespace quadbound {
namespace {

namespace fs = std::filesystem;

/// Reproduces into folders of its own, once for all tests, with one and with two threads.
class Reproduce : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const std::string unique = std::to_string(::getpid());
    for (const unsigned threads : {1U, 2U}) {
      const fs::path folder =
          fs::temp_directory_path() / ("quadbound-reproduce-" + unique + std::to_string(threads));
      ReproduceOptions options;
      options.out = folder.string();
      options.command = "test";
      options.measure = {QUADBOUND_PAPER_DATA, 100, 200, 100, threads};
      NoWatcher nobody;
      results_.push_back(reproduce(options, nobody));
      folders_.push_back(folder);
    }
  }
  static void TearDownTestSuite() {
    for (const fs::path& folder : folders_) fs::remove_all(folder);
    folders_.clear();
    results_.clear();
  }
  static std::string file(const std::string& name) {
    return read_file((folders_[0] / name).string());
  }

  static inline std::vector<fs::path> folders_;
  static inline std::vector<ReproduceResult> results_;
};

TEST_F(Reproduce, HoldsAndNoClaimFails) {
  EXPECT_TRUE(results_[0].holds);
  EXPECT_GE(results_[0].claims.size(), 20U);
  for (const PaperClaim& claim : results_[0].claims)
    EXPECT_NE(claim.verdict, PaperVerdict::kFails) << claim.what;
}

/// A verdict that changes must change paper/claims.json too.
TEST_F(Reproduce, GivesTheVerdictsOfTheFileOfClaims) {
  using Entry = std::tuple<std::string, std::string, std::string, std::string>;
  std::vector<Entry> expected;
  const auto file_of_claims = nlohmann::json::parse(read_file(QUADBOUND_PAPER_CLAIMS));
  for (const auto& claim : file_of_claims.at("claims")) {
    if (claim.at("checked_by") != "quadbound reproduce") continue;
    const std::string why = claim.value("why", "");
    expected.emplace_back(claim.at("id"), claim.at("what"), claim.at("paper"),
                          claim.at("verdict").get<std::string>() + (why.empty() ? "" : ": " + why));
  }
  std::vector<Entry> found;
  for (const PaperClaim& claim : results_[0].claims)
    found.emplace_back(claim.id, claim.what, claim.paper, verdict_text(claim));
  EXPECT_EQ(found, expected);
}

TEST_F(Reproduce, SameBytesTwiceSaveTheMachine) {
  std::size_t compared = 0;
  for (const auto& entry : fs::directory_iterator(folders_[0])) {
    const fs::path name = entry.path().filename();
    if (name == "machine.json") continue;
    EXPECT_TRUE(read_file(entry.path().string()) == read_file((folders_[1] / name).string()))
        << name;
    ++compared;
  }
  EXPECT_EQ(compared, 36U);
}

TEST_F(Reproduce, JsonHoldsTheNumbers) {
  const auto json = nlohmann::json::parse(file("reproduction.json"));
  EXPECT_EQ(json.at("format"), "quadbound-reproduction");
  EXPECT_EQ(json.at("version"), 1);
  EXPECT_EQ(json.at("fig-10").at("n"), 303);
  EXPECT_EQ(json.at("fig-10").at("smallest").at("tan"), "1/2");
  EXPECT_EQ(json.at("theorem-1").at("unlisted"), 0);
  EXPECT_EQ(json.at("paper-warping").size(), 5U);
  for (const auto& run : json.at("n-against-N")) EXPECT_TRUE(run.at("proved").get<bool>());
}

TEST_F(Reproduce, PolygonsAreProvedAndOfThePapersSize) {
  const auto json = nlohmann::json::parse(file("reproduction.json"));
  const std::vector<std::pair<std::string, int>> edges{
      {"fig-46", 19}, {"fig-49", 33}, {"fig-50", 303}, {"plate", 36}};
  ASSERT_EQ(json.at("polygons").size(), edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& polygon = json.at("polygons").at(i);
    EXPECT_EQ(polygon.at("id"), edges[i].first);
    EXPECT_EQ(polygon.at("n"), edges[i].second);
    EXPECT_TRUE(polygon.at("proved").get<bool>());
    EXPECT_GE(polygon.at("smallest").at("degrees").get<double>(), 18.4349);
    EXPECT_LE(polygon.at("largest").at("degrees").get<double>(), 171.8699);
    std::uint64_t vertices = 0;
    for (const auto& [degree, count] : polygon.at("degrees").items())
      vertices += count.get<std::uint64_t>();
    EXPECT_EQ(vertices, polygon.at("vertices").get<std::uint64_t>());
    EXPECT_GE(polygon.at("scaled_jacobian").at("smallest").get<double>(), 0.1414);
  }
}

TEST_F(Reproduce, EveryFigureHasItsPicture) {
  for (const char* const name : {"fig-44", "fig-45", "fig-46", "fig-47", "fig-48", "fig-49",
                                 "fig-50", "fig-51", "fig-52", "fig-53", "plate"}) {
    EXPECT_NE(file(std::string(name) + ".svg").find("<svg"), std::string::npos) << name;
    EXPECT_TRUE(file(std::string(name) + ".pdf").starts_with("%PDF")) << name;
    EXPECT_NE(file("reproduction.md").find(std::string("](") + name + ".svg)"), std::string::npos);
  }
}

TEST_F(Reproduce, CsvHasALineForEachMesh) {
  const auto json = nlohmann::json::parse(file("reproduction.json"));
  const std::string csv = file("n-against-N.csv");
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
            1 + json.at("n-against-N").size());
}

TEST_F(Reproduce, ReportHasTheSameTablesInBothForms) {
  const std::string markdown = file("reproduction.md");
  const std::string html = file("reproduction.html");
  for (const PaperClaim& claim : results_[0].claims)
    EXPECT_NE(markdown.find(claim.id), std::string::npos);
  for (const ListedClaim& claim : list_claims(file_of_claims(), results_[0].claims)) {
    EXPECT_NE(html.find("<tr id=\"" + claim.anchor + "\""), std::string::npos) << claim.anchor;
    EXPECT_NE(claim.place, "-") << claim.id;
  }
  for (const char* const mesh : {"plate", "fig-46", "fig-47", "fig-49", "fig-50", "fig-10"})
    EXPECT_NE(html.find(std::string("id=\"mesh-") + mesh + "\""), std::string::npos) << mesh;
  EXPECT_LT(html.size(), 8'000'000U);
  EXPECT_EQ(html.find("src=\"http"), std::string::npos);
  EXPECT_NE(html.find("data:image/png;base64,iVBOR"), std::string::npos);
  EXPECT_NE(html.find("<svg"), std::string::npos);
}

TEST_F(Reproduce, TimesAreInOneFileOnly) {
  const auto machine = nlohmann::json::parse(file("machine.json"));
  EXPECT_EQ(machine.at("steps").size(), 8U);
  EXPECT_EQ(file("reproduction.json").find("seconds"), std::string::npos);
}

TEST(ReproduceSizes, FullIsLargerInAllThree) {
  const MeasureOptions usual;
  const MeasureOptions full = full_measure_options();
  EXPECT_GE(full.max_n, 10 * usual.max_n);
  EXPECT_GE(full.trees, 10 * usual.trees);
  EXPECT_GE(full.audits, 10 * usual.audits);
}

TEST(ReproduceErrors, MissingDataIsBadInput) {
  ReproduceOptions options;
  options.out =
      (fs::temp_directory_path() / ("quadbound-none-" + std::to_string(::getpid()))).string();
  options.measure.data = "/nowhere";
  NoWatcher nobody;
  EXPECT_THROW(reproduce(options, nobody), InputError);
  fs::remove_all(options.out);
}

TEST(Document, EscapesAndEncodes) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("a"), "YQ==");
  EXPECT_EQ(base64("ab"), "YWI=");
  EXPECT_EQ(base64("abc"), "YWJj");
  const Document document{Heading{2, "a < b"}, Paragraph{"`x` & y"}, TextTable{{"1|4"}, {{"2"}}}};
  EXPECT_EQ(to_markdown(document), "## a < b\n\n`x` & y\n\n| 1\\|4 |\n| --- |\n| 2 |\n");
  const std::string html = to_html(document, {"t", "", ""});
  EXPECT_NE(html.find("<h2>a &lt; b</h2>"), std::string::npos);
  EXPECT_NE(html.find("<p><code>x</code> &amp; y</p>"), std::string::npos);
}

TEST(Document, NumbersForReaders) {
  EXPECT_EQ(with_commas(0), "0");
  EXPECT_EQ(with_commas(999), "999");
  EXPECT_EQ(with_commas(20845), "20,845");
  EXPECT_EQ(with_commas(1234567), "1,234,567");
}

}  // namespace
}  // namespace quadbound
