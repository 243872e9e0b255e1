// fit_figure: two panels, the table as points, fits as lines.
#include "lab/fit_figure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "lab/tabulate.h"

namespace relume {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr int most_fits = 4;  // lines that can be told apart
constexpr const char* dashes[most_fits] = {"solid", "(14,5)", "(5,4)", "(12,4,3,4)"};

/// Rec. 709's.
double luminance(const glm::dvec3& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

struct Point {
  double angle;  ///< degrees, the panel's axis
  int h, d;
};

/// One panel: bins along an angle, the others fixed at phi_d = 90 degrees.
struct Panel {
  std::string title, axis;
  double fixed;  ///< the other angle, degrees
  std::vector<Point> points;
};

int bin_at(double angle, double whole, int count) { return std::clamp(int(angle / whole * count), 0, count - 1); }

Panel highlight(const MerlTable& table, double theta_d) {
  const int d = bin_at(theta_d, 90, table.theta_d);
  std::ostringstream title;
  title << "highlight: {/Symbol q}_d = " << angles_of(table, 0, d, 0).theta_d / degree << "°";
  Panel panel{title.str(), "{/Symbol q}_h, degrees", angles_of(table, 0, d, 0).theta_d / degree, {}};
  for (int h = 0; h < table.theta_h; ++h) panel.points.push_back({angles_of(table, h, d, 0).theta_h / degree, h, d});
  return panel;
}

Panel fresnel(const MerlTable& table, double theta_h) {
  const int h = bin_at(std::sqrt(theta_h / 90), 1, table.theta_h);
  std::ostringstream title;
  title.precision(3);
  title << "Fresnel: {/Symbol q}_h = " << angles_of(table, h, 0, 0).theta_h / degree << "°";
  Panel panel{title.str(), "{/Symbol q}_d, degrees", angles_of(table, h, 0, 0).theta_h / degree, {}};
  for (int d = 0; d < table.theta_d; ++d) panel.points.push_back({angles_of(table, h, d, 0).theta_d / degree, h, d});
  return panel;
}

/// A block of data: angle, the table's luminance, then each fit's; rows where either direction is below the horizon or nothing is measured left out.
std::string data_of(const Panel& panel, const MerlTable& table, const std::vector<Brdf>& brdfs) {
  const int phi = table.phi_d / 2;
  std::vector<DirectionPair> pairs;
  std::vector<std::pair<double, double>> measured;
  for (const Point& p : panel.points) {
    const DirectionPair pair = directions_of(angles_of(table, p.h, p.d, phi));
    glm::dvec3 f;
    for (int c = 0; c < 3; ++c) f[c] = table.f[std::size_t(c)][table.at(p.h, p.d, phi)];
    if (pair.l.z <= 0 || pair.v.z <= 0 || std::min({f.x, f.y, f.z}) < 0) continue;
    pairs.push_back(pair);
    measured.emplace_back(p.angle, luminance(f));
  }
  std::vector<std::vector<Reflectance>> fitted;
  for (const Brdf& brdf : brdfs) fitted.push_back(brdf.reflectance(pairs));
  std::ostringstream rows;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    rows << measured[i].first << " " << measured[i].second;
    for (const auto& values : fitted) rows << " " << luminance(values[i].total()) / pairs[i].l.z;
    rows << "\n";
  }
  return rows.str();
}

/// At phi_d = 90 degrees n.l = n.v = cos theta_h cos theta_d.
std::string limit_of(const Panel& panel, double grazing) {
  const double cosine = std::cos(grazing * degree) / std::cos(panel.fixed * degree);
  if (cosine >= 1 || grazing >= 90) return "unset arrow\n";
  const std::string at = std::to_string(std::acos(cosine) / degree);
  return "unset arrow\nset arrow from " + at + ",graph 0 to " + at + ",graph 1 nohead back lc rgb '#888888' lw 1.5\n";
}

std::string plot_of(const std::string& block, const std::vector<std::string>& names, bool keyed) {
  std::ostringstream plot;
  plot << "plot " << block << " using 1:2 with points lc rgb 'black' pt 6 ps 0.7 title " << quoted("table");
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::string name = names[k];
    for (std::size_t at = 0; (at = name.find('_', at)) != std::string::npos; at += 2) name.replace(at, 1, "\\_");
    plot << ", " << block << " using 1:" << k + 3 << " with lines lt " << k + 1 << " lw 2.5 dt " << dashes[k] << " title '" << name << "'";
  }
  return (keyed ? "set key top right reverse Left opaque\n" : "unset key\n") + plot.str() + "\n";
}

}  // namespace

Figure fit_figure(const MerlTable& table, const std::vector<Fit>& fits, double grazing, const std::string& title,
                  const std::shared_ptr<Device>& device) {
  std::vector<Brdf> brdfs;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < std::min<std::size_t>(fits.size(), most_fits); ++k) {
    brdfs.emplace_back(fits[k].brdf, fits[k].settings(), device);
    names.push_back(fits[k].brdf);
  }
  const Panel panels[] = {highlight(table, 20), fresnel(table, 2)};
  Figure figure{{}, {}, 1200, 560, true};
  std::string shown_title = title;
  std::erase_if(shown_title, [](char c) { return c == '"' || c == '\\' || c == '\n' || c == '`'; });
  figure.commands = "set multiplot layout 1,2 title \"" + shown_title +
                    "\" noenhanced\nset logscale y\nset format y '10^{%T}'\nset ylabel 'f_r, 1/sr (luminance)'\n";
  for (int k = 0; k < 2; ++k) {
    const std::string block = "$slice" + std::to_string(k);
    figure.data += block + " << END\n" + data_of(panels[k], table, brdfs) + "END\n";
    figure.commands += "set title \"" + panels[k].title + "\"\nset xlabel \"" + panels[k].axis + "\"\nset xrange [0:90]\nset xtics 15\n" +
                       limit_of(panels[k], grazing) + plot_of(block, names, k == 0);
  }
  figure.commands += "unset multiplot\n";
  return figure;
}

}  // namespace relume
