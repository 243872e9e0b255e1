// Directional albedo: the share of light from one direction that a BRDF reflects, the integral of f_r n.l over the hemisphere of l.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "lab/brdf.h"

namespace relume {

struct Albedo {
  glm::dvec3 value;
  glm::dvec3 error;  ///< how far two rules of cubature are apart: as a rule many times the error of the better one, which gave the value
};

/// Of each half of a BRDF.
struct LobeAlbedos {
  Albedo diffuse, specular;
  Albedo total() const { return {diffuse.value + specular.value, diffuse.error + specular.error}; }
};

/// f_r n.l for many pairs of directions: a Brdf's, or what takes its place. Mirror-symmetric about the plane of n and v, as every isotropic BRDF is.
using ReflectanceOf = std::function<std::vector<Reflectance>(std::span<const DirectionPair>)>;

/// `cos_view` in 0 < n.v <= 1; `tolerance` for the error. What single precision leaves, some 3e-7 of the value, comes on top.
Albedo directional_albedo(const Brdf& brdf, double cos_view, double tolerance = 1e-6);

/// Of many directions to the viewer at once, which is faster: the device is asked for more pairs at a time.
std::vector<LobeAlbedos> directional_albedos(const ReflectanceOf& reflectance, std::span<const double> cos_views, double tolerance = 1e-6);

}  // namespace relume
