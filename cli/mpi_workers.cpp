// SPDX-License-Identifier: Apache-2.0
#include "cli/mpi_workers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/mpi/exception.hpp>
#include <boost/mpi/status.hpp>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <exception>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "cli/case_workers.hpp"
#include "cli/polygon_campaign.hpp"
#include "cli/task_pool.hpp"

namespace quadbound::cli {
namespace {

namespace mpi = boost::mpi;
using Clock = std::chrono::steady_clock;

enum Tag : int { kCase, kStop, kAnswer, kAlive };

constexpr std::chrono::milliseconds kBetweenSigns{500};
/// A rank that was silent for so long is taken for lost. If it is only slow, nothing goes wrong but
/// that its cases are tried twice.
constexpr std::chrono::seconds kSilence{5};
/// Rank 0 has more to do between its signs, such as reading the journal of a campaign that goes on.
constexpr std::chrono::seconds kSilenceOfRank0{300};
constexpr std::chrono::milliseconds kNap{2};

// --- messages ------------------------------------------------------------------------------------

struct Answer {
  std::uint64_t index = 0;
  TaskOutcome outcome;
};

/// "INDEX END LENGTH" and a line's end, the answer of that length, and the detail.
std::string to_text(const Answer& answer) {
  return fmt::format("{} {} {}\n{}{}", answer.index, static_cast<int>(answer.outcome.end),
                     answer.outcome.answer.size(), answer.outcome.answer, answer.outcome.detail);
}

Answer answer_from(const std::string& text) {
  const char* at = text.data();
  const auto number = [&at, end = text.data() + text.size()] {
    std::uint64_t value = 0;
    at = std::from_chars(at, end, value).ptr + 1;  // past the space or the line's end
    return value;
  };
  Answer answer;
  answer.index = number();
  answer.outcome.end = static_cast<TaskEnd>(number());
  const std::size_t length = number();
  const auto start = static_cast<std::size_t>(at - text.data());
  answer.outcome.answer = text.substr(start, length);
  answer.outcome.detail = text.substr(start + length);
  return answer;
}

/// As plain bytes, which are one message: of two a rank could be lost between.
void send_text(const mpi::communicator& world, int rank, int tag, const std::string& text) {
  world.send(rank, tag, text.data(), static_cast<int>(text.size()));
}

std::string receive_text(const mpi::communicator& world, const mpi::status& status) {
  std::string text(static_cast<std::size_t>(status.count<char>().value_or(0)), '\0');
  world.recv(status.source(), status.tag(), text.data(), static_cast<int>(text.size()));
  return text;
}

// --- rank 0 --------------------------------------------------------------------------------------

class MpiWorkers : public CaseWorkers {
 public:
  MpiWorkers(const mpi::communicator& world, unsigned cases_of_a_rank)
      : world_(world), most_(cases_of_a_rank) {
    for (int rank = 0; rank < world.size(); ++rank) ranks_.push_back({{}, Clock::now(), rank != 0});
  }

  [[nodiscard]] bool has_room() const override { return lost_cases_.empty() && free_rank() != 0; }
  [[nodiscard]] bool is_idle() const override {
    return lost_cases_.empty() &&
           std::ranges::all_of(ranks_, [](const Rank& rank) { return rank.cases.empty(); });
  }

  void start(std::uint64_t index) override {
    const int rank = free_rank();
    try {
      send_text(world_, rank, kCase, fmt::format("{}", index));
      ranks_[static_cast<std::size_t>(rank)].cases.insert(index);
    } catch (const mpi::exception&) {
      lost_cases_.push_back(index);
      lose(rank);
    }
  }

  void wait(const Done& done) override {
    bool heard = false;
    while (const auto status = world_.iprobe(mpi::any_source, mpi::any_tag)) {
      heard = true;
      listen(*status, done);
    }
    give_a_sign();
    look_for_lost_ranks();
    while (!lost_cases_.empty() && free_rank() != 0) {
      const std::uint64_t index = lost_cases_.front();
      lost_cases_.pop_front();
      start(index);
    }
    if (!heard) std::this_thread::sleep_for(kNap);
  }

  /// Sends all ranks home; whether all of them are still there.
  bool stop() {
    bool all_live = true;
    for (int rank = 1; rank < world_.size(); ++rank)
      all_live = all_live && ranks_[static_cast<std::size_t>(rank)].lives;
    for (int rank = 1; rank < world_.size(); ++rank)
      if (ranks_[static_cast<std::size_t>(rank)].lives)
        send_text(world_, rank, kStop, all_live ? "all" : "");
    return all_live;
  }

 private:
  struct Rank {
    std::set<std::uint64_t> cases;
    Clock::time_point heard;
    bool lives;
  };

  /// 0 where there is none.
  [[nodiscard]] int free_rank() const {
    int best = 0;
    std::size_t fewest = most_;
    for (int rank = 1; rank < world_.size(); ++rank) {
      const Rank& candidate = ranks_[static_cast<std::size_t>(rank)];
      if (!candidate.lives || candidate.cases.size() >= fewest) continue;
      best = rank;
      fewest = candidate.cases.size();
    }
    return best;
  }

