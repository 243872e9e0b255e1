// A map of the hemisphere of directions in false colour: Lambert's azimuthal equal-area projection (Snyder 1987, Map Projections, section 24).
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "lab/panels.h"
#include "lab/plane_samples.h"
#include "lab/plots/list.h"
#include "lab/sample_table.h"

namespace relume {
namespace {

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// The direction at a place of the map: the horizon is the unit circle, the normal its middle. Below the horizon outside.
glm::dvec3 direction_at(double x, double y) {
  const double r2 = x * x + y * y, z = 1 - r2, across = std::sqrt(2 - r2);  // r = sqrt(2) sin(theta/2)
  return {x * across, y * across, z};
}

/// How far from the middle of the map a direction `angle` degrees from the normal lies.
double radius_of(double angle) { return std::numbers::sqrt2 * std::sin(angle * std::numbers::pi / 360); }

PanelSamples samples_of(const Arrangement& arrangement, int side) {
  PanelSamples samples{{}, {arrangement.standing(), arrangement.moving() + std::string(".theta"), arrangement.moving() + std::string(".phi")}, {}};
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const double x = 2.0 * i / (side - 1) - 1, y = 2.0 * j / (side - 1) - 1;
      const glm::dvec3 direction = x * x + y * y < 1 ? direction_at(x, y) : glm::dvec3(0, 0, -1);
      samples.pairs.push_back(arrangement.with(direction));
      samples.places.push_back({arrangement.angle, degrees(std::acos(direction.z)), degrees(std::atan2(y, x))});
    }
  return samples;
}

std::string circles() {
  std::ostringstream text;
  text << "$rim << END\n";
  for (int angle = 0; angle <= 360; ++angle) text << in_plane(angle).x << ' ' << in_plane(angle).z << '\n';
  text << "END\n$rings << END\n";
  for (const double ring : {30.0, 60.0}) {
    for (int angle = 0; angle <= 360; ++angle) text << radius_of(ring) * in_plane(angle).x << ' ' << radius_of(ring) * in_plane(angle).z << '\n';
    text << '\n';
  }
  text << "END\n";
  return text.str();
}

/// The important directions: all lie in the plane of incidence, on the map's middle line.
std::string marks(const PlotRequest& request) {
  std::ostringstream data;
  data << "$directions << END\n";
  int k = 0;
  for (const NamedDirection& d : request.arrangement.directions(request.marked ? &*request.marked : nullptr))
    data << radius_of(d.angle) << " 0 " << (k++ % 2 ? -1 : 1) << " \"{/:Italic " << d.name << "}\"\n";
  data << "END\n";
  return data.str();
}

PanelShape shape_of(const PlotRequest& request, int side) {
  PanelShape shape{side, -1, 1, -1.04, 1.04, {}, {}, {}, false};
  shape.axes = "unset border\nunset xtics\nunset ytics\nset style textbox opaque noborder fillcolor rgb '#303030' margins 0.4,0.3\n";
  for (const int ring : {30, 60})
    shape.axes +=
        "set label \"" + std::to_string(ring) + "°\" at 0," + nine_digits(-radius_of(ring) - 0.04) + " center front font ',9' tc rgb '#ffffff'\n";
  shape.data = circles() + marks(request);
  // Light over dark and dark over light: a mark is seen on any colour.
  shape.over =
      ", $rings with lines lc rgb '#a0ffffff' dt 3 lw 1, $rim with lines lc black lw 2, $directions using 1:2 with points pt 7 ps 0.9 lc black, "
      "$directions using 1:2 with points pt 7 ps 0.5 lc rgb 'white', $directions using 1:(0.1*$3):4 with labels boxed tc rgb 'white' font ',11'";
  return shape;
}

/// The highest value: of the map, or of the finer samples of the plane of incidence, where lobes have their tips.
std::string remark(const std::string& label, double in_map, const Tip& in_the_plane) {
  if (!in_the_plane.bounded) return label + ": f_r grows without end towards the horizon";
  if (in_map > in_the_plane.value * (1 + 1e-5)) return label + ": highest " + nine_digits(in_map) + " 1/sr, beside the plane of incidence";
  const std::string narrow = in_map < in_the_plane.value / 2 ? ", in a lobe too narrow for the map" : "";
  return label + ": highest " + nine_digits(in_the_plane.value) + " 1/sr at " + nine_digits(std::round(in_the_plane.angle * 100) / 100 + 0.0) +
         " degrees" + narrow;
}

double highest_of(const Panel& panel) {
  double highest = 0;
  for (const double value : panel.values)
    if (value > highest) highest = value;
  return highest;
}

}  // namespace

Plot plot_hemisphere(const PlotRequest& request) {
  const Arrangement& a = request.arrangement;
  const int side = panel_side(request.compared.subjects.size() * request.parts.size());
  Plot plot;
  const std::vector<Panel> panels = panels_of(request, samples_of(a, side), plot.csv);
  double peak = 0;
  auto panel = panels.begin();
  for (const Subject& subject : request.compared.subjects) {
    const std::vector<PlaneSample> plane = plane_samples(request.brdf(subject), a, request.measure);
    for (const LobePart part : request.parts) {
      const Tip tip = tip_of(plane, request.measure, part);
      const double in_map = highest_of(*panel);
      plot.remarks.push_back(remark(panel->title, in_map, tip));
      peak = std::max(peak, tip.bounded ? std::max(in_map, tip.value) : tip.value);
      ++panel;
    }
  }
  const std::string title =
      request.measure.title() + " over " + a.moving() + " directions, " + a.standing() + " at " + nine_digits(a.angle) + "°, equal-area";
  plot.figure = panels_figure(request, title, panels, shape_of(request, side), request.scale_for(peak, ScaleKind::log));
  return plot;
}

}  // namespace relume
