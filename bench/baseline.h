// An earlier run, as write_json left it, to compare with.
#pragma once

#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "bench/bench.h"

namespace relume::bench {

/// Seconds of one go, round by round, by the subject's name.
using Baseline = std::map<std::string, std::vector<double>>;

/// Reads Google Benchmark's JSON: this program's, or another's. Throws Error{input}.
Baseline read_baseline(const std::filesystem::path& file);

/// Prints how the subjects that both have changed, and whether that is more than noise: the quartiles of both runs lie apart, and the medians by more
/// than a twentieth. True where one became slower.
bool compare_with_baseline(const Bench& bench, const Baseline& baseline, std::ostream& out);

}  // namespace relume::bench
