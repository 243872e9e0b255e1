// LayerFrame: the spaces, axes and encodings of gbuffer/reading.h at work.
#include "gbuffer/layer_frame.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace relume {

using glm::dvec3;

glm::dmat3 camera_from_view_ray(const dvec3& seen) {
  const dvec3 z = glm::normalize(-seen);
  const dvec3 a = glm::normalize(glm::cross(dvec3(0, 1, 0), z)), b = glm::normalize(glm::cross(z, dvec3(1, 0, 0)));
  // The stored triple is (-a.n, b.n, z.n): the inverse of the matrix whose rows these are.
  return glm::inverse(glm::transpose(glm::dmat3(-a, b, z)));
}

dvec3 in_axes(const Axes& axes, const dvec3& stored) {
  dvec3 ordered;
  for (int i = 0; i < 3; ++i) ordered[i] = axes.sign[std::size_t(i)] * stored[axes.from[std::size_t(i)]];
  return ordered;
}

glm::dmat3 matrix_of(const Axes& axes) {
  glm::dmat3 m(0.0);
  for (int i = 0; i < 3; ++i) m[axes.from[std::size_t(i)]][i] = axes.sign[std::size_t(i)];
  return m;
}

std::string text_of(const Axes& axes) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) text += std::string(i ? "," : "") + (axes.sign[i] < 0 ? "-" : "") + "xyz"[axes.from[i]];
  return text;
}

dvec3 decoded_normal(const Reading& reading, const dvec3& stored) {
  return reading.normal_encoding == NormalEncoding::as_signed || stored == dvec3(0) ? stored : 2.0 * stored - 1.0;
}

LayerFrame::LayerFrame(const Reading& reading) : reading_(reading) {
  if (reading.camera) {
    world_from_camera_ = reading.camera->world_from_camera;
    camera_from_world_ = glm::inverse(world_from_camera_);
    orthographic_ = reading.camera->projection == Camera::Projection::orthographic;
  }
  plain_normals_ = reading.normal_space == Space::world && reading.normal_axes == Axes{};
  plain_positions_ = reading.position_space == Space::world && reading.position_axes == Axes{} && reading.position_scale == 1;
}

dvec3 LayerFrame::direction_in_world(const dvec3& decoded, const dvec3& position) const {
  if (plain_normals_) return decoded;
  const dvec3 ordered = in_axes(reading_.normal_axes, decoded);
  if (reading_.normal_space == Space::world) return ordered;
  if (reading_.normal_space == Space::camera) return glm::dmat3(world_from_camera_) * ordered;
  const dvec3 seen = orthographic_ ? dvec3(0, 0, -1) : dvec3(camera_from_world_ * glm::dvec4(position, 1));
  return glm::dmat3(world_from_camera_) * (camera_from_view_ray(seen) * ordered);
}

dvec3 LayerFrame::position_in_world(const dvec3& stored) const {
  if (plain_positions_) return stored;
  const dvec3 ordered = reading_.position_scale * in_axes(reading_.position_axes, stored);
  return reading_.position_space == Space::world ? ordered : dvec3(world_from_camera_ * glm::dvec4(ordered, 1));
}

dvec3 LayerFrame::position_from_depth(int x, int y, double depth) const {
  const Lens& lens = *reading_.camera->lens;
  const double across = (x + 0.5 - lens.centre_x) / lens.scale_x, up = (lens.centre_y - (y + 0.5)) / lens.scale_y;
  const double away = std::abs(depth);  // some write what lies ahead as negative z
  if (orthographic_) return dvec3(world_from_camera_ * glm::dvec4(across, up, -away, 1));
  const dvec3 ray{across, up, -1};
  const dvec3 seen = ray * (reading_.depth_kind == DepthKind::z ? away : away / glm::length(ray));
  return dvec3(world_from_camera_ * glm::dvec4(seen, 1));
}

}  // namespace relume
