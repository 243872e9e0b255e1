// From a rig's lights to the records that kernels read: sorted by type, angles as cosines.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/frame.h"
#include "host/rig.h"

namespace relume {

struct LightRecords {
  std::vector<LightRecord> records;          ///< sorted by type; within a type in the rig's order
  std::array<int, LIGHT_COUNT + 1> begin{};  ///< records[begin[t]] .. records[begin[t + 1]] are of type t
  std::vector<std::string> names;            ///< of each record, for layers
  glm::dvec3 ambient{0};                     ///< sum of the ambient lights' radiance
  double ambient_fraction = 0;               ///< sum of the ambient lights' fractions
};

LightRecords light_records(const std::vector<Light>& lights);

}  // namespace relume
