// panels_figure: gnuplot's multiplot, each map an image with contours, margins in pixels. Colours: viridis (Smith and van der Walt 2015).
#include "lab/panels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "gbuffer/error.h"

namespace relume {
namespace {

constexpr const char* viridis =
    "set palette defined (0 '#440154', 1 '#482878', 2 '#3e4989', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', 6 '#35b779', 7 '#6ece58', 8 '#b5de2b', "
    "9 '#fde725')\n";

std::string matrix(const std::string& name, const Panel& panel, int side, const Scale& scale) {
  std::ostringstream text;
  text.precision(5);
  text << name << " << END\n";
  for (std::size_t i = 0; i < panel.values.size(); ++i) {
    if (std::isnan(panel.values[i]))
      text << "NaN";
    else
      text << std::min(scale(panel.values[i]), 1.0);
    text << ((i + 1) % std::size_t(side) == 0 ? '\n' : ' ');
  }
  text << "END\n";
  return text.str();
}

/// `using`: from a matrix's column and row to the axes.
std::string placed(const PanelShape& shape) {
  const std::string step = nine_digits((shape.high - shape.low) / (shape.side - 1)), low = nine_digits(shape.low);
  return " matrix using (" + low + "+" + step + "*$1):(" + low + "+" + step + "*$2):3";
}

/// Lines of equal value, made by gnuplot into blocks $contours0, ...
std::string contours(std::size_t panels, const PanelShape& shape, const Scale& scale) {
  std::string levels;
  for (const double mark : scale.marks())
    if (scale(mark) > 0 && scale(mark) < 1) levels += (levels.empty() ? "" : ",") + nine_digits(scale(mark));
  std::string text = "set contour base\nunset surface\nset cntrparam levels discrete " + levels + "\n";
  for (std::size_t k = 0; k < panels; ++k) {
    const std::string number = std::to_string(k);
    text += "set table $contours" + number + "\nsplot $map" + number + placed(shape) + "\nunset table\n";
  }
  return text + "unset contour\nset surface\n";
}

/// Round values beside the colours.
std::string colour_bar(const PlotRequest& request, const Scale& scale) {
  std::string tics;
  for (const double mark : scale.marks())
    if (scale(mark) > 0 || mark == 0) tics += (tics.empty() ? "'" : ", '") + mark_text(mark) + "' " + nine_digits(scale(mark));
  return std::string(viridis) + "set cbrange [0:1]\nset cbtics (" + tics + ")\nset cblabel " +
         quoted(request.measure.title() + ", " + name_of(scale.kind()) + " scale") + " offset 1.5,0\n";
}

/// Where things stand, in pixels from the figure's left and top.
struct Layout {
  int columns, rows, panel, left, gap_x, top, gap_y, right, bottom;

  int width() const { return left + columns * panel + (columns - 1) * gap_x + right; }
  int height() const { return top + rows * panel + (rows - 1) * gap_y + bottom; }
};

Layout layout_of(std::size_t panels, const PanelShape& shape) {
  Layout l{};
  l.columns = panels <= 3 ? int(panels) : panels == 4 ? 2 : panels <= 6 ? 3 : 4;
  l.rows = (int(panels) + l.columns - 1) / l.columns;
  l.panel = panels == 1 ? 480 : panels <= 4 ? 330 : 250;
  l.left = shape.axis_labels ? 70 : 20;
  l.gap_x = shape.axis_labels ? 70 : 20;
  l.top = 95;
  l.gap_y = shape.axis_labels ? 100 : 50;
  l.right = 140;
  l.bottom = shape.axis_labels ? 60 : 20;
  return l;
}

std::string margins(const Layout& l, int k) {
  std::ostringstream text;
  const double left = l.left + (k % l.columns) * (l.panel + l.gap_x), top = l.top + (k / l.columns) * (l.panel + l.gap_y);
  text << "set lmargin at screen " << left / l.width() << "\nset rmargin at screen " << (left + l.panel) / l.width() << "\nset tmargin at screen "
       << 1 - top / l.height() << "\nset bmargin at screen " << 1 - (top + l.panel) / l.height() << "\n";
  return text.str();
}

std::string bar_place(const Layout& l) {
  std::ostringstream text;
  const double height = std::min(320, l.height() - l.top - l.bottom), middle = l.top + (l.height() - l.top - l.bottom) / 2.0;
  text << "set colorbox user origin " << double(l.width() - l.right + 25) / l.width() << ',' << 1 - (middle + height / 2) / l.height() << " size "
       << 18.0 / l.width() << ',' << height / l.height() << "\n";
  return text.str();
}

}  // namespace

int panel_side(std::size_t panels) { return panels == 1 ? 321 : panels <= 4 ? 241 : 181; }

std::vector<Panel> panels_of(const PlotRequest& request, const PanelSamples& samples, std::string& csv) {
  constexpr std::size_t most = 12;  // more are too small to be read
  if (const std::size_t count = request.compared.subjects.size() * request.parts.size(); count > most)
    throw Error(ErrorKind::input, "--brdf, --set, --lobes: " + std::to_string(count) + " maps (at most " + std::to_string(most) + ")");
  SampleTable table(request.compared, samples.columns, brdf_columns());
  std::vector<Panel> panels;
  for (const Subject& subject : request.compared.subjects) {
    const std::vector<Reflectance> values = request.brdf(subject).reflectance(samples.pairs);
    const auto seen = [&](std::size_t i) { return samples.pairs[i].l.z > 0 && samples.pairs[i].v.z > 0; };
    for (const LobePart part : request.parts) {
      panels.push_back({request.label(subject, part), {}});
      for (std::size_t i = 0; i < values.size(); ++i)
        panels.back().values.push_back(seen(i) ? request.measure(values[i], samples.pairs[i].l.z, part) : std::numeric_limits<double>::quiet_NaN());
    }
    for (std::size_t i = 0; request.numbers && i < values.size(); ++i)
      if (seen(i)) table.add(subject, samples.places[i], brdf_values(values[i], samples.pairs[i].l.z));
  }
  csv = table.csv();
  return panels;
}

Figure panels_figure(const PlotRequest& request, const std::string& title, const std::vector<Panel>& panels, const PanelShape& shape,
                     const Scale& scale) {
  const Layout layout = layout_of(panels.size(), shape);
  Figure figure;
  figure.markup = true;
  figure.width = layout.width();
  figure.height = layout.height();
  figure.data = shape.data;
  for (std::size_t k = 0; k < panels.size(); ++k) figure.data += matrix("$map" + std::to_string(k), panels[k], shape.side, scale);
  figure.commands = contours(panels.size(), shape, scale) + "set multiplot " + title_command(request, title).substr(4) + colour_bar(request, scale) +
                    bar_place(layout) + "unset key\nunset grid\nset size ratio -1\n" + shape.axes;
  std::ostringstream range;
  range << "set xrange [" << shape.from << ':' << shape.to << "]\nset yrange [" << shape.from << ':' << shape.to << "]\n";
  figure.commands += range.str();
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const std::string number = std::to_string(k);
    figure.commands += margins(layout, int(k)) + (k > 0 ? "unset colorbox\n" : "") + "set title " + quoted(plain(panels[k].title)) +
                       " offset 0,-0.4\nplot $map" + number + placed(shape) + " with image, $contours" + number +
                       " using 1:2 with lines lc rgb '#60ffffff' lw 1" + shape.over + "\n";
  }
  figure.commands += "unset multiplot";
  return figure;
}

}  // namespace relume
