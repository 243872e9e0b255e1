// From the planes of the G-buffer to a Surface: the viewer, the facing rule, and every parameter from its plane or constant.
#ifndef RELUME_LOAD_SURFACE_H
#define RELUME_LOAD_SURFACE_H

#include "kernels/frame.h"
#include "kernels/surface.h"

RELUME_FN real3 load3(RELUME_GLOBAL const float* planes, int stride, int plane, int i) {
  RELUME_GLOBAL const float* p = planes + (size_t)stride * plane + i;
  return real3_of(load(p), load(p + stride), load(p + 2 * (size_t)stride));
}

RELUME_FN real field_1(RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Field* f, int i) {
  if (f->step == 0) return all_lanes(planes[f->offset]);
  return load(planes + f->offset + i);
}

RELUME_FN real3 field_3(RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Field* f, int i) {
  RELUME_GLOBAL const float* p = planes + f->offset;
  const int c = f->component_step;
  if (f->step == 0) return real3_of(all_lanes(p[0]), all_lanes(p[c]), all_lanes(p[2 * (size_t)c]));
  return real3_of(load(p + i), load(p + c + i), load(p + 2 * (size_t)c + i));
}

#define RELUME_LOAD_PARAMETER(name, components, ...) s.name = field_##components(planes, &frame->field[FIELD_##name], i);

/// The lobes' parameters, from plane or constant.
RELUME_FN Surface load_parameters(RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const float* tables, int i) {
  Surface s;
  s.tables = tables;
  RELUME_PARAMETERS(RELUME_LOAD_PARAMETER)
  return s;
}

RELUME_FN Surface load_surface(RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame, RELUME_GLOBAL const float* tables, int i) {
  Surface s = load_parameters(planes, frame, tables, i);
  const int stride = frame->plane_stride;
  s.position = load3(planes, stride, frame->position, i);
  s.n = load3(planes, stride, frame->normal, i);
  s.base_n = s.n;
  if (frame->base_normal >= 0) s.base_n = load3(planes, stride, frame->base_normal, i);
  const float w = frame->viewer[3];
  const real3 viewer = real3_of(all_lanes(frame->viewer[0]), all_lanes(frame->viewer[1]), all_lanes(frame->viewer[2]));
  s.v = w == 0.0f ? viewer : unit3(subtract3(viewer, s.position));
  const real facing = field_1(planes, &frame->field[FIELD_facing], i);
  const mask turn = (facing == (float)FACING_two_sided) & (dot3(s.n, s.v) < 0.0f);
  s.n = choose3(turn, scale3(s.n, all_lanes(-1.0f)), s.n);
  s.base_n = choose3(turn, scale3(s.base_n, all_lanes(-1.0f)), s.base_n);
  s.n_v = dot3(s.n, s.v);
  return s;
}

#endif
