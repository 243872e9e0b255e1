// A diffuse base under a dielectric surface, smooth or rough, as Mitsuba 3's plastic and roughplastic have it.
#ifndef RELUME_PLASTIC_H
#define RELUME_PLASTIC_H

#include "kernels/cosines.h"
#include "kernels/fresnel/dielectric.h"
#include "kernels/surface.h"

/// Light that enters a rough surface: the material's table (host/rough_transmittance) at i/63, linear between. For s.transmittance >= 0.
RELUME_FN real rough_plastic_transmittance(Surface s, real cosine) {
  const real x = clamped(cosine, 0.0f, 1.0f) * 63.0f;
  const real below = smaller(whole_below(x), all_lanes(62.0f));
  const integer at = to_integer(larger(s.transmittance, all_lanes(0.0f)) + below);
  const real low = gather(s.tables, at);
  return low + (gather(s.tables, at + 1) - low) * (x - below);
}

RELUME_FN real plastic_transmittance(Surface s, real cosine) {
  const real smooth = dielectric_transmittance(s.ior, larger(cosine, all_lanes(0.0f)));
  const mask rough = s.transmittance >= 0.0f;
  if (!any_of(rough)) return smooth;
  return choose(rough, rough_plastic_transmittance(s, cosine), smooth);
}

/// What a surface throws back of the diffuse light inside: the rough one's comes with its table, the smooth one's is the fit of
/// Egan and Hilgeman 1973, "Diffuse Reflection", in 1/ior.
RELUME_FN real plastic_internal_reflectance(Surface s) {
  const real x = 1.0f / s.ior;
  // The fit was made for ior up to about 2 and passes 1 before 4, where the exact value is 0.96.
  const real smooth = smaller((-1.4399f * x + 0.7099f) * x + 0.6681f + 0.0636f * s.ior, all_lanes(0.96f));
  return choose(s.transmittance >= 0.0f, s.fdr, smooth);
}

/// f_r = albedo/(1 - fdr) T(l) T(v)/(pi ior^2); nonlinear: what is thrown back inside is coloured again, albedo/(1 - albedo fdr).
RELUME_FN real3 diffuse_plastic(Cosines c, Surface s) {
  const real fdr = plastic_internal_reflectance(s);
  const real3 kept = choose3(s.nonlinear > 0.5f, scale3(s.albedo, fdr), grey(fdr));
  const real3 base = divide3(s.albedo, subtract3(grey(all_lanes(1.0f)), kept));
  const real entering = plastic_transmittance(s, c.n_l) * s.entering;
  return scale3(base, (RELUME_INVERSE_PI / (s.ior * s.ior)) * (c.n_l * entering));
}

#endif
