// What an environment light becomes: directional lights for the kernels' loop over lights, or an image that the device evaluates for itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/device_environment.h"
#include "host/environment_options.h"
#include "host/frame.h"
#include "host/rig.h"

namespace relume {

/// Irradiance on a surface that faces it, W/m^2, from a direction of the map's own frame.
struct DirectedIrradiance {
  glm::dvec3 direction, irradiance;
};

/// Every texel that is not black, with the solid angle that it weighs in the interpolated radiance.
std::vector<DirectedIrradiance> texel_irradiances(const EnvironmentMap& map);

/// Black but for the brightest texel, which has the light of all.
EnvironmentMap brightest_alone(const EnvironmentMap& map);

/// One of the two is empty; both where the image is black.
struct EnvironmentLights {
  std::vector<LightRecord> records;
  std::optional<DeviceEnvironment> on_device;
};

/// The way of `options`. Adds a note that says what was done. Error{input} about the image.
EnvironmentLights environment_lights(const Light& light, const EnvironmentOptions& options, std::vector<std::string>& notes);

}  // namespace relume
