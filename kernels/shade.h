// The sum over lights of incident * f_r * n.l for RELUME_LANES neighbouring pixels: the lecture's rendering equation for point lights.
#ifndef RELUME_SHADE_H
#define RELUME_SHADE_H

#include "kernels/ambient.h"
#include "kernels/brdf.h"
#include "kernels/bump.h"
#include "kernels/lights.h"  // made by the build from the list: includes every light
#include "kernels/load_surface.h"
#include "kernels/lookups.h"
#include "kernels/store.h"

typedef struct {
  real3 diffuse, specular;
} Radiance;

#define RELUME_LIGHT_OF_TYPE(name, ...) \
  if (k < frame->light_begin[LIGHT_##name + 1]) return light_##name(lights + k, position);

/// Light k; lights are sorted by type, so the branch goes one way for many lights in a row, and for all lanes. Behind the last type come points
/// that stand in for clusters of lights (host/light_tree.h).
RELUME_FN Incident incident_from(RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const LightRecord* lights, int k, real3 position) {
  RELUME_LIGHTS(RELUME_LIGHT_OF_TYPE)
  return light_point(lights + k, position);
}

/// Which lanes show a surface to the viewer.
typedef struct {
  mask diffuse, specular;
} Seen;

/// The share of a light where the surface faces it, else 0.
RELUME_FN real facing_share(Incident in, Cosines c, Surface s, int bump_shadowing) {
  real share = choose(c.n_l > 0.0f, in.share, all_lanes(0.0f));
  if (bump_shadowing != BUMP_none) share = share * bump_visibility(bump_shadowing, s, in.l);
  return share;
}

/// The sum with one light's reflection.
RELUME_FN Radiance with_light(Radiance sum, Choice choice, RELUME_GLOBAL const LightRecord* light, real share, Cosines c, Surface s, Seen seen) {
  const mask lit = share > 0.0f;
  const real3 irradiance = scale3(light_intensity(light), share), dark = grey(all_lanes(0.0f));
  sum.diffuse = fused3(irradiance, choose3(lit & seen.diffuse, reflect_diffuse(choice.diffuse, c, s), dark), sum.diffuse);
  sum.specular = fused3(irradiance, choose3(lit & seen.specular, reflect_specular(choice.specular, c, s), dark), sum.specular);
  return sum;
}

/// Lights that are met before any is reflected. One where a work-item has one pixel: devices of that kind hide what an operation takes behind other
/// work-items, and have no fast memory for arrays.
#if defined(RELUME_OPENCL) && RELUME_LANES == 1
#define RELUME_BATCH 1
#else
#define RELUME_BATCH 16
#endif

#define RELUME_DECLARE_BATCH(member) real batch_##member[RELUME_BATCH];
#define RELUME_PUT_INTO_BATCH(member) batch_##member[arrivals] = c.member;
#define RELUME_TAKE_FROM_BATCH(member) c.member = batch_##member[k];

/// `sum` with the lights of the pixels' list, or with all. They come in batches, through short loops one after the other: a processor has some 200
/// vector instructions under way at a time, which one loop over everything would fill with a light or two, whose operations wait for each other.
/// For the same reason a light's direction is worked out while the one before it is met. What reaches no lane is left out without a branch that could
/// be mispredicted. Each member of the cosines has its own array, so that one which no lobe reads is dropped.
RELUME_FN Radiance direct_light(Choice choice, RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const LightRecord* lights,
                                RELUME_GLOBAL const int* lists, Surface s, Seen seen, Radiance sum, int i) {
  const int listed = frame->lists > 0;
  RELUME_GLOBAL const int* own = lists + (listed ? frame->lists + 2 * (i / RELUME_LISTED_PIXELS) : 0);
  const int end = listed ? own[1] : frame->light_begin[LIGHT_COUNT];
  int next = listed ? own[0] : frame->light_begin[0];
  if (next >= end) return sum;
  int from[RELUME_BATCH], light = listed ? lists[next] : next;
  real share[RELUME_BATCH];
  RELUME_COSINES(RELUME_DECLARE_BATCH)
  Incident coming = incident_from(frame, lights, light, s.position);
  while (next < end) {
    int arrivals = 0;
    for (; next < end && arrivals < RELUME_BATCH; ++next) {
      const Incident in = coming;
      from[arrivals] = light;
      if (next + 1 < end) light = listed ? lists[next + 1] : next + 1;
      coming = incident_from(frame, lights, light, s.position);  // the last one once more: a branch would cost more
      const Cosines c = cosines_of(s.n, in.l, s.v);
      RELUME_COSINES(RELUME_PUT_INTO_BATCH)
      share[arrivals] = facing_share(in, c, s, frame->bump_shadowing);
      arrivals += any_of(share[arrivals] > 0.0f);
    }
    for (int k = 0; k < arrivals; ++k) {
      Cosines c;
      c.n_v = s.n_v;
      RELUME_COSINES(RELUME_TAKE_FROM_BATCH)
      sum = with_light(sum, choice, lights + from[k], share[k], c, s, seen);
    }
  }
  return sum;
}

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

/// Shades pixels i .. i + RELUME_LANES - 1 of those whose program this is; the others' output is left alone.
RELUME_FN void shade_pixels(Choice choice, RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame,
                            RELUME_GLOBAL const LightRecord* lights, RELUME_GLOBAL const int* lists, RELUME_GLOBAL const float* tables,
                            RELUME_GLOBAL float* out, int i) {
  const mask mine = load(planes + (size_t)frame->plane_stride * frame->program_plane + i) == (float)frame->program;
  if (!any_of(mine)) return;
  if (frame->base > 0 && frame->lists > 0 && lists[frame->lists + 2 * (i / RELUME_LISTED_PIXELS)] < 0) return;
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
  Radiance sum = direct_light(choice, frame, lights, lists, s, seen, sums_so_far(frame, out, i), i);
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
