// From a rig's lights to the records that kernels read: sorted by type, angles as cosines.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/device_environment.h"
#include "host/environment_options.h"
#include "host/frame.h"
#include "host/rig.h"

namespace relume {

/// A light of the rig with its records: one, or one for each of an environment's directions, or none where the device evaluates an image.
struct RigLight {
  std::string name;
  int begin = 0, end = 0;
  int environment = -1;  ///< which of the environments, or -1: none
  int group = 0;         ///< of LightLinks
};

struct LightRecords {
  /// Sorted by type, environments after directional ones; within a type in the rig's order, but where there are thousands neighbours together.
  std::vector<LightRecord> records;
  std::array<int, LIGHT_COUNT + 1> begin{};  ///< records[begin[t]] .. records[begin[t + 1]] are of type t
  std::vector<RigLight> lights;              ///< all but ambient ones, in the order of their records
  std::vector<DeviceEnvironment> environments;
  std::vector<std::string> notes;  ///< how environments were taken
  glm::dvec3 ambient{0};           ///< sum of the ambient lights' radiance
  double ambient_fraction = 0;     ///< sum of the ambient lights' fractions
};

/// LightRecord::falloff_scale, for kernels to multiply by.
float falloff_scale(int falloff, float range_begin, float range);

/// Reads the images of environments. Error{input}.
LightRecords light_records(const std::vector<Light>& lights, const EnvironmentOptions& environments = {.method = EnvironmentMethod::exact});

}  // namespace relume
