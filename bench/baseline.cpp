// Ratios of medians; their spread from the quartiles of both runs, which were not taken in turns and so cannot be paired.
#include "bench/baseline.h"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gbuffer/error.h"

namespace relume::bench {
namespace {

using nlohmann::json;

constexpr double least_change = 0.05;  // what one machine's clock and memory layout do to the same program from run to run

double seconds_in(const std::string& unit) { return unit == "ns" ? 1e-9 : unit == "us" ? 1e-6 : unit == "ms" ? 1e-3 : 1; }

json parsed(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw Error(ErrorKind::input, file.string() + ": cannot be read (--compare takes what --json wrote)");
  json all = json::parse(in, nullptr, false);
  if (all.is_discarded() || !all.is_object() || !all.contains("benchmarks") || !all["benchmarks"].is_array())
    throw Error(ErrorKind::input, file.string() + ": not a benchmark's JSON (--compare takes what --json wrote)");
  return all;
}

}  // namespace

Baseline read_baseline(const std::filesystem::path& file) try {
  Baseline baseline;
  const json all = parsed(file);
  for (const json& run : all["benchmarks"])
    if (run.value("run_type", "iteration") == "iteration" && !run.value("error_occurred", false))
      baseline[run.at("run_name").get<std::string>()].push_back(run.at("real_time").get<double>() * seconds_in(run.value("time_unit", "ns")));
  return baseline;
} catch (const json::exception&) {
  throw Error(ErrorKind::input, file.string() + ": a run without run_name or real_time (--compare takes what --json wrote)");
}

bool compare_with_baseline(const Bench& bench, const Baseline& baseline, std::ostream& out) {
  int compared = 0;
  bool slower = false;
  out << "\ntime against the baseline (quartiles of both runs), below 1 is faster\n";
  for (const Measurement& m : bench.measurements) {
    const auto before = baseline.find(m.subject.name);
    if (before == baseline.end()) continue;
    ++compared;
    const auto over = [&](double share, double share_before) { return quantile(m.seconds, share) / quantile(before->second, share_before); };
    const double median = over(0.5, 0.5), low = over(0.25, 0.75), high = over(0.75, 0.25);
    const bool is_slower = low > 1 && median > 1 + least_change, is_faster = high < 1 && median < 1 - least_change;
    slower = slower || is_slower;
    char text[96];
    std::snprintf(text, sizeof text, " %8.3f  (%.3f .. %.3f)  %s\n", median, low, high, is_slower ? "slower" : is_faster ? "faster" : "");
    out << m.subject.name << std::string(m.subject.name.size() < 58 ? 58 - m.subject.name.size() : 0, ' ') << text;
  }
  if (compared == 0) throw Error(ErrorKind::input, "--compare: the baseline has none of the subjects that were measured");
  return slower;
}

}  // namespace relume::bench
