// SPDX-License-Identifier: Apache-2.0
#include "bench/staged.hpp"

#include <string_view>

namespace quadbound {
namespace {

#if defined(__clang__)
constexpr const char* kCompiler = __VERSION__;  // names itself
#else
constexpr const char* kCompiler = "GCC " __VERSION__;
#endif

bool all_right = true;

/// Takes `--large` off the arguments.
bool wants_large(int& argc, char** argv) {
  int kept = 1;
  bool found = false;
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--large") {
      found = true;
    } else {
      argv[kept++] = argv[i];
    }
  }
  argc = kept;
  return found;
}

}  // namespace

void refuse(benchmark::State& state, const char* why) {
  all_right = false;
  state.SkipWithError(why);
}

void set_counter(benchmark::State& state, const std::string& name, std::uint64_t value) {
  state.counters[name] = benchmark::Counter(static_cast<double>(value));
}

void set_angles(benchmark::State& state, const Report& report) {
  for (const auto& [claim, name] :
       {std::pair{"min-angle", "smallest_angle"}, std::pair{"max-angle", "largest_angle"}}) {
    const Claim* found = report.find(claim);
    if (found != nullptr && found->worst)
      state.counters[name] = benchmark::Counter(found->worst->degrees());
  }
}

void set_rates(benchmark::State& state, std::uint64_t quads) {
  using Flags = benchmark::Counter;
  const auto count = static_cast<double>(quads);
  state.counters["quads_per_second"] = Flags(count, Flags::kIsIterationInvariantRate);
  state.counters["time_per_quad"] = Flags(count, Flags::kIsIterationInvariantRate | Flags::kInvert);
}

void set_peak(benchmark::State& state, const ResidentPeak& peak, std::uint64_t quads) {
  /// Below this many quads the peak is lost in what the process holds anyway.
  constexpr std::uint64_t kFewQuads = 100'000;
  const auto bytes = peak.beyond_start();
  if (bytes && quads >= kFewQuads)
    state.counters["peak_bytes_per_quad"] =
        static_cast<double>(*bytes) / static_cast<double>(quads);
}

int run_benchmarks(int argc, char** argv, void (*add_all)(bool large)) {
  const bool large = wants_large(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::AddCustomContext("compiler", kCompiler);
  add_all(large);
  // A filter that matches nothing would time nothing for ever.
  if (benchmark::RunSpecifiedBenchmarks() == 0) return 2;
  benchmark::Shutdown();
  return all_right ? 0 : 1;
}

}  // namespace quadbound
