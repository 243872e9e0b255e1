// Cameras against what they saw: lenses, reprojection, and how well a pose explains positions.
#include "gbuffer/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>

#include "gbuffer/median.h"

namespace relume {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What the lens makes pixels of: offsets a unit in front of the eye; orthographic: world units.
struct Tangents {
  std::vector<glm::dvec2> values;
  std::size_t behind = 0;
};

Tangents tangents_of(const Camera& camera, const std::vector<Sighting>& sightings) {
  const glm::dmat4 camera_from_world = glm::inverse(camera.world_from_camera);
  const bool orthographic = camera.projection == Camera::Projection::orthographic;
  Tangents tangents;
  for (const Sighting& s : sightings) {
    const glm::dvec3 p(camera_from_world * glm::dvec4(s.position, 1));
    tangents.behind += !orthographic && p.z >= 0;
    tangents.values.push_back(orthographic ? glm::dvec2(p) : glm::dvec2(p) / std::abs(p.z));
  }
  return tangents;
}

/// x = a + b tan along one image axis: what a field of view and an off-centre window may do to the image.
struct Line {
  double n = 0, t = 0, p = 0, tt = 0, tp = 0;

  void add(double tangent, double pixel, double weight) {
    n += weight, t += weight * tangent, p += weight * pixel, tt += weight * tangent * tangent, tp += weight * tangent * pixel;
  }
  double slope() const { return (n * tp - t * p) / (n * tt - t * t); }
  double at(double tangent) const { return (p - slope() * t) / n + slope() * tangent; }
};

bool usable(const Lens& lens) {
  return std::isfinite(lens.scale_x + lens.scale_y + lens.centre_x + lens.centre_y) && lens.scale_x > 0 && lens.scale_y > 0;
}

/// The optical axis meets the middle of the window, so that a field of view describes the image.
bool centred(const Lens& lens, const Window& display) {
  const double middle_x = 0.5 * (display.min_x + display.max_x), middle_y = 0.5 * (display.min_y + display.max_y);
  return std::abs(lens.centre_x - middle_x) < 0.01 * display.width() && std::abs(lens.centre_y - middle_y) < 0.01 * display.height();
}

}  // namespace

glm::dvec3 Camera::backward() const { return glm::normalize(glm::dvec3(world_from_camera[2])); }

std::optional<Lens> lens_of(const Camera& camera, const Window& display, double pixel_aspect) {
  if (camera.lens) return camera.lens;
  const bool orthographic = camera.projection == Camera::Projection::orthographic;
  const double span = orthographic ? camera.height : 2 * std::tan(camera.vertical_fov * std::numbers::pi / 360);
  const double scale_y = display.height() / span;
  const Lens lens{scale_y / pixel_aspect, scale_y, 0.5 * (display.min_x + display.max_x), 0.5 * (display.min_y + display.max_y)};
  return span > 0 && usable(lens) ? std::optional(lens) : std::nullopt;
}

void set_extent(Camera& camera, const Lens& lens, const Window& display) {
  const double half = usable(lens) && centred(lens, display) ? 0.5 * display.height() / lens.scale_y : 0;
  if (camera.projection == Camera::Projection::orthographic)
    camera.height = 2 * half;
  else
    camera.vertical_fov = 360 / std::numbers::pi * std::atan(half);
}

void set_extent(Camera& camera, const PoseFit& fit, const Window& display) {
  camera.lens = usable(fit.lens()) ? std::optional(fit.lens()) : std::nullopt;
  set_extent(camera, fit.lens(), display);
}

double reprojection_error(const Camera& camera, const std::vector<Sighting>& sightings) {
  if (!camera.lens || sightings.empty()) return infinity;
  const Tangents tangents = tangents_of(camera, sightings);
  if (2 * tangents.behind > sightings.size()) return infinity;
  const Lens& lens = *camera.lens;
  std::vector<double> errors;
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    const glm::dvec2& t = tangents.values[i];
    errors.push_back(std::hypot(lens.centre_x + lens.scale_x * t.x - sightings[i].x, lens.centre_y - lens.scale_y * t.y - sightings[i].y));
  }
  return median(errors);
}

PoseFit fit_pose(const Camera& camera, const std::vector<Sighting>& sightings) {
  const Tangents tangents = tangents_of(camera, sightings);
  std::vector<double> weights(sightings.size(), 1), errors(sightings.size());
  PoseFit fit{infinity, 0, 0, 0, 0};
  constexpr int rounds = 4;  // outliers (edges, positions at infinity) are quiet after three
  for (int round = 0; round < rounds; ++round) {
    Line across, down;
    for (std::size_t i = 0; i < sightings.size(); ++i) {
      across.add(tangents.values[i].x, sightings[i].x, weights[i]);
      down.add(tangents.values[i].y, sightings[i].y, weights[i]);
    }
    fit = {infinity, across.at(0), down.at(0), -down.slope(), across.slope()};
    if (2 * tangents.behind > sightings.size() || !usable(fit.lens())) return fit;
    for (std::size_t i = 0; i < sightings.size(); ++i)
      errors[i] = std::hypot(across.at(tangents.values[i].x) - sightings[i].x, down.at(tangents.values[i].y) - sightings[i].y);
    fit.residual = median(errors);
    const double width = std::max(2 * fit.residual, 1e-9);  // Cauchy weights, as in recover()
    for (std::size_t i = 0; i < sightings.size(); ++i) weights[i] = 1 / (1 + errors[i] * errors[i] / (width * width));
  }
  return fit;
}

std::optional<Camera> recover_camera(const std::vector<Sighting>& sightings, const Window& display, double max_residual) {
  return recover(sightings, display, max_residual).camera;
}

}  // namespace relume
