// The sum over lights of incident * f_r * n.l for RELUME_LANES neighbouring pixels: the lecture's rendering equation for point lights.
#ifndef RELUME_SHADE_H
#define RELUME_SHADE_H

#include "kernels/ambient.h"
#include "kernels/brdf.h"
#include "kernels/bump.h"
#include "kernels/lights.h"  // made by the build from the list: includes every light
#include "kernels/load_surface.h"
#include "kernels/lookups.h"

typedef struct {
  real3 diffuse, specular;
} Radiance;

/// One light's share.
RELUME_FN Radiance reflect(Choice choice, Incident in, Surface s, mask diffuse_seen, mask specular_seen, int bump_shadowing) {
  Radiance r;
  r.diffuse = grey(all_lanes(0.0f));
  r.specular = r.diffuse;
  const Cosines c = cosines_of(s.n, in.l, s.v);
  const mask lit = c.n_l > 0.0f;
  if (!any_of(lit)) return r;
  real3 irradiance = in.irradiance;
  if (bump_shadowing != BUMP_none) irradiance = scale3(irradiance, bump_visibility(bump_shadowing, s, in.l));
  const real3 dark = r.diffuse;
  r.diffuse = choose3(lit & diffuse_seen, multiply3(irradiance, reflect_diffuse(choice.diffuse, c, s)), dark);
  r.specular = choose3(lit & specular_seen, multiply3(irradiance, reflect_specular(choice.specular, c, s)), dark);
  return r;
}

#define RELUME_LIGHT_OF_TYPE(name, ...) \
  if (k < frame->light_begin[LIGHT_##name + 1]) return light_##name(lights + k, position);

/// Light k; lights are sorted by type, so the branch goes one way for many lights in a row, and for all lanes.
RELUME_FN Incident incident_from(RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const LightRecord* lights, int k, real3 position) {
  RELUME_LIGHTS(RELUME_LIGHT_OF_TYPE)
  return light_directional(lights + k, position);
}

/// What is written is finite: NaN (a parameter was NaN) becomes 0, what overflows becomes the largest float.
RELUME_FN real finite(real x) { return choose(x == x, clamped(x, -3.4e38f, 3.4e38f), all_lanes(0.0f)); }

RELUME_FN void store_where(mask m, real3 value, RELUME_GLOBAL float* out, int stride, int plane, int i) {
  if (plane < 0) return;
  RELUME_GLOBAL float* p = out + (size_t)stride * plane + i;
  store(choose(m, finite(value.x), load(p)), p);
  store(choose(m, finite(value.y), load(p + stride)), p + stride);
  store(choose(m, finite(value.z), load(p + 2 * (size_t)stride)), p + 2 * (size_t)stride);
}

/// Shades pixels i .. i + RELUME_LANES - 1 of those whose program this is; the others' output is left alone.
RELUME_FN void shade_pixels(Choice choice, RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame,
                            RELUME_GLOBAL const LightRecord* lights, RELUME_GLOBAL const float* tables, RELUME_GLOBAL float* out, int i) {
  const mask mine = load(planes + (size_t)frame->plane_stride * frame->program_plane + i) == (float)frame->program;
  if (!any_of(mine)) return;
  Surface s = load_surface(planes, frame, tables, i);
  s.fresnel = choice.fresnel;
  s.shadowing = choice.shadowing;
  s.distribution = choice.distribution;
  s = looked_up(choice, s);
  const mask front = s.n_v > 0.0f;
  const mask seen = field_1(planes, &frame->field[FIELD_facing], i) == (float)FACING_as_stored;
  const mask diffuse_seen = front | seen;
  const mask specular_seen = front;
  Radiance sum;
  sum.diffuse = grey(all_lanes(0.0f));
  sum.specular = sum.diffuse;
  for (int k = frame->light_begin[0]; k < frame->light_begin[LIGHT_COUNT]; ++k) {
    const Radiance r = reflect(choice, incident_from(frame, lights, k, s.position), s, diffuse_seen, specular_seen, frame->bump_shadowing);
    sum.diffuse = add3(sum.diffuse, r.diffuse);
    sum.specular = add3(sum.specular, r.specular);
  }
  const real coverage = field_1(planes, &frame->field[FIELD_coverage], i);
  sum.diffuse = scale3(sum.diffuse, coverage);
  sum.specular = scale3(sum.specular, coverage);
  const real3 ambient = scale3(reflect_ambient(choice, frame, s, diffuse_seen, specular_seen), coverage);
  const int stride = frame->out_stride;
  store_where(mine, add3(add3(sum.diffuse, sum.specular), ambient), out, stride, frame->total, i);
  store_where(mine, sum.diffuse, out, stride, frame->diffuse, i);
  store_where(mine, sum.specular, out, stride, frame->specular, i);
  store_where(mine, ambient, out, stride, frame->ambient_out, i);
}

#endif
