// A sphere under one directional light, shaded by the kernels as a G-buffer that was made in memory.
#pragma once

#include <glm/vec3.hpp>
#include <memory>

#include "gbuffer/picture.h"
#include "host/device.h"
#include "host/materials.h"

namespace relume {

struct SphereView {
  int size = 150;                ///< pixels of the square picture
  glm::dvec3 to_light{0, 0, 1};  ///< unit; x right, y up, z towards the orthographic viewer
};

/// Radiance with alpha, anti-aliased: 4 channels. The light gives pi W/m^2 to a surface that faces it, which makes Lambert's radiance albedo n.l.
Picture lit_sphere(const Material& material, const SphereView& view, Device& device);

}  // namespace relume
