// Cook and Torrance 1982, "A Reflectance Model for Computer Graphics": Beckmann's D, V-groove G, Fresnel, in today's normalisation D G F/(4 n.l n.v)
// (the paper's own, with its D without 1/pi over pi n.l n.v, is four times as bright and reflects more than arrives).
#ifndef RELUME_COOK_TORRANCE_H
#define RELUME_COOK_TORRANCE_H

#include "kernels/fresnel/fresnel.h"
#include "kernels/microfacet/beckmann.h"
#include "kernels/microfacet/width.h"

/// f_r n.l = D G F/(4 n.v)
RELUME_FN real3 specular_cook_torrance(Cosines c, Surface s) {
  const real alpha = width_of(s);
  return scale3(fresnel_of(s, v_h(c)), beckmann_distribution(c, alpha) * beckmann_visibility(s.shadowing, c, alpha));
}

#endif