  void listen(const mpi::status& status, const Done& done) {
    Rank& rank = ranks_[static_cast<std::size_t>(status.source())];
    rank.heard = Clock::now();
    rank.lives = true;  // it may have been only slow
    const std::string text = receive_text(world_, status);
    if (status.tag() != kAnswer) return;
    const Answer answer = answer_from(text);
    if (rank.cases.erase(answer.index) != 0) done(answer.index, answer.outcome);
  }

  void give_a_sign() {
    if (Clock::now() - last_sign_ < kBetweenSigns) return;
    last_sign_ = Clock::now();
    for (int rank = 1; rank < world_.size(); ++rank)
      if (ranks_[static_cast<std::size_t>(rank)].lives) send_text(world_, rank, kAlive, "");
  }

  void look_for_lost_ranks() {
    const Clock::time_point now = Clock::now();
    for (int rank = 1; rank < world_.size(); ++rank) {
      const Rank& candidate = ranks_[static_cast<std::size_t>(rank)];
      if (candidate.lives && now - candidate.heard > kSilence) lose(rank);
    }
  }

  void lose(int number) {
    Rank& rank = ranks_[static_cast<std::size_t>(number)];
    rank.lives = false;
    lost_cases_.insert(lost_cases_.end(), rank.cases.begin(), rank.cases.end());
    fmt::print(stderr, "quadbound: rank {} is silent; others take its {} cases\n", number,
               rank.cases.size());
    rank.cases.clear();
    if (std::ranges::none_of(ranks_, &Rank::lives))
      throw std::runtime_error("all ranks but rank 0 are lost; --resume goes on");
  }

  mpi::communicator world_;
  std::size_t most_;
  std::vector<Rank> ranks_;
  std::deque<std::uint64_t> lost_cases_;
  Clock::time_point last_sign_{};
};

// --- the other ranks -----------------------------------------------------------------------------

/// Tries the cases that rank 0 hands out.
class Servant {
 public:
  Servant(const mpi::communicator& world, const FuzzOptions& options)
      : world_(world),
        options_(options),
        campaign_(campaign_of(options)),
        pool_(workers_of(options)) {}

  /// Until there are no more; whether all ranks are still there.
  bool run() {
    for (;;) {
      while (const auto status = world_.iprobe(0, mpi::any_tag)) {
        heard_ = Clock::now();
        const std::string text = receive_text(world_, *status);
        if (status->tag() == kStop) return text == "all";
        if (status->tag() == kCase) start(text);
      }
      if (Clock::now() - heard_ > kSilenceOfRank0) throw std::runtime_error("rank 0 is lost");
      give_a_sign();
      if (pool_.is_idle())
        std::this_thread::sleep_for(kNap);
      else
        pool_.wait(kNap);
    }
  }

 private:
  void start(const std::string& text) {
    std::uint64_t index = 0;
    std::from_chars(text.data(), text.data() + text.size(), index);
    pool_.start([&] { return try_case(campaign_, index, trial_of(options_)); }, limits_of(options_),
                [this, index](const TaskOutcome& outcome) {
                  send_text(world_, 0, kAnswer, to_text(Answer{index, outcome}));
                });
  }

  void give_a_sign() {
    if (Clock::now() - last_sign_ < kBetweenSigns) return;
    last_sign_ = Clock::now();
    send_text(world_, 0, kAlive, "");
  }

  const mpi::communicator& world_;
  const FuzzOptions& options_;
  PolygonCampaign campaign_;
  TaskPool pool_;
  Clock::time_point heard_ = Clock::now();
  Clock::time_point last_sign_{};
};

/// Without all ranks MPI cannot be ended in order: it would wait for those that are lost.
[[noreturn]] void leave_without_mpi(int status) {
  std::fflush(nullptr);
  std::_Exit(status);
}

ExitStatus lead(const mpi::communicator& world, const FuzzOptions& options) {
  MpiWorkers workers(world, workers_of(options));
  bool all_live = true;
  const ExitStatus status = run_campaign(options, workers, [&] { all_live = workers.stop(); });
  if (!all_live) leave_without_mpi(status);
  return status;
}

}  // namespace

ExitStatus fuzz_over_mpi(const FuzzOptions& options) {
  mpi::environment environment;
  const mpi::communicator world;
  MPI_Comm_set_errhandler(world, MPI_ERRORS_RETURN);
  try {
    if (world.size() < 2) throw std::runtime_error("--mpi needs two ranks or more");
    if (world.rank() == 0) return lead(world, options);
    if (!Servant(world, options).run()) leave_without_mpi(kGood);
    return kGood;
  } catch (const std::exception& error) {
    if (world.rank() == 0) fmt::print(stderr, "quadbound: {}\n", error.what());
    std::fflush(nullptr);
    mpi::environment::abort(kBadInput);
    throw;  // not reached
  }
}

}  // namespace quadbound::cli
