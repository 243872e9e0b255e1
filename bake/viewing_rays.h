// The rays through the centres of a camera's pixels, in double precision.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "gbuffer/camera.h"

namespace relume {

/// Points are origin + t direction; t counts units along the camera's axis.
struct Ray {
  glm::dvec3 origin, direction;
};

class ViewingRays {
 public:
  /// Error{input} for a camera whose lens is not known, or whose axes are no axes.
  ViewingRays(const Camera& camera, const Window& display);

  Ray through(int x, int y) const;
  /// Whether the side that `normal` points to, of a plane through `point`, is seen.
  bool sees(const glm::dvec3& point, const glm::dvec3& normal) const;
  bool orthographic() const { return orthographic_; }

 private:
  glm::dmat4 world_from_camera_;
  Lens lens_;
  bool orthographic_;
};

}  // namespace relume
