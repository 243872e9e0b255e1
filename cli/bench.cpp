// relume bench: how fast this machine shades, beside what else could shade on it.
#include <iostream>

#include "bench/run_bench.h"
#include "cli/commands.h"
#include "gbuffer/error.h"
#include "gbuffer/printable.h"

namespace relume {
namespace {

struct BenchArguments {
  bench::Options options;
  std::string filter, json, csv, plots, compare;
  std::vector<std::string> sizes, precisions{"exact"};
  int repetitions = 0;
};

/// "1920x1080"
bench::Size size_of(const std::string& text) {
  bench::Size size{};
  int end = 0;
  const bool whole = std::sscanf(text.c_str(), "%dx%d%n", &size.width, &size.height, &end) == 2 && end == int(text.size());
  constexpr int most = 1 << 15;
  if (!whole || size.width < 1 || size.height < 1 || size.width > most || size.height > most)
    throw Error(ErrorKind::input, "--size " + printable(text) + ": no size (WIDTHxHEIGHT, each 1 to 32768)");
  return size;
}

int bench_all(BenchArguments a) {
  const auto given = [](const std::string& file) { return file.empty() ? std::nullopt : std::optional<std::filesystem::path>(file); };
  bench::Options& o = a.options;
  if (!a.filter.empty()) o.filter = a.filter;
  for (const std::string& size : a.sizes) o.sizes.push_back(size_of(size));
  o.precisions.clear();
  for (const std::string& precision : a.precisions) o.precisions.push_back(precision == "relaxed" ? Precision::relaxed : Precision::exact);
  o.rounds.rounds_are_asked_for = a.repetitions > 0;
  if (a.repetitions > 0) o.rounds.rounds = a.repetitions;
  o.json = given(a.json);
  o.csv = given(a.csv);
  o.plots = given(a.plots);
  o.baseline = given(a.compare);
  return bench::run_bench(o, std::cout);
}

}  // namespace

void add_bench(CLI::App& command, Action& action) {
  const auto a = std::make_shared<BenchArguments>();
  bench::Options& o = a->options;
  command.add_option("--filter", a->filter, "only names that this regular expression finds; opens every dimension that no other option narrows");
  command.add_flag("--list", o.list, "print the names, measure nothing");
  command.add_flag("--costs", o.costs, "print what each lobe and light costs, counted from the kernels' source; measure nothing");
  command.add_option("--device", o.devices, "as for shade; again for another; all: every one and the twin. Default: the best there is")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--lanes", o.lanes, "pixels side by side: 1, 4, 8, 16; several with commas. Default: the device's own")
      ->delimiter(',')
      ->check(CLI::IsMember({1, 4, 8, 16}));
  command.add_option("--precision", a->precisions, "exact, relaxed, or both with a comma: each device in each. Default: exact")
      ->delimiter(',')
      ->check(CLI::IsMember({"exact", "relaxed"}));
  command.add_option("--size", a->sizes, "WIDTHxHEIGHT of the frame; several with commas")->delimiter(',');
  command.add_option("--lights", o.lights, "numbers of lights, with commas")->delimiter(',')->check(CLI::Range(1, 1 << 20));
  command.add_option("--brdf", o.brdfs, "lobes, with commas: ggx, lambert+cook_torrance")->delimiter(',');
  command
      .add_option("--repetitions", a->repetitions, "rounds, in each of which everything has its turn. Default: 11, 3 at least where that takes long")
      ->check(CLI::Range(1, 10000));
  command.add_option("--min-time", o.rounds.least_seconds, "seconds that a subject has in a round at least. Default: 0.02")
      ->check(CLI::Range(0.0, 60.0));
  command.add_option("--json", a->json, "FILE in Google Benchmark's layout");
  command.add_option("--csv", a->csv, "FILE, a line for each subject");
  command.add_option("--plots", a->plots, "FOLDER for SVG and PNG plots (made by gnuplot)");
  command.add_option("--compare", a->compare, "BASELINE.json of an earlier run: ratios, and exit code 1 where something became slower");
  command.footer("Needs no file. Example: relume bench --device all --filter 'lambert\\+ggx/point/64/' --json today.json");
  command.callback([a, &action] { action = [a] { return bench_all(*a); }; });
}

}  // namespace relume
