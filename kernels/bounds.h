// Bounds of a cell's pixels: where their surfaces lie and face, which culling asks instead of each pixel (host/light_lists.h). A box around a step in
// depth is mostly empty, and lists the lights in its empty middle; so wide boxes are split, as in Harada 2012, "A 2.5D culling for Forward+".
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
  e.low = smaller(choose(where, value, e.low), e.low);
  e.high = larger(choose(where, value, e.high), e.high);
  return e;
}

/// Over all lanes.
RELUME_FN void fold(Extent e, float* low, float* high) {
  *low = least_of(e.low);
  *high = -least_of(-e.high);
}

typedef struct {
  Extent x, y, z;
} Extent3;

RELUME_FN Extent3 no_extent3(void) {
  Extent3 e;
  e.x = e.y = e.z = no_extent();
  return e;
}

RELUME_FN Extent3 extended3(Extent3 e, real3 value, mask where) {
  e.x = extended(e.x, value.x, where);
  e.y = extended(e.y, value.y, where);
  e.z = extended(e.z, value.z, where);
  return e;
}

RELUME_FN void fold3(Extent3 e, float low[3], float high[3]) {
  fold(e.x, &low[0], &high[0]);
  fold(e.y, &low[1], &high[1]);
  fold(e.z, &low[2], &high[2]);
}

/// A cell by lanes: where each group of them lies in the planes, and in which part of the cell each lane is; -1: no surface.
typedef struct {
  int groups;
  int at[RELUME_CELL_PIXELS / RELUME_LANES];
  real part[RELUME_CELL_PIXELS / RELUME_LANES];
} CellLanes;

/// Pixels to the right that are fetched from memory meanwhile: cells are asked for one by one, in short pieces of many rows and planes, which no
/// processor foresees. Saves a third of the time.
#define RELUME_BOUND_SOON 48

/// Of `count` blocks of RELUME_LISTED_PIXELS pixels, by number; all in part 0.
RELUME_FN void load_cell(RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame, const int* blocks, int count, CellLanes* cell) {
  RELUME_GLOBAL const float* program = planes + (size_t)frame->plane_stride * frame->program_plane;
  cell->groups = 0;
  for (int k = 0; k < count; ++k)
    for (int i = blocks[k] * RELUME_LISTED_PIXELS; i < (blocks[k] + 1) * RELUME_LISTED_PIXELS && i < frame->pixels; i += RELUME_LANES) {
      fetch_soon(program + i + RELUME_BOUND_SOON);
      for (int c = 0; c < 3; ++c) {
        fetch_soon(planes + (size_t)frame->plane_stride * (frame->position + c) + i + RELUME_BOUND_SOON);
        fetch_soon(planes + (size_t)frame->plane_stride * (frame->normal + c) + i + RELUME_BOUND_SOON);
      }
      cell->at[cell->groups] = i;
      cell->part[cell->groups++] = choose(load(program + i) >= 0.0f, all_lanes(0.0f), all_lanes(-1.0f));
    }
}

RELUME_FN void bound_positions(RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame, const CellLanes* cell, int part,
                               PixelBounds* bounds) {
  Extent3 box = no_extent3();
  for (int g = 0; g < cell->groups; ++g)
    box = extended3(box, load3(planes, frame->plane_stride, frame->position, cell->at[g]), cell->part[g] == (float)part);
  fold3(box, bounds->low, bounds->high);
}

