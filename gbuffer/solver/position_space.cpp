// Are positions in the world or in the camera's space, does z point out of the scene or into it, and in which units? Whichever reading puts them at
// their pixels.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "gbuffer/camera_header.h"
#include "gbuffer/layer_frame.h"
#include "gbuffer/solver/question.h"
#include "gbuffer/three_digits.h"
#include "gbuffer/unit_ratio.h"

namespace relume {
namespace {

constexpr double agreement = 1.0;  ///< pixels: what half-precision positions leave
constexpr double clear_win = 0.5;  ///< of the other reading's error: nearer than that, both are as good
constexpr Axes z_forward{{0, 1, 2}, {1, 1, -1}};

struct Candidate {
  Space space;
  Axes axes;
  Camera camera;  ///< of the space that the positions are in
  PoseFit fit{std::numeric_limits<double>::infinity(), 0, 0, 0, 0};
};

std::vector<Sighting> in_axes(const std::vector<Sighting>& sightings, const Axes& axes) {
  std::vector<Sighting> ordered = sightings;
  for (Sighting& s : ordered) s.position = in_axes(axes, s.position);
  return ordered;
}

/// The camera that the user named, else those that the header may mean.
std::vector<Camera> stated_cameras(const Asked& asked, const Reading& reading) {
  if (asked.options.camera) return {*asked.options.camera};
  if (asked.options.recover_camera) return {};
  std::vector<Camera> cameras;
  if (reading.camera) cameras.push_back(*reading.camera);
  for (const Camera& camera : header_cameras(asked.file, reading.part, reading.display_window)) cameras.push_back(camera);
  return cameras;
}

Candidate best_of(std::vector<Candidate> candidates, const std::vector<Sighting>& sightings) {
  for (Candidate& c : candidates) c.fit = fit_pose(c.camera, in_axes(sightings, c.axes));
  return *std::min_element(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return a.fit.residual < b.fit.residual; });
}

/// Without perspective both ways to point z fit: then what is seen lies ahead of the camera.
std::vector<Candidate> in_camera_space(const std::vector<Camera>& stated, const std::vector<Sighting>& sightings) {
  Camera camera;
  if (!stated.empty()) camera.projection = stated.front().projection;
  const auto ahead = std::count_if(sightings.begin(), sightings.end(), [](const Sighting& s) { return s.position.z > 0; });
  if (camera.projection == Camera::Projection::orthographic)
    return {{Space::camera, 2 * std::size_t(ahead) > sightings.size() ? z_forward : Axes{}, camera}};
  return {{Space::camera, Axes{}, camera}, {Space::camera, z_forward, camera}};
}

std::string pixels(double residual) { return std::isfinite(residual) ? three_digits(residual) + " px" : "the wrong way round"; }

void take(const Candidate& chosen, Reading& reading) {
  const bool moved = chosen.space != reading.position_space;
  reading.position_space = chosen.space;
  reading.position_axes = chosen.axes;
  if (moved) reading.normal_space = chosen.space;
  if (reading.normal_space == Space::camera && chosen.space == Space::camera) reading.normal_axes = chosen.axes;
  if (chosen.space != Space::camera || !reading.camera) return;
  reading.camera->residual = chosen.fit.residual;
  if (chosen.fit.residual < agreement) set_extent(*reading.camera, chosen.fit, reading.display_window);
}

/// A rotation by right angles, perhaps mirrored, if the matrix is one.
std::optional<Axes> right_angles(const glm::dmat3& m) {
  Axes axes;
  for (int i = 0; i < 3; ++i) {
    int found = -1;
    for (int j = 0; j < 3; ++j)
      if (std::abs(std::abs(m[j][i]) - 1) < 0.02) found = j;
    if (found < 0) return {};
    axes.from[std::size_t(i)] = found;
    axes.sign[std::size_t(i)] = m[found][i] < 0 ? -1 : 1;
  }
  return axes;
}

/// Positions that fit no stated camera as they are may do so in other units or with other axes: the camera that saw them, recovered, is then the
/// stated one but for those.
bool take_units_and_axes(const std::vector<Camera>& stated, const std::vector<Sighting>& sightings, Reading& reading) {
  const auto seen = recover_camera(sightings, reading.display_window);
  if (!seen || seen->projection != Camera::Projection::perspective || !(glm::length(seen->eye()) > 0)) return false;
  for (const Camera& camera : stated) {
    const auto axes = right_angles(glm::dmat3(camera.world_from_camera) * glm::transpose(glm::dmat3(seen->world_from_camera)));
    if (!axes) continue;
    const auto ratio = unit_ratio_near(glm::length(camera.eye()) / glm::length(seen->eye()), 0.01);
    if (!ratio) continue;  // some camera's axes and distance can always be made to fit
    const double scale = *ratio;
    if (!(glm::distance(camera.eye(), scale * in_axes(*axes, seen->eye())) < 0.01 * glm::length(camera.eye()))) continue;
    if (*axes == Axes{} && scale == 1) return false;
    reading.position_axes = *axes;
    reading.position_scale = scale;
    reading.verdicts.push_back({"position units and axes", three_digits(scale) + " times " + text_of(*axes),
                                "so turned and scaled, the positions are where " + camera.source + " sees them; as stored they are not",
                                "--position-scale, --position-axes", true});
    return true;
  }
  return false;
}

/// A camera at the origin of a world with its axes: the two spaces are one.
bool is_origin(const Camera& camera) {
  double apart = 0;
  for (int i = 0; i < 4; ++i) apart = std::max(apart, glm::length(camera.world_from_camera[i] - glm::dmat4(1)[i]));
  return apart < 1e-6;
}

}  // namespace

void ask_position_space(const Asked& asked, Reading& reading) {
  if (!reading.roles.contains("position") || asked.options.position_axes) return;
  std::vector<glm::dvec3> normals;
  const auto sightings = clear_sightings(asked.bands, reading, normals);
  constexpr std::size_t few = 8;
  if (sightings.size() < few) return;
  const auto stated = stated_cameras(asked, reading);
  const Candidate seen = best_of(in_camera_space(stated, sightings), sightings);
  if (stated.empty() || asked.options.position_space) {
    if (reading.position_space == Space::camera) take(seen, reading);
    return;
  }
  std::vector<Candidate> worlds;
  for (const Camera& camera : stated) worlds.push_back({Space::world, Axes{}, camera});
  const Candidate world = best_of(worlds, sightings);
  const bool camera_wins = seen.fit.residual < agreement && seen.fit.residual < clear_win * world.fit.residual;
  const bool world_wins = world.fit.residual < agreement && world.fit.residual < clear_win * seen.fit.residual;
  const bool of_the_file = !asked.options.camera;  // a rig in another world is the one to be turned (host/rig_alignment.h)
  if (of_the_file && !camera_wins && !world_wins && world.fit.residual > agreement && seen.fit.residual > agreement &&
      take_units_and_axes(stated, sightings, reading))
    return;
  const bool camera = camera_wins || (!world_wins && reading.position_space == Space::camera);
  const bool not_seen = !camera && seen.fit.residual > agreement;  // then the header's camera is another's: find_camera says so
  take(camera ? seen : world, reading);
  reading.verdicts.push_back({"position space", camera ? "camera" : "world",
                              "reprojected, positions miss their pixels by " + pixels(world.fit.residual) + " as world positions (" +
                                  world.camera.source + ") and by " + pixels(seen.fit.residual) + " as positions in camera space",
                              "--position-space", camera_wins || world_wins || not_seen || is_origin(world.camera)});
}

}  // namespace relume
