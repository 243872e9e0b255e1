// The surface of a Principled BSDF from the colour passes, where a Blender file stores neither base colour nor metallic nor specular level.
#pragma once

#include <array>

namespace relume {

/// What the lobe `cycles_principled` needs beside the roughness, for ior 1.5.
struct CyclesSurface {
  std::array<double, 3> base_color;
  double metallic;
  double specular_level;
};

/// `glossy_albedo`, `diffuse_albedo`: GlossCol and DiffCol of a pixel; `multi_ggx`: its distribution, else plain GGX.
/// Grey surfaces can be a bright dielectric or partly metal alike: up to twice the usual specular level they are taken for dielectrics.
CyclesSurface solve_cycles_surface(const std::array<double, 3>& glossy_albedo, const std::array<double, 3>& diffuse_albedo, double roughness,
                                   double n_v, bool multi_ggx);

}  // namespace relume
