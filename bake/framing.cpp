// framing: as near as every vertex allows.
#include "bake/framing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "gbuffer/error.h"

namespace relume {

glm::dmat4 looking_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
  const double distance = glm::distance(eye, target);
  if (!(distance > 0) || !std::isfinite(distance)) throw Error(ErrorKind::input, "--eye and --target: are one place, so there is no way to look");
  const glm::dvec3 backward = (eye - target) / distance;
  glm::dvec3 right = glm::cross(up, backward);
  if (glm::length(right) < 1e-9) right = glm::cross(glm::dvec3(up.y, up.z, up.x), backward);  // straight up or down: another axis serves
  right = glm::normalize(right);
  return {glm::dvec4(right, 0), glm::dvec4(glm::cross(backward, right), 0), glm::dvec4(backward, 0), glm::dvec4(eye, 1)};
}

Camera framing(const Mesh& mesh, const glm::dvec3& up, double vertical_fov, double aspect) {
  const MeshBounds bounds = bounds_of(mesh);
  const glm::dvec3 front = up.z > 0 ? glm::dvec3(0, -1, 0) : glm::dvec3(0, 0, 1), to_eye = front + glm::dvec3(0.4, 0, 0) + 0.3 * up;
  Camera camera;
  camera.vertical_fov = vertical_fov;
  camera.source = "framing the mesh";
  camera.world_from_camera = looking_at(bounds.centre() + to_eye, bounds.centre(), up);
  constexpr double margin = 0.95;  // of the picture's half width and height, for air around the mesh
  const double down = margin * std::tan(glm::radians(vertical_fov / 2)), across = down * aspect;
  const glm::dvec3 right(camera.world_from_camera[0]), upward(camera.world_from_camera[1]), backward(camera.world_from_camera[2]);
  double distance = 0;
  for (const MeshTriangle& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 p = mesh.corner(triangle, k) - bounds.centre();
      const double wide = std::abs(glm::dot(p, right)) / across, high = std::abs(glm::dot(p, upward)) / down;
      distance = std::max(distance, glm::dot(p, backward) + std::max(wide, high));
    }
  camera.world_from_camera[3] = glm::dvec4(bounds.centre() + distance * backward, 1);
  return camera;
}

}  // namespace relume
