// Light that a perturbed normal must not let through: bump and normal maps against the unperturbed normal.
// Estevez, Lecocq and Stein 2019, "A Microfacet-Based Shadowing Function to Solve the Bump Terminator Problem" (Ray Tracing Gems, ch. 12).
#ifndef RELUME_BUMP_H
#define RELUME_BUMP_H

#include "kernels/choice.h"
#include "kernels/surface.h"

/// tan^2 of the angle between unit vectors whose dot product is `cosine`.
RELUME_FN real tan2_of(real cosine) {
  const real c2 = larger(cosine * cosine, all_lanes(1e-12f));  // the paper's least cosine, 1e-6: infinity times an alpha of 0 would be NaN
  return larger(1.0f - c2, all_lanes(0.0f)) / c2;
}

RELUME_FN real bump_visibility(int rule, Surface s, real3 l) {
  const real base_l = dot3(s.base_n, l);
  real factor = choose(base_l > 0.0f, all_lanes(1.0f), all_lanes(0.0f));
  if (rule == BUMP_smith) {
    const real alpha2 = clamped(0.125f * tan2_of(dot3(s.base_n, s.n)), 0.0f, 1.0f);
    factor = factor * (2.0f / (1.0f + square_root(1.0f + alpha2 * tan2_of(base_l))));
  }
  return factor;
}

#endif
