// Lambert as lectures have it: reflected light is Kd n.l, without 1/pi. Lambert 1760, "Photometria".
#ifndef RELUME_LAMBERT_ORIGINAL_H
#define RELUME_LAMBERT_ORIGINAL_H

#include "kernels/cosines.h"
#include "kernels/surface.h"

/// f_r n.l = Kd n.l
RELUME_FN real3 diffuse_lambert_original(Cosines c, Surface s) { return scale3(s.kd, c.n_l); }

#endif
