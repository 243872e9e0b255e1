// Cycles' Principled BSDF: the metal and dielectric highlights with their Fresnel terms, as Blender 4.5 and 5.0 have them.
#ifndef RELUME_CYCLES_PRINCIPLED_H
#define RELUME_CYCLES_PRINCIPLED_H

#include "kernels/fresnel/dielectric.h"
#include "kernels/fresnel/schlick.h"
#include "kernels/microfacet/cycles_lobe.h"
#include "kernels/microfacet/multi_ggx.h"

/// Reflectance at normal incidence: specular_level scales that of the ior, 1/2 leaves it.
RELUME_FN real cycles_f0(Surface s) {
  const real f0 = 2.0f * s.specular_level * squared((s.ior - 1.0f) / (s.ior + 1.0f));
  return clamped(f0, 0.0f, 0.99f);  // Cycles' most
}

/// The lobes' weights by the later bounces: per channel the metal's, and the dielectric's.
typedef struct {
  real3 metal;
  real dielectric;
} CyclesGain;

/// Mean Fresnel over the hemisphere: Schlick's is b + (1 - b)/21; the dielectric's is Kulla and Conty's fit, (eta - 1)/(4.08567 + 1.00071 eta).
RELUME_FN CyclesGain cycles_gain(Surface s, real3 base, real f0, real eta) {
  const real albedo = s.one_bounce;
  const real mean = s.one_bounce_mean;
  const real3 metal = mix3(base, grey(all_lanes(1.0f)), all_lanes(1.0f / 21.0f));
  CyclesGain gain;
  gain.metal = real3_of(multi_ggx_gain(albedo, mean, metal.x), multi_ggx_gain(albedo, mean, metal.y), multi_ggx_gain(albedo, mean, metal.z));
  gain.dielectric = multi_ggx_gain(albedo, mean, clamped(larger((eta - 1.0f) / (4.08567f + 1.00071f * eta), f0), 0.0f, 1.0f));
  return gain;
}

RELUME_FN real3 specular_cycles_principled(Cosines c, Surface s) {
  const real f0 = cycles_f0(s);
  const real eta = (1.0f + square_root(f0)) / (1.0f - square_root(f0));
  const real3 base = real3_of(clamped(s.base_color.x, 0.0f, 1.0f), clamped(s.base_color.y, 0.0f, 1.0f), clamped(s.base_color.z, 0.0f, 1.0f));
  const real h = v_h(c);
  real3 metal = mix3(base, grey(all_lanes(1.0f)), schlick_weight(h));
  real dielectric = dielectric_reflectance(eta, h);
  if (s.distribution == DISTRIBUTION_multi_ggx) {
    const CyclesGain gain = cycles_gain(s, base, f0, eta);
    metal = multiply3(metal, gain.metal);
    dielectric = dielectric * gain.dielectric;
  }
  return scale3(mix3(grey(dielectric), metal, clamped(s.metallic, 0.0f, 1.0f)), cycles_lobe(c, s));
}

#endif
