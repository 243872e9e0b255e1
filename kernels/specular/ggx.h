// GGX microfacets, D G F/(4 n.l n.v): Walter et al. 2007; the specular lobe of glTF's metal-rough model.
#ifndef RELUME_GGX_H
#define RELUME_GGX_H

#include "kernels/fresnel/fresnel.h"
#include "kernels/microfacet/ggx.h"
#include "kernels/microfacet/width.h"

/// f_r n.l = D G F/(4 n.v)
RELUME_FN real3 specular_ggx(Cosines c, Surface s) {
  const real alpha = width_of(s);
  return scale3(fresnel_of(s, v_h(c)), ggx_distribution(c, alpha) * ggx_visibility(s.shadowing, c, alpha));
}

#endif
