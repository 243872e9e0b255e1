// The entry point on a device: one work-item for RELUME_LANES neighbouring pixels.
#if RELUME_LANES == 1
#define RELUME_STAGED
#endif
#include "kernels/built_choice.h"
#include "kernels/shade.h"

__kernel void shade(__global const float* restrict planes, __global const Frame* restrict frame, __global const LightRecord* restrict lights,
                    __global const int* restrict lists, __global const float* restrict tables, __global float* restrict out, int first) {
  const int i = first + (int)get_global_id(0) * RELUME_LANES;
#ifdef RELUME_STAGED
  // Behind the last pixel as well: planes are padded by more than a group, with pixels of no program.
  __local Stage stage;
  shade_pixels(built_choice(), planes, frame, lights, lists, tables, out, i, &stage);
#else
  if (i < frame->pixels) shade_pixels(built_choice(), planes, frame, lights, lists, tables, out, i);
#endif
}
