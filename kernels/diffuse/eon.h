// EON: Portsmouth, Kutz and Hill 2024, "EON: A Practical Energy-Preserving Rough Diffuse BRDF" (Fujii's Oren-Nayar plus what scatters more than
// once).
#ifndef RELUME_EON_H
#define RELUME_EON_H

#include "kernels/cosines.h"
#include "kernels/math.h"
#include "kernels/surface.h"

#define RELUME_EON_C1 0.28779340921062135f  // 1/2 - 2/(3 pi)
#define RELUME_EON_C2 0.07248821245692394f  // 2/3 - 28/(15 pi)

/// c1 - G(m)/pi, so that the single-scattering albedo is E = 1 - r (c1 - G/pi)/(1 + c1 r). G by the paper's exact form,
/// sin (theta - sin cos) + 2/3 (sin/cos (1 - sin^3) - sin), with 1 - sin^3 = cos^2 (1 + sin + sin^2)/(1 + sin): no division by a cosine of 0.
RELUME_FN real eon_missing(real n_w) {
  const real m = smaller(n_w, all_lanes(1.0f));
  const real sine = square_root((1.0f - m) * (1.0f + m));
  const real slope = m * (1.0f + sine + sine * sine) / (1.0f + sine) - 1.0f;
  const real g = sine * ((arc_cosine(m) - sine * m) + (2.0f / 3.0f) * slope);
  return RELUME_EON_C1 - g * RELUME_INVERSE_PI;
}

RELUME_FN real eon_multiple(real albedo, real average) { return albedo * albedo * average / (1.0f - albedo * (1.0f - average)); }

/// f_r = albedo/pi A (1 + r t) + rho_m/pi (1 - E(l))(1 - E(v))/(1 - average E), t = s/max(n.l, n.v) where s = l.v - (n.l)(n.v) > 0, else s.
/// The last fraction has r A in each bracket: with it taken out, r = 0 is no 0/0.
RELUME_FN real3 diffuse_eon(Cosines c, Surface s) {
  const real r = s.sigma_r;
  const real flat = 1.0f / (1.0f + RELUME_EON_C1 * r);
  const real far = 0.5f * c.sum2 - c.n_l * c.n_v;  // 1 + l.v - (n.l)(n.v), accurate where l is nearly opposite to v and the lobe nearly 0
  const real side = far - 1.0f;
  const real average = flat * (1.0f + RELUME_EON_C2 * r);
  const real lost = flat * r * (1.0f / (RELUME_EON_C1 - RELUME_EON_C2)) * (eon_missing(c.n_l) * eon_missing(c.n_v));
  const real once = flat * choose(side > 0.0f, 1.0f + r * (side / larger(c.n_l, c.n_v)), (1.0f - r) + r * far);
  const real3 again = real3_of(eon_multiple(s.albedo.x, average), eon_multiple(s.albedo.y, average), eon_multiple(s.albedo.z, average));
  return scale3(add3(scale3(s.albedo, once), scale3(again, lost)), c.n_l * RELUME_INVERSE_PI);
}

#endif
