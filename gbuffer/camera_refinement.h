// The last step of finding a camera: pose and lens moved to where the reprojection error is least.
#pragma once

#include <vector>

#include "gbuffer/camera.h"

namespace relume {

/// Moves a camera that has a lens to the least robust reprojection error. With `fixed_lens` the pose alone (what a plane can still tell).
void refine(Camera& camera, const std::vector<Sighting>& sightings, bool fixed_lens = false);

}  // namespace relume
