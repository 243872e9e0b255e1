// light_records: a sort by type and place, and the numbers in the form the kernels want.
#include "host/light_records.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

#include "host/environment_lights.h"
#include "host/space_order.h"

namespace relume {
namespace {

static_assert(int(LightType::ambient) == LIGHT_COUNT, "a type's value is the kernels' number");
static_assert(int(Falloff::inverse_square) == FALLOFF_inverse_square && int(Falloff::windowed) == FALLOFF_windowed &&
              int(Falloff::linear) == FALLOFF_linear && int(Falloff::none) == FALLOFF_none);
static_assert(int(Cone::gltf) == CONE_gltf && int(Cone::smoothstep) == CONE_smoothstep && int(Cone::linear) == CONE_linear);

LightRecord record_of(const Light& light) {
  LightRecord r{};
  for (int c = 0; c < 3; ++c) {
    r.position[c] = float(light.position[c]);
    r.intensity[c] = float(light.intensity[c]);
    r.direction[c] = float(light.direction[c]);
  }
  r.range = float(light.range);
  r.falloff = int(light.falloff);
  r.falloff_scale = falloff_scale(r.falloff, float(light.range_begin), r.range);
  r.cone = int(light.cone);
  const double inner = glm::radians(light.inner_angle), outer = glm::radians(light.outer_angle);
  r.inner = float(light.cone == Cone::linear ? inner : std::cos(inner));
  r.outer = float(light.cone == Cone::linear ? outer : std::cos(outer));
  const bool bounded = light.type != LightType::directional && (light.falloff == Falloff::windowed || light.falloff == Falloff::linear);
  r.reach = bounded ? r.range * 1.0001f : std::numeric_limits<float>::infinity();
  return r;
}

/// More records than a processor's second cache holds: then it pays that neighbours in space, which the same pixels meet, are neighbours in memory.
constexpr std::size_t too_many_for_cache = 8192;

/// In the order of their records.
std::vector<const Light*> lights_of(int type, const std::vector<Light>& lights) {
  std::vector<const Light*> found;
  for (const Light& light : lights)
    if (int(light.type) == type) found.push_back(&light);
  if (type == LIGHT_directional || found.size() <= too_many_for_cache) return found;
  std::array<std::vector<float>, 3> positions;
  for (const Light* light : found)
    for (int c = 0; c < 3; ++c) positions[std::size_t(c)].push_back(float(light->position[c]));
  const std::vector<std::uint32_t> places = places_on_curve(positions[0], positions[1], positions[2]);
  std::vector<std::size_t> order(found.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
  std::vector<const Light*> sorted(found.size());
  std::transform(order.begin(), order.end(), sorted.begin(), [&](std::size_t k) { return found[k]; });
  return sorted;
}

}  // namespace

float falloff_scale(int falloff, float range_begin, float range) {
  return falloff == FALLOFF_linear ? 1.0f / (range - range_begin) : falloff == FALLOFF_windowed ? 1.0f / (range * range) : 0.0f;
}

LightRecords light_records(const std::vector<Light>& lights, const EnvironmentOptions& environments) {
  LightRecords result;
  const auto add = [&](const Light& light, const std::vector<LightRecord>& records) {
    const int begin = int(result.records.size());
    result.records.insert(result.records.end(), records.begin(), records.end());
    result.lights.push_back({light.name, begin, int(result.records.size())});
  };
  const auto add_environment = [&](const Light& light) {
    EnvironmentLights found = environment_lights(light, environments, result.notes);
    add(light, found.records);
    if (!found.on_device) return;
    result.lights.back().environment = int(result.environments.size());
    result.environments.push_back(std::move(*found.on_device));
  };
  for (int type = 0; type < LIGHT_COUNT; ++type) {
    result.begin[type] = int(result.records.size());
    for (const Light* light : lights_of(type, lights)) add(*light, {record_of(*light)});
    if (type != LIGHT_directional) continue;
    for (const Light& light : lights)
      if (light.type == LightType::environment) add_environment(light);
  }
  result.begin[LIGHT_COUNT] = int(result.records.size());
  for (const Light& light : lights)
    if (light.type == LightType::ambient) {
      if (light.fraction)
        result.ambient_fraction += *light.fraction;
      else
        result.ambient += light.intensity;
    }
  return result;
}

}  // namespace relume
