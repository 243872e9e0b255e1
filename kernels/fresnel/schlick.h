// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering": f0 + (f90 - f0)(1 - v.h)^5; metallic mixes f0 with the base colour as
// glTF does.
#ifndef RELUME_SCHLICK_H
#define RELUME_SCHLICK_H

#include "kernels/surface.h"

/// (1 - x)^5, x clamped to 0..1
RELUME_FN real schlick_weight(real x) {
  const real m = clamped(1.0f - x, 0.0f, 1.0f);
  const real m2 = m * m;
  return m2 * m2 * m;
}

RELUME_FN real3 fresnel_schlick(Surface s, real v_h) {
  const real3 f0 = mix3(s.f0, s.albedo, s.metallic);
  const real m = 1.0f - v_h, m2 = m * m;  // v.h is in 0..1, but for its rounding
  return mix3(f0, s.f90, m2 * m2 * m);
}

#endif
