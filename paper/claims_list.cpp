// SPDX-License-Identifier: Apache-2.0
#include "paper/claims_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "model/errors.hpp"
#include "paper/page_files.hpp"

namespace quadbound {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kMeasuredBy = "quadbound reproduce";

/// What to type: a name of a test needs the command that runs it.
std::string command_of(const std::string& checked_by) {
  if (checked_by == "nothing yet") return "none yet";
  if (checked_by.starts_with("quadbound ")) return checked_by;
  return "ctest --preset release -R " + checked_by;
}

class ClaimsList {
 public:
  explicit ClaimsList(std::string_view text) : file_(Json::parse(text)) {}

  std::vector<ListedClaim> run(const std::vector<PaperClaim>& measured) {
    for (const PaperClaim& claim : measured)
      add({{},
           claim.id,
           {},
           claim.what,
           claim.paper,
           claim.ours,
           std::string(verdict_name(claim.verdict)),
           claim.why,
           std::string(kMeasuredBy)});
    for (const Json& claim : file_.at("claims")) {
      if (claim.at("checked_by") == kMeasuredBy) continue;
      add({{},
           claim.at("id"),
           {},
           claim.at("what"),
           claim.value("paper", "-"),
           claim.value("ours", "-"),
           claim.at("verdict"),
           claim.value("why", ""),
           command_of(claim.at("checked_by"))});
    }
    std::stable_sort(claims_.begin(), claims_.end(), [&](const auto& left, const auto& right) {
      return number_of_place(left.id) < number_of_place(right.id);
    });
    return std::move(claims_);
  }

 private:
  void add(ListedClaim claim) {
    const int number = ++met_[claim.id];
    claim.anchor = number == 1 ? claim.id : fmt::format("{}-{}", claim.id, number);
    claim.place = places_.value(claim.id, "-");
    claims_.push_back(std::move(claim));
  }

  /// In the order of the file, which is that of the paper.
  [[nodiscard]] std::ptrdiff_t number_of_place(const std::string& id) const {
    return std::distance(places_.begin(), places_.find(id));
  }

  Json file_;
  const Json& places_ = file_.at("places");
  std::map<std::string, int> met_;
  std::vector<ListedClaim> claims_;
};

}  // namespace

std::string_view file_of_claims() { return kClaimsFile; }

std::vector<ListedClaim> list_claims(std::string_view file_of_claims,
                                     const std::vector<PaperClaim>& measured) {
  try {
    return ClaimsList(file_of_claims).run(measured);
  } catch (const Json::exception& error) {
    throw InputError({"paper/claims.json", {}, {}}, error.what());
  }
}

}  // namespace quadbound
