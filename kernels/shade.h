// The sum over lights of incident * f_r * n.l for RELUME_LANES neighbouring pixels: the lecture's rendering equation for point lights.
#ifndef RELUME_SHADE_H
#define RELUME_SHADE_H

#include "kernels/ambient.h"
#include "kernels/batched_lights.h"
#include "kernels/load_surface.h"
#include "kernels/lookups.h"
#include "kernels/staged_lights.h"
#include "kernels/store.h"

// Where lights are staged all work-items of a group meet at barriers: none returns before.
#ifdef RELUME_STAGED
#define RELUME_STAGE_PARAMETER , __local Stage* stage
#define RELUME_STAGE_ARGUMENTS , mine, stage
#define RELUME_MAY_RETURN 0
#else
#define RELUME_STAGE_PARAMETER
#define RELUME_STAGE_ARGUMENTS
#define RELUME_MAY_RETURN 1
#endif

/// What other lights gave to the sums, where a base is kept of them (host/live_frame.h), else nothing.
RELUME_FN Radiance sums_so_far(RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const float* out, int i) {
  Radiance sum;
  sum.diffuse = sum.specular = grey(all_lanes(0.0f));
  if (frame->base == 0) return sum;
  sum.diffuse = load3(out, frame->out_stride, frame->base, i);
  sum.specular = load3(out, frame->out_stride, frame->base + 3, i);
  return sum;
}

/// Ambient light does not change with the lights that are added to a base: what was written with it stands.
RELUME_FN real3 ambient_light(Choice choice, RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const float* out, Surface s, Seen seen, real coverage,
                              int i) {
  if (frame->base > 0 && frame->ambient_out >= 0) return load3(out, frame->out_stride, frame->ambient_out, i);
  return scale3(reflect_ambient(choice, frame, s, seen.diffuse, seen.specular), coverage);
}

/// A block that no changed light reaches, where a base is kept.
RELUME_FN int is_left_alone(RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const int* lists, int i) {
  return frame->base > 0 && frame->lists > 0 && i < frame->pixels && lists[frame->lists + 2 * (i / RELUME_LISTED_PIXELS)] < 0;
}

/// Shades pixels i .. i + RELUME_LANES - 1 of those whose program this is; the others' output is left alone.
RELUME_FN void shade_pixels(Choice choice, RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame,
                            RELUME_GLOBAL const LightRecord* lights, RELUME_GLOBAL const int* lists, RELUME_GLOBAL const float* tables,
                            RELUME_GLOBAL float* out, int i RELUME_STAGE_PARAMETER) {
  mask mine = load(planes + (size_t)frame->plane_stride * frame->program_plane + i) == (float)frame->program;
  if (is_left_alone(frame, lists, i)) mine = mine & !mine;
  if (RELUME_MAY_RETURN && !any_of(mine)) return;
  Surface s = load_surface(planes, frame, tables, i);
  s.fresnel = choice.fresnel;
  s.shadowing = choice.shadowing;
  s.distribution = choice.distribution;
  s = looked_up(choice, s);
  const mask front = s.n_v > 0.0f;
  const mask as_stored = field_1(planes, &frame->field[FIELD_facing], i) == (float)FACING_as_stored;
  Seen seen;
  seen.diffuse = front | as_stored;
  seen.specular = front;
  const int stride = frame->out_stride;
  Radiance sum = direct_light(choice, frame, lights, lists, s, seen, sums_so_far(frame, out, i), i RELUME_STAGE_ARGUMENTS);
  if (frame->sums > 0) {
    store_where(mine, sum.diffuse, out, stride, frame->sums, i);
    store_where(mine, sum.specular, out, stride, frame->sums + 3, i);
  }
  const real coverage = field_1(planes, &frame->field[FIELD_coverage], i);
  sum.diffuse = scale3(sum.diffuse, coverage);
  sum.specular = scale3(sum.specular, coverage);
  const real3 ambient = ambient_light(choice, frame, out, s, seen, coverage, i);
  store_where(mine, add3(add3(sum.diffuse, sum.specular), ambient), out, stride, frame->total, i);
  store_where(mine, sum.diffuse, out, stride, frame->diffuse, i);
  store_where(mine, sum.specular, out, stride, frame->specular, i);
  if (frame->base == 0) store_where(mine, ambient, out, stride, frame->ambient_out, i);
}

#endif
