// write_json: Google Benchmark's own reporter, given our runs.
#include <benchmark/benchmark.h>

#include <sstream>

#include "bench/report.h"
#include "gbuffer/printable.h"
#include "gbuffer/whole_file.h"

namespace relume::bench {
namespace {

using Run = benchmark::BenchmarkReporter::Run;

Run run_of(const Measurement& m, std::size_t family, double seconds, double cpu_seconds) {
  Run run;
  run.run_name.function_name = m.subject.name;
  run.family_index = std::int64_t(family);
  run.per_family_instance_index = 0;
  run.repetitions = std::int64_t(m.seconds.size());
  run.iterations = m.goes;
  run.real_accumulated_time = seconds * double(m.goes);
  run.cpu_accumulated_time = cpu_seconds * double(m.goes);
  run.report_label = m.subject.verdict.empty() ? "" : "image against the twin: " + m.subject.verdict;
  run.statistics = nullptr;
  const Work& work = m.subject.work;
  const auto rate = [&](const std::string& name, double amount) {
    if (amount > 0) run.counters[name] = benchmark::Counter(amount / seconds);
  };
  rate("items_per_second", work.pairs());
  for (const auto& [counted, pairs] : work.pixel_lights) rate("pixel_lights_per_second, " + counted, pairs);
  rate("flop_per_second", work.flops);
  rate("bytes_per_second", work.bytes);
  if (m.subject.roof.flops > 0) rate("share_of_peak", work.flops / m.subject.roof.flops);
  return run;
}

Run aggregate_of(const Measurement& m, std::size_t family, const std::string& name, double share) {
  Run run = run_of(m, family, quantile(m.seconds, share), quantile(m.cpu_seconds, share));
  run.run_type = Run::RT_Aggregate;
  run.aggregate_name = name;
  run.repetition_index = Run::no_repetition_index;
  // Google Benchmark counts repetitions as an aggregate's iterations, and takes its times as they are.
  run.iterations = std::int64_t(m.seconds.size());
  run.real_accumulated_time = quantile(m.seconds, share) * double(run.iterations);
  run.cpu_accumulated_time = quantile(m.cpu_seconds, share) * double(run.iterations);
  return run;
}

std::vector<Run> runs_of(const Measurement& m, std::size_t family) {
  std::vector<Run> runs;
  for (std::size_t round = 0; round < m.seconds.size(); ++round) {
    runs.push_back(run_of(m, family, m.seconds[round], m.cpu_seconds[round]));
    runs.back().repetition_index = std::int64_t(round);
  }
  runs.push_back(aggregate_of(m, family, "min", 0));
  runs.push_back(aggregate_of(m, family, "median", 0.5));
  return runs;
}

/// What the numbers were measured on. Google Benchmark keeps context for the life of the process: once is enough.
void add_context(const Bench& bench) {
  benchmark::AddCustomContext("relume", RELUME_VERSION);
  for (const BenchDevice& d : bench.devices) {
    const std::string text =
        d.info.name + ", " + d.info.platform + ", " + d.info.version + ", driver " + d.info.driver + ", " + std::to_string(d.info.lanes) + " lanes";
    benchmark::AddCustomContext("device_" + d.label, printable(text));
  }
}

}  // namespace

void write_json(const std::filesystem::path& file, const Bench& bench) {
  std::ostringstream text;
  benchmark::JSONReporter reporter;
  reporter.SetOutputStream(&text);
  reporter.SetErrorStream(&text);
  add_context(bench);
  reporter.ReportContext(benchmark::BenchmarkReporter::Context());
  for (std::size_t k = 0; k < bench.measurements.size(); ++k) reporter.ReportRuns(runs_of(bench.measurements[k], k));
  reporter.Finalize();
  write_whole(file, text.str(), true);
}

}  // namespace relume::bench
