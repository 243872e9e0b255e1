// An environment by samples, on a device: one work-item for RELUME_LANES neighbouring pixels.
#include "kernels/built_choice.h"
#include "kernels/environment_sampled.h"

__kernel void environment_sampled(__global const float* restrict planes, __global const Frame* restrict frame,
                                  __global const LightRecord* restrict lights, __global const int* restrict lists,
                                  __global const float* restrict tables, __global float* restrict out, int first) {
  const int i = first + (int)get_global_id(0) * RELUME_LANES;
  if (i < frame->pixels) environment_sampled_pixels(built_choice(), planes, frame, lights, lists, tables, out, i);
}
