// Exact Fresnel reflectance of a conductor, unpolarised: Born and Wolf, "Principles of Optics", 14.2, as arranged by Lagarde 2013, "Memo on Fresnel
// equations".
#ifndef RELUME_CONDUCTOR_H
#define RELUME_CONDUCTOR_H

#include "kernels/surface.h"

/// a + ib is the complex cosine inside times the index: a^2 - b^2 = eta^2 - k^2 - sin^2, a b = eta k.
RELUME_FN real conductor_reflectance(real eta, real k, real c) {
  const real c2 = c * c;
  const real sin2 = 1.0f - c2;
  const real a2_less_b2 = eta * eta - k * k - sin2;
  const real ab = eta * k;
  const real a2_plus_b2 = square_root(a2_less_b2 * a2_less_b2 + 4.0f * (ab * ab));
  // For metals a is the smaller of the two, and as a difference it would cancel: silver would lose three bits.
  const real greater = square_root(0.5f * (a2_plus_b2 + absolute(a2_less_b2)));
  const real a = choose(a2_less_b2 >= 0.0f, greater, ab / greater);
  const real cross = 2.0f * (a * c);
  const real level = a2_plus_b2 + c2;
  const real s = (level - cross) / (level + cross);
  const real level_p = c2 * a2_plus_b2 + sin2 * sin2;
  const real cross_p = cross * sin2;
  return 0.5f * s * (1.0f + (level_p - cross_p) / (level_p + cross_p));
}

RELUME_FN real3 fresnel_conductor(Surface s, real v_h) {
  return real3_of(conductor_reflectance(s.eta.x, s.k.x, v_h), conductor_reflectance(s.eta.y, s.k.y, v_h), conductor_reflectance(s.eta.z, s.k.z, v_h));
}

#endif
