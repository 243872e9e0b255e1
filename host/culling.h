// What culling asks of many pixels or lights at a time: compiled once for each lane count beside the twin (host/twin_lanes.h).
#pragma once

#include "host/frame.h"
#include "host/light_columns.h"

namespace relume {

struct Culling {
  /// bound_parts of kernels/bounds.h.
  int (*bound_cell)(const float* planes, const Frame& frame, const int* blocks, int count, float widest, PixelBounds* parts);
  /// Where those of [first, last) are that may reach a position within one of the boxes, whichever way the surface there faces, to `places`, which
  /// holds (last - first) rounded up to 16. Returns how many.
  int (*places_near)(const LightColumns& lights, int first, int last, const PixelBounds* boxes, int box_count, int* places);
  /// The numbers (`light`) of those of `count` that may light some pixel of one of the parts, in their order, to `numbers`, which holds `count`
  /// rounded up to 16. Returns how many.
  int (*numbers_lighting)(const LightColumns& lights, int count, const PixelBounds* parts, int part_count, const int* light, int* numbers);
};

/// On this processor's widest vectors.
const Culling& culling();

}  // namespace relume
