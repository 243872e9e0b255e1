// Three reals: directions, positions and colours, with the algebra spelt out so that every compiler rounds alike.
#ifndef RELUME_VECTOR_H
#define RELUME_VECTOR_H

#include "kernels/language.h"

typedef struct {
  real x, y, z;
} real3;

RELUME_FN real3 real3_of(real x, real y, real z) {
  real3 r;
  r.x = x;
  r.y = y;
  r.z = z;
  return r;
}
RELUME_FN real3 grey(real x) { return real3_of(x, x, x); }
RELUME_FN real3 add3(real3 a, real3 b) { return real3_of(a.x + b.x, a.y + b.y, a.z + b.z); }
RELUME_FN real3 subtract3(real3 a, real3 b) { return real3_of(a.x - b.x, a.y - b.y, a.z - b.z); }
RELUME_FN real3 multiply3(real3 a, real3 b) { return real3_of(a.x * b.x, a.y * b.y, a.z * b.z); }
RELUME_FN real3 divide3(real3 a, real3 b) { return real3_of(a.x / b.x, a.y / b.y, a.z / b.z); }
RELUME_FN real3 scale3(real3 a, real s) { return real3_of(a.x * s, a.y * s, a.z * s); }
RELUME_FN real dot3(real3 a, real3 b) { return fused(a.z, b.z, fused(a.y, b.y, a.x * b.x)); }
/// a b + c
RELUME_FN real3 fused3(real3 a, real3 b, real3 c) { return real3_of(fused(a.x, b.x, c.x), fused(a.y, b.y, c.y), fused(a.z, b.z, c.z)); }
/// a + b s
RELUME_FN real3 add_scaled3(real3 a, real3 b, real s) { return real3_of(fused(b.x, s, a.x), fused(b.y, s, a.y), fused(b.z, s, a.z)); }
RELUME_FN real3 choose3(mask m, real3 a, real3 b) { return real3_of(choose(m, a.x, b.x), choose(m, a.y, b.y), choose(m, a.z, b.z)); }
/// a + (b - a) t
RELUME_FN real3 mix3(real3 a, real3 b, real t) { return add_scaled3(a, subtract3(b, a), t); }
RELUME_FN real3 unit3(real3 a) { return scale3(a, 1.0f / square_root(dot3(a, a))); }

RELUME_FN real larger(real a, real b) { return choose(a > b, a, b); }   // b where a is NaN
RELUME_FN real smaller(real a, real b) { return choose(a < b, a, b); }  // b where a is NaN
RELUME_FN real clamped(real x, float low, float high) { return smaller(larger(x, all_lanes(low)), all_lanes(high)); }
RELUME_FN real squared(real x) { return x * x; }

#define RELUME_PI 3.14159265358979323846f
#define RELUME_INVERSE_PI 0.31830988618379067154f

#endif
