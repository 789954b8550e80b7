// SPDX-License-Identifier: Apache-2.0
#include "cli/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>
#include <thread>

#include "algo/theorem_1.hpp"
#include "cli/fuzz_cases.hpp"
#include "model/files.hpp"
#include "verify/report.hpp"

namespace quadbound::cli {

unsigned workers_of(const FuzzOptions& options) {
  return options.threads == 0 ? std::max(1U, std::thread::hardware_concurrency()) : options.threads;
}

std::vector<std::string> chosen_families(const FuzzOptions& options,
                                         std::span<const FamilyDescription> families) {
  for (const std::string& family : options.families)
    (void)find_family(families, family);  // refuse before the work
  return options.families.empty() ? names_of(families) : options.families;
}

bool reached_all(const std::vector<std::string>& never_reached) {
  for (const std::string& name : never_reached)
    fmt::print(stderr, "quadbound: {} was never reached: the campaign is too narrow\n", name);
  return never_reached.empty();
}

double CaseNumbers::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::optional<std::uint64_t> CaseNumbers::next() {
  const double seconds = elapsed();
  const bool by_time = options_.seconds > 0;
  if (stopped_ || (by_time && seconds >= options_.seconds)) return std::nullopt;
  const std::uint64_t index = next_++;
  if (!by_time && index >= options_.count) return std::nullopt;
  if (by_time)
    progress_.steps(static_cast<std::size_t>(seconds),
                    static_cast<std::size_t>(std::ceil(options_.seconds)));
  else
    progress_.steps(index, options_.count);
  return index;
}

void make_findings_folder(const FuzzOptions& options) {
  std::error_code error;
  std::filesystem::create_directories(options.findings, error);
  if (error)
    throw OutputError(fmt::format("{}: cannot be made: {}", options.findings, error.message()));
}

void FindingsFolder::write_case(const std::string& path,
                                const std::function<void(std::ostream&)>& write) const {
  make_findings_folder(options_);
  write_file(path, write);
}

namespace {

/// Lines of the index of a campaign that goes on.
struct OldIndex {
  bool has_line = false;
  bool is_torn = false;  ///< the last line has no end, as a full disk leaves it
};

OldIndex look_into(const std::string& path, const std::string& line) {
  std::ifstream stream(path, std::ios::binary);
  OldIndex index;
  for (std::string other; std::getline(stream, other);) {
    index.is_torn = stream.eof();
    index.has_line = index.has_line || (other == line && !index.is_torn);
  }
  return index;
}

}  // namespace

void FindingsFolder::note(const Entry& entry) const {
  const std::string index = path("INDEX");
  const std::string line =
      fmt::format("{}\t{}\t{}\t{}", entry.claim, entry.origin, entry.replay, entry.detail);
  const OldIndex old = options_.resume ? look_into(index, line) : OldIndex{};
  if (!old.has_line) {
    std::ofstream stream(index, std::ios::binary | std::ios::app);
    stream << (old.is_torn ? "\n" : "") << line << "\n";
    if (!stream.flush()) throw OutputError(index + ": cannot be written");
  }
  if (!options_.quiet)
    fmt::print(stderr, "quadbound: finding: {}: {}\n", entry.claim, entry.replay);
}

std::string angle_text(const std::optional<Corner<Rational>>& corner) {
  if (!corner) return "-";
  constexpr std::size_t kLongest = 20;
  std::string exact = arctangent_text(*corner);
  if (exact.size() <= kLongest) return exact;
  return fmt::format("{:.6f} degrees", JudgedCorner{{}, corner->cross, corner->dot}.degrees());
}

Json angle_json(const std::optional<Corner<Rational>>& corner) {
  return corner ? Json(arctangent_text(*corner)) : Json(nullptr);
}

std::string counts_line(const std::string& title, std::span<const std::string_view> names,
                        std::span<const std::uint64_t> values) {
  std::string text = title;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{} {}: {}", i == 0 ? "" : ",", names[i], values[i]);
  return text + "\n";
}

Json counts_json(std::span<const std::string_view> names, std::span<const std::uint64_t> values) {
  Json json = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) json[std::string(names[i])] = values[i];
  return json;
}

}  // namespace quadbound::cli
