// What was measured, for people and for programs: a table, Google Benchmark's JSON, CSV.
#pragma once

#include <filesystem>
#include <ostream>

#include "bench/bench.h"

namespace relume::bench {

void print_header(std::ostream& out, const Bench& bench);
void print_row(std::ostream& out, const Measurement& m);
void print_weighed(std::ostream& out, const Weighed& weighed);

/// Google Benchmark's layout: each round an "iteration" with its counters, then the aggregates "min" and "median". Error{output}.
void write_json(const std::filesystem::path& file, const Bench& bench);
/// One line for each subject. Error{output}.
void write_csv(const std::filesystem::path& file, const Bench& bench);

}  // namespace relume::bench
