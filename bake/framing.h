// Cameras that were not given: placed by hand, or so that the whole mesh is in the picture.
#pragma once

#include "bake/mesh.h"
#include "gbuffer/camera.h"

namespace relume {

/// The pose at `eye` that looks at `target` with `up` upwards. Error{input} where the two are one place.
glm::dmat4 looking_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);

/// From the front, a little from the right and above: where -z is into the scene with y up, y with z up. `aspect`: width over height.
Camera framing(const Mesh& mesh, const glm::dvec3& up, double vertical_fov, double aspect);

}  // namespace relume
