// Blinn-Phong normalised as a reflectance: Blinn 1977, with the norm of Giesen 2009, "Phong and Blinn-Phong Normalization Factors".
#ifndef RELUME_BLINN_PHONG_EXACT_H
#define RELUME_BLINN_PHONG_EXACT_H

#include "kernels/specular/phong_lobe.h"
#include "kernels/surface.h"

/// f_r n.l = Ks (e+2)(e+4)/(8 pi (2^(-e/2) + e)) (n.h)^e n.l: all of Ks is reflected at normal incidence.
RELUME_FN real3 specular_blinn_phong_exact(Cosines c, Surface s) {
  const real e = s.exponent;
  const real norm = (e + 2.0f) * (e + 4.0f) / (exp_of(e * -0.34657359f) + e) * (0.125f * RELUME_INVERSE_PI);  // ln 2/2
  return scale3(s.ks, norm * blinn_power(c, e) * c.n_l);
}

#endif
