// A frame made in memory where every pixel faces every light and the viewer: bumpy ground under a cloud of lights. Nothing is dark, nothing is
// skipped, so that a rate says what the arithmetic costs.
#pragma once

#include <vector>

#include "bench/resident_frame.h"
#include "host/rig.h"

namespace relume::bench {

/// Its roles are albedo, alpha and what else lobes read that matters to them; the camera is above, looking down.
FrameSource ground_source(int width, int height);

/// Lights that see all of the ground: unranged points, spots whose cone holds all of it, or directions.
std::vector<Light> ground_lights(LightType type, int count);

}  // namespace relume::bench
