// Burley 2012, "Physically-Based Shading at Disney": the diffuse lobe, brighter at grazing angles the rougher it is.
#ifndef RELUME_BURLEY_H
#define RELUME_BURLEY_H

#include "kernels/cosines.h"
#include "kernels/fresnel/schlick.h"
#include "kernels/surface.h"

/// f_r = albedo/pi (1 + (F90 - 1)(1 - n.l)^5)(1 + (F90 - 1)(1 - n.v)^5), F90 = 1/2 + 2 roughness (v.h)^2
RELUME_FN real3 diffuse_burley(Cosines c, Surface s) {
  const real rise = 0.5f * s.roughness * c.sum2 - 0.5f;  // F90 - 1; (v.h)^2 is |v+l|^2/4
  const real light = 1.0f + rise * schlick_weight(c.n_l);
  const real view = 1.0f + rise * schlick_weight(c.n_v);
  return scale3(s.albedo, (c.n_l * RELUME_INVERSE_PI) * light * view);
}

#endif
