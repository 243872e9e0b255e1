// Exact Fresnel reflectance of a dielectric, unpolarised, in the form of Cook and Torrance 1982, "A Reflectance Model for Computer Graphics".
#ifndef RELUME_DIELECTRIC_H
#define RELUME_DIELECTRIC_H

#include "kernels/surface.h"

/// F = 1/2 ((g-c)/(g+c))^2 (1 + ((c(g+c)-1)/(c(g-c)+1))^2), g^2 = ior^2 - 1 + c^2, c = v.h; 1 under total reflection (ior < 1).
RELUME_FN real dielectric_reflectance(real ior, real c) {
  const real contrast = (ior - 1.0f) * (ior + 1.0f);
  const real g2 = contrast + c * c;
  const real g = square_root(larger(g2, all_lanes(0.0f)));
  const real sum = larger(g + c, all_lanes(1e-15f));  // 0 only at ior = 1 and c = 0; its square must not vanish
  const real difference = contrast / sum;             // g - c, which cancels where ior is near 1
  const real s = difference / sum;
  const real p = (c * sum - 1.0f) / (c * difference + 1.0f);
  const real f = smaller(0.5f * (s * s) * (1.0f + p * p), all_lanes(1.0f));  // rounding must not leave less than nothing to enter
  return choose(g2 > 0.0f, f, choose(ior < 1.0f, all_lanes(1.0f), all_lanes(0.0f)));
}

/// 1 - F where light enters the denser side (ior >= 1), without the cancellation at grazing angles, where it goes to 0:
/// 2 c g (1/(c+g)^2 + (ior/(ior^2 c + g))^2).
RELUME_FN real dielectric_transmittance(real ior, real c) {
  const real g = square_root((ior - 1.0f) * (ior + 1.0f) + c * c);
  const real s = 1.0f / larger(c + g, all_lanes(1e-15f));  // 0 only at ior = 1 and c = 0
  const real p = ior / larger(ior * ior * c + g, all_lanes(1e-15f));
  return 2.0f * c * g * (s * s + p * p);
}

RELUME_FN real3 fresnel_dielectric(Surface s, real v_h) { return grey(dielectric_reflectance(s.ior, v_h)); }

#endif
