// Blinn 1977, "Models of Light Reflection for Computer Synthesized Pictures", as lectures have it: reflected light is Ks (n.h)^e, with no n.l.
#ifndef RELUME_BLINN_PHONG_ORIGINAL_H
#define RELUME_BLINN_PHONG_ORIGINAL_H

#include "kernels/specular/phong_lobe.h"
#include "kernels/surface.h"

/// f_r n.l = Ks (n.h)^e
RELUME_FN real3 specular_blinn_phong_original(Cosines c, Surface s) { return scale3(s.ks, blinn_power(c, s.exponent)); }

#endif
