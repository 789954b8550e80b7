// SPDX-License-Identifier: Apache-2.0
#pragma once
// The journal of a campaign of polygons: what is needed to go on where it was, and for its summary.
//
// A file of lines, each a JSON object. The first says which campaign it is; then comes a line per
// finished case, in the order in which they ended; the line "end" says that the campaign ended by
// itself. Lines are only ever added, each by one call to the system, so that neither a killed
// program nor a full disk takes more than the line that it was writing.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cli/campaign.hpp"
#include "cli/polygon_tally.hpp"

namespace quadbound::cli {

/// All that decides what a case of a campaign comes to, and the shard; not how many cases.
Json campaign_json(const FuzzOptions& options);
/// Sets what campaign_json tells, but for the shard. Errors: std::exception for anything else.
void set_campaign(const Json& campaign, FuzzOptions& options);
/// The name of what two campaigns do not have in common; empty where there is nothing.
std::string difference(const Json& a, const Json& b);

/// What to do with the parts of a journal. Without `on_case` cases are passed over unread.
struct JournalReader {
  std::function<void(const Json& campaign)> on_campaign;
  std::function<void(std::uint64_t index, const PolygonResult& result)> on_case;
};

struct JournalFacts {
  std::uint64_t bytes = 0;  ///< of whole lines
  std::uint64_t lines = 0;
  bool has_ended = false;
  std::uint64_t count =
      0;  ///< of the cases of a campaign that has ended; 0 where the clock ended it
};

/// Reads a journal line by line. A last line without an end, as a crash leaves it, is no line.
/// Errors: InputError for a file that cannot be read or is no journal, with the line.
JournalFacts read_journal(const std::string& path, const JournalReader& reader);

/// The journal of a campaign that runs.
///
/// Guarantees: 1. what add() was given is there after the end of the program, however it ends.
/// 2. no two campaigns write the same file at once.
class PolygonJournal {
 public:
  /// Opens the file of the options, and with --resume adds the cases there to the tally.
  /// Errors: InputError where it belongs to another campaign, or to one that has not ended and is
  /// not to be resumed; OutputError.
  PolygonJournal(const FuzzOptions& options, PolygonTally& tally);
  ~PolygonJournal();
  PolygonJournal(const PolygonJournal&) = delete;
  PolygonJournal& operator=(const PolygonJournal&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] bool has(std::uint64_t index) const {
    return index < is_there_.size() && is_there_[index];
  }
  /// Errors: OutputError. Complexity: one call to the system.
  void add(std::uint64_t index, const PolygonResult& result);
  /// The campaign has come to its end.
  void end(const FuzzOptions& options);

 private:
  void open(const FuzzOptions& options);
  void lock() const;
  /// How many bytes of the file are kept.
  std::uint64_t take_up(const FuzzOptions& options, PolygonTally& tally);
  void refuse_unless_ended() const;
  void write(const std::string& line) const;

  std::string path_;
  int descriptor_ = -1;
  std::vector<bool> is_there_;
};

}  // namespace quadbound::cli
