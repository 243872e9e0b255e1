// Blinn-Phong normalised as a distribution of normals: Blinn 1977, with the norm of Lafortune and Willems 1994.
#ifndef RELUME_BLINN_PHONG_H
#define RELUME_BLINN_PHONG_H

#include "kernels/specular/phong_lobe.h"
#include "kernels/surface.h"

/// f_r n.l = Ks (e+2)/(2 pi) (n.h)^e n.l
RELUME_FN real3 specular_blinn_phong(Cosines c, Surface s) {
  const real norm = (s.exponent + 2.0f) * (0.5f * RELUME_INVERSE_PI);
  return scale3(s.ks, norm * blinn_power(c, s.exponent) * c.n_l);
}

#endif
