// Bounds of a few blocks of pixels: where their surfaces lie and face, which culling asks instead of each pixel (host/light_lists.h).
#ifndef RELUME_BOUNDS_H
#define RELUME_BOUNDS_H

#include "kernels/load_surface.h"

/// Of one or more numbers in each lane.
typedef struct {
  real low, high;
} Extent;

RELUME_FN Extent no_extent(void) {
  Extent e;
  e.low = all_lanes(INFINITY);
  e.high = all_lanes(-INFINITY);
  return e;
}

/// The extent with `value` too, in the lanes of the mask.
RELUME_FN Extent extended(Extent e, real value, mask where) {
  e.low = choose(where & (value < e.low), value, e.low);
  e.high = choose(where & (value > e.high), value, e.high);
  return e;
}

/// Over all lanes.
RELUME_FN void fold(Extent e, float* low, float* high) {
  *low = least_of(e.low);
  *high = -least_of(-e.high);
}

/// What `bounds` holds so far of normals n.
typedef struct {
  Extent x, y, z, depth;
} Facing;

RELUME_FN Facing facing_too(Facing f, real3 n, real depth, mask where) {
  f.x = extended(f.x, n.x, where);
  f.y = extended(f.y, n.y, where);
  f.z = extended(f.z, n.z, where);
  f.depth = extended(f.depth, depth, where);
  return f;
}

/// Of `count` blocks of RELUME_LISTED_PIXELS pixels, by number. bounds->reference is given: a point near them.
RELUME_FN void bound_blocks(RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame, const int* blocks, int count, PixelBounds* bounds) {
  Extent x = no_extent(), y = no_extent(), z = no_extent();
  Facing f;
  f.x = f.y = f.z = f.depth = no_extent();
  const int stride = frame->plane_stride;
  const real3 q = real3_of(all_lanes(bounds->reference[0]), all_lanes(bounds->reference[1]), all_lanes(bounds->reference[2]));
  for (int k = 0; k < count; ++k) {
    const int first = blocks[k] * RELUME_LISTED_PIXELS;
    for (int i = first; i < first + RELUME_LISTED_PIXELS && i < frame->pixels; i += RELUME_LANES) {
      const mask shown = load(planes + (size_t)stride * frame->program_plane + i) >= 0.0f;
      const real3 p = load3(planes, stride, frame->position, i), n = load3(planes, stride, frame->normal, i);
      x = extended(x, p.x, shown);
      y = extended(y, p.y, shown);
      z = extended(z, p.z, shown);
      const real depth = dot3(n, subtract3(p, q)), w = all_lanes(frame->viewer[3]);
      // A surface of two sides is shaded from the viewer's: from either, where rounding could decide it (1e-4 is a thousand roundings).
      const mask two_sided = field_1(planes, &frame->field[FIELD_facing], i) == (float)FACING_two_sided;
      const real3 to_viewer = real3_of(frame->viewer[0] - w * p.x, frame->viewer[1] - w * p.y, frame->viewer[2] - w * p.z);
      const real3 terms = multiply3(n, to_viewer);
      const real towards = terms.x + terms.y + terms.z, slack = 1e-4f * (absolute(terms.x) + absolute(terms.y) + absolute(terms.z));
      f = facing_too(f, n, depth, shown & (~two_sided | (towards > -slack)));
      f = facing_too(f, scale3(n, all_lanes(-1.0f)), -depth, shown & two_sided & (towards < slack));
    }
  }
  float unused;
  fold(x, &bounds->low[0], &bounds->high[0]);
  fold(y, &bounds->low[1], &bounds->high[1]);
  fold(z, &bounds->low[2], &bounds->high[2]);
  fold(f.x, &bounds->normal_low[0], &bounds->normal_high[0]);
  fold(f.y, &bounds->normal_low[1], &bounds->normal_high[1]);
  fold(f.z, &bounds->normal_low[2], &bounds->normal_high[2]);
  fold(f.depth, &bounds->deepest, &unused);
}

#endif
