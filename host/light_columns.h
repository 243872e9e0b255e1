// Lights as structure of arrays, for tests of many at a time (host/light_reach.h).
#pragma once

namespace relume {

/// The kernels compute squared distances and cosines within some 4e-7 of themselves; this is a wide berth.
constexpr float reach_margin = 1e-4f;

/// Arrays that are read to a multiple of 16; lights of the padding have a range2 below 0, and reach nothing.
struct LightColumns {
  const float *x, *y, *z;                                 ///< positions; of a directional light the way to it
  const float* w;                                         ///< 1; 0 for a directional light
  const float* range2;                                    ///< squared, with a margin for rounding; infinity where nothing is out of range
  const float *axis_x, *axis_y, *axis_z, *cosine, *sine;  ///< of cones, and of their half-angles: 0 and 0 where there is none
  bool any_cone;                                          ///< else the cones are not there to be read
};

}  // namespace relume
