// The figure of a scan line: Gouraud 1971 and Phong 1975; Mach bands lie where the slope of radiance jumps, at facets' edges.
#include "cli/figures/scan_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace relume {
namespace {

/// A pixel of the line, and whether its neighbours show the mesh too.
struct Sample {
  int column;
  std::int64_t facet;
  double gouraud, phong, gouraud_bend = NAN, phong_bend = NAN;
};

std::vector<Sample> samples_of(const ScanLine& line) {
  const int width = line.phong.width;
  const std::size_t first = std::size_t(line.row) * std::size_t(width);
  std::vector<Sample> samples;
  const auto bend = [](const LitImage& image, std::size_t i) { return image.luminance(i - 1) - 2 * image.luminance(i) + image.luminance(i + 1); };
  for (int x = 0; x < width; ++x) {
    const std::size_t i = first + std::size_t(x);
    if (line.facets[i] < 0) continue;
    Sample sample{x, line.facets[i], line.gouraud.luminance(i), line.phong.luminance(i)};
    if (x > 0 && x + 1 < width && line.facets[i - 1] >= 0 && line.facets[i + 1] >= 0)
      sample.gouraud_bend = bend(line.gouraud, i), sample.phong_bend = bend(line.phong, i);
    samples.push_back(sample);
  }
  return samples;
}

std::string text(const char* format, double value) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}

std::string row_of_csv(const Sample& s) {
  const auto number = [](double value) { return std::isnan(value) ? std::string() : text("%.9g", value); };
  return std::to_string(s.column) + "," + std::to_string(s.facet) + "," + number(s.gouraud) + "," + number(s.phong) + "," + number(s.gouraud_bend) +
         "," + number(s.phong_bend) + "\n";
}

/// gnuplot breaks a line at an empty one: where the scan line leaves the mesh.
std::string data_of(const std::vector<Sample>& samples) {
  std::string data = "$line << END\n", edges = "$edges << END\n";
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    if (i > 0 && samples[i - 1].column + 1 < s.column) data += "\n";
    if (i > 0 && samples[i - 1].column + 1 == s.column && samples[i - 1].facet != s.facet) edges += text("%.1f\n", s.column - 0.5);
    data +=
        text("%.0f ", s.column) + text("%.9g ", s.gouraud) + text("%.9g ", s.phong) + text("%.9g ", s.gouraud_bend) + text("%.9g\n", s.phong_bend);
  }
  if (edges.ends_with("END\n")) edges += "NaN\n";  // one facet: gnuplot takes no empty list
  return data + "END\n" + edges + "END\n";
}

/// Largest value along the line but for its ends, where facets seen at a grazing angle squeeze all change into a pixel or two.
double largest(const std::vector<Sample>& samples, double Sample::*value) {
  double most = 0;
  for (std::size_t i = samples.size() / 20; i < samples.size() - samples.size() / 20; ++i)
    if (!std::isnan(samples[i].*value)) most = std::max(most, std::abs(samples[i].*value));
  return most > 0 ? most : 1;
}

/// Of the figure, in pixels from its top.
constexpr int images_top = 70, image_side = 440, panel_height = 145, panel_step = 215;

/// How high the pictures stand.
int image_height(const ScanLine& line) { return std::min(image_side, image_side * line.phong.height / line.phong.width); }

/// gnuplot's margins of a panel, in pixels from the figure's top left.
std::string panel_at(const Figure& figure, double left, double right, double top, double bottom) {
  return text("set lmargin at screen %.5f\n", left / figure.width) + text("set rmargin at screen %.5f\n", right / figure.width) +
         text("set tmargin at screen %.5f\n", 1 - top / figure.height) + text("set bmargin at screen %.5f\n", 1 - bottom / figure.height);
}

/// A picture around x = `middle`, with the line drawn in.
std::string image_panel(const Figure& figure, const std::string& title, const std::string& png, double middle, const ScanLine& line) {
  const double high = image_height(line), wide = high * line.phong.width / line.phong.height;
  return panel_at(figure, middle - wide / 2, middle + wide / 2, images_top, images_top + high) +
         "unset border\nunset tics\nunset grid\nunset key\nset title " + quoted(title) +
         " offset 0,-0.5\nset xrange [-0.5:" + std::to_string(line.phong.width) + "-0.5]\nset yrange [-0.5:" + std::to_string(line.phong.height) +
         "-0.5]\nplot '" + png + "' binary filetype=png with rgbimage, " + std::to_string(line.phong.height - 1 - line.row) +
         " with lines lc rgb '#E69F00' lw 1 dt 2\n";
}

