// The lobes alone, for given cosines: what `relume evaluate` tabulates, and tests compare with the oracle.
#ifndef RELUME_EVALUATE_H
#define RELUME_EVALUATE_H

#include "kernels/brdf.h"
#include "kernels/load_surface.h"
#include "kernels/lookups.h"

/// Rows i .. i + RELUME_LANES - 1. The planes from frame->position are the members of Cosines in their order.
/// Writes f_r n.l, diffuse and specular, to the output planes frame->diffuse and frame->specular.
RELUME_FN void evaluate_pixels(Choice choice, RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame,
                               RELUME_GLOBAL const LightRecord* lights, RELUME_GLOBAL const int* lists, RELUME_GLOBAL const float* tables,
                               RELUME_GLOBAL float* out, int i) {
  (void)lights, (void)lists;
  const size_t stride = frame->plane_stride;
  RELUME_GLOBAL const float* p = planes + stride * frame->position + i;
  Cosines c;
  c.n_l = load(p);
  c.n_v = load(p + stride);
  c.l_v = load(p + 2 * stride);
  c.sum2 = load(p + 3 * stride);
  c.across2 = load(p + 4 * stride);
  c.along2 = load(p + 5 * stride);
  c.tan2_h = load(p + 6 * stride);
  c.chord2 = load(p + 7 * stride);
  c.r_l = load(p + 8 * stride);
  Surface s = load_parameters(planes, frame, tables, i);
  s.position = s.n = s.v = s.base_n = grey(all_lanes(0.0f));
  s.n_v = c.n_v;
  s.fresnel = choice.fresnel;
  s.shadowing = choice.shadowing;
  s.distribution = choice.distribution;
  s = looked_up(choice, s);
  const mask seen = (c.n_l > 0.0f) & (c.n_v > 0.0f);
  const real3 dark = grey(all_lanes(0.0f)), diffuse = choose3(seen, reflect_diffuse(choice.diffuse, c, s), dark);
  const real3 specular = choose3(seen, reflect_specular(choice.specular, c, s), dark);
  RELUME_GLOBAL float* q = out + (size_t)frame->out_stride * frame->diffuse + i;
  store(diffuse.x, q);
  store(diffuse.y, q + frame->out_stride);
  store(diffuse.z, q + 2 * (size_t)frame->out_stride);
  q = out + (size_t)frame->out_stride * frame->specular + i;
  store(specular.x, q);
  store(specular.y, q + frame->out_stride);
  store(specular.z, q + 2 * (size_t)frame->out_stride);
}

#endif