/// The axis in which the box is longest.
RELUME_FN int longest_side(const PixelBounds* b) {
  const float x = b->high[0] - b->low[0], y = b->high[1] - b->low[1], z = b->high[2] - b->low[2];
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

/// The lanes of the part that lie beyond `middle` become `other`'s.
RELUME_FN void split_part(RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame, int part, int axis, float middle, int other,
                          CellLanes* cell) {
  RELUME_GLOBAL const float* position = planes + (size_t)frame->plane_stride * (frame->position + axis);
  for (int g = 0; g < cell->groups; ++g) {
    const mask beyond = (cell->part[g] == (float)part) & (load(position + cell->at[g]) > middle);
    cell->part[g] = choose(beyond, all_lanes((float)other), cell->part[g]);
  }
}

/// The way the pixels of a part face, as they are shaded.
RELUME_FN void bound_normals(RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame, const CellLanes* cell, int part,
                             PixelBounds* bounds) {
  Extent3 normals = no_extent3();
  Extent depth = no_extent();
  const int stride = frame->plane_stride;
  const int one_for_all = frame->field[FIELD_facing].step == 0 && planes[frame->field[FIELD_facing].offset] != (float)FACING_two_sided;
  for (int c = 0; c < 3; ++c) bounds->reference[c] = 0.5f * (bounds->low[c] + bounds->high[c]);
  const real3 q = real3_of(all_lanes(bounds->reference[0]), all_lanes(bounds->reference[1]), all_lanes(bounds->reference[2]));
  for (int g = 0; g < cell->groups; ++g) {
    const int i = cell->at[g];
    const mask mine = cell->part[g] == (float)part;
    const real3 p = load3(planes, stride, frame->position, i), n = load3(planes, stride, frame->normal, i);
    const real above = dot3(n, subtract3(p, q));
    if (one_for_all) {
      normals = extended3(normals, n, mine);
      depth = extended(depth, above, mine);
      continue;
    }
    // A surface of two sides is shaded from the viewer's: from either, where rounding could decide it (1e-4 is a thousand roundings).
    const real w = all_lanes(frame->viewer[3]);
    const mask two_sided = field_1(planes, &frame->field[FIELD_facing], i) == (float)FACING_two_sided;
    const real3 to_viewer = real3_of(frame->viewer[0] - w * p.x, frame->viewer[1] - w * p.y, frame->viewer[2] - w * p.z);
    const real3 terms = multiply3(n, to_viewer);
    const real towards = terms.x + terms.y + terms.z, slack = 1e-4f * (absolute(terms.x) + absolute(terms.y) + absolute(terms.z));
    const mask as_it_is = mine & (~two_sided | (towards > -slack)), turned = mine & two_sided & (towards < slack);
    normals = extended3(extended3(normals, n, as_it_is), scale3(n, all_lanes(-1.0f)), turned);
    depth = extended(extended(depth, above, as_it_is), -above, turned);
  }
  float unused;
  fold3(normals, bounds->normal_low, bounds->normal_high);
  fold(depth, &bounds->deepest, &unused);
}

/// Of a cell of `count` blocks of pixels, by number: how many parts it has, none where it shows no surface. Boxes with a side longer than `widest`
/// are split in its middle, the longest first, as long as there are parts.
RELUME_FN int bound_parts(RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame, const int* blocks, int count, float widest,
                          PixelBounds* parts) {
  CellLanes cell;
  load_cell(planes, frame, blocks, count, &cell);
  bound_positions(planes, frame, &cell, 0, &parts[0]);
  if (!(parts[0].low[0] <= parts[0].high[0])) return 0;
  int made = 1;
  for (; made < RELUME_CELL_PARTS; ++made) {
    int longest = 0, axis = 0;
    float side = 0;
    for (int k = 0; k < made; ++k) {
      const int a = longest_side(&parts[k]);
      if (parts[k].high[a] - parts[k].low[a] > side) longest = k, axis = a, side = parts[k].high[a] - parts[k].low[a];
    }
    const float middle = 0.5f * (parts[longest].low[axis] + parts[longest].high[axis]);
    // Not infinite either: neither half would be empty.
    if (!(side > widest && middle > parts[longest].low[axis] && middle < parts[longest].high[axis])) break;
    split_part(planes, frame, longest, axis, middle, made, &cell);
    bound_positions(planes, frame, &cell, longest, &parts[longest]);
    bound_positions(planes, frame, &cell, made, &parts[made]);
  }
  for (int k = 0; k < made; ++k) bound_normals(planes, frame, &cell, k, &parts[k]);
  return made;
}

#endif
