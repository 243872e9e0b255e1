// Choosing a camera and checking it against the positions.
#include "gbuffer/find_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "gbuffer/camera_header.h"
#include "gbuffer/camera_plane.h"
#include "gbuffer/layer_frame.h"
#include "gbuffer/samples.h"
#include "gbuffer/three_digits.h"

namespace relume {
namespace {

std::string point(const glm::dvec3& p) { return "(" + three_digits(p.x) + ", " + three_digits(p.y) + ", " + three_digits(p.z) + ")"; }

/// What the search goes by: positions at pixels and the normals there.
struct Evidence {
  std::vector<Sighting> sightings;
  std::vector<glm::dvec3> normals;
  double agreement = 1;  ///< pixels: beyond this a camera is not the one that saw the file
};

/// Half-precision positions far from the origin are rounded by more than a pixel: what their last bit is worth in pixels.
double rounding_of(const Evidence& evidence, const Reading& reading) {
  const auto& types = reading.roles.at("position").types;
  if (evidence.sightings.empty() || std::find(types.begin(), types.end(), SampleType::half_float) == types.end()) return 0;
  const double n = double(evidence.sightings.size());
  glm::dvec3 middle{0};
  glm::dvec2 pixel{0};
  for (const Sighting& s : evidence.sightings) middle += s.position / n, pixel += glm::dvec2(s.x, s.y) / n;
  double size = 0, spread = 0, pixels = 0;
  for (const Sighting& s : evidence.sightings) {
    size += glm::length(s.position);
    spread += glm::distance(s.position, middle);
    pixels += glm::distance(glm::dvec2(s.x, s.y), pixel);
  }
  return spread > 0 ? 0.5 * std::ldexp(size / n, -11) * pixels / spread : 0;  // half of the 11th bit: what rounding leaves
}

Evidence evidence_of(Samples& samples, const Reading& reading) {
  Evidence evidence;
  if (!reading.roles.contains("position")) return evidence;
  evidence.sightings = clear_sightings(samples.bands(reading), reading, evidence.normals);
  evidence.agreement = std::max(evidence.agreement, rounding_of(evidence, reading));
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
  Recovery recovery = recover(evidence.sightings, reading.display_window, evidence.agreement);
  if (!recovery.camera) return recovery;
  turn_to_normals(*recovery.camera, evidence, reading);
  recovery.camera->source = "recovered from " + reading.roles.at("position").layer;
  return recovery;
}

/// What the header may mean, and before that what the convention made of it.
std::vector<Camera> candidates_of(const ExrFile& file, const Reading& reading) {
  std::vector<Camera> candidates = header_cameras(file, reading.part, reading.display_window);
  if (reading.camera) candidates.insert(candidates.begin(), *reading.camera);
  return candidates;
}

/// The positions' own lens for a camera that they bear out: a header's window is often not all in its matrices (pbrt). A lens that the header
/// states and they contradict is worth a word.
void take_lens(Camera& camera, const PoseFit& fit, const Evidence& evidence, Reading& reading) {
  const double stated = camera.lens ? reprojection_error(camera, evidence.sightings) : 0;
  camera.residual = fit.residual;
  if (fit.residual > evidence.agreement) return;
  set_extent(camera, fit, reading.display_window);
  if (stated > evidence.agreement)
    reading.notes.push_back("the lens that " + camera.source + " tells is " + three_digits(stated) +
                            " pixels off the positions' places: the lens that the positions tell is used");
}

/// The best of the header's cameras, with its residual.
std::optional<Camera> stated_camera(const ExrFile& file, Reading& reading, const Evidence& evidence) {
  std::optional<Camera> best;
  PoseFit best_fit{};
  for (Camera& camera : candidates_of(file, reading)) {
    const PoseFit fit = fit_pose(camera, evidence.sightings);
    if (best && !(fit.residual < best_fit.residual)) continue;
    best = std::move(camera);
    best_fit = fit;
  }
  if (best && !evidence.sightings.empty()) take_lens(*best, best_fit, evidence, reading);
  return best;
}

/// The camera that saw the positions, where that is plainly another than this one.
std::optional<Camera> contradicting(const Camera& camera, const Evidence& evidence, const Reading& reading) {
  constexpr double suspicious = 0.05;  // pixels; positions in half precision leave less
  if (camera.residual < suspicious) return {};
  const Recovery recovery = recovered(evidence, reading);
  if (!recovery.camera || recovery.camera->residual > 0.5 * camera.residual) return {};
  const double distance = glm::distance(evidence.sightings.front().position, recovery.camera->eye());
  const bool perspective = recovery.camera->projection == Camera::Projection::perspective;
  const double apart =
      perspective ? glm::distance(camera.eye(), recovery.camera->eye()) / distance : glm::distance(camera.backward(), recovery.camera->backward());
  // A thousandth in viewing direction shows only in the sharpest highlights.
  return camera.residual <= evidence.agreement && apart < 1e-3 ? std::nullopt : recovery.camera;
}

/// A camera from outside is obeyed, but one that did not see this file is worth a word.
void check_given(Camera& given, const Evidence& evidence, Reading& reading) {
  if (evidence.sightings.empty()) return;
  const PoseFit fit = fit_pose(given, evidence.sightings);
  given.residual = fit.residual;
  if (fit.residual <= evidence.agreement) set_extent(given, fit, reading.display_window);
  const auto other = contradicting(given, evidence, reading);
  if (!other) return;
  const bool perspective = other->projection == Camera::Projection::perspective;
  const std::string place = perspective ? "from " + point(other->eye()) : "along " + point(-other->backward());
  reading.notes.push_back("warning: the camera given (" + given.source + ") sees the positions " + three_digits(given.residual) +
                          " pixels off their places; they were seen " + place + " (--camera auto uses that)");
}

/// Positions in camera space tell the lens, whatever the pose.
void lens_of_camera_space(Camera& camera, const Evidence& evidence, const Reading& reading) {
  if (evidence.sightings.empty()) return;
  Camera at_origin = camera;
  at_origin.world_from_camera = glm::dmat4(1);
  const PoseFit fit = fit_pose(at_origin, evidence.sightings);
  camera.residual = fit.residual;
  if (fit.residual <= evidence.agreement) set_extent(camera, fit, reading.display_window);
}

/// Layers in camera space can only be lit from a world if a camera links the two; without one the camera's space is the world.
void camera_of_camera_space(const ExrFile& file, const Evidence& evidence, const ReadingOptions& options, Reading& reading) {
  if (options.camera) {
    reading.camera = options.camera;
  } else if (!reading.camera || options.recover_camera) {
    const auto stated = options.recover_camera ? std::vector<Camera>{} : candidates_of(file, reading);
    reading.camera = stated.empty() ? Camera{} : stated.front();
    if (stated.empty()) {
      reading.camera->source = "the space of the layers";
      reading.notes.push_back(
          "positions are in camera space and no camera says where in the world it stands: lights are taken in camera space, "
          "x right, y up, looking along -z (--camera FILE names a camera)");
    }
  }
  lens_of_camera_space(*reading.camera, evidence, reading);
}

/// Lens without a place: the camera's own space is the world, as for layers in camera space.
void take_lens_alone(const Lens& lens, Reading& reading) {
  reading.camera = Camera{};
  reading.camera->lens = lens;
  reading.camera->source = "the header's field of view";
  reading.notes.push_back(
      "the header tells the camera's field of view but not where in the world it stands: lights are taken in camera space, x right, y up, looking "
      "along -z (--camera FILE names a camera)");
}

/// A file with depth alone: the camera places its pixels in the world, and nothing in the file can check it.
void camera_without_positions(const ExrFile& file, const ReadingOptions& options, Reading& reading) {
  if (options.recover_camera) reading.notes.push_back("--camera auto: there are no positions to recover a camera from");
  const std::optional<Lens> lens = header_lens(file, reading.part, reading.display_window);
  if (options.camera) {
    reading.camera = options.camera;
    if (!lens_of(*reading.camera, reading.display_window, reading.pixel_aspect)) reading.camera->lens = lens;
    return;
  }
  const std::vector<Camera> stated = candidates_of(file, reading);
  const auto with_lens = std::find_if(stated.begin(), stated.end(), [](const Camera& camera) { return camera.lens.has_value(); });
  if (with_lens != stated.end()) {
    reading.camera = *with_lens;
    reading.notes.push_back("the camera is " + with_lens->source + "; there are no positions to check it by (--camera FILE overrules)");
    return;
  }
  if (stated.empty() && lens) return take_lens_alone(*lens, reading);
  reading.camera.reset();
  reading.notes.push_back(stated.empty() ? "no position layer, and no camera in the header to make positions from depth with "
                                           "(--camera FILE names a rig, a glTF or another EXR; --map position=LAYER names a layer)"
                                         : "no position layer, and the header's camera (" + stated.front().source +
                                               ") has no field of view to make positions from depth with (--camera FILE names one that has)");
}

/// A bare plane tells its camera where the lens is known, or an ordinary one.
bool recover_from_plane(const ExrFile& file, const Evidence& evidence, Reading& reading, const std::optional<Camera>& fallback) {
  const std::optional<Lens> lens = fallback ? std::nullopt : header_lens(file, reading.part, reading.display_window);
  const bool world_normals = reading.normal_space == Space::world;
  const auto camera = camera_of_plane(evidence.sightings, world_normals ? evidence.normals : std::vector<glm::dvec3>{}, reading.display_window,
                                      reading.pixel_aspect, lens, evidence.agreement);
  if (!camera) return false;
  reading.camera = camera;
  reading.camera->source = "recovered from " + reading.roles.at("position").layer + ", one plane";
  reading.notes.push_back("all positions lie in one plane, or nearly: the camera is recovered with " +
                          std::string(lens ? "the header's lens" : "a lens taken to be centred, with pixels as the header says") +
                          " (--camera FILE names a rig, a glTF or another EXR)");
  return true;
}

void recover_or_say_why(const ExrFile& file, const Evidence& evidence, Reading& reading, const std::optional<Camera>& fallback) {
  const Recovery recovery = recovered(evidence, reading);
  reading.camera = recovery.camera ? recovery.camera : fallback;
  if (recovery.camera) {
    if (fallback)
      reading.notes.push_back("the header's camera (" + fallback->source + ") sees the positions " + three_digits(fallback->residual) +
                              " pixels off their places: the camera recovered from them is used instead");
    return;
  }
  if (recovery.flat && recover_from_plane(file, evidence, reading, fallback)) return;
  reading.notes.push_back("no camera could be recovered from the positions: " + recovery.why_not +
                          (fallback ? "; the header's, which does not fit them, is used" : "") +
                          " (--camera FILE names a rig, a glTF or another EXR)");
}

void choose(const ExrFile& file, const Evidence& evidence, const ReadingOptions& options, Reading& reading) {
  if (!reading.roles.contains("position")) return camera_without_positions(file, options, reading);
  if (reading.position_space == Space::camera) return camera_of_camera_space(file, evidence, options, reading);
  if (options.camera) {
    reading.camera = options.camera;
    return check_given(*reading.camera, evidence, reading);
  }
  const std::optional<Camera> stated = options.recover_camera ? std::nullopt : stated_camera(file, reading, evidence);
  const bool unchecked = evidence.sightings.empty();
  if (stated && (unchecked || (stated->residual <= evidence.agreement && !contradicting(*stated, evidence, reading))))
    reading.camera = stated;
  else
    recover_or_say_why(file, evidence, reading, stated);
}

}  // namespace

void find_camera(Samples& samples, const ReadingOptions& options, Reading& reading) {
  const Evidence evidence = evidence_of(samples, reading);
  choose(samples.file(), evidence, options, reading);
  if (!reading.camera) return;
  reading.camera->lens = lens_of(*reading.camera, reading.display_window, reading.pixel_aspect);
  reading.camera->tolerance = evidence.agreement;
}

}  // namespace relume
