// The lecture's directions n, v, l, R_v, R_l and h of each pixel for one light, and their cosines.
#ifndef RELUME_DIRECTIONS_H
#define RELUME_DIRECTIONS_H

#include "kernels/directions_list.h"
#include "kernels/shade.h"

/// v mirrored at n: 2 (n.v) n - v
RELUME_FN real3 mirrored3(real3 n, real3 v) { return subtract3(scale3(n, 2.0f * dot3(n, v)), v); }

/// Writes the planes of kernels/directions_list.h from frame->total, three of each direction, one of each cosine. Zeros where no surface is shown;
/// where l is not defined (the light is at the surface), zeros in what needs it.
RELUME_FN void directions_pixels(Choice choice, RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame,
                                 RELUME_GLOBAL const LightRecord* lights, RELUME_GLOBAL const int* lists, RELUME_GLOBAL const float* tables,
                                 RELUME_GLOBAL float* out, int i) {
  (void)choice, (void)lists;
  const mask shown = load(planes + (size_t)frame->plane_stride * frame->program_plane + i) >= 0.0f;
  const Surface s = load_surface(planes, frame, tables, i);
  const real3 n = s.n, v = s.v, l = incident_from(frame, lights, frame->light_begin[0], s.position).l;
  const real3 R_v = mirrored3(n, v), R_l = mirrored3(n, l), h = unit3(add3(l, v));
  const real n_l = dot3(n, l), n_v = s.n_v, l_v = dot3(l, v), n_h = dot3(n, h), v_h = dot3(v, h), R_v_l = dot3(R_v, l);
  const real zero = all_lanes(0.0f);
  RELUME_GLOBAL float* p = out + (size_t)frame->out_stride * frame->total + i;
#define RELUME_STORE_COSINE(c)              \
  store(choose(shown, finite(c), zero), p); \
  p += frame->out_stride;
#define RELUME_STORE_DIRECTION(d) RELUME_STORE_COSINE(d.x) RELUME_STORE_COSINE(d.y) RELUME_STORE_COSINE(d.z)
  RELUME_DIRECTIONS(RELUME_STORE_DIRECTION)
  RELUME_DIRECTION_COSINES(RELUME_STORE_COSINE)
#undef RELUME_STORE_DIRECTION
#undef RELUME_STORE_COSINE
}

#endif
