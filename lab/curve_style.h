// How curves of one figure are told apart.
#pragma once

#include <string>

#include "lab/plot.h"

namespace relume {

/// Error{input} where there are more BRDFs than can be told apart: colours, and dashes where lobes and exchanged directions leave them.
void check_curves(const PlotRequest& request);

/// gnuplot's line style of a BRDF's part, by position.
std::string curve_style(const PlotRequest& request, std::size_t subject, std::size_t part, bool swapped = false);

}  // namespace relume
