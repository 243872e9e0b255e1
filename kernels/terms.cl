// The factors of microfacet lobes on a device: one work-item for RELUME_LANES rows of a table.
#include "kernels/built_choice.h"
#include "kernels/terms.h"

__kernel void terms(__global const float* restrict planes, __global const Frame* restrict frame, __global const LightRecord* restrict lights,
                    __global const int* restrict lists, __global const float* restrict tables, __global float* restrict out, int first) {
  const int i = first + (int)get_global_id(0) * RELUME_LANES;
  if (i < frame->pixels) terms_pixels(built_choice(), planes, frame, lights, lists, tables, out, i);
}
