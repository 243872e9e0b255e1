// Cycles' diffuse: Lambert, or Fujii's Oren-Nayar (mimosa-pudica.net, "A tiny improvement of Oren-Nayar reflectance model") with the
// multiple scattering of OpenPBR where there is a roughness.
#ifndef RELUME_DIFFUSE_CYCLES_H
#define RELUME_DIFFUSE_CYCLES_H

#include "kernels/cosines.h"
#include "kernels/math.h"
#include "kernels/surface.h"

/// G(c) = sin (acos c - 2/3 - sin c) + 2/3 sin/c (1 - sin^3); the last factor is c^2 (1 + sin + sin^2)/(1 + sin), which needs no division by c.
RELUME_FN real fujii_g(real cosine) {
  const real c = clamped(cosine, 0.0f, 1.0f);
  const real sine = square_root((1.0f - c) * (1.0f + c));
  const real tail = c * (1.0f + sine + sine * sine) / (1.0f + sine);
  return sine * (arc_cosine(c) - 0.66666667f - sine * c + 0.66666667f * tail);
}

/// f_r = albedo (A + B t + M): one bounce A + B t, more bounces M = albedo^2/pi Ea/(1 - Ea)/(1 - albedo (1 - Ea)) (1 - E(v))(1 - E(l)),
/// E(w) = pi A + B G(w) the directional albedo of one bounce, Ea its mean.
RELUME_FN real3 fujii_reflectance(Cosines c, Surface s, real roughness) {
  const real n_v = larger(c.n_v, all_lanes(0.0f));
  const real a = 1.0f / (RELUME_PI + roughness * (0.5f * RELUME_PI - 0.66666667f));
  const real b = roughness * a;
  const real t = c.l_v - c.n_l * n_v;
  const real one_bounce = a + b * choose(t > 0.0f, t / larger(c.n_l, n_v), t);
  // 1 - pi A, not pi A, in 1 - E: it is small where the surface is nearly smooth.
  const real lost = b * (0.5f * RELUME_PI - 0.66666667f);
  const real mean_lost = lost - b * ((2.0f * RELUME_PI - 5.6f) / 3.0f);
  const real apart = (lost - b * fujii_g(n_v)) * (lost - b * fujii_g(c.n_l));
  const real scale = RELUME_INVERSE_PI * (1.0f - mean_lost) / mean_lost * apart;
  const real3 more_bounces = divide3(scale3(multiply3(s.albedo, s.albedo), scale), subtract3(grey(all_lanes(1.0f)), scale3(s.albedo, mean_lost)));
  return multiply3(s.albedo, add3(grey(one_bounce), more_bounces));
}

RELUME_FN real3 diffuse_cycles(Cosines c, Surface s) {
  const real3 lambert = scale3(s.albedo, c.n_l * RELUME_INVERSE_PI);
  const real roughness = clamped(s.diffuse_roughness, 0.0f, 1.0f);
  const mask rough = roughness >= 1e-5f;  // below it Cycles takes Lambert
  if (!any_of(rough)) return lambert;
  return choose3(rough, scale3(fujii_reflectance(c, s, roughness), c.n_l), lambert);
}

#endif
