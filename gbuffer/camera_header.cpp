// Cameras from OpenEXR's matrix attributes.
#include "gbuffer/camera_header.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <optional>

#include "gbuffer/exr_file.h"

namespace relume {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// For column vectors, from 16 stored numbers: OpenEXR stores matrices for row vectors, pbrt the transpose of that.
glm::dmat4 matrix_of(const std::vector<double>& stored, bool transposed) {
  glm::dmat4 m;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) m[i][j] = transposed ? stored[std::size_t(4 * j + i)] : stored[std::size_t(4 * i + j)];
  return m;
}

/// A rotation, perhaps mirrored and evenly scaled, and a translation.
bool rigid(const glm::dmat4& m) {
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
  const double size = glm::length(x), tolerance = 1e-3 * size * size;
  const bool affine = std::abs(m[0].w) + std::abs(m[1].w) + std::abs(m[2].w) < 1e-6 * size && std::abs(m[3].w - 1) < 1e-6;
  return affine && size > 0 && std::abs(glm::dot(x, y)) < tolerance && std::abs(glm::dot(y, z)) < tolerance && std::abs(glm::dot(z, x)) < tolerance &&
         std::abs(glm::length(y) - size) < 1e-3 * size && std::abs(glm::length(z) - size) < 1e-3 * size;
}

/// What the projection adds to the pose: its kind, and how much of the world the window spans.
void add_projection(Camera& camera, const glm::dmat4& ndc_from_world, bool transposed, bool unit_range, const Window& display) {
  const glm::dmat4 ndc_from_camera = ndc_from_world * camera.world_from_camera;
  const glm::dvec4 up = ndc_from_camera[1];
  const glm::dmat4& m = ndc_from_camera;
  const bool orthographic = std::abs(m[0].w) + std::abs(m[1].w) + std::abs(m[2].w) < 1e-6;
  camera.projection = orthographic ? Camera::Projection::orthographic : Camera::Projection::perspective;
  // pbrt's 0..1 spans the shorter side of the image only (measured, pbrt-truth), everybody else's the whole height.
  const double sides = transposed ? double(display.height()) / std::min(display.width(), display.height()) : 1;
  const double span = (unit_range ? 1 : 2) * sides, scale = std::abs(up.y) / (orthographic ? 1 : std::abs(m[2].w));
  if (scale <= 0 || !std::isfinite(scale)) return;
  if (orthographic)
    camera.height = span / scale;
  else
    camera.vertical_fov = 2 * degrees * std::atan(0.5 * span / scale);
}

/// 0..1 or -1..1: where the optical axis arrives tells (third-party files call both worldToNDC).
bool unit_range(const glm::dmat4& ndc_from_world, const Camera& camera) {
  const glm::dvec4 axis = ndc_from_world * glm::dvec4(camera.eye() - camera.backward(), 1);
  return axis.w == 0 || std::abs(axis.x / axis.w) > 0.25 || std::abs(axis.y / axis.w) > 0.25;
}

std::optional<Camera> camera_of(const Imf::Header& header, const std::vector<double>& stored, bool transposed, const Window& display) {
  const glm::dmat4 camera_from_world = matrix_of(stored, transposed);
  if (!rigid(camera_from_world)) return {};
  glm::dmat4 pose = glm::inverse(camera_from_world);
  pose[2] *= -1.0;  // the attribute's camera looks along +z, ours along -z
  for (int axis = 0; axis < 3; ++axis) pose[axis] = glm::normalize(pose[axis]);
  Camera camera;
  camera.world_from_camera = pose;
  camera.source = transposed ? "worldToCamera of the header, stored transposed" : "worldToCamera of the header";
  for (const char* name : {"worldToNDC", "worldToScreen"}) {
    const auto projection = matrix_attribute(header, name);
    if (!projection) continue;
    const glm::dmat4 ndc_from_world = matrix_of(*projection, transposed);
    add_projection(camera, ndc_from_world, transposed, unit_range(ndc_from_world, camera), display);
    return camera;
  }
  camera.vertical_fov = number_attribute(header, "fieldOfViewVertical").value_or(0);
  return camera;
}

}  // namespace

std::vector<Camera> header_cameras(const Imf::Header& header, const Window& display) {
  const auto stored = matrix_attribute(header, "worldToCamera");
  std::vector<Camera> cameras;
  if (!stored || !std::all_of(stored->begin(), stored->end(), [](double v) { return std::isfinite(v); })) return cameras;
  for (const bool transposed : {false, true})
    if (const auto camera = camera_of(header, *stored, transposed, display)) cameras.push_back(*camera);
  return cameras;
}

}  // namespace relume
