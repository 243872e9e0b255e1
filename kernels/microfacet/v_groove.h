// V-groove shadowing and masking: Torrance and Sparrow 1967; Cook and Torrance 1982, "A Reflectance Model for Computer Graphics".
#ifndef RELUME_V_GROOVE_H
#define RELUME_V_GROOVE_H

#include "kernels/cosines.h"

/// G/(4 n.v), G = min(1, 2 n.h n.v/v.h, 2 n.h n.l/v.h); n.h/v.h = 2 (n.l + n.v)/|v+l|^2.
RELUME_FN real v_groove_visibility(Cosines c) {
  const real along = c.n_l + c.n_v;
  const real groove = 4.0f * along * smaller(c.n_l, c.n_v);
  return choose(groove < c.sum2, groove / c.sum2, all_lanes(1.0f)) * (0.25f / c.n_v);
}

#endif
