// Rounds of Google Benchmark runs. Its own repetitions come one subject after the other, or shuffled; ratios of neighbours in time need turns.
#include "bench/rounds.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>

#include "gbuffer/watched.h"

namespace relume::bench {
namespace {

constexpr double patience = 10;  // seconds for one group of subjects, where nobody asked for more
/// Below, a round begins with a go that is not timed: what ran before leaves threads on other cores, and others' data in caches, which is 5 ms of a
/// go.
constexpr double short_go = 0.1;  // seconds

/// Takes the times of one round, in the order of the subjects.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(std::vector<Measurement>& all) : all_(all) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.error_occurred || run.run_type != Run::RT_Iteration) continue;
      Measurement& m = all_[std::size_t(run.family_index)];
      m.seconds.push_back(run.real_accumulated_time / double(run.iterations));
      m.cpu_seconds.push_back(run.cpu_accumulated_time / double(run.iterations));
    }
  }

 private:
  std::vector<Measurement>& all_;
};

double seconds_of(const Subject& subject) {
  const auto begin = std::chrono::steady_clock::now();
  subject.run();
  beat();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// An exception may not pass through Google Benchmark: it is kept for later. False where there was one.
bool go(benchmark::State& state, const Subject& subject, std::exception_ptr& failure) {
  try {
    subject.run();
  } catch (...) {
    failure = std::current_exception();
    state.SkipWithError("failed");
    return false;
  }
  beat();
  return true;
}

void run_in(benchmark::State& state, const Subject& subject, bool is_short, std::exception_ptr& failure) {
  if (is_short && !go(state, subject, failure)) return;
  for (auto _ : state)
    if (!go(state, subject, failure)) break;
}

}  // namespace

std::vector<Measurement> measure(const std::vector<Subject>& subjects, const RoundOptions& options) {
  std::vector<Measurement> all;
  std::exception_ptr failure;
  double round_seconds = 0;
  for (const Subject& subject : subjects) {
    seconds_of(subject);  // compiles, touches memory, wakes threads
    const double once = std::max(seconds_of(subject), 1e-7);
    const auto goes = std::int64_t(std::clamp(std::ceil(options.least_seconds / once), 1.0, 1e6));
    const bool is_short = once < short_go;
    round_seconds += once * double(goes + is_short);
    all.push_back({subject, {}, {}, goes});
    benchmark::RegisterBenchmark(subject.name.c_str(),
                                 [&subject, &failure, is_short](benchmark::State& state) { run_in(state, subject, is_short, failure); })
        ->Iterations(goes)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
  }
  int rounds = options.rounds;
  if (!options.rounds_are_asked_for) rounds = std::clamp(int(patience / round_seconds), std::min(3, rounds), rounds);
  Collector collector(all);
  for (int round = 0; round < rounds && !failure; ++round) benchmark::RunSpecifiedBenchmarks(&collector, "all");
  benchmark::ClearRegisteredBenchmarks();
  if (failure) std::rethrow_exception(failure);
  return all;
}

}  // namespace relume::bench
