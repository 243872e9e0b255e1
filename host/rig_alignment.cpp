// Aligns a rig's camera with the one that saw the file: 48 exchanges of axes times a scale.
#include "host/rig_alignment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "gbuffer/unit_ratio.h"
#include "host/json.h"

namespace relume {
namespace {

/// Degrees: the other eye of a stereo pair stays within, and the next exchange of axes is a quarter turn away.
constexpr double same_direction = 10;
/// Of the distance: as above, while another shot's camera rarely stands so near.
constexpr double same_place = 0.1;

/// The 48 ways to exchange axes and turn them round.
std::vector<glm::dmat3> exchanges() {
  std::vector<glm::dmat3> all;
  std::array<int, 3> from{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      glm::dmat3 m(0.0);
      for (int row = 0; row < 3; ++row) m[from[std::size_t(row)]][row] = signs >> row & 1 ? -1 : 1;
      all.push_back(m);
    }
  } while (std::next_permutation(from.begin(), from.end()));
  return all;
}

/// The largest angle between corresponding axes: a roll counts as much as a turn.
double angle_between(const glm::dmat3& a, const glm::dmat3& b) {
  double angle = 0;
  for (int c = 0; c < 3; ++c) angle = std::max(angle, std::acos(std::clamp(glm::dot(glm::normalize(a[c]), glm::normalize(b[c])), -1.0, 1.0)));
  return glm::degrees(angle);
}

/// A ratio of units where one is near; else the scale itself.
double unit_near(double scale) {
  constexpr double near = 0.03;  // what the two eyes of a stereo pair leave
  return unit_ratio_near(scale, near).value_or(scale);
}

bool orthographic(const Camera& camera) { return camera.projection == Camera::Projection::orthographic; }

/// How far the scaled eye is from the file's; an orthographic eye may stand anywhere along its axis.
double off(const Camera& rig, const Camera& file, const glm::dmat3& axes, double scale) {
  glm::dvec3 apart = scale * (axes * rig.eye()) - file.eye();
  if (orthographic(file)) apart -= file.backward() * glm::dot(apart, file.backward());
  return glm::length(apart) / std::max(glm::length(file.eye()), 1e-300);
}

/// By the eyes' distances from the origin; orthographic: by the heights of what is seen.
double scale_between(const Camera& rig, const Camera& file, const glm::dmat3& axes) {
  if (orthographic(file)) return rig.height > 0 && file.height > 0 ? file.height / rig.height : 1;
  const glm::dvec3 eye = axes * rig.eye();
  const double length = glm::length(eye);
  const double scale = length > 1e-6 * glm::length(file.eye()) ? glm::dot(eye, file.eye()) / (length * length) : 1;
  return std::isfinite(scale) && scale > 0 ? scale : 1;
}

Alignment with_axes(const Camera& rig, const Camera& file, const glm::dmat3& axes, bool any_scale) {
  Alignment found{axes, 1, angle_between(axes * glm::dmat3(rig.world_from_camera), glm::dmat3(file.world_from_camera)), 0};
  const double scale = any_scale ? scale_between(rig, file, axes) : 1, unit = unit_near(scale);
  // A scale of no unit needs better cause: a camera that was moved towards the origin looks like one.
  found.scale = unit != scale || off(rig, file, axes, scale) < 0.03 * same_place ? unit : 1;
  found.off = off(rig, file, axes, found.scale);
  return found;
}

}  // namespace

std::optional<Alignment> align(const Camera& rig, const Camera& file, const Unknown& unknown) {
  if (rig.projection != file.projection) return {};
  Alignment best = with_axes(rig, file, glm::dmat3(1.0), unknown.scale);
  if (unknown.axes)
    for (const glm::dmat3& axes : exchanges())
      if (const Alignment found = with_axes(rig, file, axes, unknown.scale); found.angle < best.angle) best = found;
  return best.angle < same_direction && best.off < same_place ? std::optional(best) : std::nullopt;
}

void transform(Rig& rig, const Alignment& alignment) {
  const double scale = alignment.scale;
  for (Light& light : rig.lights) {
    light.position = scale * (alignment.axes * light.position);
    light.direction = alignment.axes * light.direction;
    light.world_from_light = alignment.axes * light.world_from_light;
    light.range_begin *= scale;
    light.range *= scale;
    const bool thins_out = light.falloff == Falloff::inverse_square || light.falloff == Falloff::windowed;
    if ((light.type == LightType::point || light.type == LightType::spot) && thins_out) light.intensity *= scale * scale;
  }
  if (!rig.camera) return;
  glm::dmat4& pose = rig.camera->world_from_camera;
  for (int c = 0; c < 3; ++c) pose[c] = glm::dvec4(alignment.axes * glm::dvec3(pose[c]), 0);
  pose[3] = glm::dvec4(scale * (alignment.axes * glm::dvec3(pose[3])), 1);
  rig.camera->height *= scale;
}

std::string described(const Alignment& alignment) {
  std::string text;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      if (const double sign = alignment.axes[column][row]; sign != 0)
        text += std::string(text.empty() ? "(" : ", ") + (sign < 0 ? "-" : "") + "xyz"[column];
  return "(x, y, z) becomes " + (alignment.scale == 1 ? "" : in_digits(alignment.scale) + " ") + text + ")";
}

}  // namespace relume