/// Curves of one of the panels beneath the pictures, facets' edges behind them; columns stand under one another.
struct CurvePanel {
  int number;
  double lowest, highest;
  std::string title, curves;
};

std::string commands_of(const Figure& figure, const ScanLine& line, const CurvePanel& panel) {
  const int top = images_top + image_height(line) + 55 + panel.number * panel_step;
  const std::string low = text("%.9g", panel.lowest), high = text("%.9g", panel.highest);
  return panel_at(figure, 100, 965, top, top + panel_height) + "set yrange [" + low + ":" + high + "]\nset title " + quoted(panel.title) +
         " offset 0,-0.5\nplot $edges using 1:(" + low + "):(0):(" + high + "-(" + low +
         ")) with vectors nohead lc rgb '#999999' lw 1 dt 3 title \"facets' edges\", " + panel.curves + "\n";
}

std::string column_axes(const std::vector<Sample>& samples) {
  return "set border 3\nset tics nomirror out\nset xtics autofreq nomirror\nset ytics "
         "autofreq nomirror\n"
         "set format x ''\nset format y '%g'\nset key right top noopaque\nset xrange [" +
         std::to_string(samples.empty() ? 0 : samples.front().column) + ":" + std::to_string(samples.empty() ? 1 : samples.back().column) + "]\n";
}

}  // namespace

int row_of_highlight(const LitImage& phong, const std::vector<std::int64_t>& facets) {
  std::size_t brightest = 0;
  for (std::size_t i = 0; i < facets.size(); ++i)
    if (facets[i] >= 0 && (facets[brightest] < 0 || phong.luminance(i) > phong.luminance(brightest))) brightest = i;
  return int(brightest / std::size_t(phong.width));
}

std::string csv_of(const ScanLine& line) {
  std::string csv = "column,facet,gouraud,phong,gouraud_second_difference,phong_second_difference\n";
  for (const Sample& sample : samples_of(line)) csv += row_of_csv(sample);
  return csv;
}

Figure figure_of(const ScanLine& line, const std::string& gouraud_png, const std::string& phong_png) {
  const std::vector<Sample> samples = samples_of(line);
  const double gouraud = largest(samples, &Sample::gouraud), phong = largest(samples, &Sample::phong), both = 1.1 * std::max(gouraud, phong);
  const double gouraud_bend = 1.2 * largest(samples, &Sample::gouraud_bend), phong_bend = 1.2 * largest(samples, &Sample::phong_bend);
  const std::string by_gouraud = " with lines lt 1 title 'Gouraud interpolation'", by_phong = " with lines lt 2 title 'Phong interpolation'";
  Figure figure;
  figure.width = 1000;
  figure.height = images_top + image_height(line) + 3 * panel_step + 50;
  figure.data = data_of(samples);
  figure.commands =
      "set multiplot\nset label 1 " + quoted("Lit by " + line.lobes + "; along row " + std::to_string(line.row)) + " at screen 0.5," +
      text("%.4f", 1 - 25.0 / figure.height) + " center font ',13'\n" +
      image_panel(figure, "Gouraud interpolation: vertices are lit", gouraud_png, 260, line) + "unset label 1\n" +
      image_panel(figure, "Phong interpolation: pixels are lit", phong_png, 740, line) + column_axes(samples) +
      commands_of(figure, line,
                  {0, 0, both,
                   "Luminance, W/(m² sr): at most " + text("%.3g", gouraud) + " with Gouraud interpolation, " + text("%.3g", phong) + " with Phong's",
                   "$line using 1:3" + by_phong + ", $line using 1:2" + by_gouraud}) +
      "unset key\n" +
      commands_of(figure, line,
                  {1, -gouraud_bend, gouraud_bend, "Second difference, per pixel²: Gouraud's peaks are Mach bands, at facets' edges",
                   "$line using 1:4" + by_gouraud}) +
      "set format x '%g'\nset xlabel 'column, pixels' offset 0,0.3\n" +
      commands_of(figure, line,
                  {2, -phong_bend, phong_bend, "The same with Phong interpolation, on a scale of its own", "$line using 1:5" + by_phong}) +
      "unset multiplot\n";
  return figure;
}

}  // namespace relume
