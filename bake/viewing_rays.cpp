// ViewingRays: the inverse of what gbuffer/camera.h says of Lens.
#include "bake/viewing_rays.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "gbuffer/error.h"

namespace relume {

ViewingRays::ViewingRays(const Camera& camera, const Window& display)
    : world_from_camera_(camera.world_from_camera), orthographic_(camera.projection == Camera::Projection::orthographic) {
  const auto lens = lens_of(camera, display, 1);
  const double volume = glm::determinant(glm::dmat3(world_from_camera_));
  if (!lens) throw Error(ErrorKind::input, camera.source + ": the camera's field of view or height is not known, or is none (--fov tells it)");
  if (!std::isfinite(volume) || volume == 0) throw Error(ErrorKind::input, camera.source + ": the camera's axes span no space");
  lens_ = *lens;
}

Ray ViewingRays::through(int x, int y) const {
  const double across = (x + 0.5 - lens_.centre_x) / lens_.scale_x, up = (lens_.centre_y - y - 0.5) / lens_.scale_y;
  const glm::dvec4 from = orthographic_ ? glm::dvec4(across, up, 0, 1) : glm::dvec4(0, 0, 0, 1);
  const glm::dvec4 along = orthographic_ ? glm::dvec4(0, 0, -1, 0) : glm::dvec4(across, up, -1, 0);
  return {glm::dvec3(world_from_camera_ * from), glm::dvec3(world_from_camera_ * along)};
}

bool ViewingRays::sees(const glm::dvec3& point, const glm::dvec3& normal) const {
  const glm::dvec3 to_viewer = orthographic_ ? glm::dvec3(world_from_camera_[2]) : glm::dvec3(world_from_camera_[3]) - point;
  return glm::dot(normal, to_viewer) >= 0;
}

}  // namespace relume
