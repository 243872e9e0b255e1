// densities: the same view of each sphere; pixels that it does not show count as equal.
#include "cli/figures/density.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "bake/bake.h"
#include "bake/framing.h"
#include "bake/sphere_mesh.h"
#include "gbuffer/temporary_file.h"

namespace relume {
namespace {

constexpr int pixels = 384;            // each way: the finest sphere's edges are still three of them
constexpr std::size_t finest_few = 4;  // spheres that the slope is taken from: a highlight is wider than their edges

BakeJob job_for(const std::filesystem::path& file) {
  BakeJob job;
  job.output = file;
  job.camera.world_from_camera = looking_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
  job.camera.vertical_fov = 25;  // the sphere and a little air
  job.width = job.height = pixels;
  job.format.overwrite = true;
  return job;
}

double difference(const LitImage& a, const LitImage& b, const std::vector<std::int64_t>& facets) {
  double squares = 0, sum = 0, count = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (facets[i] < 0) continue;
    squares += std::pow(a.luminance(i) - b.luminance(i), 2);
    sum += b.luminance(i);
    ++count;
  }
  return std::sqrt(squares / count) / (sum / count);
}

std::string numbers(const char* format, const Density& d) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), format, d.triangles, d.edge, d.gouraud, d.flat);
  return text.data();
}

std::string slope_text(const std::vector<Density>& all, double Density::*difference) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", slope_of(all, difference));
  return text.data();
}

/// A power law through the finest sphere's point, for the eye.
std::string law(const Density& finest, double value, int power) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.9g*(x/%.9g)**%d", value, finest.edge, power);
  return text.data();
}

}  // namespace

std::vector<Density> densities(const Lighting& lighting) {
  std::vector<Density> all;
  for (const int cuts : {1, 2, 3, 4, 6, 8, 11, 16, 23, 32, 45, 64}) {
    const TemporaryFile file(".exr");
    Mesh sphere = sphere_mesh(cuts);
    Density d{int(sphere.triangles.size()), mean_edge(sphere), 0, 0};
    bake(std::move(sphere), job_for(file.path()), [](double) {});
    const std::vector<std::int64_t> facets = facets_of(file.path());
    const LitImage phong = lit(file.path(), Interpolation::phong, lighting);
    d.gouraud = difference(lit(file.path(), Interpolation::gouraud, lighting), phong, facets);
    d.flat = difference(lit(file.path(), Interpolation::flat, lighting), phong, facets);
    all.push_back(d);
  }
  return all;
}

double slope_of(const std::vector<Density>& all, double Density::*difference) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = all.size() - finest_few; i < all.size(); ++i) {
    const double log_edge = std::log(all[i].edge), log_difference = std::log(all[i].*difference);
    n += 1, x += log_edge, y += log_difference, xx += log_edge * log_edge, xy += log_edge * log_difference;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

std::string csv_of(const std::vector<Density>& all) {
  std::string csv = "triangles,edge,gouraud,flat\n";
  for (const Density& d : all) csv += numbers("%d,%.9g,%.9g,%.9g\n", d);
  return csv;
}

Figure figure_of(const std::vector<Density>& all, const std::string& lobes) {
  const Density& finest = all.back();
  Figure figure;
  figure.data = "$spheres << END\n";
  for (const Density& d : all) figure.data += numbers("%d %.9g %.9g %.9g\n", d);
  figure.data += "END\n";
  figure.commands = "set title " + quoted("Difference to Phong interpolation, spheres of growing density") + ".\"\\n\"." + quoted("lit by " + lobes) +
                    "\nset label 1 'slopes: least squares over the four finest' at graph 0.98,0.26 right font ',10'\nset logscale xy\nset xlabel "
                    "'mean edge, radii of the sphere'\nset ylabel 'rms difference over mean radiance'\nset format y '%g'\n"
                    "set xrange [" +
                    std::to_string(finest.edge * 0.8) + ":" + std::to_string(all.front().edge * 1.25) + "]\nset key right bottom\n" +
                    "plot $spheres using 2:4 with linespoints lt 2 title " + quoted("flat interpolation: slope " + slope_text(all, &Density::flat)) +
                    ", $spheres using 2:3 with linespoints lt 1 title " +
                    quoted("Gouraud interpolation: slope " + slope_text(all, &Density::gouraud)) + ", " + law(finest, finest.flat, 1) +
                    " with lines lc rgb '#888888' lw 1 dt 3 title 'edge', " + law(finest, finest.gouraud, 2) +
                    " with lines lc rgb '#888888' lw 1 dt 2 title 'edge²'\n";
  return figure;
}

}  // namespace relume
