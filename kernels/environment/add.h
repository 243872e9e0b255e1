// What the programs of this folder begin and end with: the surface of a pixel, and its light added to what the output holds.
#ifndef RELUME_ENVIRONMENT_ADD_H
#define RELUME_ENVIRONMENT_ADD_H

#include "kernels/load_surface.h"
#include "kernels/lookups.h"
#include "kernels/store.h"

RELUME_FN Surface surface_at(Choice choice, RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const float* tables,
                             int i) {
  Surface s = load_surface(planes, frame, tables, i);
  s.fresnel = choice.fresnel;
  s.shadowing = choice.shadowing;
  s.distribution = choice.distribution;
  return looked_up(choice, s);
}

RELUME_FN void add_where(mask m, real3 value, RELUME_GLOBAL float* out, int stride, int plane, int i) {
  if (plane < 0) return;
  store_where(m, add3(value, load3(out, stride, plane, i)), out, stride, plane, i);
}

/// In the lanes of the mask, where the surface shows; `off`: how far off the sum may be.
RELUME_FN void add_reflection(RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame, Surface s, mask mine, real3 diffuse,
                              real3 specular, real3 off, RELUME_GLOBAL float* out, int i) {
  const mask front = s.n_v > 0.0f, as_stored = field_1(planes, &frame->field[FIELD_facing], i) == (float)FACING_as_stored;
  const real coverage = field_1(planes, &frame->field[FIELD_coverage], i);
  const real3 dark = grey(all_lanes(0.0f));
  diffuse = choose3(front | as_stored, scale3(diffuse, coverage), dark);
  specular = choose3(front, scale3(specular, coverage), dark);
  const int stride = frame->out_stride;
  add_where(mine, add3(diffuse, specular), out, stride, frame->total, i);
  add_where(mine, diffuse, out, stride, frame->diffuse, i);
  add_where(mine, specular, out, stride, frame->specular, i);
  if (frame->error < 0) return;
  RELUME_GLOBAL float* error = out + (size_t)stride * frame->error + i;
  const real squares = finite(dot3(off, off) * squared(coverage) * (1.0f / 3.0f));
  store(choose(mine & front, load(error) + squares, load(error)), error);
}

#endif
