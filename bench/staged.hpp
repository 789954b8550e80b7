// SPDX-License-Identifier: Apache-2.0
#pragma once
// What benchmarks of a mesher have in common: stages whose answers are checked before they are
// timed, their rates and their peak of memory.
//
// A stage is a struct with kName; prepare(), which is not timed; run(), whose result's destruction
// is timed as well; and is_right(result).

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

#include "bench/resident_memory.hpp"
#include "verify/report.hpp"

namespace quadbound {

/// Skips the benchmark; run_benchmarks returns 1 then.
void refuse(benchmark::State& state, const char* why);

void set_counter(benchmark::State& state, const std::string& name, std::uint64_t value);

/// The extreme angles of a proved mesh in degrees, as quality figures.
void set_angles(benchmark::State& state, const Report& report);

/// Quads per second and time per quad of the loop that just ended.
void set_rates(benchmark::State& state, std::uint64_t quads);

/// The peak per quad; nothing where it is unknown or lost in what the process holds anyway.
void set_peak(benchmark::State& state, const ResidentPeak& peak, std::uint64_t quads);

/// Runs a stage once outside the timing: its answer must be right, and its peak of memory is taken.
template <class Stage>
bool passes_trial(benchmark::State& state, Stage& stage, std::uint64_t quads) {
  stage.prepare();
  const ResidentPeak peak;
  const auto made = stage.run();
  set_peak(state, peak, quads);
  return stage.is_right(made);
}

/// Refuses the stage if it fails its trial, and times it otherwise.
template <class Stage>
void time_stage(benchmark::State& state, Stage& stage, std::uint64_t quads) {
  if (!passes_trial(state, stage, quads)) return refuse(state, "the stage differs");
  for (auto _ : state) {
    state.PauseTiming();
    stage.prepare();
    state.ResumeTiming();
    auto made = stage.run();
    benchmark::DoNotOptimize(made);
  }
  set_rates(state, quads);
}

/// The body of main: `add_all` registers the benchmarks, with the large ones where `--large` is
/// given. Returns the exit status: 1 where a benchmark was refused, 2 for bad usage.
int run_benchmarks(int argc, char** argv, void (*add_all)(bool large));

}  // namespace quadbound
