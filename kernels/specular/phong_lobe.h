// The cosine powers of Phong's and Blinn's lobes, from quantities that do not cancel near the peak.
#ifndef RELUME_PHONG_LOBE_H
#define RELUME_PHONG_LOBE_H

#include "kernels/cosines.h"
#include "kernels/math.h"

/// (R_v.l)^e, 0 where R_v.l <= 0. R_v.l = 1 - |R_v - l|^2/2.
RELUME_FN real phong_power(Cosines c, real e) { return choose(c.chord2 < 2.0f, exp_of(e * log1p_of(-0.5f * c.chord2)), all_lanes(0.0f)); }

/// (n.h)^e. (n.h)^2 = 1/(1 + tan^2).
RELUME_FN real blinn_power(Cosines c, real e) { return exp_of(-0.5f * e * log1p_of(c.tan2_h)); }

#endif
