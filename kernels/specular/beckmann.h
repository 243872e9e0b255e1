// Beckmann microfacets with Smith's shadowing, D G F/(4 n.l n.v): Walter et al. 2007; Mitsuba's and PBRT's rough surfaces.
#ifndef RELUME_BECKMANN_H
#define RELUME_BECKMANN_H

#include "kernels/fresnel/fresnel.h"
#include "kernels/microfacet/beckmann.h"
#include "kernels/microfacet/width.h"

/// f_r n.l = D G F/(4 n.v)
RELUME_FN real3 specular_beckmann(Cosines c, Surface s) {
  const real alpha = width_of(s);
  return scale3(fresnel_of(s, v_h(c)), beckmann_distribution(c, alpha) * beckmann_visibility(s.shadowing, c, alpha));
}

#endif
