// The lobes alone, for given cosines: what `relume evaluate` tabulates, and tests compare with the oracle.
#ifndef RELUME_EVALUATE_H
#define RELUME_EVALUATE_H

#include "kernels/brdf.h"
#include "kernels/load_surface.h"
#include "kernels/lookups.h"

/// Of rows i .. i + RELUME_LANES - 1: the planes from frame->position are the members of Cosines in their order.
RELUME_FN Cosines row_cosines(RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame, int i) {
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
  return c;
}

/// The surface of these rows: their parameters, and nothing of a pixel.
RELUME_FN Surface row_surface(Choice choice, RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const float* tables,
                              Cosines c, int i) {
  Surface s = load_parameters(planes, frame, tables, i);
  s.position = s.n = s.v = s.base_n = grey(all_lanes(0.0f));
  s.n_v = c.n_v;
  s.fresnel = choice.fresnel;
  s.shadowing = choice.shadowing;
  s.distribution = choice.distribution;
  return s;
}

RELUME_FN void store3(real3 value, RELUME_GLOBAL float* out, RELUME_GLOBAL const Frame* frame, int plane, int i) {
  RELUME_GLOBAL float* q = out + (size_t)frame->out_stride * plane + i;
  store(value.x, q);
  store(value.y, q + frame->out_stride);
  store(value.z, q + 2 * (size_t)frame->out_stride);
}

/// Rows i .. i + RELUME_LANES - 1. Writes f_r n.l, diffuse and specular, to the output planes frame->diffuse and frame->specular.
RELUME_FN void evaluate_pixels(Choice choice, RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame,
                               RELUME_GLOBAL const LightRecord* lights, RELUME_GLOBAL const int* lists, RELUME_GLOBAL const float* tables,
                               RELUME_GLOBAL float* out, int i) {
  (void)lights, (void)lists;
  const Cosines c = row_cosines(planes, frame, i);
  const Surface s = looked_up(choice, row_surface(choice, planes, frame, tables, c, i));
  const mask seen = (c.n_l > 0.0f) & (c.n_v > 0.0f);
  const real3 dark = grey(all_lanes(0.0f));
  store3(choose3(seen, reflect_diffuse(choice.diffuse, c, s), dark), out, frame, frame->diffuse, i);
  store3(choose3(seen, reflect_specular(choice.specular, c, s), dark), out, frame, frame->specular, i);
}

#endif
