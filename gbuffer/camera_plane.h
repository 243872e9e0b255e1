// The camera that sees a bare plane: there a lens has to be known or assumed.
#pragma once

#include <optional>
#include <vector>

#include "gbuffer/camera.h"

namespace relume {

/// `lens`: the header's; without one a centred lens of unknown length with pixels of that aspect is assumed, and the camera says so.
/// Surfaces face their viewer and worlds are right-handed: which side of the plane the viewer is on. Empty where the two disagree, and where the
/// plane does not tell (seen head on, or not by such a lens).
std::optional<Camera> camera_of_plane(const std::vector<Sighting>& sightings, const std::vector<glm::dvec3>& normals, const Window& display,
                                      double pixel_aspect, const std::optional<Lens>& lens, double max_residual);

}  // namespace relume
