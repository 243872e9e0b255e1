// The energy that a single-bounce GGX loses, given back as Cycles does: Kulla and Conty 2017, "Revisiting Physically Based Shading at Imageworks",
// scaled into the single-bounce lobe. All of it depends on the pixel alone.
#ifndef RELUME_MULTI_GGX_H
#define RELUME_MULTI_GGX_H

#include "kernels/cycles_tables.h"
#include "kernels/surface.h"

/// Share of light from the viewer's direction that one bounce reflects: E(roughness, n.v), bilinear as in Cycles.
RELUME_FN real multi_ggx_albedo(Surface s) {
  const float last = RELUME_CYCLES_TABLE_SIDE - 1;
  const real x = clamped(s.roughness, 0.0f, 1.0f) * last;
  const real y = clamped(s.n_v, 0.0f, 1.0f) * last;
  const real left = smaller(whole_below(x), all_lanes(last - 1.0f));
  const real below = smaller(whole_below(y), all_lanes(last - 1.0f));
  const real t = x - left;
  const integer at = to_integer(below * (float)RELUME_CYCLES_TABLE_SIDE + left) + RELUME_CYCLES_E_START;
  const integer above = at + RELUME_CYCLES_TABLE_SIDE;
  const real low = gather(s.tables, at) * (1.0f - t) + gather(s.tables, at + 1) * t;
  const real high = gather(s.tables, above) * (1.0f - t) + gather(s.tables, above + 1) * t;
  return low + (high - low) * (y - below);
}

/// The same for light from everywhere.
RELUME_FN real multi_ggx_mean_albedo(Surface s) {
  const float last = RELUME_CYCLES_TABLE_SIDE - 1;
  const real x = clamped(s.roughness, 0.0f, 1.0f) * last;
  const real left = smaller(whole_below(x), all_lanes(last - 1.0f));
  const integer at = to_integer(left) + RELUME_CYCLES_E_MEAN_START;
  const real low = gather(s.tables, at);
  return low + (gather(s.tables, at + 1) - low) * (x - left);
}

/// What a lobe is multiplied by where E = albedo, its mean is mean_albedo, and facets reflect `fresnel` on average: 1 + Fms (1 - E)/E,
/// Fms = F mean/(1 - F (1 - mean)).
RELUME_FN real multi_ggx_gain(real albedo, real mean_albedo, real fresnel) {
  const real later = fresnel * mean_albedo / (1.0f - fresnel * (1.0f - mean_albedo));
  return 1.0f + later * (1.0f - albedo) / albedo;
}

#endif
