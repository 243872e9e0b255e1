// What a rig does not say of its world (which axis is up, which hand, what unit), found by setting its camera against the file's.
#pragma once

#include <glm/mat3x3.hpp>
#include <optional>
#include <string>

#include "gbuffer/camera.h"
#include "host/rig.h"

namespace relume {

/// From a rig's world to the file's: axes exchanged and turned round (determinant -1: the other hand), then scaled.
struct Alignment {
  glm::dmat3 axes{1.0};
  double scale = 1;
  double angle = 0;  ///< degrees that are left between the two cameras
  double off = 0;    ///< distance that is left between them, as a share of the file's camera's distance from the origin

  bool is_identity() const { return axes == glm::dmat3(1.0) && scale == 1; }
};

/// What is to be found out; the rest is as it is.
struct Unknown {
  bool axes = true, scale = true;
};

/// The only exchange of axes, with the scale that goes with it, that takes the rig's camera to the file's; empty where none does.
/// Scales near those of known units are taken to be those.
std::optional<Alignment> align(const Camera& rig, const Camera& file, const Unknown& unknown = {});

/// Takes lights and camera along; point and spot lights keep the light that they throw on what has grown with them.
void transform(Rig& rig, const Alignment& alignment);

/// "(x, y, z) becomes 100 (x, -z, y)"
std::string described(const Alignment& alignment);

}  // namespace relume
