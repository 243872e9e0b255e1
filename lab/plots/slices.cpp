// A slice of a BRDF over the angles of the half vector and of the difference (Rusinkiewicz 1998), as Disney's BRDF Explorer shows it (Burley 2012).
#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/arrangement.h"
#include "lab/panels.h"
#include "lab/plots/list.h"

namespace relume {
namespace {

constexpr double widest = 89.99;  // degrees: at 90 there is no f_r
constexpr double grazing = 80;    // degrees: to where a figure has room for what is highest; beyond, f_r grows as 1/(n.l n.v)
constexpr int decades = 5;        // it varies by more than over a hemisphere

/// The azimuth of the difference is 90 degrees: light and view stand off the plane of n and h, equally high, and above the horizon everywhere.
DirectionPair pair_of(double theta_h, double theta_d) {
  const glm::dvec3 h = in_plane(theta_h), d = in_plane(theta_d);
  return {{h.x * d.z, d.x, h.z * d.z}, {h.x * d.z, -d.x, h.z * d.z}};
}

PanelSamples samples_of(int side) {
  PanelSamples samples{{}, {"theta_h", "theta_d"}, {}};
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const double theta_h = widest * i / (side - 1), theta_d = widest * j / (side - 1);
      samples.pairs.push_back(pair_of(theta_h, theta_d));
      samples.places.push_back({theta_h, theta_d});
    }
  return samples;
}

struct Highest {
  double value = 0, theta_h = 0, theta_d = 0;
};

Highest highest_of(const Panel& panel, const PanelSamples& samples) {
  Highest highest;
  for (std::size_t i = 0; i < panel.values.size(); ++i)
    if (std::max(samples.places[i][0], samples.places[i][1]) <= grazing && panel.values[i] > highest.value)
      highest = {panel.values[i], samples.places[i][0], samples.places[i][1]};
  return highest;
}

}  // namespace

Plot plot_slices(const PlotRequest& request) {
  const int side = panel_side(request.compared.subjects.size() * request.parts.size());
  const PanelSamples samples = samples_of(side);
  Plot plot;
  const std::vector<Panel> panels = panels_of(request, samples, plot.csv);
  double peak = 0;
  for (const Panel& panel : panels) {
    const Highest highest = highest_of(panel, samples);
    peak = std::max(peak, highest.value);
    plot.remarks.push_back(panel.title + ": highest to 80 degrees " + nine_digits(highest.value) + " 1/sr at theta_h " +
                           nine_digits(highest.theta_h) + ", theta_d " + nine_digits(highest.theta_d) + " degrees");
  }
  PanelShape shape{side, 0, widest, 0, 90, {}, {}, {}, true};
  shape.axes =
      "set border 15\nset xtics 30 out nomirror\nset ytics 30 out nomirror\nset xlabel \"θ_h, degrees\" offset 0,0.4\n"
      "set ylabel \"θ_d, degrees\" offset 1,0\n";
  plot.figure = panels_figure(request, request.measure.title() + " over half vector and difference, φ_d = 90°", panels, shape,
                              request.scale_for(peak, ScaleKind::log, decades));
  return plot;
}

}  // namespace relume
