// An environment made ready to be looked up: harmonics of its irradiance, and its image as lobes of several widths see it.
#pragma once

#include <vector>

#include "host/device_environment.h"

namespace relume {

/// Puts them into the tables, behind the image.
EnvironmentRecord place_prefiltered(const DeviceEnvironment& environment, std::vector<float>& tables);

}  // namespace relume
