// Pictures of a run: roofline, scaling, time against the number of lights, lobes beside the yardsticks. Drawn by gnuplot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/bench.h"

namespace relume::bench {

/// Writes those that the measurements have data for, each as SVG and PNG, with the data and the script beside them. The files' names; a sentence in
/// `note` where there is no gnuplot. Error{output}.
std::vector<std::string> write_plots(const std::filesystem::path& folder, const Bench& bench, std::string& note);

}  // namespace relume::bench
