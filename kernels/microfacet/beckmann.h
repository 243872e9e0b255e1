// Beckmann's distribution of normals with Smith's shadowing by the rational fit of Walter, Marschner, Li and Torrance 2007,
// "Microfacet Models for Refraction through Rough Surfaces"; height-correlated: Heitz 2014.
#ifndef RELUME_MICROFACET_BECKMANN_H
#define RELUME_MICROFACET_BECKMANN_H

#include "kernels/choice.h"
#include "kernels/cosines.h"
#include "kernels/math.h"
#include "kernels/microfacet/v_groove.h"

/// D = exp(-tan^2/a^2)/(pi a^2 cos^4)
RELUME_FN real beckmann_distribution(Cosines c, real alpha) {
  const real scale = 1.0f / (alpha * alpha);
  // Where tan^2 is beyond 1e8 the exponential is 0 for every alpha up to 1000, and (1 + tan^2)^2 must not overflow against it.
  const real tan2 = smaller(c.tan2_h, all_lanes(1e8f));
  return (scale * RELUME_INVERSE_PI) * exp_up_to_89(tan2 * -scale) * squared(1.0f + tan2);
}

/// Lambda(w) as a fraction, from G1 = 1/(1 + Lambda) = (3.535 a + 2.181 a^2)/(1 + 2.276 a + 2.577 a^2) for a = 1/(alpha tan) < 1.6, else 1.
typedef struct {
  real above, below;
} BeckmannLambda;

RELUME_FN BeckmannLambda beckmann_lambda(real n_w, real alpha) {
  const real y = alpha * square_root(larger((1.0f - n_w) * (1.0f + n_w), all_lanes(0.0f)));  // a = n_w/y, kept as a fraction: y may be 0
  const mask flat = n_w >= 1.6f * y;
  BeckmannLambda lambda;
  lambda.above = choose(flat, all_lanes(0.0f), y * (y - 1.259f * n_w) + 0.396f * (n_w * n_w));
  lambda.below = choose(flat, all_lanes(1.0f), n_w * (3.535f * y + 2.181f * n_w));
  return lambda;
}

/// G/(4 n.v) with G = 1/(1 + Lambda(l) + Lambda(v))
RELUME_FN real beckmann_smith_visibility(Cosines c, real alpha) {
  const BeckmannLambda l = beckmann_lambda(c.n_l, alpha);
  const BeckmannLambda v = beckmann_lambda(c.n_v, alpha);
  return l.below / (4.0f * c.n_v * ((1.0f + v.above / v.below) * l.below + l.above));
}

/// G/(4 n.v) with G = G1(l) G1(v)
RELUME_FN real beckmann_smith_separable_visibility(Cosines c, real alpha) {
  const BeckmannLambda l = beckmann_lambda(c.n_l, alpha);
  const BeckmannLambda v = beckmann_lambda(c.n_v, alpha);
  return l.below / (4.0f * c.n_v * ((1.0f + v.above / v.below) * (l.below + l.above)));
}

RELUME_FN real beckmann_visibility(int shadowing, Cosines c, real alpha) {
  switch (shadowing) {
    case SHADOWING_v_groove:
      return v_groove_visibility(c);
    case SHADOWING_smith_separable:
      return beckmann_smith_separable_visibility(c, alpha);
    default:
      return beckmann_smith_visibility(c, alpha);
  }
}

#endif
