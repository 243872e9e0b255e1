// understand_with_camera: the rig's camera checked against the file.
#include "host/camera_choice.h"

#include <glm/geometric.hpp>
#include <sstream>

#include "gbuffer/error.h"

namespace relume {
namespace {

/// How far apart two cameras see a scene, as an angle: eyes against the distance of what they look at is not known here, so against the world's scale
/// through the eye's own distance from the origin.
bool agree(const Camera& a, const Camera& b) {
  if (a.projection != b.projection) return false;
  if (a.projection == Camera::Projection::orthographic) return glm::distance(a.backward(), b.backward()) < 1e-3;
  return glm::distance(a.eye(), b.eye()) <= 1e-3 * (1e-3 + glm::length(a.eye()));
}

std::string text(const glm::dvec3& p) {
  std::ostringstream out;
  out << "(" << p.x << ", " << p.y << ", " << p.z << ")";
  return out.str();
}

}  // namespace

Reading understand_with_camera(const ExrFile& file, const ReadingOptions& options, const std::optional<Camera>& rig_camera) {
  Reading reading = understand(file, options);
  if (options.camera || !rig_camera) {
    if (!reading.camera)
      throw Error(ErrorKind::input, file.path().string() +
                                        ": no camera: none in the header or the rig, and the positions do not determine one (--camera FILE names a rig, a glTF "
                                        "or another EXR)");
    return reading;
  }
  if (reading.camera && !agree(*reading.camera, *rig_camera)) {
    reading.notes.push_back("the rig's camera at " + text(rig_camera->eye()) + " is not the one that saw this file, which stands at " +
                            text(reading.camera->eye()) + " (" + reading.camera->source + "); the file's is used (--camera RIG overrules)");
    return reading;
  }
  ReadingOptions with_camera = options;
  with_camera.camera = rig_camera;
  return understand(file, with_camera);
}

}  // namespace relume
