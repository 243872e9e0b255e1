// The benchmark as the command line calls it: devices measured, suites run, results reported.
#pragma once

#include <ostream>

#include "bench/options.h"

namespace relume::bench {

/// Prints a line for each subject as soon as it is known. The exit code: 1 where a baseline was given and something became slower, else 0.
/// Throws Error.
int run_bench(const Options& options, std::ostream& out);

}  // namespace relume::bench
