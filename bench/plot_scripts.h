// What each plot of a run shows, in gnuplot's language.
#pragma once

#include <string>
#include <vector>

#include "bench/bench.h"

namespace relume::bench {

struct Plot {
  std::string name;      ///< of its files
  std::string data;      ///< gnuplot's data blocks
  std::string commands;  ///< titles, axes and the plot itself
  int width = 900, height = 560;
};

/// Those for which the measurements have data.
std::vector<Plot> plots_of(const Bench& bench);

}  // namespace relume::bench
