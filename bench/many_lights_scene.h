// The many-light workload that throughput is compared on: ground, wall, 220 balls and 60 posts under 1024 ranged point lights, as in ISPC's example
// "deferred" (Lauritzen and Montgomery), whose lights are spread the same way.
#pragma once

#include <vector>

#include "bench/resident_frame.h"

namespace relume::bench {

struct ManyLights {
  FrameSource source;  ///< roles kd, ks, exponent
  std::vector<Light> lights;
};

/// `reach`: factor on the ranges of the lights. The numbers drawn for `seed` are those of the workload's other spellings.
ManyLights many_lights(int width, int height, double reach, unsigned seed, int lights = 1024);

}  // namespace relume::bench
