// The cosine powers of Phong's and Blinn's lobes, from quantities that do not cancel near the peak.
#ifndef RELUME_PHONG_LOBE_H
#define RELUME_PHONG_LOBE_H

#include "kernels/cosines.h"
#include "kernels/math.h"

/// (R_v.l)^e, 0 where R_v.l <= 0. Towards the peak from R_v.l = 1 - |R_v - l|^2/2, towards the side from R_v.l itself: log x = -log(1 + (1/x - 1)).
RELUME_FN real phong_power(Cosines c, real e) {
  const mask aside = c.chord2 > 1.0f;
  const real inverse = 1.0f / larger(c.r_l, all_lanes(1e-30f));
  const real log_cosine = log1p_of(choose(aside, inverse - 1.0f, -0.5f * c.chord2));
  return choose(c.r_l > 0.0f, exp_of(e * choose(aside, -log_cosine, log_cosine)), all_lanes(0.0f));
}

/// (n.h)^e. (n.h)^2 = 1/(1 + tan^2).
RELUME_FN real blinn_power(Cosines c, real e) { return exp_of(-0.5f * e * log1p_of(c.tan2_h)); }

#endif
