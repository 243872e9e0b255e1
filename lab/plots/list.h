// Every kind of `relume plot`, once: a file lab/plots/<kind>.cpp with plot_<kind>, and its line here.
#pragma once

#include "lab/plot.h"

namespace relume {

/// PLOT(kind, most subjects that it can tell apart, options that it takes beside those of all, summary)
#define RELUME_PLOTS(PLOT)                                                                                                           \
  PLOT(polar, 12, "view light mark quantity radius channel highest lobes swap", "values in the plane of incidence, as radii")        \
  PLOT(hemisphere, 12, "view light mark quantity radius channel highest lobes", "values over all directions, in false colour")       \
  PLOT(albedo, 12, "channel highest lobes", "directional albedo, the share of light that is reflected, against the view angle")      \
  PLOT(slices, 12, "quantity radius channel highest lobes", "values over theta_h and theta_d (phi_d = 90 degrees), in false colour") \
  PLOT(spheres, 144, "light exposure", "spheres under a light, a column for each value of the first sweep")

struct PlotKind {
  std::string name;
  std::size_t most;
  std::string options, summary;
  Plot (*make)(const PlotRequest&);
};

#define RELUME_DECLARE_PLOT(kind, ...) Plot plot_##kind(const PlotRequest& request);
RELUME_PLOTS(RELUME_DECLARE_PLOT)
#undef RELUME_DECLARE_PLOT

}  // namespace relume
