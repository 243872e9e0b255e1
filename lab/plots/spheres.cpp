// A sheet of lit spheres, a column for each value of the first sweep, shaded by the kernels that shade frames.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "gbuffer/error.h"
#include "lab/lit_sphere.h"
#include "lab/plots/list.h"
#include "lab/sample_table.h"

namespace relume {
namespace {

/// Which sphere stands where.
struct Sheet {
  std::vector<std::string> column_names, row_names;
  std::vector<std::pair<int, int>> places;  ///< column and row of each subject
  int columns() const { return int(column_names.size()); }
  int rows() const { return int(row_names.size()); }
};

int position_of(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return int(found - names.begin());
  names.push_back(name);
  return int(names.size()) - 1;
}

/// Rows are BRDFs with the values of further sweeps; where nothing varies the BRDFs stand side by side.
Sheet sheet_of(const Comparison& compared) {
  Comparison rest = compared;  // what tells rows apart
  const auto across = std::find_if(rest.sweeps.begin(), rest.sweeps.end(), [](const Sweep& s) { return s.varies(); });
  Sheet sheet;
  if (across == rest.sweeps.end()) {
    sheet.row_names = {""};
    for (const Subject& subject : compared.subjects) {
      sheet.places.emplace_back(sheet.columns(), 0);
      sheet.column_names.push_back(subject.brdf);
    }
    return sheet;
  }
  const Sweep swept = *across;
  rest.sweeps.erase(across);
  for (const std::string& value : swept.values) sheet.column_names.push_back(swept.parameter + " = " + value);
  for (const Subject& subject : compared.subjects) {
    const auto value = std::find(swept.values.begin(), swept.values.end(), subject.value(swept.parameter));
    const int column = value == swept.values.end() ? 0 : int(value - swept.values.begin());
    sheet.places.emplace_back(column, position_of(sheet.row_names, rest.label(subject)));
  }
  return sheet;
}

constexpr float ground = 0.1f;  // radiance: dark enough that a highlight and a shaded limb both stand out

void paste(const Picture& sphere, int left, int top, Picture& sheet) {
  for (int y = 0; y < sphere.height; ++y)
    for (int x = 0; x < sphere.width; ++x) {
      const float* from = sphere.values.data() + (std::size_t(y) * std::size_t(sphere.width) + std::size_t(x)) * 4;
      float* to = sheet.values.data() + (std::size_t(top + y) * std::size_t(sheet.width) + std::size_t(left + x)) * 3;
      for (int c = 0; c < 3; ++c) to[c] = from[c] + (1 - from[3]) * ground;
    }
}

std::string codes(const Picture& sheet, double exposure) {
  std::ostringstream text;
  text << "$sheet << END\n";
  const float gain = float(std::exp2(exposure));
  for (std::size_t i = 0; i < sheet.values.size(); i += 3)
    text << int(srgb_code(sheet.values[i] * gain)) << ' ' << int(srgb_code(sheet.values[i + 1] * gain)) << ' '
         << int(srgb_code(sheet.values[i + 2] * gain)) << '\n';
  text << "END\n";
  return text.str();
}

std::string tics(const char* axis, const std::vector<std::string>& names, int size, bool downwards) {
  std::ostringstream text;
  text << "set " << axis << " (";
  for (std::size_t k = 0; k < names.size(); ++k) {
    const double middle = (double(k) + 0.5) * size - 0.5;
    text << (k ? ", " : "") << quoted(plain(names[k])) << ' ' << (downwards ? double(names.size()) * size - 1 - middle : middle);
  }
  text << ")\n";
  return text.str();
}

std::size_t longest(const std::vector<std::string>& names) {
  std::size_t most = 0;
  for (const std::string& name : names) most = std::max(most, name.size());
  return most;
}

Figure figure_of(const PlotRequest& request, const Sheet& sheet, const Picture& picture, int size) {
  const int left = 30 + 9 * int(longest(sheet.row_names)), top = 105, side = 15;  // 9 pixels a letter
  const std::string light = "Light " + nine_digits(request.arrangement.angle) + "° from the viewer, irradiance π; exposure " +
                            nine_digits(request.exposure) + " stops, sRGB";
  Figure figure;
  figure.markup = true;
  figure.width = std::max(left + picture.width + side, 640);  // room for the title
  figure.height = top + picture.height + side;
  const double slack = (figure.width - left - side - picture.width) / 2.0;
  figure.data = codes(picture, request.exposure);
  std::ostringstream margins;
  margins << "set lmargin at screen " << (left + slack) / figure.width << "\nset rmargin at screen " << (left + slack + picture.width) / figure.width
          << "\nset tmargin at screen " << 1 - double(top) / figure.height << "\nset bmargin at screen " << double(side) / figure.height
          << "\nset xrange [-0.5:" << picture.width - 0.5 << "]\nset yrange [-0.5:" << picture.height - 0.5 << "]\n";
  const std::string width = std::to_string(picture.width), last = std::to_string(picture.height - 1);
  figure.commands = "set label " + quoted(light) + " at screen 0.5, screen " + nine_digits(1 - 24.0 / figure.height) + " center\n" +
                    (request.compared.constants().empty() ? ""
                                                          : "set label " + quoted(plain(request.compared.constants())) + " at screen 0.5, screen " +
                                                                nine_digits(1 - 46.0 / figure.height) + " center font ',10'\n") +
                    margins.str() +
                    "unset border\nunset grid\nunset key\nunset xtics\nset x2tics scale 0 font ',11'\nset ytics scale 0 font ',11'\n" +
                    tics("x2tics", sheet.column_names, size, false) + tics("ytics", sheet.row_names, size, true) +
                    "set x2range [-0.5:" + nine_digits(picture.width - 0.5) + "]\nplot $sheet using (int($0)%" + width + "):(" + last + "-int($0)/" +
                    width + "):1:2:3 with rgbimage";
  return figure;
}

double brightest_of(const Picture& sphere) {
  float most = 0;
  for (std::size_t i = 0; i < sphere.values.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, sphere.values[i + c]);
  return most;
}

void add_rows(const Subject& subject, const Picture& sphere, SampleTable& table) {
  for (int y = 0; y < sphere.height; ++y)
    for (int x = 0; x < sphere.width; ++x) {
      const float* pixel = sphere.values.data() + (std::size_t(y) * std::size_t(sphere.width) + std::size_t(x)) * 4;
      if (pixel[3] > 0) table.add(subject, {double(x), double(y)}, {pixel[0], pixel[1], pixel[2], pixel[3]});
    }
}

/// From the viewer's side, upwards and to the left.
glm::dvec3 to_light(double angle) {
  const glm::dvec3 aside = in_plane(angle);
  return {-aside.x * std::sqrt(0.5), aside.x * std::sqrt(0.5), aside.z};
}

}  // namespace

Plot plot_spheres(const PlotRequest& request) {
  const Sheet sheet = sheet_of(request.compared);
  constexpr int most = 12, widest = 1500;  // pixels of a sheet
  if (sheet.columns() > most || sheet.rows() > most)
    throw Error(ErrorKind::input, "plot spheres: " + std::to_string(sheet.columns()) + " columns, " + std::to_string(sheet.rows()) +
                                      " rows (at most " + std::to_string(most) + " of each)");
  SphereView view;
  view.size = std::min(view.size, widest / sheet.columns());
  view.to_light = to_light(request.arrangement.angle);
  Picture picture{sheet.columns() * view.size, sheet.rows() * view.size, 3, {}};
  picture.values.assign(std::size_t(picture.width) * std::size_t(picture.height) * 3, 1.0f);  // white where no sphere stands
  SampleTable table(request.compared, {"x", "y"}, {"radiance.r", "radiance.g", "radiance.b", "coverage"});
  Plot plot;
  for (std::size_t k = 0; k < request.compared.subjects.size(); ++k) {
    const Subject& subject = request.compared.subjects[k];
    const Picture sphere = lit_sphere(request.brdf(subject).material(), view, *request.device);
    paste(sphere, sheet.places[k].first * view.size, sheet.places[k].second * view.size, picture);
    if (request.numbers) add_rows(subject, sphere, table);
    plot.remarks.push_back(request.compared.label(subject) + ": brightest pixel " + nine_digits(brightest_of(sphere)) + " W/(m^2 sr)");
  }
  plot.csv = table.csv();
  plot.figure = figure_of(request, sheet, picture, view.size);
  plot.picture = std::move(picture);
  return plot;
}

}  // namespace relume
