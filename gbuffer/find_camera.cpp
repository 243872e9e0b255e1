// Choosing a camera and checking it against the positions.
#include "gbuffer/find_camera.h"

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "gbuffer/camera_header.h"
#include "gbuffer/layer_frame.h"
#include "gbuffer/sample_rows.h"

namespace relume {
namespace {

constexpr double agreement = 1.0;  ///< pixels: beyond this a camera is not the one that saw the file

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string point(const glm::dvec3& p) { return "(" + number(p.x) + ", " + number(p.y) + ", " + number(p.z) + ")"; }

/// What the search goes by: positions at pixels and the normals there.
struct Evidence {
  std::vector<Sighting> sightings;
  std::vector<glm::dvec3> normals;
};

Evidence evidence_of(const ExrFile& file, const Reading& reading) {
  Evidence evidence;
  const auto bands = sample_rows(file, reading, {"position", "normal", "depth", "coverage"});
  evidence.sightings = clear_sightings(bands, reading, evidence.normals);
  for (Sighting& s : evidence.sightings) s.position = reading.position_scale * in_axes(reading.position_axes, s.position);
  return evidence;
}

/// Surfaces face their viewer: an orthographic view that fits from both ends is seen from the end that most normals point to.
void turn_to_normals(Camera& camera, const Evidence& evidence, const Reading& reading) {
  if (camera.projection != Camera::Projection::orthographic || reading.normal_space != Space::world) return;
  glm::dvec3 mean{0};
  for (const glm::dvec3& normal : evidence.normals) mean += normal;
  if (glm::dot(mean, camera.backward()) >= 0) return;
  const glm::dvec3 backward = camera.backward();
  double farthest = 0;
  for (const Sighting& s : evidence.sightings) farthest = std::max(farthest, glm::dot(s.position - camera.eye(), -backward));
  camera.world_from_camera[2] *= -1.0;
  camera.world_from_camera[3] -= glm::dvec4(2 * farthest * backward, 0);
}

Recovery recovered(const Evidence& evidence, const Reading& reading) {
  Recovery recovery = recover(evidence.sightings, reading.display_window, agreement);
  if (!recovery.camera) return recovery;
  turn_to_normals(*recovery.camera, evidence, reading);
  recovery.camera->source = "recovered from " + reading.roles.at("position").layer;
  return recovery;
}

/// The best of the header's cameras, with its residual.
std::optional<Camera> stated_camera(const ExrFile& file, const Reading& reading, const Evidence& evidence) {
  std::vector<Camera> candidates;
  if (reading.camera) candidates.push_back(*reading.camera);
  for (const Camera& camera : header_cameras(file.parts()[std::size_t(reading.part)].header, reading.display_window)) candidates.push_back(camera);
  if (reading.part != 0)  // renderers of multi-part files often describe the camera in the first part only
    for (const Camera& camera : header_cameras(file.parts().front().header, reading.display_window)) candidates.push_back(camera);
  std::optional<Camera> best;
  for (Camera& camera : candidates) {
    const PoseFit fit = fit_pose(camera, evidence.sightings);
    camera.residual = fit.residual;
    if (fit.residual <= agreement) set_extent(camera, fit, reading.display_window);  // a lens's window is often not in the matrices (pbrt)
    if (!best || camera.residual < best->residual) best = camera;
  }
  return best;
}

/// A camera from outside is obeyed, but one that did not see this file is worth a word.
void check_given(Camera& given, const Evidence& evidence, Reading& reading) {
  if (evidence.sightings.empty()) return;
  given.residual = fit_pose(given, evidence.sightings).residual;
  constexpr double suspicious = 0.05;  // pixels; positions in half precision leave less
  if (given.residual < suspicious) return;
  const Recovery recovery = recovered(evidence, reading);
  if (!recovery.camera || recovery.camera->residual > 0.5 * given.residual) return;
  const double distance = glm::distance(evidence.sightings.front().position, recovery.camera->eye());
  const bool perspective = recovery.camera->projection == Camera::Projection::perspective;
  const double apart =
      perspective ? glm::distance(given.eye(), recovery.camera->eye()) / distance : glm::distance(given.backward(), recovery.camera->backward());
  if (given.residual <= agreement && apart < 1e-3) return;  // a thousandth in viewing direction shows only in the sharpest highlights
  const std::string place = perspective ? "from " + point(recovery.camera->eye()) : "along " + point(-recovery.camera->backward());
  reading.notes.push_back("warning: the camera given (" + given.source + ") sees the positions " + number(given.residual) +
                          " pixels off their places; they were seen " + place + " (--camera auto uses that)");
}

/// Layers in camera space can only be lit from a world if a camera links the two; without one the camera's space is the world.
void camera_of_camera_space(const ExrFile& file, const ReadingOptions& options, Reading& reading) {
  if (options.camera) {
    reading.camera = options.camera;
    return;
  }
  if (reading.camera && !options.recover_camera) return;
  const auto stated = header_cameras(file.parts()[std::size_t(reading.part)].header, reading.display_window);
  if (!stated.empty() && !options.recover_camera) {
    reading.camera = stated.front();
    return;
  }
  reading.camera = Camera{};
  reading.camera->source = "the space of the layers";
  reading.notes.push_back(
      "positions are in camera space and no camera says where in the world it stands: lights are taken in camera space, "
      "x right, y up, looking along -z (--camera FILE names a camera)");
}

void recover_or_say_why(const Evidence& evidence, Reading& reading, const std::optional<Camera>& fallback) {
  const Recovery recovery = recovered(evidence, reading);
  reading.camera = recovery.camera ? recovery.camera : fallback;
  if (recovery.camera) {
    if (fallback)
      reading.notes.push_back("the header's camera (" + fallback->source + ") sees the positions " + number(fallback->residual) +
                              " pixels off their places: the camera recovered from them is used instead");
    return;
  }
  reading.notes.push_back("no camera could be recovered from the positions: " + recovery.why_not +
                          (fallback ? "; the header's, which does not fit them, is used" : "") +
                          " (--camera FILE names a rig, a glTF or another EXR)");
}

}  // namespace

void find_camera(const ExrFile& file, const ReadingOptions& options, Reading& reading) {
  if (reading.position_space == Space::camera) return camera_of_camera_space(file, options, reading);
  const Evidence evidence = evidence_of(file, reading);
  if (options.camera) {
    reading.camera = options.camera;
    return check_given(*reading.camera, evidence, reading);
  }
  const std::optional<Camera> stated = options.recover_camera ? std::nullopt : stated_camera(file, reading, evidence);
  const bool unchecked = evidence.sightings.empty();
  if (stated && (unchecked || stated->residual <= agreement))
    reading.camera = stated;
  else
    recover_or_say_why(evidence, reading, stated);
}

}  // namespace relume
