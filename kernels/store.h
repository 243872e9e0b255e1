// What a pixel's light is written with: finite numbers, in the lanes of a mask.
#ifndef RELUME_STORE_H
#define RELUME_STORE_H

#include "kernels/vector.h"

/// What is written is finite: NaN (a parameter was NaN) becomes 0, what overflows becomes the largest float.
RELUME_FN real finite(real x) { return choose(x == x, clamped(x, -3.4e38f, 3.4e38f), all_lanes(0.0f)); }

RELUME_FN void store_where(mask m, real3 value, RELUME_GLOBAL float* out, int stride, int plane, int i) {
  if (plane < 0) return;
  RELUME_GLOBAL float* p = out + (size_t)stride * plane + i;
  if (!any_of(!m)) {
    store_past_cache(finite(value.x), p);
    store_past_cache(finite(value.y), p + stride);
    store_past_cache(finite(value.z), p + 2 * (size_t)stride);
    return;
  }
  store(choose(m, finite(value.x), load(p)), p);
  store(choose(m, finite(value.y), load(p + stride)), p + stride);
  store(choose(m, finite(value.z), load(p + 2 * (size_t)stride)), p + 2 * (size_t)stride);
}

#endif
