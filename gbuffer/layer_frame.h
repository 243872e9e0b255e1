// From vectors as a layer stores them to the world: encoding, axes, scale, space, and positions made from depth.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "gbuffer/reading.h"

namespace relume {

/// V-Ray's frame of a pixel whose surface lies at `seen` (camera space): columns a, b, z with a stored normal (-n.a, n.b, n.z), so n is this matrix
/// times the stored triple. Measured on a V-Ray for Maya file (research: exr-conventions A.5).
glm::dmat3 camera_from_view_ray(const glm::dvec3& seen);

/// Components put in order.
glm::dvec3 in_axes(const Axes& axes, const glm::dvec3& stored);

/// The same as a matrix.
glm::dmat3 matrix_of(const Axes& axes);

/// The normal as a direction in the layer's own space: decoded, not normalised; zero where none is stored.
glm::dvec3 decoded_normal(const Reading& reading, const glm::dvec3& stored);

/// "x,-y,z", as the options take it.
std::string text_of(const Axes& axes);

class LayerFrame {
 public:
  explicit LayerFrame(const Reading& reading);

  glm::dvec3 decoded(const glm::dvec3& stored) const { return decoded_normal(reading_, stored); }
  /// The direction (any length) in the world, of a surface at `position` (world).
  glm::dvec3 direction_in_world(const glm::dvec3& decoded, const glm::dvec3& position) const;
  /// A stored position, already divided by its coverage, in the world.
  glm::dvec3 position_in_world(const glm::dvec3& stored) const;
  /// What a depth puts at the centre of pixel (x, y) of the display window. The reading's camera has a lens.
  glm::dvec3 position_from_depth(int x, int y, double depth) const;

 private:
  const Reading& reading_;
  glm::dmat4 world_from_camera_{1.0}, camera_from_world_{1.0};
  bool orthographic_ = false, plain_normals_ = true, plain_positions_ = true;
};

}  // namespace relume
