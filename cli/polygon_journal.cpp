// SPDX-License-Identifier: Apache-2.0
#include "cli/polygon_journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "cli/polygon_campaign.hpp"
#include "model/errors.hpp"
#include "model/files.hpp"

namespace quadbound::cli {
namespace {

constexpr const char* kFormat = "quadbound-fuzz-journal";
constexpr int kVersion = 1;

InputError error_in(const std::string& path, const std::string& text) {
  return {{path, std::nullopt, std::nullopt}, text};
}

OutputError write_error(const std::string& path) {
  return OutputError(fmt::format("{}: cannot be written: {}; --resume goes on where it ends", path,
                                 std::strerror(errno)));
}

constexpr std::string_view kCaseStart = "{\"case\":";
constexpr std::string_view kEndStart = "{\"end\":";

void read_first_line(const std::string& line, const JournalReader& reader) {
  const Json json = Json::parse(line);
  if (json.at("format") != kFormat || json.at("version") != kVersion)
    throw std::invalid_argument("no journal of this version");
  if (reader.on_campaign) reader.on_campaign(json.at("campaign"));
}

void read_case(const std::string& line, const JournalReader& reader) {
  std::uint64_t index = 0;
  const char* const digits = line.data() + kCaseStart.size();
  const bool has_index =
      line.starts_with(kCaseStart) &&
      std::from_chars(digits, line.data() + line.size(), index).ec == std::errc{};
  if (!has_index) throw std::invalid_argument("no case");
  if (reader.on_case) reader.on_case(index, result_from_text(line));
}

}  // namespace

Json campaign_json(const FuzzOptions& options) {
  const PolygonCampaign campaign = campaign_of(options);
  const PolygonTrial trial = trial_of(options);
  return {{"program", QUADBOUND_VERSION},
          {"seed", campaign.seed},
          {"families", campaign.families},
          {"max_n", campaign.max_n},
          {"max_cells", trial.budget.max_cells},
          {"max_seconds", trial.budget.max_seconds},
          {"max_memory", options.max_megabytes},
          {"min_tangent", {trial.angles.smallest.numerator, trial.angles.smallest.denominator}},
          {"shard", {options.shard.number, options.shard.of}}};
}

void set_campaign(const Json& campaign, FuzzOptions& options) {
  campaign.at("seed").get_to(options.seed);
  campaign.at("families").get_to(options.families);
  options.max_n = campaign.at("max_n").get<std::uint64_t>();
  options.max_cells = campaign.at("max_cells").get<std::uint64_t>();
  campaign.at("max_seconds").get_to(options.max_seconds);
  campaign.at("max_memory").get_to(options.max_megabytes);
  const Json& tangent = campaign.at("min_tangent");
  options.min_tangent = Arctangent{tangent.at(0).get<int>(), tangent.at(1).get<int>()};
}

std::string difference(const Json& a, const Json& b) {
  for (const auto& [key, value] : a.items())
    if (!b.contains(key) || b.at(key) != value) return key;
  return {};
}

JournalFacts read_journal(const std::string& path, const JournalReader& reader) {
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw error_in(path, fmt::format("cannot be opened: {}", std::strerror(errno)));
  JournalFacts facts;
  std::string line;
  while (std::getline(stream, line) && !stream.eof()) {
    facts.has_ended = line.starts_with(kEndStart);
    try {
      if (facts.lines == 0)
        read_first_line(line, reader);
      else if (facts.has_ended)
        facts.count = Json::parse(line).at("end").at("count").get<std::uint64_t>();
      else
        read_case(line, reader);
    } catch (const InputError&) {
      throw;
    } catch (const std::exception&) {
      throw error_in(path, fmt::format("line {} is none of a journal", facts.lines + 1));
    }
    facts.bytes += line.size() + 1;
    ++facts.lines;
  }
  if (stream.bad()) throw error_in(path, "cannot be read");
  return facts;
}

PolygonJournal::PolygonJournal(const FuzzOptions& options, PolygonTally& tally)
    : path_(journal_path(options)) {
  open(options);
  try {
    lock();
    const std::uint64_t kept = options.resume ? take_up(options, tally) : 0;
    if (!options.resume) refuse_unless_ended();
    lock();  // closing the file after reading it has dropped the lock
    if (::ftruncate(descriptor_, static_cast<off_t>(kept)) != 0) throw write_error(path_);
    if (kept == 0)
      write(Json{{"format", kFormat}, {"version", kVersion}, {"campaign", campaign_json(options)}}
                .dump());
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

PolygonJournal::~PolygonJournal() { ::close(descriptor_); }

void PolygonJournal::open(const FuzzOptions& options) {
  if (options.journal.empty()) make_findings_folder(options);
  constexpr mode_t kMode = 0666;  // less the mask of the user, as for any file
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, kMode);
  if (descriptor_ < 0)
    throw OutputError(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
  if (std::filesystem::is_regular_file(path_)) return;
  ::close(descriptor_);
  throw OutputError(path_ + ": a journal must be a file that can be read again");
}

/// A lock of fcntl goes with this process: children that outlive it for a moment do not keep it.
void PolygonJournal::lock() const {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  const bool is_taken =
      ::fcntl(descriptor_, F_SETLK, &whole) != 0 && (errno == EACCES || errno == EAGAIN);
  if (is_taken) throw error_in(path_, "another campaign is writing this journal");
}

std::uint64_t PolygonJournal::take_up(const FuzzOptions& options, PolygonTally& tally) {
  const PolygonCampaign cases = campaign_of(options);
  JournalReader reader;
  reader.on_campaign = [&](const Json& campaign) {
    if (const auto key = difference(campaign_json(options), campaign); !key.empty())
      throw error_in(path_, fmt::format("the journal of another campaign: {} differs", key));
  };
  reader.on_case = [&](std::uint64_t index, const PolygonResult& result) {
    if (has(index)) throw error_in(path_, fmt::format("case {} is there twice", index));
    if (options.seconds == 0 && index >= options.count)
      throw error_in(path_, fmt::format("case {} is beyond --count {}", index, options.count));
    is_there_.resize(std::max<std::size_t>(is_there_.size(), index + 1));
    is_there_[index] = true;
    tally.add(index, result, family_of(cases, index));
  };
  return read_journal(path_, reader).bytes;
}

void PolygonJournal::refuse_unless_ended() const {
  const JournalFacts facts = read_journal(path_, {});
  if (facts.lines > 1 && !facts.has_ended)
    throw error_in(path_,
                   "of a campaign that has not ended; go on with --resume, or remove the file");
}

void PolygonJournal::add(std::uint64_t index, const PolygonResult& result) {
  write(fmt::format("{}{},{}", kCaseStart, index, to_text(result).substr(1)));
}

void PolygonJournal::end(const FuzzOptions& options) {
  const bool by_the_clock = options.seconds > 0;
  write(fmt::format("{}{{\"count\":{}}}}}", kEndStart, by_the_clock ? 0 : options.count));
}

void PolygonJournal::write(const std::string& line) const {
  const std::string whole = line + "\n";
  for (std::size_t written = 0; written < whole.size();) {
    const ssize_t count = ::write(descriptor_, whole.data() + written, whole.size() - written);
    if (count < 0 && errno != EINTR) throw write_error(path_);
    if (count > 0) written += static_cast<std::size_t>(count);
  }
}

}  // namespace quadbound::cli
