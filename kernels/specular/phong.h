// Phong made plausible: Lafortune and Willems 1994, "Using the Modified Phong Reflectance Model for Physically Based Rendering".
#ifndef RELUME_PHONG_H
#define RELUME_PHONG_H

#include "kernels/specular/phong_lobe.h"
#include "kernels/surface.h"

/// f_r n.l = Ks (e+2)/(2 pi) (R_v.l)^e n.l: all of Ks is reflected at normal incidence.
RELUME_FN real3 specular_phong(Cosines c, Surface s) {
  const real norm = (s.exponent + 2.0f) * (0.5f * RELUME_INVERSE_PI);
  return scale3(s.ks, norm * phong_power(c, s.exponent) * c.n_l);
}

#endif
