// From options to groups of subjects, and from measurements to reports.
#include "bench/run_bench.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <regex>

#include "bench/baseline.h"
#include "bench/cost_table.h"
#include "bench/device_limits.h"
#include "bench/plots.h"
#include "bench/report.h"
#include "bench/suites.h"
#include "gbuffer/error.h"

namespace relume::bench {
namespace {

/// Whether a name is asked for.
class Filter {
 public:
  explicit Filter(const std::optional<std::string>& pattern) try : all_(!pattern), pattern_(pattern.value_or("")) {
  } catch (const std::regex_error&) {
    throw Error(ErrorKind::input, "--filter \"" + *pattern + "\" is no regular expression (for example: ggx.*/64/)");
  }
  bool operator()(const std::string& name) const { return all_ || std::regex_search(name, pattern_); }

 private:
  bool all_;
  std::regex pattern_;
};

std::vector<Group> wanted_groups(const Bench& bench, const Filter& filter) {
  std::vector<Group> wanted;
#define RELUME_ADD_SUITE(name)               \
  for (Group & group : name##_groups(bench)) \
    if (std::any_of(group.names.begin(), group.names.end(), filter)) wanted.push_back(std::move(group));
  RELUME_SUITES(RELUME_ADD_SUITE)
#undef RELUME_ADD_SUITE
  if (wanted.empty()) throw Error(ErrorKind::input, "--filter fits no name (relume bench --filter . --list prints all)");
  return wanted;
}

void list(const std::vector<Group>& groups, const Filter& filter, std::ostream& out) {
  for (const Group& group : groups)
    for (const std::string& name : group.names)
      if (filter(name)) out << name << "\n";
}

void run_group(Bench& bench, const Group& group, const Filter& filter, std::ostream& out) {
  std::vector<Measurement> measured = measure(group.make(filter), bench.options.rounds);
  if (group.finish) group.finish(measured);
  for (const Measurement& m : measured) print_row(out, m);
  for (const Claim& claim : group.claims)
    if (const std::optional<Weighed> weighed = weigh(claim, measured)) {
      bench.weighed.push_back(*weighed);
      print_weighed(out, *weighed);
    }
  bench.measurements.insert(bench.measurements.end(), measured.begin(), measured.end());
}

}  // namespace

int run_bench(const Options& options, std::ostream& out) {
  if (options.costs) {
    print_costs(out);
    return 0;
  }
  char program[] = "relume", *arguments[] = {program, nullptr};
  int count = 1;
  benchmark::Initialize(&count, arguments);
  Bench bench{options, bench_devices(options.devices, options.precisions), {}, {}};
  const Filter filter(options.filter);
  const std::vector<Group> groups = wanted_groups(bench, filter);
  if (options.list) {
    list(groups, filter, out);
    return 0;
  }
  const std::optional<Baseline> baseline = options.baseline ? std::optional(read_baseline(*options.baseline)) : std::nullopt;
  measure_limits(bench);
  print_header(out, bench);
  for (const Measurement& m : bench.measurements) print_row(out, m);
  for (const Group& group : groups) run_group(bench, group, filter, out);
  if (options.json) write_json(*options.json, bench);
  if (options.csv) write_csv(*options.csv, bench);
  if (options.plots) {
    std::string note;
    for (const std::string& file : write_plots(*options.plots, bench, note)) out << "wrote " << (*options.plots / file).string() << "\n";
    if (!note.empty()) out << note << "\n";
  }
  return baseline && compare_with_baseline(bench, *baseline, out) ? 1 : 0;
}

}  // namespace relume::bench
