// Every figure of `relume figure`, once: a file cli/figures/<name>.cpp with figure_<name>, and its line here.
#pragma once

#include "cli/commands.h"

namespace relume {

#define RELUME_FIGURES(FIGURE)                                                                                              \
  FIGURE(interpolation, "Gouraud against Phong interpolation: pictures, a scan line, and their difference against density") \
  FIGURE(ks, "the greatest coefficient of Phong's and Blinn's lobes, from the kernels and from the formula")                \
  FIGURE(environment, "a G-buffer under its whole environment, and under light from one point with the same energy")

#define RELUME_DECLARE_FIGURE(name, summary) void figure_##name(CLI::App& command, Action& action);
RELUME_FIGURES(RELUME_DECLARE_FIGURE)
#undef RELUME_DECLARE_FIGURE

}  // namespace relume
