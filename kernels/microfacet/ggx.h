// GGX: Walter, Marschner, Li and Torrance 2007, "Microfacet Models for Refraction through Rough Surfaces"; height-correlated Smith: Heitz 2014,
// "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs".
#ifndef RELUME_MICROFACET_GGX_H
#define RELUME_MICROFACET_GGX_H

#include "kernels/choice.h"
#include "kernels/cosines.h"
#include "kernels/microfacet/v_groove.h"

/// D = a^2/(pi cos^4 (a^2 + tan^2)^2); with both sides of the fraction times |v+l|^2 cos^2 nothing is divided twice and grazing angles stay finite.
RELUME_FN real ggx_distribution(Cosines c, real alpha) {
  const real alpha2 = alpha * alpha;
  return (alpha2 * RELUME_INVERSE_PI) * squared(c.sum2 / (c.across2 + alpha2 * c.along2));
}

/// cos sqrt(1 + a^2 tan^2): n.w (1 + 2 Lambda(w))
RELUME_FN real ggx_stretched(real n_w, real alpha) {
  const real alpha2 = alpha * alpha;
  return square_root(alpha2 + (1.0f - alpha2) * (n_w * n_w));
}

/// G/(4 n.v) with G = 1/(1 + Lambda(l) + Lambda(v)): light and view are hidden together.
RELUME_FN real ggx_smith_visibility(Cosines c, real alpha) {
  return 0.5f * c.n_l / (c.n_l * ggx_stretched(c.n_v, alpha) + c.n_v * ggx_stretched(c.n_l, alpha));
}

/// G/(4 n.v) with G = G1(l) G1(v): light and view are hidden independently.
RELUME_FN real ggx_smith_separable_visibility(Cosines c, real alpha) {
  return c.n_l / ((c.n_l + ggx_stretched(c.n_l, alpha)) * (c.n_v + ggx_stretched(c.n_v, alpha)));
}

RELUME_FN real ggx_visibility(int shadowing, Cosines c, real alpha) {
  switch (shadowing) {
    case SHADOWING_v_groove:
      return v_groove_visibility(c);
    case SHADOWING_smith_separable:
      return ggx_smith_separable_visibility(c, alpha);
    default:
      return ggx_smith_visibility(c, alpha);
  }
}

#endif
