// Phong 1975, "Illumination for Computer Generated Pictures", as lectures have it: reflected light is Ks (R_v.l)^e, with no n.l.
#ifndef RELUME_PHONG_ORIGINAL_H
#define RELUME_PHONG_ORIGINAL_H

#include "kernels/specular/phong_lobe.h"
#include "kernels/surface.h"

/// f_r n.l = Ks (R_v.l)^e
RELUME_FN real3 specular_phong_original(Cosines c, Surface s) { return scale3(s.ks, phong_power(c, s.exponent)); }

#endif
