// The factors of microfacet lobes alone, D, G and F, for given cosines: what `relume check-brdf` holds to their laws.
#ifndef RELUME_TERMS_H
#define RELUME_TERMS_H

#include "kernels/evaluate.h"
#include "kernels/fresnel/fresnel.h"
#include "kernels/microfacet/beckmann.h"
#include "kernels/microfacet/ggx.h"
#include "kernels/microfacet/width.h"

/// Rows i .. i + RELUME_LANES - 1, as evaluate_pixels has them, of the choice's distribution, shadowing and Fresnel terms. Writes D, G and 0 to the
/// output planes from frame->diffuse, F to those from frame->specular.
RELUME_FN void terms_pixels(Choice choice, RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame,
                            RELUME_GLOBAL const LightRecord* lights, RELUME_GLOBAL const int* lists, RELUME_GLOBAL const float* tables,
                            RELUME_GLOBAL float* out, int i) {
  (void)lights, (void)lists;
  const Cosines c = row_cosines(planes, frame, i);
  const Surface s = row_surface(choice, planes, frame, tables, c, i);
  const real alpha = width_of(s);
  const int beckmann = choice.distribution == DISTRIBUTION_beckmann;
  const real d = beckmann ? beckmann_distribution(c, alpha) : ggx_distribution(c, alpha);
  const real visibility = beckmann ? beckmann_visibility(choice.shadowing, c, alpha) : ggx_visibility(choice.shadowing, c, alpha);
  store3(real3_of(d, 4.0f * c.n_v * visibility, all_lanes(0.0f)), out, frame, frame->diffuse, i);
  store3(fresnel_of(s, v_h(c)), out, frame, frame->specular, i);
}

#endif
