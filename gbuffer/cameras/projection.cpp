// Decomposes projections (Hartley and Zisserman 2004, 6.2.4), whose image is [0,1] or [-1,1], y down or up (research: exr-conventions B).
#include "gbuffer/cameras/projection.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace relume {
namespace {

bool near(double a, double b) { return std::abs(a - b) < 0.01 * std::max(std::abs(a), std::abs(b)); }

/// An image axis in camera space: what a unit of the tangent (orthographic: of the world) adds to NDC, and NDC on the optical axis.
struct Axis {
  double scale, centre;
};

/// [0,1] or [-1,1]: whether the optical axis arrives nearer to (1/2, 1/2) or to (0, 0) tells (third-party files call both worldToNDC).
bool unit_range(double x, double y) { return x + y > 0.5; }

/// Which may have y.scale < 0: image y down.
Lens lens_of_axes(const Axis& x, const Axis& y, const Window& display, double pixel_aspect) {
  const bool unit = unit_range(x.centre, y.centre);
  const double range = unit ? 1 : 2, middle = unit ? 0.5 : 0;
  double across = display.width() / range, down = display.height() / range;
  const bool square_pixels = near(x.scale * across * pixel_aspect, std::abs(y.scale) * down);
  // One scale for both: the range spans the shorter side alone (pbrt, measured: pbrt-truth; RenderMan's screen space).
  if (!square_pixels && near(x.scale, std::abs(y.scale))) across = down = std::min(display.width(), display.height()) / range;
  const double side = y.scale < 0 ? 1 : -1;
  return {x.scale * across, std::abs(y.scale) * down, 0.5 * (display.min_x + display.max_x) + (x.centre - middle) * across,
          0.5 * (display.min_y + display.max_y) + side * (y.centre - middle) * down};
}

glm::dvec4 row(const glm::dmat4& m, int r) { return {m[0][r], m[1][r], m[2][r], m[3][r]}; }

bool straight(const glm::dvec3& right, const glm::dvec3& up, const glm::dvec3& forward) {
  const double tolerance = 1e-3;
  return glm::length(right) > 0 && glm::length(up) > 0 && std::abs(glm::dot(right, up)) < tolerance * glm::length(right) * glm::length(up) &&
         std::abs(glm::dot(right, forward)) < tolerance * glm::length(right) && std::abs(glm::dot(up, forward)) < tolerance * glm::length(up);
}

/// The projection `m` out of camera space turns the image, or does not start at the eye: then it belongs to another pose.
bool askew(const glm::dmat4& m, const glm::dmat4& ndc_from_world, const Camera& camera, bool orthographic) {
  constexpr double tolerance = 1e-3;  // matrices are stored in single precision
  if (std::abs(m[1].x) + std::abs(m[0].y) > tolerance * std::abs(m[0].x)) return true;
  if (orthographic) return false;
  const double steepest = glm::length(glm::dvec3(row(ndc_from_world, 0))) + glm::length(glm::dvec3(row(ndc_from_world, 3)));
  return std::abs(m[0].w) + std::abs(m[1].w) > tolerance * std::abs(m[2].w) ||
         std::abs(m[3].x) + std::abs(m[3].y) + std::abs(m[3].w) > tolerance * steepest * (1 + glm::length(camera.eye()));
}

/// Pose with the image's y taken as up; nothing where the axes are askew.
std::optional<Camera> posed(const glm::dmat4& m) {
  glm::dvec4 x = row(m, 0), y = row(m, 1), w = row(m, 3);
  const glm::dvec4 z = row(m, 2);
  const bool orthographic = glm::length(glm::dvec3(w)) < 1e-6 * glm::length(glm::dvec3(x));
  const double size = orthographic ? w.w : glm::length(glm::dvec3(w));
  if (!(std::abs(size) > 0) || !std::isfinite(size)) return {};
  x /= size, y /= size, w /= size;
  glm::dvec3 right(x), up(y), forward = orthographic ? -glm::cross(right, up) : glm::dvec3(w);
  if (orthographic && glm::dot(forward, glm::dvec3(z) / size) < 0) forward = -forward;  // z grows away from the eye
  forward = glm::normalize(forward);
  if (!orthographic) right -= forward * glm::dot(right, forward), up -= forward * glm::dot(up, forward);
  if (!straight(right, up, forward)) return {};
  // The eye: x and y on the optical axis, w = 0 or, orthographic, z = 0.
  const glm::dvec4 depth = orthographic && glm::length(glm::dvec3(z)) > 0 ? z / size : orthographic ? glm::dvec4(forward, 0) : w;
  const glm::dmat3 rows = glm::transpose(glm::dmat3(glm::dvec3(x), glm::dvec3(y), glm::dvec3(depth)));
  const glm::dvec3 eye = -(glm::inverse(rows) * glm::dvec3(x.w, y.w, depth.w));
  if (!std::isfinite(eye.x + eye.y + eye.z)) return {};
  Camera camera;
  camera.projection = orthographic ? Camera::Projection::orthographic : Camera::Projection::perspective;
  camera.world_from_camera = pose_of(right, up, -forward, eye);
  return camera;
}

}  // namespace

