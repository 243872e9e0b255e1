// A polar plot: how far from the surface's point a curve is, tells how much is reflected that way, in the plane of incidence.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <sstream>

#include "gbuffer/error.h"
#include "lab/curve_style.h"
#include "lab/plane_samples.h"
#include "lab/plots/list.h"
#include "lab/sample_table.h"

namespace relume {
namespace {

/// One curve, and what it is called.
struct Curve {
  std::string label, style;
  LobePart part;
  std::vector<PlaneSample> samples;
  Tip tip;
};

void check_swap(const PlotRequest& request) {
  if (request.swap && request.measure.quantity == Quantity::reflectance)
    throw Error(ErrorKind::input, "--swap: compares f_r; the reflectance f_r n.l has the cosine of one side only (--quantity f_r)");
}

void add_rows(const PlotRequest& request, const Subject& subject, const Arrangement& arrangement, const std::vector<PlaneSample>& samples,
              SampleTable& table) {
  if (!request.numbers) return;
  for (const PlaneSample& s : samples) {
    const double standing = -arrangement.angle;
    const std::vector<double> places = arrangement.light_stands ? std::vector{s.angle, standing} : std::vector{standing, s.angle};
    table.add(subject, places, brdf_values(s.value, s.pair.l.z));
  }
}

std::vector<Curve> curves_of(const PlotRequest& request, SampleTable& table) {
  std::vector<Curve> all;
  const auto add = [&](std::size_t subject, const Arrangement& arrangement, bool swapped) {
    const Subject& s = request.compared.subjects[subject];
    const std::vector<PlaneSample> samples = plane_samples(request.brdf(s), arrangement, request.measure);
    add_rows(request, s, arrangement, samples, table);
    for (std::size_t k = 0; k < request.parts.size(); ++k) {
      const LobePart part = request.parts[k];
      all.push_back({request.label(s, part) + (swapped ? ", view and light exchanged" : ""), curve_style(request, subject, k, swapped), part, samples,
                     tip_of(samples, request.measure, part)});
    }
  };
  for (std::size_t i = 0; i < request.compared.subjects.size(); ++i) add(i, request.arrangement, false);
  for (std::size_t i = 0; request.swap && i < request.compared.subjects.size(); ++i) add(i, request.arrangement.swapped(), true);
  return all;
}

/// Points of a curve, ending at the rim where it goes beyond.
std::string block(const std::string& name, const Curve& curve, const Measure& measure, const Scale& scale) {
  std::ostringstream text;
  text << name << " << END\n";
  glm::dvec3 last(0);
  for (const PlaneSample& s : curve.samples) {
    const double radius = scale(measure(s.value, s.pair.l.z, curve.part)), before = glm::length(last);
    const glm::dvec3 point = radius * in_plane(s.angle);
    if ((radius > 1) != (before > 1) && &s != &curve.samples.front()) {
      const glm::dvec3 rim = last + (1 - before) / (radius - before) * (point - last);
      text << rim.x << ' ' << rim.z << (radius > 1 ? "\n\n" : "\n");
    }
    if (radius <= 1) text << point.x << ' ' << point.z << '\n';
    last = point;
  }
  text << "END\n";
  return text.str();
}

/// Half circles at the scale's marks, rays every 30 degrees.
std::string grid(const Scale& scale) {
  std::ostringstream text;
  text << "$grid << END\n";
  for (const double mark : scale.marks()) {
    for (int angle = -90; angle <= 90; ++angle) text << scale(mark) * in_plane(angle).x << ' ' << scale(mark) * in_plane(angle).z << '\n';
    text << '\n';
  }
  for (int angle = -60; angle <= 60; angle += 30) text << "0 0\n" << in_plane(angle).x << ' ' << in_plane(angle).z << "\n\n";
  text << "END\n";
  return text.str();
}

std::string label(const std::string& text, double x, double y, const std::string& how) {
  std::ostringstream command;
  command << "set label " << quoted(text) << " at " << x << ',' << y << ' ' << how << '\n';
  return command.str();
}

std::string arrows(const std::vector<NamedDirection>& directions) {
  std::ostringstream text;
  for (const NamedDirection& d : directions) {
    const glm::dvec3 to = in_plane(d.angle);
    text << "set arrow from 0,0 to " << 1.09 * to.x << ',' << 1.09 * to.z << " head filled size 0.025,18 lc rgb '#444444' lw 1.2 front\n"
         << label("{/:Italic " + d.name + "}", 1.13 * to.x, 1.13 * to.z + 0.005,
                  d.angle < -4  ? "right front"
                  : d.angle > 4 ? "left front"
                                : "center front offset 0,0.4");
  }
  return text.str();
}

/// Names of rings under the surface, of rays outside the rim where no arrow stands.
std::string marks(const Scale& scale, const std::vector<NamedDirection>& directions) {
  std::string text;
  for (const double mark : scale.marks())
    if (scale(mark) > 0.05) text += label(mark_text(mark), scale(mark), -0.035, "center font ',10' tc rgb '#555555'");
  for (int angle = -90; angle <= 90; angle += 30) {
    const auto near = [&](const NamedDirection& d) { return std::abs(d.angle - angle) < 5; };
    if (std::none_of(directions.begin(), directions.end(), near))
      text += label(std::to_string(std::abs(angle)) + "°", 1.06 * in_plane(angle).x, 1.06 * in_plane(angle).z + (std::abs(angle) == 90 ? 0.03 : 0),
                    "center font ',10' tc rgb '#555555'");
  }
  return text;
}

double peak_of(const std::vector<Curve>& all) {
  double peak = 0;
  for (const Curve& curve : all) peak = std::max(peak, curve.tip.value);
  return peak;
}

std::string remark(const PlotRequest& request, const Curve& curve, const Scale& scale) {
  const std::string where = "at " + nine_digits(std::round(curve.tip.angle * 100) / 100 + 0.0) + " degrees";
  if (!curve.tip.bounded)
    return curve.label + ": f_r grows without end towards the horizon; cut at the rim, " + nine_digits(scale.highest()) + " 1/sr";
  const std::string cut = curve.tip.value > scale.highest() * (1 + 1e-9) ? "; cut at the rim, " + nine_digits(scale.highest()) : "";
  return curve.label + ": highest " + (request.measure.quantity == Quantity::f_r ? "f_r " : "reflectance ") + nine_digits(curve.tip.value) +
         " 1/sr " + where + cut;
}

Figure figure_of(const PlotRequest& request, const std::vector<Curve>& all, const Scale& scale) {
  const Arrangement& a = request.arrangement;
  const std::vector<NamedDirection> directions = a.directions(request.marked ? &*request.marked : nullptr);
  Figure figure;
  figure.markup = true;
  figure.width = 900;
  figure.height = 540 + 20 * int((all.size() + 1) / 2);
  figure.data = grid(scale);
  std::string plotted = "plot $grid with lines lc rgb '#d0d0d0' lw 1 notitle";
  for (std::size_t k = 0; k < all.size(); ++k) {
    figure.data += block("$curve" + std::to_string(k), all[k], request.measure, scale);
    plotted += ", $curve" + std::to_string(k) + " with lines" + all[k].style + " title " + quoted(plain(all[k].label));
  }
  const std::string over = std::string("over ") + a.moving() + " directions, " + a.standing() + " at " + nine_digits(a.angle) + "°";
  figure.commands =
      title_command(request, request.measure.title() + " " + over) +
      "set size ratio -1\nunset border\nunset tics\nunset grid\nset xrange [-1.35:1.35]\nset yrange [-0.13:1.25]\nset lmargin 1\nset rmargin 1\n"
      "set key bmargin center horizontal maxcols 2 width 2 reverse Left\nset arrow from -1.02,0 to 1.02,0 nohead lw 1.5 lc black\n" +
      marks(scale, directions) + label(std::string(name_of(scale.kind())) + " radius", -0.5, -0.035, "center font ',10' tc rgb '#555555'") +
      arrows(directions) + plotted;
  return figure;
}

}  // namespace

Plot plot_polar(const PlotRequest& request) {
  check_curves(request);
  check_swap(request);
  SampleTable table(request.compared, {"view", "light"}, brdf_columns());
  const std::vector<Curve> all = curves_of(request, table);
  const Scale scale = request.scale_for(peak_of(all), ScaleKind::linear);
  Plot plot{figure_of(request, all, scale), table.csv(), {}, {}};
  for (const Curve& curve : all) plot.remarks.push_back(remark(request, curve, scale));
  return plot;
}

}  // namespace relume
