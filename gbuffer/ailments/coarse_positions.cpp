// How far rounding moves a position, against the nearest light: half floats hold 11 bits, floats 24.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "gbuffer/ailments/ailment.h"
#include "gbuffer/three_digits.h"

namespace relume {
namespace {

using glm::dvec3;

/// Of the distance to a light: direction off by 0.6 degrees, irradiance by 2 %, about where steps show as bands.
constexpr double visible = 0.01;
/// Pairs of pixel and light that are tried in a frame of 1080p: a tenth of a second.
constexpr std::size_t most_lights = 64;

/// Half the step from one number to the next, of a format with this many bits after the leading one.
double rounding(double value, int bits) { return value == 0 || !std::isfinite(value) ? 0 : std::ldexp(0.5, std::ilogb(value) - bits); }

double rounding_at(const std::vector<const float*>& position, std::size_t i, int bits) {
  return glm::length(dvec3(rounding(position[0][i], bits), rounding(position[1][i], bits), rounding(position[2][i], bits)));
}

double nearest(const std::vector<dvec3>& lights, const dvec3& place) {
  double squared = 1e300;
  for (const dvec3& light : lights) squared = std::min(squared, glm::dot(light - place, light - place));
  return std::sqrt(squared);
}

enum Measure { rounded, x_range, y_range, z_range, measures };

void look(const Row& row, const std::vector<dvec3>& lights, int bits, std::span<Tally> tallies) {
  const bool turn = lights.size() <= most_lights || row.y % int(lights.size() / most_lights + 1) == 0;
  const auto position = row.components("position");
  for (std::size_t i = 0; i < row.place.size(); ++i) {
    if (row.shown[i] != Shown::surface) continue;
    for (int c = 0; c < 3; ++c) tallies[x_range + c].measure(row.place[i][c]);
    if (!turn) continue;
    const double error = rounding_at(position, i, bits);
    tallies[rounded].measure(error);
    ++tallies[rounded].judged;
    if (lights.empty()) continue;
    const double share = error / nearest(lights, row.place[i]);
    if (share > visible) tallies[rounded].add(row.min_x + int(i), row.y, share);
  }
}

double extent(std::span<const Tally> t) {
  if (!(t[x_range].least <= t[x_range].greatest)) return 0;
  dvec3 size;
  for (int c = 0; c < 3; ++c) size[c] = t[x_range + c].greatest - t[x_range + c].least;
  return glm::length(size);
}

std::string degrees(double share) { return three_digits(std::atan(share) * 180 / 3.14159265358979323846); }

/// The type's name and its bits after the leading one.
std::pair<std::string, int> format_of(SampleType type) { return type == SampleType::half_float ? std::pair("half", 10) : std::pair("single", 23); }

void conclude(std::span<const Tally> t, const RoleLayer& layer, bool lit, std::vector<Finding>& findings) {
  const Tally& tally = t[rounded];
  const std::string type = format_of(layer.types.front()).first;
  const char* const cure = "render positions as 32-bit float; --map position=LAYER takes another layer";
  if (tally.pixels) {
    findings.push_back({"", Severity::defect, layer.layer, tally,
                        "positions in " + type + " precision are too coarse for the nearest light at " + share_in_words(tally),
                        "light directions are off by up to " + degrees(tally.worst) + " degrees and brightness by up to " +
                            three_digits(200 * tally.worst) + " %: bands and blocks",
                        cure});
  } else if (!lit && tally.judged && tally.greatest / visible > 0.01 * extent(t)) {
    findings.push_back(
        {"",
         Severity::hint,
         layer.layer,
         {},
         "positions in " + type + " precision are rounded by up to " + three_digits(tally.greatest) + " units, in a scene of " +
             three_digits(extent(t)),
         "lights nearer than " + three_digits(tally.greatest / visible) + " units to a surface are off by over 2 % (--lights RIG tells where)",
         cure});
  }
}

void examine(const Patient& patient, std::vector<Check>& checks, std::vector<Finding>&) {
  if (!patient.has("position")) return;
  const RoleLayer& layer = patient.layer("position");
  const int bits = format_of(layer.types.front()).second;
  checks.push_back({{},
                    measures,
                    [&lights = patient.lights, bits](const Row& row, std::span<Tally> tallies) { look(row, lights, bits, tallies); },
                    [&layer, lit = !patient.lights.empty()](std::span<const Tally> t, std::vector<Finding>& f) { conclude(t, layer, lit, f); }});
}

}  // namespace

extern const Ailment ailment_coarse_positions;
const Ailment ailment_coarse_positions{"coarse_positions", "positions rounded too coarsely for the lights", examine};

}  // namespace relume