glm::dmat4 matrix_of(const std::vector<double>& stored, bool transposed) {
  glm::dmat4 m;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) m[i][j] = transposed ? stored[std::size_t(4 * j + i)] : stored[std::size_t(4 * i + j)];
  return m;
}

bool rigid(const glm::dmat4& m) {
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
  const double size = glm::length(x), tolerance = 1e-3 * size * size;
  const bool affine = std::abs(m[0].w) + std::abs(m[1].w) + std::abs(m[2].w) < 1e-6 * size && std::abs(m[3].w - 1) < 1e-6;
  return affine && size > 0 && std::abs(glm::dot(x, y)) < tolerance && std::abs(glm::dot(y, z)) < tolerance && std::abs(glm::dot(z, x)) < tolerance &&
         std::abs(glm::length(y) - size) < 1e-3 * size && std::abs(glm::length(z) - size) < 1e-3 * size;
}

glm::dmat4 pose_of(const glm::dvec3& right, const glm::dvec3& up, const glm::dvec3& backward, const glm::dvec3& eye) {
  return {glm::dvec4(glm::normalize(right), 0), glm::dvec4(glm::normalize(up), 0), glm::dvec4(glm::normalize(backward), 0), glm::dvec4(eye, 1)};
}

bool add_projection(Camera& camera, const glm::dmat4& ndc_from_world, const Window& display, double pixel_aspect) {
  const glm::dmat4 m = ndc_from_world * camera.world_from_camera;
  const glm::dvec4 w = row(m, 3);
  const bool orthographic = std::abs(w.x) + std::abs(w.y) + std::abs(w.z) < 1e-6 * (std::abs(m[0].x) + std::abs(w.w));
  const double size = orthographic ? w.w : std::abs(w.z);
  if (!(std::abs(size) > 0) || !std::isfinite(size) || askew(m, ndc_from_world, camera, orthographic)) return false;
  const double forward = !orthographic && w.z > 0 ? 1 : -1;  // along the camera's z axis: in front of the eye w grows
  camera.projection = orthographic ? Camera::Projection::orthographic : Camera::Projection::perspective;
  if (forward > 0) camera.world_from_camera[2] *= -1.0;
  if (m[0].x / size < 0) camera.world_from_camera[0] *= -1.0;
  const glm::dvec4 centre = orthographic ? m[3] : forward * m[2];
  const Lens lens = lens_of_axes({std::abs(m[0].x / size), centre.x / size}, {m[1].y / size, centre.y / size}, display, pixel_aspect);
  if (!std::isfinite(lens.centre_x + lens.centre_y) || !(lens.scale_x > 0) || !(lens.scale_y > 0)) return false;
  camera.lens = lens;
  set_extent(camera, lens, display);
  return true;
}

std::vector<Camera> cameras_of_projection(const glm::dmat4& ndc_from_world, const Window& display, double pixel_aspect) {
  const auto as_up = posed(ndc_from_world);
  if (!as_up) return {};
  std::vector<Camera> cameras;
  for (const bool y_down : {false, true}) {
    Camera camera = *as_up;
    if (y_down) camera.world_from_camera[1] *= -1.0;
    if (add_projection(camera, ndc_from_world, display, pixel_aspect)) cameras.push_back(camera);
  }
  // [0,1] is OpenEXR's and RenderMan's NDC with y down; [-1,1] counts upwards everywhere.
  const glm::dvec4 axis = ndc_from_world * glm::dvec4(as_up->eye() - as_up->backward(), 1);
  if (unit_range(axis.x / axis.w, axis.y / axis.w)) std::reverse(cameras.begin(), cameras.end());
  return cameras;
}

}  // namespace relume
