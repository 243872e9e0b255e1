// What each plot of a run shows, in gnuplot's language.
#pragma once

#include <string>
#include <vector>

#include "bench/bench.h"
#include "figure/figure.h"

namespace relume::bench {

struct Plot {
  std::string name;  ///< of its files
  Figure figure;
};

/// Those for which the measurements have data.
std::vector<Plot> plots_of(const Bench& bench);

}  // namespace relume::bench
