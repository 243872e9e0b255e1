// Median cut: an environment as a few directional lights of about equal energy. Debevec 2005, "A Median Cut Algorithm for Light Probe Sampling".
#pragma once

#include <vector>

#include "host/environment_lights.h"

namespace relume {

/// At most `lights`; fewer where the map has fewer texels that are not black.
std::vector<DirectedIrradiance> median_cut(const EnvironmentMap& map, int lights);

}  // namespace relume
