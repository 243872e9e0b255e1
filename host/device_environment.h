// An environment that a device evaluates for itself: its image, and the tables that the programs of kernels/environment read.
#pragma once

#include <vector>

#include "host/environment_map.h"
#include "host/frame.h"

namespace relume {

struct DeviceEnvironment {
  EnvironmentMap map;  ///< the light's intensity is in its radiance
  glm::dmat3 world_from_map{1.0};
};

/// Puts an image into the tables.
EnvironmentImage place_image(const EnvironmentMap& map, std::vector<float>& tables);

/// The environment's image, and its frame.
EnvironmentRecord place_environment(const DeviceEnvironment& environment, std::vector<float>& tables);

/// The same, with what samples are drawn by.
EnvironmentRecord place_sampled(const DeviceEnvironment& environment, int samples, std::vector<float>& tables);

/// A number of 0..1 for each pixel, from its place in the whole frame alone, so that bands and crops show the same picture; another for each `salt`.
float scrambled(int x, int y, int surface, unsigned salt);

}  // namespace relume
