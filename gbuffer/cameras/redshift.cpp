// Redshift: rs/camera/transform (camera to world) and rs/camera/fov (research: exr-conventions B.3).
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "gbuffer/camera_header.h"
#include "gbuffer/cameras/field_of_view.h"
#include "gbuffer/cameras/header_values.h"
#include "gbuffer/cameras/projection.h"

namespace relume {
namespace {

/// How the stored axes make right, up and backward. Scripts that take the camera over either flip z or turn half way round y.
struct Reading {
  double right, backward;  ///< signs of the stored x and z axes
  const char* name;
};
constexpr Reading flipped{1, -1, "z flipped"}, turned{-1, -1, "turned half way about y"}, plain{1, 1, "as stored"};

std::vector<Camera> read(const HeaderValues& values, const Window& display) {
  const auto stored = values.numbers("rs/camera/transform", 16);
  if (!stored) return {};
  const bool transposed = (*stored)[3] != 0 || (*stored)[7] != 0 || (*stored)[11] != 0;  // the translation stands in the last column
  const glm::dmat4 matrix = matrix_of(*stored, transposed);
  if (!rigid(matrix)) return {};
  const auto lens = lens_of_degrees(values.number("rs/camera/fov").value_or(0), display, values.pixel_aspect());
  // A right-handed world is the rule; the first reading is the one that makes the camera so.
  const bool mirrored = glm::determinant(glm::dmat3(matrix)) < 0;
  std::vector<Camera> cameras;
  for (const Reading& reading : {mirrored ? flipped : turned, mirrored ? turned : plain, mirrored ? plain : flipped}) {
    Camera camera;
    camera.world_from_camera =
        pose_of(reading.right * glm::dvec3(matrix[0]), glm::dvec3(matrix[1]), reading.backward * glm::dvec3(matrix[2]), glm::dvec3(matrix[3]));
    set_lens(camera, lens, display);
    camera.source = std::string("rs/camera/transform of the header, ") + reading.name;
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace

extern const HeaderCamera header_camera_redshift;
const HeaderCamera header_camera_redshift{"redshift", "rs/camera/transform and rs/camera/fov", "exr-conventions B.3", read};

}  // namespace relume
