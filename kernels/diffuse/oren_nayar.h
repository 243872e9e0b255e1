// Oren and Nayar 1994, "Generalization of Lambert's Reflectance Model": the qualitative model.
#ifndef RELUME_OREN_NAYAR_H
#define RELUME_OREN_NAYAR_H

#include "kernels/cosines.h"
#include "kernels/surface.h"

/// f_r = albedo/pi (A + B max(0, cos(phi_l - phi_v)) sin(a) tan(b)), a and b the larger and smaller of the angles to n.
/// sin(a) sin(b) cos(phi_l - phi_v) = l.v - (n.l)(n.v), so no angle is needed, and b's cosine is the larger one.
RELUME_FN real3 diffuse_oren_nayar(Cosines c, Surface s) {
  const real sigma2 = s.sigma * s.sigma;
  const real flat = 1.0f - 0.5f * sigma2 / (sigma2 + 0.33f);
  const real rough = 0.45f * sigma2 / (sigma2 + 0.09f);
  const real same_side = larger(c.l_v - c.n_l * c.n_v, all_lanes(0.0f)) / larger(c.n_l, c.n_v);
  return scale3(s.albedo, (c.n_l * RELUME_INVERSE_PI) * (flat + rough * same_side));
}

#endif
