// Disney's tint: the hue and saturation of the base colour, at luminance 1. Burley 2012, "Physically-Based Shading at Disney".
#ifndef RELUME_TINT_H
#define RELUME_TINT_H

#include "kernels/surface.h"

/// White where the base colour is black; luminance is Rec. 709's with Mitsuba's digits.
RELUME_FN real3 base_tint(Surface s) {
  const real luminance = 0.212671f * s.albedo.x + 0.715160f * s.albedo.y + 0.072169f * s.albedo.z;
  return choose3(luminance > 0.0f, scale3(s.albedo, 1.0f / luminance), grey(all_lanes(1.0f)));
}

#endif
