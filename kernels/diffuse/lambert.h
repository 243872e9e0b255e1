// Lambert: the same in every direction. Lambert 1760, "Photometria".
#ifndef RELUME_LAMBERT_H
#define RELUME_LAMBERT_H

#include "kernels/cosines.h"
#include "kernels/surface.h"

/// f_r n.l = albedo/pi n.l
RELUME_FN real3 diffuse_lambert(Cosines c, Surface s) { return scale3(s.albedo, c.n_l * RELUME_INVERSE_PI); }

#endif
