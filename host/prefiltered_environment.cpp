// place_prefiltered: Ramamoorthi and Hanrahan 2001 for the irradiance; for the levels Karis 2013 with the samples' own width, Krivanek and Colbert
// 2008, "Real-time Shading with Filtered Importance Sampling".
#include "host/prefiltered_environment.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "host/environment_lights.h"

namespace relume {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int levels = 8, level_width = 128, level_height = 64;  // 2.8 degrees: the narrowest lobe, of alpha 1/64, is 3.6 wide

/// 9 coefficients of the irradiance's polynomial in the world's frame, whose terms kernels/environment_prefiltered.h has: the harmonics' own
/// constants squared, and the cosine's (pi, 2 pi/3, pi/4), are in them.
std::vector<float> harmonics_of(const DeviceEnvironment& environment) {
  std::array<glm::dvec3, 9> sums{};
  for (const DirectedIrradiance& texel : texel_irradiances(environment.map)) {
    const glm::dvec3 d = glm::normalize(environment.world_from_map * texel.direction);
    const double terms[] = {1, d.y, d.z, d.x, d.x * d.y, d.y * d.z, 3 * d.z * d.z - 1, d.x * d.z, d.x * d.x - d.y * d.y};
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += texel.irradiance * terms[k];
  }
  const double first = 2 * pi / 3 * 3 / (4 * pi), second = pi / 4 * 15 / (4 * pi), axis = pi / 4 * 5 / (16 * pi), cross = pi / 4 * 15 / (16 * pi);
  const double factors[] = {pi / (4 * pi), first, first, first, second, second, axis, second, cross};
  std::vector<float> coefficients;
  for (std::size_t k = 0; k < sums.size(); ++k)
    for (int c = 0; c < 3; ++c) coefficients.push_back(float(sums[k][c] * factors[k]));
  return coefficients;
}

EnvironmentMap blank(int width, int height) {
  return {width, height, false, false, std::vector<std::array<float, 3>>(std::size_t(width) * std::size_t(height))};
}

std::array<float, 3> as_texel(const glm::dvec3& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// Means over the texels whose centres lie in each new one; what has none takes the image where it is.
EnvironmentMap reduced(const EnvironmentMap& map, int width, int height) {
  EnvironmentMap result = blank(width, height);
  std::vector<glm::dvec3> sums(result.radiance.size(), glm::dvec3(0));
  std::vector<double> weights(result.radiance.size(), 0);
  const std::vector<double> solid_angles = map.solid_angles();
  for (int i = 0; i < map.height; ++i)
    for (int j = 0; j < map.width; ++j) {
      const int row = std::min(int(map.polar_angle(i) / pi * height), height - 1),
                column = std::min(int(map.azimuth(j) / (2 * pi) * width), width - 1);
      const std::size_t to = std::size_t(row) * std::size_t(width) + std::size_t(column);
      const std::array<float, 3>& texel = map.radiance[std::size_t(i) * std::size_t(map.width) + std::size_t(j)];
      sums[to] += solid_angles[std::size_t(i)] * glm::dvec3(texel[0], texel[1], texel[2]);
      weights[to] += solid_angles[std::size_t(i)];
    }
  for (std::size_t k = 0; k < sums.size(); ++k)
    result.radiance[k] = as_texel(weights[k] > 0 ? sums[k] / weights[k] : map.towards(result.direction(int(k) / width, int(k) % width)));
  return result;
}

/// The image in halves of its size, each with the mean solid angle of its texels.
class Pyramid {
 public:
  explicit Pyramid(const EnvironmentMap& map) {
    maps_.push_back(reduced(map, 2 * level_width, 2 * level_height));
    while (maps_.back().height > 2) maps_.push_back(reduced(maps_.back(), maps_.back().width / 2, maps_.back().height / 2));
  }

  /// The mean around a direction of about so many steradians.
  glm::dvec3 mean(const glm::dvec3& direction, double solid_angle) const {
    const double texel = 4 * pi / double(maps_[0].radiance.size());
    const double level = std::clamp(0.5 * std::log2(solid_angle / texel), 0.0, double(maps_.size() - 1));
    const std::size_t below = std::min(std::size_t(level), maps_.size() - 2);
    const double t = level - double(below);
    return (1 - t) * maps_[below].towards(direction) + t * maps_[below + 1].towards(direction);
  }

 private:
  std::vector<EnvironmentMap> maps_;
};

/// What a GGX lobe of this width reflects of the image, seen along its normal: facets by their distribution, weighed by the cosine of what they
/// reflect.
class Lobe {
 public:
  explicit Lobe(double alpha) {
    constexpr int samples = 64;
    for (int k = 0; k < samples; ++k) {
      const double u = (k + 0.5) / samples, phi = 2 * pi * std::fmod(k / std::numbers::phi, 1.0);  // a spiral by the golden angle
      const double cos2 = (1 - u) / (1 + (alpha * alpha - 1) * u), down = 2 * cos2 - 1;            // of the facet, and of what it reflects
      if (down <= 0) continue;
      const double sine = std::sqrt(1 - down * down), spread = 1 - cos2 * (1 - alpha * alpha);
      const double density = alpha * alpha / (pi * spread * spread) / 4;
      samples_.push_back({{sine * std::cos(phi), sine * std::sin(phi), down}, 1 / (density * samples)});
      weight_ += down;
    }
  }

  std::array<float, 3> filtered(const Pyramid& image, const glm::dvec3& axis) const {
    const glm::dvec3 t = glm::normalize(glm::cross(std::abs(axis.x) > 0.5 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), axis)),
                     b = glm::cross(axis, t);
    glm::dvec3 sum(0);
    for (const Sample& s : samples_)
      sum += s.direction.z / weight_ * image.mean(s.direction.x * t + s.direction.y * b + s.direction.z * axis, s.solid_angle);
    return as_texel(sum);
  }

 private:
  struct Sample {
    glm::dvec3 direction;  ///< about z
    double solid_angle;
  };
  std::vector<Sample> samples_;
  double weight_ = 0;
};

}  // namespace

EnvironmentRecord place_prefiltered(const DeviceEnvironment& environment, std::vector<float>& tables) {
  EnvironmentRecord record = place_environment(environment, tables);
  record.harmonics = int(tables.size());
  const std::vector<float> harmonics = harmonics_of(environment);
  tables.insert(tables.end(), harmonics.begin(), harmonics.end());
  const Pyramid pyramid(environment.map);
  for (int k = 1; k <= levels; ++k) {
    EnvironmentMap level = blank(level_width, level_height);
    const Lobe lobe(std::pow(double(k) / levels, 2));
    tbb::parallel_for(0, level_height, [&](int i) {
      for (int j = 0; j < level_width; ++j)
        level.radiance[std::size_t(i) * level_width + std::size_t(j)] = lobe.filtered(pyramid, level.direction(i, j));
    });
    const EnvironmentImage placed = place_image(level, tables);
    if (k == 1) record.level = placed;
  }
  record.levels = levels;
  return record;
}

}  // namespace relume
