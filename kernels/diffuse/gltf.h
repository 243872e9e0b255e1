// glTF 2.0, appendix B: the diffuse part of metal-rough materials, what the dielectric surface above it lets through; a metal has none.
#ifndef RELUME_GLTF_H
#define RELUME_GLTF_H

#include "kernels/cosines.h"
#include "kernels/fresnel/schlick.h"
#include "kernels/surface.h"

/// f_r = albedo/pi (1 - metallic)(1 - F), F Schlick's of the dielectric: its largest channel, so that no channel gains (KHR_materials_specular)
RELUME_FN real3 diffuse_gltf(Cosines c, Surface s) {
  const real3 fresnel = mix3(s.f0, s.f90, schlick_weight(v_h(c)));
  const real reflected = larger(larger(fresnel.x, fresnel.y), fresnel.z);
  return scale3(s.albedo, (c.n_l * RELUME_INVERSE_PI) * (1.0f - s.metallic) * (1.0f - reflected));
}

#endif
