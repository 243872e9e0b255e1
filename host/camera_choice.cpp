// understand_with_camera: the rig's camera checked against the file.
#include "host/camera_choice.h"

#include <sstream>

#include "gbuffer/error.h"

namespace relume {
namespace {

/// Pixels: a camera whose reprojected positions miss by more did not see the file.
constexpr double agreement = 1.0;

std::string text(const glm::dvec3& p) {
  std::ostringstream out;
  out << "(" << p.x << ", " << p.y << ", " << p.z << ")";
  return out.str();
}

}  // namespace

Reading understand_with_camera(const ExrFile& file, const ReadingOptions& options, const std::optional<Camera>& rig_camera) {
  ReadingOptions with_rig = options;
  if (!with_rig.camera && !with_rig.recover_camera) with_rig.camera = rig_camera;
  Reading reading = understand(file, with_rig);
  const bool rig_is_used = !options.camera && with_rig.camera;
  if (rig_is_used && reading.camera && reading.camera->residual > agreement) {
    Reading without = understand(file, options);
    if (without.camera && without.camera->residual >= 0 && without.camera->residual < reading.camera->residual) {
      without.notes.push_back("the rig's camera at " + text(rig_camera->eye()) + " is not the one that saw this file, which stands at " +
                              text(without.camera->eye()) + " (" + without.camera->source + "); the file's is used (--camera RIG overrules)");
      return without;
    }
  }
  if (!reading.camera)
    throw Error(ErrorKind::input,
                file.path().string() +
                    ": no camera: none in the header or the rig, and the positions do not determine one (--camera FILE names a rig, a glTF "
                    "or another EXR)");
  return reading;
}

}  // namespace relume
