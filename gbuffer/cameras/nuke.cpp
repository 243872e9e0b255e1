// Nuke: nuke/camera/matrix (camera to world, for column vectors, looking along -z), focal and haperture, as compositors' scripts write them.
#include "gbuffer/camera_header.h"
#include "gbuffer/cameras/field_of_view.h"
#include "gbuffer/cameras/header_values.h"
#include "gbuffer/cameras/projection.h"

namespace relume {
namespace {

std::vector<Camera> read(const HeaderValues& values, const Window& display) {
  const auto stored = values.numbers("nuke/camera/matrix", 16);
  if (!stored) return {};
  const double focal = values.number("nuke/camera/focal").value_or(0), film = values.number("nuke/camera/haperture").value_or(0);
  const auto lens = lens_of_width(focal > 0 ? film / focal : 0, display, values.pixel_aspect());
  std::vector<Camera> cameras;
  for (const bool transposed : {true, false}) {  // Nuke lists its matrices row by row, with the translation at the rows' ends
    const glm::dmat4 matrix = matrix_of(*stored, transposed);
    if (!rigid(matrix)) continue;
    Camera camera;
    camera.world_from_camera = pose_of(glm::dvec3(matrix[0]), glm::dvec3(matrix[1]), glm::dvec3(matrix[2]), glm::dvec3(matrix[3]));
    set_lens(camera, lens, display);
    camera.source = "nuke/camera/matrix of the header";
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace

extern const HeaderCamera header_camera_nuke;
const HeaderCamera header_camera_nuke{"nuke", "nuke/camera/matrix, focal and haperture", "Nuke's camera-from-metadata scripts", read};

}  // namespace relume
