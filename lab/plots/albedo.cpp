// Directional albedo against the angle: the share of light that is reflected, in all directions together.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "lab/curve_style.h"
#include "lab/directional_albedo.h"
#include "lab/plots/list.h"
#include "lab/sample_table.h"

namespace relume {
namespace {

struct Curve {
  std::string label, style;
  std::vector<double> albedos;
};

/// Every two degrees, and closer to grazing, where albedos change most.
std::vector<double> angles() {
  std::vector<double> all;
  for (double angle = 0; angle < 80; angle += 2) all.push_back(angle);
  for (double angle = 80; angle < 89; angle += 0.5) all.push_back(angle);
  for (const double angle : {89.0, 89.3, 89.6, 89.8, 89.9}) all.push_back(angle);
  return all;
}

std::vector<LobeAlbedos> albedos_of(const Brdf& brdf, const std::vector<double>& angles) {
  std::vector<double> cosines;
  for (const double angle : angles) cosines.push_back(in_plane(angle).z);
  return directional_albedos([&](std::span<const DirectionPair> pairs) { return brdf.reflectance(pairs); }, cosines);
}

glm::dvec3 part_of(const LobeAlbedos& albedo, LobePart part) {
  return part == LobePart::total ? albedo.total().value : part == LobePart::diffuse ? albedo.diffuse.value : albedo.specular.value;
}

std::vector<std::string> columns() {
  std::vector<std::string> names;
  for (const char* what : {"albedo", "albedo.diffuse", "albedo.specular", "error"})
    for (const char* channel : {".r", ".g", ".b"}) names.push_back(std::string(what) + channel);
  return names;
}

void add_row(const Subject& subject, double angle, const LobeAlbedos& albedo, SampleTable& table) {
  std::vector<double> values;
  for (const glm::dvec3& colour : {albedo.total().value, albedo.diffuse.value, albedo.specular.value, albedo.total().error})
    for (int c = 0; c < 3; ++c) values.push_back(colour[c]);
  table.add(subject, {angle}, values);
}

std::string remark(const Curve& curve, const std::vector<double>& angles) {
  const auto most = std::max_element(curve.albedos.begin(), curve.albedos.end());
  return curve.label + ": " + nine_digits(curve.albedos.front()) + " at 0 degrees, highest " + nine_digits(*most) + " at " +
         nine_digits(angles[std::size_t(most - curve.albedos.begin())]) + " degrees";
}

Figure figure_of(const PlotRequest& request, const std::vector<Curve>& curves, const std::vector<double>& angles) {
  Figure figure;
  figure.markup = true;
  figure.height = 480 + 20 * int((curves.size() + 1) / 2);
  std::ostringstream data;
  std::string plotted;
  double most = 1;  // where energy is kept
  for (std::size_t k = 0; k < curves.size(); ++k) {
    data << "$curve" << k << " << END\n";
    for (std::size_t i = 0; i < angles.size(); ++i) data << angles[i] << ' ' << curves[k].albedos[i] << '\n';
    data << "END\n";
    plotted += (k ? ", $curve" : "$curve") + std::to_string(k) + " with lines" + curves[k].style + " title " + quoted(plain(curves[k].label));
    most = std::max(most, *std::max_element(curves[k].albedos.begin(), curves[k].albedos.end()));
  }
  figure.data = data.str();
  const double top = request.highest.value_or(most > 1.02 ? Scale(ScaleKind::linear, most).highest() : 1.05);
  figure.commands = title_command(request, "Directional albedo, " + std::string(name_of(request.measure.channel))) +
                    "set xlabel \"view angle, degrees\\n \" offset 0,0.3\nset ylabel \"share of light reflected\"\nset xrange [0:90]\nset xtics "
                    "15\nset yrange [0:" +
                    nine_digits(top) + "]\nset key bmargin center horizontal maxcols 2 width 2 reverse Left\n" +
                    "set arrow from 0,1 to 90,1 nohead dt 3 lw 1.5 lc rgb '#444444'\nplot " + plotted;
  return figure;
}

}  // namespace

Plot plot_albedo(const PlotRequest& request) {
  check_curves(request);
  SampleTable table(request.compared, {"view"}, columns());
  const std::vector<double> at = angles();
  std::vector<Curve> curves;
  for (std::size_t k = 0; k < request.compared.subjects.size(); ++k) {
    const Subject& subject = request.compared.subjects[k];
    const std::vector<LobeAlbedos> albedos = albedos_of(request.brdf(subject), at);
    for (std::size_t i = 0; i < at.size(); ++i) add_row(subject, at[i], albedos[i], table);
    for (std::size_t p = 0; p < request.parts.size(); ++p) {
      curves.push_back({request.label(subject, request.parts[p]), curve_style(request, k, p), {}});
      for (const LobeAlbedos& albedo : albedos)
        curves.back().albedos.push_back(in_channel(part_of(albedo, request.parts[p]), request.measure.channel));
    }
  }
  Plot plot{figure_of(request, curves, at), table.csv(), {}, {}};
  for (const Curve& curve : curves) plot.remarks.push_back(remark(curve, at));
  return plot;
}

}  // namespace relume
