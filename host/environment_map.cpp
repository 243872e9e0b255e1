// EnvironmentMap: where texels look, and how much of the sphere each weighs.
#include "host/environment_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "gbuffer/error.h"
#include "host/json.h"

namespace relume {
namespace {

constexpr double pi = std::numbers::pi;

/// Integral of sin over the angles from `from` to from + step, weighed by what falls from 1 to 0 between them.
double falling_weight(double from, double step) { return std::cos(from) - (std::sin(from + step) - std::sin(from)) / step; }

void check_shape(int width, int height, const std::string& place) {
  const double ratio = double(width) / height;
  if (ratio >= 1.5 && ratio <= 3) return;  // 2:1, with room for maps that repeat a column or leave out a pole
  throw Error(ErrorKind::input,
              place + ": " + std::to_string(width) + "x" + std::to_string(height) +
                  " is no latitude-longitude image (about twice as wide as high; six faces or a mirrored ball are to be converted)");
}

void check_radiance(const std::vector<std::array<float, 3>>& radiance, int width, const std::string& place) {
  const auto usable = [](float x) { return x >= 0 && std::isfinite(x); };
  const auto bad =
      std::find_if(radiance.begin(), radiance.end(), [&](const auto& texel) { return !std::all_of(texel.begin(), texel.end(), usable); });
  if (bad == radiance.end()) return;
  const float value = *std::find_if_not(bad->begin(), bad->end(), usable);
  const std::string what = std::isnan(value) ? "NaN" : std::isinf(value) ? "infinite" : "negative (" + in_digits(value) + ")";
  const auto at = bad - radiance.begin();
  throw Error(ErrorKind::input, place + ": the radiance of texel " + std::to_string(at % width) + ", " + std::to_string(at / width) + " is " + what +
                                    " (numbers from 0 to 3.4e38 are radiance; oiiotool --fixnan, --clamp mend a file)");
}

/// The last column looks where the first does.
void merge_seam(EnvironmentMap& map) {
  std::vector<std::array<float, 3>> merged;
  merged.reserve(std::size_t(map.width - 1) * std::size_t(map.height));
  for (int i = 0; i < map.height; ++i) {
    const auto row = map.radiance.begin() + std::ptrdiff_t(i) * map.width;
    merged.insert(merged.end(), row, row + map.width - 1);
    auto& first = merged[merged.size() - std::size_t(map.width - 1)];
    for (std::size_t c = 0; c < 3; ++c) first[c] = 0.5f * first[c] + 0.5f * row[map.width - 1][c];
  }
  map.radiance = std::move(merged);
  --map.width;
}

}  // namespace

double EnvironmentMap::polar_angle(int row) const { return pi * (row + row_shift()) / row_steps(); }
double EnvironmentMap::azimuth(int column) const { return 2 * pi * (column + column_shift()) / width; }

glm::dvec3 EnvironmentMap::direction(int row, int column) const {
  const double theta = polar_angle(row), phi = azimuth(column);
  return {std::cos(phi) * std::sin(theta), std::sin(phi) * std::sin(theta), std::cos(theta)};
}

glm::dvec3 EnvironmentMap::towards(const glm::dvec3& d) const {
  const double azimuth = std::atan2(d.y, d.x) / (2 * pi), polar = std::atan2(std::hypot(d.x, d.y), d.z) / pi;
  const double x = (azimuth - std::floor(azimuth)) * width - column_shift(), y = polar * row_steps() - row_shift();
  const int left = int(std::floor(x)), top = int(std::floor(y));
  const auto texel = [&](int row, int column) {
    const std::array<float, 3>& r =
        radiance[std::size_t(std::clamp(row, 0, height - 1)) * std::size_t(width) + std::size_t((column + width) % width)];
    return glm::dvec3(r[0], r[1], r[2]);
  };
  const double across = x - left, down = y - top;
  return (1 - down) * ((1 - across) * texel(top, left) + across * texel(top, left + 1)) +
         down * ((1 - across) * texel(top + 1, left) + across * texel(top + 1, left + 1));
}

std::vector<double> EnvironmentMap::solid_angles() const {
  std::vector<double> angles;
  const double step = pi / row_steps();
  for (int i = 0; i < height; ++i) {
    const double theta = polar_angle(i);
    // Beyond the first and the last row their radiance goes on to the pole.
    const double above = i == 0 ? 1 - std::cos(theta) : falling_weight(pi - theta, step);
    const double below = i == height - 1 ? 1 + std::cos(theta) : falling_weight(theta, step);
    angles.push_back(2 * pi / width * (above + below));
  }
  return angles;
}

EnvironmentMap environment_of(int width, int height, std::vector<std::array<float, 3>> radiance, const EnvironmentMapping& mapping,
                              const std::string& place) {
  check_shape(width, height, place);
  check_radiance(radiance, width, place);
  EnvironmentMap map{width, height, mapping.rows_on_border && height > 1, mapping.columns_on_border && width > 1, std::move(radiance)};
  if (map.columns_on_border) merge_seam(map);
  return map;
}

}  // namespace relume
