// Stored normals beside the normals of the surface that the positions span: what shows the space of the former.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "gbuffer/solver/question.h"

namespace relume {

struct SurfaceNormal {
  glm::dvec3 geometric;  ///< world, unit, facing the viewer: from differences of positions
  glm::dvec3 stored;     ///< decoded, unit, in the layer's own space and axes
  glm::dvec3 seen;       ///< the surface point in camera space
};

/// At pixels whose neighbours continue the same surface; some thousands at most. The reading has a camera. The base normal is taken where there is
/// one: bump maps only blur the answer.
std::vector<SurfaceNormal> surface_normals(const Asked& asked, const Reading& reading);

}  // namespace relume
