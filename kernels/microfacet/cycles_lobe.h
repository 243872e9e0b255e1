// The single-bounce lobe that Cycles' glossy closures share, with its alpha and the least roughness that it lights.
#ifndef RELUME_CYCLES_LOBE_H
#define RELUME_CYCLES_LOBE_H

#include "kernels/microfacet/beckmann.h"
#include "kernels/microfacet/ggx.h"
#include "kernels/surface.h"

/// D G/(4 n.v), height-correlated, alpha = roughness^2.
RELUME_FN real cycles_lobe(Cosines c, Surface s) {
  const real alpha = clamped(s.roughness * s.roughness, 1e-5f, 1.0f);
  const real ggx = ggx_distribution(c, alpha) * ggx_smith_visibility(c, alpha);
  const real lobe = s.distribution == DISTRIBUTION_beckmann ? beckmann_distribution(c, alpha) * beckmann_smith_visibility(c, alpha) : ggx;
  // Up to this Cycles takes the surface for a mirror (roughness^4 <= 2e-10), which shows no light that is a point.
  return choose(alpha * alpha > 2e-10f, lobe, all_lanes(0.0f));
}

#endif
