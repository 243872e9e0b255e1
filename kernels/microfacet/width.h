// The slope width that microfacet lobes divide by.
#ifndef RELUME_WIDTH_H
#define RELUME_WIDTH_H

#include "kernels/surface.h"

/// alpha, at least 1e-4: at 0 a lobe is a mirror, which no light of a point's size can be seen in, and 1e-4 radians is about the step of a normal
/// stored as half.
RELUME_FN real width_of(Surface s) { return larger(s.alpha, all_lanes(1e-4f)); }

#endif
