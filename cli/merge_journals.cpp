// SPDX-License-Identifier: Apache-2.0
// Journals of the shards of a campaign of polygons, told as one campaign.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/polygon_campaign.hpp"
#include "cli/polygon_journal.hpp"
#include "model/errors.hpp"

namespace quadbound::cli {
namespace {

/// Adds up journals, each case once.
class Merge {
 public:
  explicit Merge(const FuzzOptions& options) : options_(options) {}

  void add(const std::string& path) {
    JournalReader reader;
    reader.on_campaign = [&](const Json& campaign) { check(path, campaign); };
    reader.on_case = [&](std::uint64_t index, const PolygonResult& result) {
      note(path, index);
      tally_.add(index, result, family_of(campaign_, index));
    };
    const JournalFacts facts = read_journal(path, reader);
    if (facts.lines == 0)
      throw InputError({path, std::nullopt, std::nullopt}, "has not even a first line");
    if (!facts.has_ended) {
      has_ended_ = false;
      fmt::print(stderr, "quadbound: {}: has not ended\n", path);
    }
    count_ = std::max(count_, facts.count);
  }

  /// Whether no case is missing; says which are.
  bool is_whole() {
    const auto missing = std::ranges::find(is_there_, false);
    const std::uint64_t first = static_cast<std::uint64_t>(missing - is_there_.begin());
    const bool by_the_clock = count_ == 0;  // no number of cases was asked for
    if (!by_the_clock && tally_.all.cases < count_) {
      has_ended_ = false;
      fmt::print(stderr, "quadbound: {} of {} cases are missing, the first is {}\n",
                 count_ - tally_.all.cases, count_, first);
    }
    return has_ended_;
  }

  [[nodiscard]] const FuzzOptions& options() const { return options_; }
  [[nodiscard]] const PolygonTally& tally() const { return tally_; }

 private:
  void check(const std::string& path, const Json& campaign) {
    if (first_.is_null()) {
      first_ = campaign;
      set_campaign(campaign, options_);
      campaign_ = campaign_of(options_);
    }
    if (const auto key = difference(first_, campaign); !key.empty() && key != "shard")
      throw InputError({path, std::nullopt, std::nullopt},
                       fmt::format("the journal of another campaign: {} differs", key));
  }

  void note(const std::string& path, std::uint64_t index) {
    is_there_.resize(std::max<std::size_t>(is_there_.size(), index + 1));
    if (is_there_[index])
      throw InputError({path, std::nullopt, std::nullopt},
                       fmt::format("case {} is in another journal as well", index));
    is_there_[index] = true;
  }

  FuzzOptions options_;
  PolygonCampaign campaign_;
  PolygonTally tally_;
  Json first_;
  std::vector<bool> is_there_;
  std::uint64_t count_ = 0;
  bool has_ended_ = true;
};

}  // namespace

ExitStatus merge_journals(const FuzzOptions& options) {
  Merge merge(options);
  for (const std::string& path : options.merge) merge.add(path);
  const bool is_whole = merge.is_whole();
  const ExitStatus status = conclude(merge.options(), merge.tally(), is_whole);
  return status == kGood && !is_whole ? kBudgetRanOut : status;
}

}  // namespace quadbound::cli
