// environment_lights: texels, or median cut's regions, as records of directional lights; or the image with its intensity.
#include "host/environment_lights.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "host/json.h"
#include "host/median_cut.h"

namespace relume {
namespace {

/// 1 GiB of records, and an hour of a fast machine at 1080p.
constexpr std::size_t most_texels = std::size_t(1) << 24;

LightRecord record_of(const DirectedIrradiance& from, const Light& light) {
  const glm::dvec3 way = -glm::normalize(light.world_from_light * (light.mapping->light_from_map * from.direction));
  const glm::dvec3 irradiance = from.irradiance * light.intensity;
  LightRecord record{};
  for (int c = 0; c < 3; ++c) {
    record.direction[c] = float(way[c]);
    record.intensity[c] = float(irradiance[c]);
  }
  record.reach = std::numeric_limits<float>::infinity();
  return record;
}

std::string size_of(const EnvironmentMap& map) { return std::to_string(map.width + map.columns_on_border) + "x" + std::to_string(map.height); }

bool is_black(const EnvironmentMap& map) {
  return std::all_of(map.radiance.begin(), map.radiance.end(), [](const auto& texel) { return texel == std::array<float, 3>{}; });
}

void check_size(const EnvironmentMap& map, const Light& light) {
  if (map.radiance.size() <= most_texels) return;
  throw Error(ErrorKind::input, printable(light.texture.native()) + ": " + size_of(map) + " texels are too many for the exact sum (at most " +
                                    std::to_string(most_texels) + "; --environment has faster ways)");
}

DeviceEnvironment on_device(EnvironmentMap map, const Light& light) {
  for (std::array<float, 3>& texel : map.radiance)
    for (int c = 0; c < 3; ++c) texel[std::size_t(c)] = float(texel[std::size_t(c)] * light.intensity[c]);
  return {std::move(map), light.world_from_light * light.mapping->light_from_map};
}

}  // namespace

std::vector<DirectedIrradiance> texel_irradiances(const EnvironmentMap& map) {
  std::vector<DirectedIrradiance> all;
  const std::vector<double> solid_angles = map.solid_angles();
  for (int i = 0; i < map.height; ++i)
    for (int j = 0; j < map.width; ++j) {
      const auto& [r, g, b] = map.radiance[std::size_t(i) * std::size_t(map.width) + std::size_t(j)];
      if (r > 0 || g > 0 || b > 0) all.push_back({map.direction(i, j), solid_angles[std::size_t(i)] * glm::dvec3(r, g, b)});
    }
  return all;
}

EnvironmentMap brightest_alone(const EnvironmentMap& map) {
  const std::vector<double> solid_angles = map.solid_angles();
  const auto luminance = [](const std::array<float, 3>& c) { return 0.2125 * c[0] + 0.7154 * c[1] + 0.0721 * c[2]; };
  const auto brightest =
      std::max_element(map.radiance.begin(), map.radiance.end(), [&](const auto& a, const auto& b) { return luminance(a) < luminance(b); });
  const auto at = std::size_t(brightest - map.radiance.begin());
  glm::dvec3 energy(0);
  for (const DirectedIrradiance& texel : texel_irradiances(map)) energy += texel.irradiance;
  energy /= solid_angles[at / std::size_t(map.width)];
  EnvironmentMap alone = map;
  std::fill(alone.radiance.begin(), alone.radiance.end(), std::array<float, 3>{});
  alone.radiance[at] = {float(energy.x), float(energy.y), float(energy.z)};
  return alone;
}

EnvironmentLights environment_lights(const Light& light, const EnvironmentOptions& options, std::vector<std::string>& notes) {
  EnvironmentMap map = read_environment(light.texture, *light.mapping);
  if (options.brightest_alone) map = brightest_alone(map);
  const std::string who = "environment " + in_quotes(light.name) + ": ", from = " of " + size_of(map) + " texels";
  EnvironmentLights lights;
  if (is_black(map)) {
    notes.push_back(who + "black everywhere");
  } else if (is_on_device(options.method) && !options.brightest_alone) {
    const bool sampled = options.method == EnvironmentMethod::sampled;
    notes.push_back(who + (sampled ? "sampled, an image" : "looked up (approximate; its error is not estimated) in a prefiltered image") + from);
    lights.on_device = on_device(std::move(map), light);
  } else {
    const bool exact = options.method != EnvironmentMethod::median_cut;
    if (exact) check_size(map, light);
    const std::vector<DirectedIrradiance> directions = exact ? texel_irradiances(map) : median_cut(map, options.lights);
    for (const DirectedIrradiance& direction : directions) lights.records.push_back(record_of(direction, light));
    notes.push_back(who + (exact ? "exact sum of " : "median cut into ") + std::to_string(directions.size()) + " directional lights," + from);
  }
  return lights;
}

}  // namespace relume
